// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_COMMANDS_H
#define DSC_COMMANDS_H

namespace CLI {
class App;
}

namespace dsc {

class Inputs;

/// Descriptions of the commands that the program `dsc` leaves to other programs, for the help.
inline constexpr char description_of_info[] = "Print statistics of a file",
                      description_of_improve[] = "Optimize the tetrahedra of a labeled mesh; the "
                                                 "interface is preserved",
                      description_of_cut_locus[] = "Compute the cut locus of a point of a surface",
                      description_of_segment[] = "Divide an image into phases, and mesh them",
                      description_of_grains[] = "Let the grains of a polycrystal grow",
                      description_of_fluid[] = "Simulate incompressible liquids with free surfaces",
                      description_of_reconstruct[] =
                          "Reconstruct the closed solid whose surface a point set samples";

/// Each function adds a command with its options to the program. The command runs during the
/// parsing of the command line and stores the exit code. The command throws Usage_error if its
/// options are invalid. Other errors are std::runtime_error, with a message of one line that states
/// the cause and what to do. `inputs` must exist until the end of the program.
/// Adds the commands that move an interface: one for each motion.
void add_flows(CLI::App& app, const Inputs& inputs, int& exit_code);
void add_convert(CLI::App& app, const Inputs& inputs, int& exit_code);
void add_view(CLI::App& app, int& exit_code);
void add_info(CLI::App& app, int& exit_code);
void add_improve(CLI::App& app, int& exit_code);
void add_cut_locus(CLI::App& app, int& exit_code);
void add_reconstruct(CLI::App& app, int& exit_code);
void add_segment(CLI::App& app, int& exit_code);
void add_grains(CLI::App& app, int& exit_code);
void add_fluid(CLI::App& app, int& exit_code);

} // namespace dsc

#endif // DSC_COMMANDS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `dsc`. It contains the flows of surfaces and conversions. Other programs in the same
// folder contain the rest, so that they need not be built for a first result.

#include "commands/commands.h"
#include "input/Inputs.h"
#include "input/files.h"
#include "input/translations.h"
#include "programs/errors.h"
#include "programs/program.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstring>
#include <string>

namespace {

/// A command that another program contains.
struct Other_command
{
  const char* name;
  const char* description;
  const char* program;
};
constexpr std::array<Other_command, 7> other_commands = {
    {{"info", dsc::description_of_info, "dsc-full"},
     {"improve", dsc::description_of_improve, "dsc-full"},
     {"cut-locus", dsc::description_of_cut_locus, "dsc-cut-locus"},
     {"reconstruct", dsc::description_of_reconstruct, "dsc-reconstruct"},
     {"segment", dsc::description_of_segment, "dsc-segment"},
     {"grains", dsc::description_of_grains, "dsc-grains"},
     {"fluid", dsc::description_of_fluid, "dsc-fluid"}}};

/// Leaves the commands that move an interface to the program for several processes. Without it, all
/// processes would write the same files.
/// \param app contains these commands only
void leave_flows_to_mpi(CLI::App& app, const std::string& command) {
  const auto is_command = [&](const CLI::App* flow) { return flow->get_name() == command; };
  if (!dsc::is_started_by_mpi() || app.get_subcommands(is_command).empty())
    return;
  static constexpr char name[] = "dsc-mpi";
  if (!dsc::exists(dsc::path_of_program(name)))
    throw dsc::Usage_error("mpirun needs the program dsc-mpi; build it with the CMake option "
                           "-DDSC_WITH_MPI=ON (Debian: libopenmpi-dev), or run dsc without mpirun");
  throw dsc::Other_program{name, "the command '" + command + "' for several processes"};
}

} // namespace

int main(int argc, char** argv) {
  const dsc::Inputs& inputs = dsc::surface_inputs();
  return dsc::run_program(argc, argv, [&](CLI::App& app, int& exit_code) {
    for (const Other_command& other : other_commands)
      if (argc > 1 && std::strcmp(argv[1], other.name) == 0)
        throw dsc::Other_program{other.program, std::string("the command '") + other.name + "'"};
    dsc::add_flows(app, inputs, exit_code);
    leave_flows_to_mpi(app, argc > 1 ? argv[1] : "");
    dsc::add_convert(app, inputs, exit_code);
    dsc::add_view(app, exit_code);
    for (const Other_command& other : other_commands)
      app.add_subcommand(other.name, other.description);
  });
}

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
#include "programs/launcher.h"
#include "programs/program.h"

#include <CLI/CLI.hpp>

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
  if (dsc::exists(dsc::path_of_program(name)))
    throw dsc::Other_program{name, "the command '" + command + "' for several processes"};
  dsc::leave_messages_to_first_process();
  throw dsc::Usage_error("mpirun needs the program dsc-mpi; build it with the CMake option "
                         "-DDSC_WITH_MPI=ON (Debian: libopenmpi-dev), or run dsc without mpirun");
}

/// \throws Usage_error if a launcher started several processes, which would all do the same
void require_one_process(const std::string& command) {
  const dsc::Launch launched = dsc::launch();
  if (launched.processes < 2)
    return;
  dsc::leave_messages_to_first_process();
  throw dsc::Usage_error((command.empty() ? "dsc" : "dsc " + command) +
                         " runs as one process, but " + launched.variable + " is " +
                         std::to_string(launched.processes) +
                         "; start it without mpirun, or with mpirun -n 1");
}

} // namespace

int main(int argc, char** argv) {
  const dsc::Inputs& inputs = dsc::surface_inputs();
  const std::string command = argc > 1 ? argv[1] : "";
  return dsc::run_program(argc, argv, [&](CLI::App& app, int& exit_code) {
    for (const Other_command& other : other_commands)
      if (command == other.name) {
        if (command != "fluid")
          require_one_process(command);
        throw dsc::Other_program{other.program, "the command '" + command + "'"};
      }
    dsc::add_flows(app, inputs, exit_code);
    leave_flows_to_mpi(app, command);
    require_one_process(command);
    dsc::add_convert(app, inputs, exit_code);
    dsc::add_view(app, exit_code);
    for (const Other_command& other : other_commands)
      app.add_subcommand(other.name, other.description);
  });
}

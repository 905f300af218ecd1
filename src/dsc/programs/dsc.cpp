// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `dsc`. It contains most of the commands. The other commands are programs of their own
// in the same folder, so that they need not be built for a first result.

#include "../commands/commands.h"
#include "../errors.h"
#include "../program.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

/// A command that is a program of its own, `dsc-NAME`.
struct Other_program
{
  const char* name;
  const char* description;
};
constexpr std::array<Other_program, 3> other_programs = {
    {{"cut-locus", dsc::description_of_cut_locus},
     {"reconstruct", dsc::description_of_reconstruct},
     {"fluid", dsc::description_of_fluid}}};

bool is_other_program(const char* name) {
  return std::any_of(other_programs.begin(), other_programs.end(),
                     [&](const Other_program& p) { return std::strcmp(p.name, name) == 0; });
}

/// Replaces the process by the program of a command, with the same arguments.
/// \throws Usage_error if there is no such program beside this one
[[noreturn]] void execute(const std::string& command, char** argv) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    throw dsc::Usage_error("cannot find the folder of this program: " + error.message());
  const std::filesystem::path program = self.parent_path() / ("dsc-" + command);
  execv(program.c_str(), argv);
  throw dsc::Usage_error("cannot execute " + program.string() + ", which contains the command '" +
                         command + "': " + std::strerror(errno) + "; build or install it");
}

/// Adds the commands, in the order of the help.
void add_commands(CLI::App& app, int& exit_code) {
  dsc::add_info(app, exit_code);
  dsc::add_rotate(app, exit_code);
  dsc::add_offset(app, exit_code);
  dsc::add_enright(app, exit_code);
  dsc::add_vortex(app, exit_code);
  dsc::add_advect(app, exit_code);
  dsc::add_mean_curvature(app, exit_code);
  dsc::add_zalesak(app, exit_code);
  dsc::add_convert(app, exit_code);
  dsc::add_improve(app, exit_code);
  for (const Other_program& program : other_programs)
    app.add_subcommand(program.name, program.description);
}

} // namespace

int main(int argc, char** argv) {
  return dsc::run_program(argc, argv, [&](CLI::App& app, int& exit_code) {
    if (argc > 1 && is_other_program(argv[1]))
      execute(argv[1], argv);
    add_commands(app, exit_code);
  });
}

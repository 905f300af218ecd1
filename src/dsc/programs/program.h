// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PROGRAM_H
#define DSC_PROGRAM_H

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace dsc {

/// Thrown if another program in the folder of this program contains the required code.
struct Other_program
{
  std::string name;    ///< of the program
  std::string content; ///< the required code, for messages
};

/// Runs a program that consists of commands: reads the command line, runs the command and prints
/// errors in one line. If `Other_program` is thrown, executes that program with the same arguments.
/// \param argc, argv the arguments of the program, of which the first is a command
/// \param add_commands adds the commands, see commands/commands.h
/// \return the exit code of the program
int run_program(int argc, char** argv,
                const std::function<void(CLI::App& app, int& exit_code)>& add_commands);

} // namespace dsc

#endif // DSC_PROGRAM_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/program.h"
#include "input/nearest_name.h"

#include "input/translations.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/standard_streams.h"

#include <CGAL/assertions.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>

namespace {

enum Exit_code { bad_input = 1, bad_usage = 2, stopped = dsc::exit_code_of_interrupt };

int fail(const std::string& message, Exit_code code) {
  std::cerr << "dsc: " << dsc::printed_line(message) << '\n';
  return code;
}

// Suppresses the output of CGAL before it throws: the exception contains the message.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

/// Replaces the process by another program in the same folder, with the same arguments. Returns an
/// error message if this fails.
std::string execute(const dsc::Other_program& other, char** argv) {
  std::string program;
  try {
    program = dsc::path_of_program(other.name);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  dsc::remove_temporary_files();
  execv(program.c_str(), argv);
  return "cannot execute " + program + ", which contains " + other.content + ": " +
         std::strerror(errno) + "; build or install it";
}

/// Returns the names of the commands of an app, or of its options, with leading dashes.
std::vector<std::string> known_names(const CLI::App& app, bool are_options) {
  std::vector<std::string> result;
  if (are_options)
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames())
        result.push_back("--" + name);
  else
    for (const CLI::App* command : app.get_subcommands(nullptr))
      result.push_back(command->get_name());
  return result;
}

/// Returns the error message for the first unknown command or option, with the nearest known name,
/// or for an inequality that begins with '-'. Returns an empty string if there is none.
/// \param help the end of a message without a nearest name
std::string message_on_arguments(const CLI::App& app, int argc, char** argv,
                                 const std::string& help) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('='));
    if (argument.rfind("-", 0) == 0 && argument.rfind("--", 0) != 0 &&
        argument.find_first_of("<>") != std::string::npos)
      return "unexpected argument '" + argument +
             "'; write an inequality that begins with '-' in parentheses, like '(-x)<1'";
    const bool is_option = name.rfind("--", 0) == 0 && name.size() > 2;
    if (!is_option && (i > 1 || !chosen.empty()))
      continue;
    const std::vector<std::string> known = known_names(command, is_option);
    if (std::find(known.begin(), known.end(), name) != known.end())
      continue;
    const std::string nearest = dsc::nearest_name(name, known);
    return (name.rfind("-", 0) == 0 ? "unknown option '" : "unknown command '") + name + "'" +
           (nearest.empty() ? help : "; did you mean '" + nearest + "'?");
  }
  return "";
}

/// Reads the command line and runs its command, a subcommand of `app`. Prints the help if
/// requested.
/// \throws Usage_error if the command line is invalid; also throws the exceptions of the command
void run_command_line(CLI::App& app, int argc, char** argv) {
  if (argc < 2) {
    std::cout << app.help();
    return;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help, std::cout, std::cerr);
    return;
  } catch (const CLI::ParseError& error) {
    std::string command = "dsc";
    for (const CLI::App* chosen : app.get_subcommands())
      command += " " + chosen->get_name();
    const std::string help = "; see " + command + " --help",
                      message = message_on_arguments(app, argc, argv, help);
    throw dsc::Usage_error(message.empty() ? error.what() + help : message);
  }
}

struct Temporary_file_remover
{
  ~Temporary_file_remover() { dsc::remove_temporary_files(); }
};

} // namespace

int dsc::run_program(int argc, char** argv,
                     const std::function<void(CLI::App&, int&)>& add_commands) {
  const Temporary_file_remover temporary_files; // removed after messages, which may name them
  dsc::catch_signals();
  CGAL::set_error_handler(print_nothing);
  CGAL::set_warning_handler(print_nothing);
  try {
    CLI::App app("Deformable simplicial complexes: moving interfaces with topology changes", "dsc");
    app.require_subcommand(1);
    int exit_code = 0;
    add_commands(app, exit_code);
    dsc::Standard_streams streams(app);
    run_command_line(app, argc, argv);
    streams.write_output();
    return exit_code;
  } catch (const dsc::Other_program& other) {
    if (dsc::interrupted()) // the other program would not know
      return fail("interrupted; no result was written", stopped);
    std::cout.flush();
    return fail(execute(other, argv), bad_usage);
  } catch (const dsc::Usage_error& error) {
    return fail(error.what(), bad_usage);
  } catch (const DSC::Interrupted_error&) {
    return fail("interrupted; no result was written", stopped);
  } catch (const std::exception& error) {
    return fail(error_message(error), bad_input);
  } catch (...) {
    return fail("unknown error; check the input", bad_input);
  }
}

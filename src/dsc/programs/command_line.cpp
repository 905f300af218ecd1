// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/command_line.h"

#include "input/nearest_name.h"
#include "programs/errors.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace dsc {
namespace {

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
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
    const std::string nearest = nearest_name(name, known);
    return (name.rfind("-", 0) == 0 ? "unknown option '" : "unknown command '") + name + "'" +
           (nearest.empty() ? help : "; did you mean '" + nearest + "'?");
  }
  return "";
}

} // namespace

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
    throw Usage_error(message.empty() ? one_line(error.what()) + help : message);
  }
}

} // namespace dsc

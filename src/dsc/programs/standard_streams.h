// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_STANDARD_STREAMS_H
#define DSC_STANDARD_STREAMS_H

#include <CLI/CLI.hpp>

#include <string>

namespace dsc {

enum class File_role { input, output };

/// Lets the value of an option be `-`.
/// \param format extension of the files of an output; empty if the option `--to` gives it
CLI::Option* set_role(CLI::Option* option, File_role role, const std::string& format = "");

/// Add an option for the name of a file, or several names. A command finds a temporary file in the
/// place of `-`: a copy of standard input, or a file that is copied to standard output at the end.
template <class Path>
CLI::Option* add_input(CLI::App& command, const std::string& name, Path& path,
                       const std::string& description) {
  return set_role(command.add_option(name, path, description), File_role::input);
}

template <class Path>
CLI::Option* add_output(CLI::App& command, const std::string& name, Path& path,
                        const std::string& description, const std::string& format = "") {
  return set_role(command.add_option(name, path, description), File_role::output, format);
}

/// The standard streams of a program. While an output is `-`, all lines for standard output are
/// printed to the standard error, so that standard output contains only the file.
class Standard_streams
{
public:
  /// Adds the options `--from` and `--to` to the commands with inputs and outputs.
  explicit Standard_streams(CLI::App& app);

  /// Restores the streams for another program, which reads the same standard input.
  ~Standard_streams();

  /// Flushes the printed lines, and copies the output, if there is any, to standard output.
  /// \throws Input_error if not all bytes can be written
  void write_output();
};

} // namespace dsc

#endif // DSC_STANDARD_STREAMS_H

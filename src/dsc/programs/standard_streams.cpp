// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/standard_streams.h"

#include "input/formats.h"
#include "input/translations.h"
#include "programs/errors.h"
#include "programs/launcher.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace dsc {
namespace {

constexpr char standard[] = "-",
               cannot_write[] = "cannot write to standard output; check that the disk is not full "
                                "and that the program that reads the output is running";

/// The options for files of all commands, and what replaces `-` in the command that runs.
struct Streams
{
  std::map<const CLI::Option*, std::pair<File_role, std::string>> options; ///< roles and formats
  std::string from, to;                                                    ///< formats
  std::string input, output; ///< temporary files; empty for none
  int standard_output = -1;  ///< descriptor, while standard output is the standard error
} streams;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::string& path, const char* mode) {
  return {std::fopen(path.c_str(), mode), std::fclose};
}

/// Copies the rest of a file to another one.
void copy(std::FILE* from, std::FILE* to, const std::string& complaint) {
  std::array<char, 1 << 16> bytes;
  while (const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), from))
    if (to == nullptr || std::fwrite(bytes.data(), 1, size, to) != size)
      throw Input_error(complaint);
  if (std::ferror(from) != 0)
    throw Input_error("cannot read standard input; pipe a file into the program");
  if (to == nullptr || std::fflush(to) != 0)
    throw Input_error(complaint);
}

/// Returns a temporary file with the content of standard input.
std::string copy_of_input() {
  const std::string path = temporary_file("input");
  copy(stdin, open_file(path, "wbxe").get(),
       "cannot copy standard input to a temporary file; check that the disk is not full, or set "
       "TMPDIR to another folder");
  std::error_code error;
  if (std::filesystem::is_empty(path, error))
    throw Input_error("standard input is empty; pipe a file into the program");
  const std::string format = streams.from.empty() ? format_of_content(path) : streams.from;
  if (format.empty())
    throw Usage_error("--from is missing; the first bytes of standard input do not tell its "
                      "format, give it like --from off");
  const std::string result = temporary_file("input." + format);
  std::filesystem::rename(path, result, error);
  if (error)
    throw Input_error("cannot rename a temporary file (" + error.message() + "); set TMPDIR");
  name_in_messages(result, "standard input");
  return result;
}

/// Returns the option of a role with the value `-`; null if there is none.
/// \throws Usage_error if there are several
CLI::Option* find_standard(CLI::App& command, File_role role) {
  CLI::Option* result = nullptr;
  for (CLI::Option* const option : command.get_options({}))
    for (const std::string& value : option->results()) {
      const auto file = streams.options.find(option);
      if (value != standard || file == streams.options.end() || file->second.first != role)
        continue;
      if (result != nullptr)
        throw Usage_error(result->get_name() + " and " + option->get_name() +
                          " cannot both be -; name a file");
      result = option;
    }
  return result;
}

/// Replaces `-` in the values of an option.
void replace(CLI::Option* option, const std::string& path) {
  const std::vector<std::string> values = option->results();
  option->clear();
  for (const std::string& value : values)
    option->add_result(value == standard ? path : value);
  option->run_callback();
}

/// Checks an option for the format of `-`.
/// \param applies whether a value is `-`, and the format is not known
void require_format(const char* option, std::string& format, Use use, bool applies) {
  if (!format.empty() && !applies)
    throw Usage_error(std::string(option) + " applies only to -; leave it out");
  if (!format.empty() && format[0] == '.')
    format.erase(0, 1);
  if (!format.empty() && !has_format("file." + format, use, content::all, content::all))
    throw Usage_error(std::string(option) + " is no format of the program; write it like " +
                      option + " off");
}

/// Replaces `-` in the options of a command.
void replace_standard(CLI::App& command) {
  if (command.remaining_size() > 0)
    return; // an error, which is reported before standard input is read
  CLI::Option *const input = find_standard(command, File_role::input), *const output =
                                                                           find_standard(
                                                                               command,
                                                                               File_role::output);
  std::string format = output == nullptr ? "" : streams.options[output].second;
  require_format("--from", streams.from, Use::read, input != nullptr);
  require_format("--to", streams.to, Use::write, output != nullptr && format.empty());
  if ((input != nullptr || output != nullptr) && is_started_by_mpi())
    throw Usage_error("- applies only to a single process; name a file, or run dsc without mpirun");
  if (output != nullptr) {
    format += streams.to;
    if (format.empty())
      throw Usage_error("--to is missing; give the format of - like --to off");
    streams.output = temporary_file("output." + format);
    name_in_messages(streams.output, "standard output");
    streams.standard_output = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (streams.standard_output < 0)
      throw Input_error(cannot_write);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    replace(output, streams.output);
  }
  if (input != nullptr)
    replace(input, streams.input = copy_of_input());
}

/// Flushes the printed lines, and ends the redirection of standard output. Returns whether all
/// lines were written.
bool restore_output() {
  std::cout.flush();
  std::fflush(stdout);
  const bool result = std::cout.good() && std::ferror(stdout) == 0;
  if (const int descriptor = std::exchange(streams.standard_output, -1); descriptor >= 0) {
    dup2(descriptor, STDOUT_FILENO);
    close(descriptor);
  }
  return result;
}

} // namespace

CLI::Option* set_role(CLI::Option* option, File_role role, const std::string& format) {
  streams.options[option] = {role, format};
  return option;
}

Standard_streams::Standard_streams(CLI::App& app) {
  for (CLI::App* const command : app.get_subcommands(nullptr)) {
    command->parse_complete_callback([command] { replace_standard(*command); });
    command->add_option("--from", streams.from, "Format of standard input, like off");
    command->add_option("--to", streams.to, "Format of standard output, like stl");
  }
}

Standard_streams::~Standard_streams() {
  restore_output();
  if (const File input = open_file(streams.input, "rbe"))
    dup2(fileno(input.get()), STDIN_FILENO);
}

void Standard_streams::write_output() {
  if (!restore_output())
    throw Input_error(cannot_write);
  if (const File file = open_file(streams.output, "rbe")) // otherwise nothing was written
    copy(file.get(), stdout, cannot_write);
}

} // namespace dsc

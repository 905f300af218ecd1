// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/translations.h"

#include "input/claimed_folder.h"
#include "input/files.h"
#include "programs/interrupt.h"

#include <CGAL/Mesh_files/replace_file.h>

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

extern char** environ;

namespace dsc {
namespace fs = std::filesystem;
namespace {

/// The temporary files of this process.
struct Temporary_files
{
  std::string folder;                  ///< empty before the first file
  std::optional<Claimed_folder> claim; ///< of the folder
  int number = 0;
  std::map<std::string, std::string> translations; ///< by the name of the user
};

Temporary_files& temporary_files() {
  static Temporary_files files;
  return files;
}

/// Removes the temporary folders of this user that killed processes have left. Locks of other
/// processes are older than the shortest age, so that a new folder that is not yet locked stays.
void remove_abandoned_folders(const fs::path& parent) {
  static constexpr std::time_t shortest_age = 60; // seconds
  std::error_code error;
  fs::directory_iterator entry(parent, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string path = entry->path().string();
    struct stat status;
    if (lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == getuid() &&
        status.st_mtime + shortest_age < std::time(nullptr) && is_abandoned(path)) {
      std::error_code is_left;
      fs::remove_all(path, is_left);
    }
  }
}

/// Returns a new, empty folder.
std::string new_folder() {
  Temporary_files& files = temporary_files();
  std::error_code error;
  if (files.folder.empty()) {
    const fs::path parent = fs::temp_directory_path(error);
    if (error)
      throw Input_error("there is no folder for temporary files; set TMPDIR to a folder");
    std::string name = (parent / "dsc-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw Input_error("cannot create a temporary folder in " + parent.string() + ": " +
                        std::strerror(errno));
    files.folder = name;
    try {
      files.claim.emplace(name, Folder_kind::temporary);
    } catch (const Input_error&) { // names a folder that the user does not know
      throw Input_error("cannot create a file in the folder for temporary files, " +
                        parent.string() +
                        "; check that it has free space, and that the process may open more files");
    }
    remove_abandoned_folders(parent);
  }
  const fs::path result = fs::path(files.folder) / std::to_string(files.number++);
  fs::create_directory(result, error);
  if (error)
    throw Input_error("cannot create a temporary folder in " + files.folder + ": " +
                      error.message());
  return result.string();
}

/// Returns the content of a temporary file about a file of the user.
std::string content_of(const std::string& path, const std::string& file) {
  std::ifstream stream(path);
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream)
    throw Input_error("cannot read the answer of dsc-files for " + file +
                      "; check that TMPDIR names a folder with "
                      "free space, and that the process may open more files");
  return text;
}

/// Runs a program until it ends. Its output and messages are written to files.
/// \return its exit code; -1 if it crashed
int run_program_with(const std::vector<std::string>& arguments, const std::string& output,
                     const std::string& messages) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments)
    argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  static constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC, mode = 0600;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), flags, mode);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), flags, mode);
  pid_t child = 0;
  const int error = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::system_error(error, std::generic_category());
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!interrupted())
      continue;
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    throw DSC::Interrupted_error();
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Prints what a translation leaves out, and the choices that were made.
/// \param answer output of dsc-files after the name of the translation
void print_answer(const std::string& path, std::istream& answer) {
  Unused_content unused;
  const std::string unused_line = "unused ", note = "note ";
  for (std::string line; std::getline(answer, line);)
    if (line.compare(0, unused_line.size(), unused_line) == 0) {
      std::istringstream content(line.substr(unused_line.size()));
      std::size_t number = 1;
      if (std::isdigit(content.peek()) != 0)
        content >> number >> std::ws;
      std::string kind;
      std::getline(content, kind);
      unused.add(kind, number);
    } else if (line.compare(0, note.size(), note) == 0) {
      print_note(path, line.substr(note.size()));
    }
  print_unused(path, unused);
}

/// Runs `dsc-files` for a file. Returns what it prints.
std::string run_dsc_files(const std::string& path, std::vector<std::string> arguments) {
  require_program("dsc-files", path);
  const std::string program = path_of_program("dsc-files");
  arguments.insert(arguments.begin(), program);
  const std::string folder = new_folder(), output = folder + "/output",
                    messages = folder + "/messages";
  const int code = run_program_with(arguments, output, messages);
  if (code == 0)
    return content_of(output, path);
  static constexpr int cannot_start = 127; // exit code of the loader
  if (code == cannot_start)
    throw Input_error("cannot start the program dsc-files for " + path +
                      "; check that it is whole and that there is enough memory");
  std::string message = content_of(messages, path); // libraries may print lines before the last
  message.erase(message.find_last_not_of('\n') + 1);
  throw Input_error(path + ' ' +
                    (code < 0 || message.empty()
                         ? "crashes its reader or takes too long; is it damaged?"
                         : message.substr(message.rfind('\n') + 1)));
}

/// Translates a file by `dsc-files` with options, as pairs of a name and a value.
std::string translate_with(const std::string& path,
                           const std::vector<std::pair<std::string, std::string>>& options,
                           const std::function<bool(const std::string&)>& accepts) {
  Temporary_files& files = temporary_files();
  const auto known = files.translations.find(path);
  if (known != files.translations.end())
    return known->second;
  if (!exists(path))
    throw Input_error("cannot open " + path + "; check that the file exists and is readable");
  std::vector<std::string> arguments = {path, new_folder()};
  for (const auto& [name, value] : options)
    if (!value.empty())
      arguments.insert(arguments.end(), {name, value});
  std::istringstream answer(run_dsc_files(path, arguments));
  std::string translation;
  std::getline(answer, translation);
  if (translation.empty())
    throw Input_error("the program dsc-files gives no answer for " + path + "; is it damaged?");
  if (accepts && !accepts(translation))
    throw Input_error(path + " has content that this program does not read");
  print_answer(path, answer);
  files.translations[path] = translation;
  return translation;
}

bool is_silent = false;

} // namespace

std::string path_of_program(const std::string& name) {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error)
    throw std::runtime_error("cannot find the folder of this program: " + error.message());
  return (self.parent_path() / name).string();
}

void require_program(const std::string& name, const std::string& file) {
  if (!exists(path_of_program(name)))
    throw Input_error(file + " needs the program " + name +
                      ", which is built if VTK is found (Debian: libvtk9-dev); build it, or use "
                      "another format");
}

std::string translate(const std::string& path, const std::string& labels,
                      const std::string& thresholds,
                      const std::function<bool(const std::string&)>& accepts) {
  return translate_with(path, {{"--labels", labels}, {"--threshold", thresholds}}, accepts);
}

std::string translate_image(const std::string& path, bool has_channels) {
  return translate_with(path, {{"--values", has_channels ? "color" : "gray"}}, {});
}

void write_foreign(const std::string& input, const std::string& output, const std::string& like) {
  const std::string written = new_folder() + '/' + fs::path(output).filename().string();
  name_in_messages(written, output);
  std::vector<std::string> arguments = {"--write", input, written};
  if (!like.empty())
    arguments.push_back(like);
  run_dsc_files(output, arguments);
  DSC::replace_file(
      output, [&](std::ostream& out) { out << std::ifstream(written, std::ios::binary).rdbuf(); });
}

std::string with_user_names(std::string text) {
  for (const auto& [user, translation] : temporary_files().translations)
    for (std::size_t at = 0; (at = text.find(translation, at)) != std::string::npos;
         at += user.size())
      text.replace(at, translation.size(), user);
  return text;
}

std::vector<std::string> with_user_names(const std::vector<std::string>& texts) {
  std::vector<std::string> result;
  for (const std::string& text : texts)
    result.push_back(with_user_names(text));
  return result;
}

std::string printed_line(std::string text) {
  static constexpr std::size_t begin = 1000, end = 500;
  text = with_user_names(std::move(text));
  if (text.size() > begin + end)
    text.replace(begin, text.size() - begin - end, " ... ");
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '\n' || c == '\t' || c == '\r')
      text[i] = ' ';
    else if (c < ' ' || c == 0x7f || (0x80 <= c && c < 0xa0 && i > 0 && text[i - 1] == '\xc2'))
      text[i] = '?'; // also the control characters U+0080 to U+009F
  }
  return text;
}

void name_in_messages(const std::string& path, const std::string& name) {
  auto& names = temporary_files().translations;
  for (auto other = names.begin(); other != names.end();)
    other = other->second == path ? names.erase(other) : std::next(other);
  names[name] = path;
}

std::string temporary_file(const std::string& name) {
  const std::string result = new_folder() + '/' + name;
  name_in_messages(result, "the temporary file " + name + " in " +
                               fs::path(temporary_files().folder).parent_path().string());
  return result;
}

void remove_temporary_files() {
  Temporary_files& files = temporary_files();
  std::error_code error;
  // If the process may open few files, one folder can be opened at a time, or one without the lock.
  for (int round = 0; round < 2 && !files.folder.empty(); ++round) {
    for (int i = 0; i < files.number; ++i)
      fs::remove_all(fs::path(files.folder) / std::to_string(i), error);
    files.claim.reset();
  }
  if (!files.folder.empty())
    fs::remove(files.folder, error);
  files.folder.clear();
  files.translations.clear();
}

void print_note(const std::string& path, const std::string& text) {
  static std::set<std::string> printed;
  const std::string line = printed_line(path + ": " + text);
  if (!is_silent && printed.insert(line).second)
    std::cerr << "dsc: " << line << '\n';
}

void print_unused(const std::string& path, const Unused_content& unused) {
  if (!unused.empty())
    print_note(path, "not used: " + unused.text());
}

void keep_silent_about_unused() { is_silent = true; }

} // namespace dsc

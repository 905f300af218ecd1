// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/files.h"

#include "programs/errors.h"

#include <CGAL/Mesh_files/replace_file.h>

#include <unistd.h>

namespace dsc {
namespace fs = std::filesystem;
namespace {

/// Returns a canonical path of a file, which need not exist.
fs::path canonical(const std::string& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::path(path) : result;
}

} // namespace

std::string extension(const std::string& path) {
  std::string result = fs::path(path).extension().string();
  if (!result.empty())
    result.erase(0, 1);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

bool exists(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

void require_writable(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Input_error("'" + path + "' is not a regular file; choose another name");
  const DSC::internal::New_file probe(path); // results are written to a new file beside it
  DSC::internal::remove_partial_files(DSC::internal::folder_of(path));
}

void create_folder(const std::string& path) {
  if (path == "-")
    throw Usage_error("a folder cannot be -, which is standard output; choose a name");
  std::error_code error;
  std::vector<fs::path> parents; // of new folders
  for (fs::path folder = path; !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path())
    parents.push_back(DSC::internal::folder_of(folder.string()));
  fs::create_directories(path, error);
  for (const fs::path& parent : parents)
    DSC::internal::flush_folder(parent);
  if (error || !fs::is_directory(path, error))
    throw Input_error("cannot create the folder '" + path +
                      "'; check that no file has this name and that the parent folder is writable");
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return canonical(a) == canonical(b) || fs::equivalent(a, b, error);
}

void require_place(const std::string& option, const std::string& path,
                   const std::vector<std::string>& others) {
  if (path.empty())
    return;
  for (const std::string& other : others)
    if (!other.empty() && is_same_file(path, other))
      throw Usage_error(option + " would overwrite '" + path + "'; choose another name");
  require_writable(path);
}

std::string new_file(const std::string& stem, const std::string& extension) {
  std::string name = stem + extension;
  for (int number = 2;; ++number) {
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return name;
    }
    if (errno != EEXIST)
      throw Input_error("cannot create '" + name + "' in the working directory (" +
                        std::generic_category().message(errno) + "); check its permissions");
    name = stem + '_' + std::to_string(number) + extension;
  }
}

void remove_file(const std::string& path) {
  std::error_code error;
  fs::remove(path, error);
}

} // namespace dsc

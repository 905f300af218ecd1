// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/claimed_folder.h"

#include "input/files.h"
#include "input/translations.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/replace_file.h>

#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>

namespace dsc {
namespace {

/// Returns the path of the locked file of a folder.
std::string lock_of(const std::string& folder, Folder_kind kind) {
  return folder + (kind == Folder_kind::results ? "/.dsc-lock" : "/.dsc-temporary");
}

/// Returns a text of this process for others that find its lock.
std::string name_of_process() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string command((std::istreambuf_iterator<char>(file)), {});
  std::replace(command.begin(), command.end(), '\0', ' ');
  std::array<char, 256> host = {};
  gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(getpid()) + " on " + host.data() + ": " + command;
}

std::string content_of(int file) {
  static constexpr std::size_t most = 200; // bytes, enough to recognize a command
  std::array<char, most> bytes;
  const ssize_t size = pread(file, bytes.data(), bytes.size(), 0);
  std::string result(bytes.data(), std::size_t(std::max<ssize_t>(size, 0)));
  return result.substr(0, result.find_last_not_of(" \n") + 1);
}

/// Returns whether an open file still has a name.
bool has_name(int file, const std::string& path) {
  struct stat opened, named;
  return fstat(file, &opened) == 0 && lstat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// Opens and locks a file.
int locked_file(const std::string& folder, Folder_kind kind) {
  for (const std::string path = lock_of(folder, kind);;) {
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0)
      throw Input_error("cannot write in the folder '" + folder + "' (" +
                        std::generic_category().message(errno) +
                        "); check its permissions, or choose another one");
    if (flock(file, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) {
        const std::string owner = content_of(file);
        close(file);
        throw Input_error("another run writes in the folder '" + folder + "' (" + owner +
                          "); choose another folder, or wait until it ends");
      }
      if (kind == Folder_kind::results)
        print_note(folder,
                   "its file system has no locks; make sure that no other run writes there");
      return file;
    }
    if (has_name(file, path)) // its last owner may have removed it meanwhile
      return file;
    close(file);
  }
}

} // namespace

Claimed_folder::Claimed_folder(const std::string& path, Folder_kind kind)
    : m_path(path), m_lock_path(lock_of(path, kind)) {
  create_folder(path);
  m_lock = locked_file(path, kind);
  const std::string owner = name_of_process() + '\n';
  // On a full disk, the lock holds without the text, and the first result complains.
  [[maybe_unused]] const bool has_text =
      ftruncate(m_lock, 0) == 0 && pwrite(m_lock, owner.data(), owner.size(), 0) > 0;
  DSC::internal::remove_partial_files(path);
}

Claimed_folder::~Claimed_folder() {
  if (has_name(m_lock, m_lock_path))
    unlink(m_lock_path.c_str());
  close(m_lock);
}

void Claimed_folder::require() const {
  if (!has_name(m_lock, m_lock_path))
    throw Input_error("the folder '" + m_path +
                      "' was removed or replaced during the run; choose another folder");
}

std::string Claimed_folder::file(const std::string& name) const {
  return (std::filesystem::path(m_path) / name).string();
}

bool is_abandoned(const std::string& path) {
  const int file =
      open(lock_of(path, Folder_kind::temporary).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0)
    return false;
  const bool result = flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  return result;
}

} // namespace dsc

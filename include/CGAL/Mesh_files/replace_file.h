// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_REPLACE_FILE_H
#define CGAL_MESH_FILES_REPLACE_FILE_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <fcntl.h>
#include <sys/stat.h>
#ifdef _WIN32
#include <io.h>
#include <share.h>
#else
#include <sys/file.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <ios>
#include <locale>
#include <ostream>
#include <random>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The names of files that are not complete: a prefix and hexadecimal digits.
inline constexpr std::string_view partial_prefix = ".partial-";
inline constexpr std::size_t partial_digits = 16;

inline bool is_partial_name(std::string_view name) {
  return name.size() == partial_prefix.size() + partial_digits &&
         name.substr(0, partial_prefix.size()) == partial_prefix &&
         name.find_first_not_of("0123456789abcdef", partial_prefix.size()) == name.npos;
}

inline std::filesystem::path folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder;
}

#ifdef _WIN32
// Opens a file that no other process can open until it is closed. Returns a negative number if this
// is not possible.
inline int open_alone(const std::filesystem::path& path, int flags) {
  int file = -1;
  _wsopen_s(&file, path.c_str(), flags | _O_RDWR | _O_BINARY | _O_NOINHERIT, _SH_DENYRW,
            _S_IREAD | _S_IWRITE);
  return file;
}

inline int close(int file) { return _close(file); }
inline int write(int file, const char* text, unsigned n) { return _write(file, text, n); }
inline void flush_folder(const std::filesystem::path& /*path*/) {} // Windows has no such function
#else
using ::close;
using ::write;

// Writes the names in a folder to the disk, if the file system can.
inline void flush_folder(const std::filesystem::path& path) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0)
    return;
  ::fsync(folder);
  ::close(folder);
}
#endif

// A file that is written beside a target, and then replaces it. Otherwise it is removed at the end
// of the scope. Its name is not predictable, and links are not followed. The file is locked, so
// that others can tell whether its writer is alive.
class New_file : public std::streambuf
{
public:
  explicit New_file(const std::string& target) : m_target(target), m_buffer(std::size_t(1) << 16) {
    while (!create())
      ;
    setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
  }

  New_file(const New_file&) = delete;
  New_file& operator=(const New_file&) = delete;

  ~New_file() override {
    if (m_file >= 0)
      close(m_file);
    std::error_code error;
    if (!m_path.empty())
      std::filesystem::remove(m_path, error);
  }

  // Replaces the target. After a loss of power, there is the new file or, during this function, the
  // old one.
  void replace_target() {
    write_buffer();
#ifdef _WIN32
    std::error_code error;
    if (_commit(m_file) != 0 || close(std::exchange(m_file, -1)) != 0)
      fail();
    std::filesystem::rename(m_path, m_target, error); // open files cannot be renamed
    if (error)
      fail(error.message());
#else
    if (::fsync(m_file) != 0 || ::rename(m_path.c_str(), m_target.c_str()) != 0)
      fail();
#endif
    m_path.clear();
    flush_folder(folder_of(m_target));
  }

protected:
  int_type overflow(int_type c) override {
    write_buffer();
    if (!traits_type::eq_int_type(c, traits_type::eof()))
      sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

  int sync() override {
    write_buffer();
    return 0;
  }

private:
  // Creates the file. Returns false if its name exists, or if another process took the file for an
  // abandoned one before it was locked. On Windows, it is created locked.
  bool create() {
    std::random_device random;
    char digits[partial_digits + 1];
    std::snprintf(digits, sizeof digits, "%08x%08x", random(), random());
    m_path = (folder_of(m_target) / partial_prefix).string() + digits;
#ifdef _WIN32
    m_file = open_alone(m_path, _O_CREAT | _O_EXCL);
#else
    m_file = ::open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
#endif
    if (m_file < 0 && errno != EEXIST)
      fail();
#ifdef _WIN32
    return m_file >= 0;
#else
    struct stat status;
    if (m_file >= 0 && (flock(m_file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) &&
        fstat(m_file, &status) == 0 && status.st_nlink > 0)
      return true;
    ::close(m_file);
    return false;
#endif
  }

  void write_buffer() {
    Progress_scope::check(); // writing is interruptible
    for (const char* text = pbase(); text != pptr();) {
      const auto written = write(m_file, text, static_cast<unsigned>(pptr() - text)); // 64 KB
      if (written >= 0)
        text += written;
      else if (errno != EINTR)
        fail();
    }
    setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
  }

  [[noreturn]] void fail() const { fail(std::generic_category().message(errno)); }

  [[noreturn]] void fail(const std::string& cause) const {
    throw File_error("cannot write " + m_target + " (" + cause +
                         "): check that the folder exists, is writable and has free space",
                     m_target);
  }

  std::string m_target, m_path; // no path after the target was replaced
  std::vector<char> m_buffer;
  int m_file = -1;
};

// Removes what processes that were killed while writing have left in a folder.
inline void remove_partial_files(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    if (!is_partial_name(path.filename().string()))
      continue;
#ifdef _WIN32
    const int file = open_alone(path, 0);
    if (file < 0)
      continue;
    close(file);
    std::error_code failure; // another process may have removed it
    std::filesystem::remove(path, failure);
#else
    const int file = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
      continue;
    if (flock(file, LOCK_EX | LOCK_NB) == 0)
      ::unlink(path.c_str());
    ::close(file);
#endif
  }
}

} // namespace internal

/*!
\ingroup PkgMeshFilesRef

Writes a file by a stream, and then replaces an older file of the same name. The older file thus
stays complete until the new one is, also if the process is killed or the machine loses power: the
new file has a name that cannot be predicted, in the same folder, and is on the disk before it is
renamed. A link with the name of the file is replaced, not followed.

\param path the path of the file
\param write `write(stream)` takes a binary `std::ostream` in the classic locale. Writing stops if
       the callback of a `Progress_scope` returns `false`.
\throws File_error if the file cannot be written, or `path` is no regular file. The older file is
        then unchanged, as after an exception of `write`.
\throws Interrupted_error if the callback returns `false`; the older file is then unchanged
*/
template <class Write> void replace_file(const std::string& path, const Write& write) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw File_error(path + " is not a regular file: choose another name", path);
  internal::New_file file(path);
  std::ostream out(&file);
  out.imbue(std::locale::classic());
  out.exceptions(std::ios::badbit); // otherwise the stream would swallow exceptions of the file
  write(out);
  if (!out)
    throw File_error("cannot write all of " + path + ": check its content", path);
  file.replace_target();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_REPLACE_FILE_H

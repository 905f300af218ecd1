// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_REPLACE_FILE_H
#define CGAL_MESH_FILES_REPLACE_FILE_H

#include <CGAL/license/Mesh_files.h>

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ios>
#include <locale>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Removes a file at the end of the scope, unless the file was renamed before.
struct Temporary_file
{
  std::filesystem::path path;

  ~Temporary_file() {
    std::error_code nothing_to_remove;
    std::filesystem::remove(path, nothing_to_remove);
  }
};

// Returns the path of a file that does not exist, in the folder of `path` and with its extension.
inline std::filesystem::path unused_name(const std::filesystem::path& path) {
  std::string stem = path.stem().string() + ".partial";
  std::filesystem::path result;
  std::error_code error;
  do {
    result = path.parent_path() / (stem + path.extension().string());
    stem += '~';
  } while (std::filesystem::exists(result, error));
  return result;
}

// A file buffer that makes writing interruptible.
class Stoppable_filebuf : public std::filebuf
{
protected:
  int_type overflow(int_type c) override {
    Progress_scope::check();
    return std::filebuf::overflow(c);
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    static constexpr std::streamsize most = 1 << 20; // bytes at once, written within milliseconds
    std::streamsize done = 0;
    while (done < size) {
      Progress_scope::check();
      const std::streamsize part = (std::min)(most, size - done),
                            written = std::filebuf::xsputn(text + done, part);
      done += written;
      if (written < part)
        break;
    }
    return done;
  }
};

} // namespace internal

/*!
\ingroup PkgMeshFilesRef

Writes a file and then replaces an older file of the same name. The older file thus stays complete
until the new one is complete.

\param path the path of the file
\param write `write(temporary_path)` writes a file beside `path` and returns whether it is complete.
       The temporary file has the same extension, because formats depend on it.
\throws File_error if the file cannot be written. The older file is then unchanged, as after an
        exception of `write`.
*/
template <class Write> void replace_file(const std::string& path, Write write) {
  const std::filesystem::path target(path);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw File_error(path + " is not a regular file: choose another name", path);
  const internal::Temporary_file temporary{internal::unused_name(target)};
  if (!write(temporary.path.string()))
    throw File_error("cannot write " + path +
                         ": check that the folder exists, is writable and has free space",
                     path);
  std::filesystem::rename(temporary.path, target, error);
  if (error)
    throw File_error("cannot replace " + path + " by the file just written: " + error.message(),
                     path);
}

/*!
\ingroup PkgMeshFilesRef

Writes a file by a stream, as `replace_file()` does.

\param path the path of the file
\param write `write(stream)` takes a binary `std::ostream` in the classic locale. Writing stops if
       the callback of a `Progress_scope` returns `false`.
\throws File_error as `replace_file()` does
\throws Interrupted_error if the callback returns `false`; the older file is then unchanged
*/
template <class Write> void replace_file_by_stream(const std::string& path, Write write) {
  replace_file(path, [&](const std::string& temporary) {
    internal::Stoppable_filebuf file;
    if (!file.open(temporary, std::ios::out | std::ios::binary))
      return false;
    std::ostream out(&file);
    out.imbue(std::locale::classic());
    out.exceptions(std::ios::badbit); // otherwise the stream would swallow exceptions of the file
    try {
      write(out);
    } catch (const std::ios_base::failure&) {
      return false;
    }
    return file.close() != nullptr && out.good();
  });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_REPLACE_FILE_H

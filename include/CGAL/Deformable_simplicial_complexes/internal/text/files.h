// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_FILES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_FILES_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/open_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <locale>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Returns a word of a file in quotes, shortened, for a message of one line.
inline std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40; // characters, enough to identify the word
  std::string result(text.substr(0, longest));
  for (char& c : result)
    c = static_cast<unsigned char>(c) < ' ' || c == '\177' ? '?' : c;
  return "'" + result + "'";
}

// Returns the extension of a path in lower case, with the dot.
inline std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

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

// Calls `write(temporary_path)` to write a file beside `path`. If `write` returns `true`, the file
// is renamed to `path`. So an older file stays complete until the new one is complete. The
// temporary file has the same extension, because formats depend on it.
template <class Write> void replace_file(const std::string& path, Write write) {
  const std::filesystem::path target(path);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw File_error(path + " is not a regular file: choose another name", path);
  const Temporary_file temporary{unused_name(target)};
  if (!write(temporary.path.string()))
    throw File_error("cannot write " + path +
                         ": check that the folder exists, may be written to and has space left",
                     path);
  std::filesystem::rename(temporary.path, target, error);
  if (error)
    throw File_error("cannot replace " + path + " by the file just written: " + error.message(),
                     path);
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

// Calls `write(stream)` with a binary stream in the classic locale, and replaces the file as
// replace_file() does.
template <class Write> void replace_file_by_stream(const std::string& path, Write write) {
  replace_file(path, [&](const std::string& temporary) {
    Stoppable_filebuf file;
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

// Returns the content of a file without a byte order mark. The memory is bounded by the size of the
// file. Throws File_error as open_input() does.
inline std::string file_contents(const std::string& path) {
  std::ifstream in = open_input(path, lower_case_extension(path));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::string bytes(error ? 0 : static_cast<std::size_t>(size), '\0');
  if (error || !in.read(&bytes[0], static_cast<std::streamsize>(size)))
    throw File_error("cannot read " + path + " to its end", path);
  remove_byte_order_mark(bytes);
  return bytes;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_FILES_H

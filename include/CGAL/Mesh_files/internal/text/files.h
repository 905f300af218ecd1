// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_FILES_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_FILES_H

#include <CGAL/Mesh_files/File_error.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <sstream>
#include <string_view>
#include <system_error>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The bytes that some editors write at the beginning of UTF-8 text.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Removes the byte order mark from the beginning of a text.
inline void remove_byte_order_mark(std::string& text) {
  if (text.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
    text.erase(0, byte_order_mark.size());
}

// The first bytes of a format, the file extension, and the name of the format.
struct File_signature
{
  std::string_view bytes;
  std::string_view extension; // empty for unsupported formats
  const char* kind;           // and for unsupported formats, what to do
};

// Returns the format with these first bytes of a file; null if it is unknown.
inline const File_signature* find_signature(std::string_view begin) {
  static constexpr File_signature signatures[] = {
      {"\x1f\x8b", "", "compressed with gzip; decompress it with gunzip"},
      {"BZh", "", "compressed with bzip2; decompress it with bunzip2"},
      {"\xfd\x37zXZ", "", "compressed with xz; decompress it with unxz"},
      {"\x28\xb5\x2f\xfd", "", "compressed with zstd; decompress it with unzstd"},
      {"PK\x03\x04", "", "a zip archive; unpack it"},
      {"\xff\xfe", "", "text in UTF-16; save it in UTF-8"},
      {"\xfe\xff", "", "text in UTF-16; save it in UTF-8"},
      {"$MeshFormat", "", "a Gmsh mesh; export it from Gmsh in another format, such as .mesh"},
      {"# vtk DataFile", "", "a legacy VTK file; write it as .vtu"},
      {"\x89HDF", "", "an HDF5 file; write another format"},
      {"glTF", "", "a binary glTF file; write a surface as .ply or .obj"},
      {"ply\n", ".ply", "a PLY file"},
      {"ply\r", ".ply", "a PLY file"},
      {"OFF", ".off", "an OFF file"},
      {"solid ", ".stl", "an STL file"},
      {"MeshVersionFormatted", ".mesh", "a MEDIT mesh"},
      {"#INRIMAGE-4", ".inr", "an INR image"},
      {"\x89PNG", ".png", "a PNG image"}};
  for (const File_signature& signature : signatures)
    if (begin.compare(0, signature.bytes.size(), signature.bytes) == 0)
      return &signature;
  return nullptr;
}

// A file buffer that throws File_error if the disk cannot be read. Otherwise readers would take the
// error for the end of the file.
class Input_buffer : public std::filebuf
{
public:
  explicit Input_buffer(std::string path) : m_path(std::move(path)) {}

protected:
  int_type underflow() override {
    return checked([&] { return std::filebuf::underflow(); });
  }
  std::streamsize xsgetn(char* bytes, std::streamsize n) override {
    return checked([&] { return std::filebuf::xsgetn(bytes, n); });
  }

private:
  template <class Read> auto checked(const Read& read) -> decltype(read()) {
    try {
      return read();
    } catch (const std::ios_base::failure& error) {
      throw File_error("cannot read " + m_path + " to its end (" + error.code().message() +
                           "): check the disk",
                       m_path);
    }
  }

  std::string m_path;
};

// A file of the format with the given extension, such as ".off".
class Input_file : public std::istream
{
public:
  // Throws File_error if there is no regular file that can be read, if it is empty, or if its first
  // bytes belong to another format. A byte order mark is not skipped.
  Input_file(const std::string& path, std::string_view extension)
      : std::istream(nullptr), m_buffer(path) {
    open(path);
    rdbuf(&m_buffer);
    exceptions(std::ios::badbit); // passes exceptions of the buffer on
    constexpr std::size_t longest_signature = 32;
    std::string begin(longest_signature, '\0');
    read(&begin[0], static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(gcount()));
    require_format(path, begin, extension);
    clear();
    seekg(0);
  }

private:
  void open(const std::string& path) {
    const auto cannot_open = [&](const char* what) {
      throw File_error("cannot open " + path + ": " + what, path);
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
      cannot_open("it does not exist; check the name");
    if (std::filesystem::is_directory(status))
      cannot_open("it is a folder; name a file in it");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
      cannot_open("it is not a regular file; copy its content into a regular file");
    if (!m_buffer.open(path, std::ios::in | std::ios::binary))
      cannot_open("check its permissions");
  }

  static void require_format(const std::string& path, std::string begin,
                             std::string_view extension) {
    const auto fail = [&](const std::string& what) { throw File_error(path + " " + what, path); };
    if (begin.empty())
      fail("is empty; write it again");
    remove_byte_order_mark(begin);
    const File_signature* const signature = find_signature(begin);
    if (!signature || (!signature->extension.empty() && signature->extension == extension))
      return;
    const bool has_its_name = std::filesystem::path(path).extension() == signature->extension;
    fail(std::string("is ") + signature->kind +
         (signature->extension.empty() ? std::string()
          : has_its_name ? "; choose a file with the extension " + std::string(extension)
                         : "; rename it to " + std::string(signature->extension)));
  }

  Input_buffer m_buffer;
};

// Returns why the content of a file is not accepted, as the end of a message about the file; empty
// if it is. The content is what the file decompresses to, or what its header promises, in bytes. So
// the size of the file bounds the memory.
inline std::string why_too_large(double content, double bytes_of_file) {
  static constexpr double always = 160e6;      // bytes; images of labels need five times as much
  static constexpr double most_per_byte = 100; // compressed images of labels have less or are small
  if (content <= always + most_per_byte * bytes_of_file)
    return "";
  std::ostringstream text;
  text << "has " << content / 1e9 << " GB of content in " << bytes_of_file / 1e6
       << " MB, more than is accepted (" << always / 1e6 << " MB, and " << most_per_byte
       << " times the file); write it without compression, unless it is damaged";
  return text.str();
}

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

// Returns the content of a file without a byte order mark. The memory is bounded by the size of the
// file. Throws File_error as Input_file does.
inline std::string file_contents(const std::string& path) {
  Input_file in(path, lower_case_extension(path));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::string bytes(error ? 0 : static_cast<std::size_t>(size), '\0');
  if (error || !in.read(&bytes[0], static_cast<std::streamsize>(size)))
    throw File_error("cannot read " + path + " to its end", path);
  remove_byte_order_mark(bytes);
  return bytes;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_FILES_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace dsc_files {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail() {
  throw Failure("is truncated: it lacks bytes that its header announces");
}

/// Returns the number of bytes of a value of MetaImage; 0 for unknown types.
std::uint64_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::uint64_t> bytes = {
      {"MET_CHAR", 1},  {"MET_UCHAR", 1},     {"MET_SHORT", 2},      {"MET_USHORT", 2},
      {"MET_INT", 4},   {"MET_UINT", 4},      {"MET_LONG", 4},       {"MET_ULONG", 4},
      {"MET_FLOAT", 4}, {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_DOUBLE", 8}};
  const auto found = bytes.find(type);
  return found == bytes.end() ? 0 : found->second;
}

std::uint64_t header_number(const std::string& text) {
  std::istringstream in(text);
  std::uint64_t result = 0;
  if (!(in >> result))
    throw Failure("has a header in which '" + text + "' stands for a number");
  return result;
}

void require_complete_meta_image(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::map<std::string, std::string> header;
  // ElementDataFile is the last line.
  for (std::string line; header.count("ElementDataFile") == 0 && std::getline(file, line);) {
    const std::size_t mark = line.find('=');
    if (mark == std::string::npos)
      throw Failure("has a line without '=' in its header; is it damaged?");
    std::istringstream key(line.substr(0, mark));
    std::string name;
    key >> name;
    std::string value = line.substr(mark + 1);
    value.erase(0, value.find_first_not_of(" \t"));
    value.erase(value.find_last_not_of(" \t\r") + 1);
    header[name] = value;
  }
  std::uint64_t bytes = bytes_of(header["ElementType"]);
  std::istringstream sizes(header["DimSize"]);
  for (std::uint64_t size = 0; sizes >> size;)
    bytes *= size;
  if (header.count("ElementNumberOfChannels") > 0)
    bytes *= header_number(header["ElementNumberOfChannels"]);
  const bool is_compressed = header["CompressedData"] == "True";
  if (is_compressed)
    bytes =
        header.count("CompressedDataSize") > 0 ? header_number(header["CompressedDataSize"]) : 0;
  const std::string data = header["ElementDataFile"];
  if (data.empty())
    throw Failure("has no ElementDataFile in its header; is it truncated?");
  if (data == "LIST" || data.find('%') != std::string::npos)
    throw Failure("has its data in several files; write one file");
  const bool is_local = data == "LOCAL";
  const std::uint64_t begin = is_local ? std::uint64_t(file.tellg()) : 0;
  const fs::path place = is_local ? fs::path(path) : fs::path(path).parent_path() / data;
  std::error_code error;
  const std::uint64_t size = fs::file_size(place, error);
  if (error)
    throw Failure("has its data in the file " + data + ", which cannot be opened");
  if (size < begin + bytes)
    fail();
}

/// The numbers of a TIFF file (TIFF 6.0, and BigTIFF with 64 bits).
class Tiff_file
{
public:
  explicit Tiff_file(const std::string& path)
      : m_file(path, std::ios::binary), m_size(fs::file_size(path)) {
    char order[2];
    m_file.read(order, 2);
    m_is_big_endian = order[0] == 'M';
    m_is_big = number(2, 2) == 43;
  }

  /// Checks that all directories, and the strips or tiles of their images, are in the file.
  void require_complete() {
    std::set<std::uint64_t> known;
    const std::uint64_t word = m_is_big ? 8 : 4;
    for (std::uint64_t at = number(m_is_big ? 8 : 4, word); at != 0;) {
      if (!known.insert(at).second)
        throw Failure("contains a cycle of image directories; is it damaged?");
      const std::uint64_t count_size = m_is_big ? 8 : 2, entry_size = m_is_big ? 20 : 12,
                          entries = number(at, count_size);
      const std::uint64_t first = at + count_size;
      if (entries > m_size / entry_size)
        fail();
      std::vector<std::uint64_t> places, sizes;
      for (std::uint64_t i = 0; i < entries; ++i) {
        const std::uint64_t entry = first + i * entry_size, tag = number(entry, 2);
        if (tag == strip_offsets || tag == tile_offsets)
          places = values(entry);
        else if (tag == strip_sizes || tag == tile_sizes)
          sizes = values(entry);
      }
      for (std::size_t i = 0; i < places.size() && i < sizes.size(); ++i)
        if (sizes[i] > m_size || places[i] > m_size - sizes[i])
          fail();
      at = number(first + entries * entry_size, word);
    }
  }

private:
  static constexpr std::uint64_t strip_offsets = 273, strip_sizes = 279, tile_offsets = 324,
                                 tile_sizes = 325;

  std::uint64_t number(std::uint64_t at, std::uint64_t bytes) {
    if (bytes > m_size || at > m_size - bytes)
      fail();
    unsigned char buffer[8];
    m_file.seekg(std::streamoff(at));
    m_file.read(reinterpret_cast<char*>(buffer), std::streamsize(bytes));
    std::uint64_t result = 0;
    for (std::uint64_t i = 0; i < bytes; ++i)
      result = result * 256 + buffer[m_is_big_endian ? i : bytes - 1 - i];
    return result;
  }

  /// Returns the values of an entry of a directory: inside of the entry or at another place.
  std::vector<std::uint64_t> values(std::uint64_t entry) {
    const std::uint64_t type = number(entry + 2, 2), word = m_is_big ? 8 : 4,
                        count = number(entry + 4, word),
                        bytes = type == 3    ? 2
                                : type == 16 ? 8
                                             : 4; // SHORT, LONG8 or LONG
    if (count > m_size / bytes)
      fail();
    const std::uint64_t inside = entry + 4 + word,
                        begin = count * bytes <= word ? inside : number(inside, word);
    std::vector<std::uint64_t> result;
    for (std::uint64_t i = 0; i < count; ++i)
      result.push_back(number(begin + i * bytes, bytes));
    return result;
  }

  std::ifstream m_file;
  std::uint64_t m_size;
  bool m_is_big_endian = false, m_is_big = false;
};

/// Returns the numbers of cells of the extents with a name in an XML file, at least one along each
/// axis.
double cells_of_extents(const std::string& text, const std::string& name) {
  double result = 0;
  for (std::size_t at = 0; (at = text.find(name + "=\"", at)) != std::string::npos;) {
    at += name.size() + 2;
    std::istringstream numbers(text.substr(at, text.find('"', at) - at));
    double cells = 1, first = 0, last = 0;
    while (numbers >> first >> last)
      cells *= std::max(1., last - first);
    result += cells;
  }
  return result;
}

/// VTK leaves the values of an image undefined where there is no piece.
void require_all_pieces(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  const std::string text = content.str(), markup = text.substr(0, text.find("<AppendedData"));
  if (cells_of_extents(markup, " Extent") != cells_of_extents(markup, "WholeExtent"))
    throw Failure("has pieces that do not cover its extent; write one piece");
}

} // namespace

void require_complete(const std::string& path, const std::string& format) {
  if (format == "mha" || format == "mhd")
    require_complete_meta_image(path);
  else if (format == "vti" || format == "vtr" || format == "vts")
    require_all_pieces(path);
  else if (format == "tif" || format == "tiff")
    Tiff_file(path).require_complete();
}

} // namespace dsc_files

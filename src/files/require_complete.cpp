// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <CGAL/Mesh_files/internal/text/files.h>

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>

namespace dsc_files {
namespace {

namespace fs = std::filesystem;
using CGAL::Deformable_simplicial_complexes::internal::in_quotes;

[[noreturn]] void fail() {
  throw Failure("is truncated: it lacks bytes that its header announces");
}

/// Returns the number of bytes of a value of MetaImage.
std::uint64_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::uint64_t> bytes = {
      {"MET_CHAR", 1},  {"MET_UCHAR", 1},     {"MET_SHORT", 2},      {"MET_USHORT", 2},
      {"MET_INT", 4},   {"MET_UINT", 4},      {"MET_LONG", 4},       {"MET_ULONG", 4},
      {"MET_FLOAT", 4}, {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_DOUBLE", 8}};
  const auto found = bytes.find(type);
  if (found == bytes.end())
    throw Failure("has no known ElementType in its header; write MET_SHORT, for example");
  return found->second;
}

/// Returns the positive integers in a value of a header.
std::vector<std::uint64_t> header_numbers(const std::string& text,
                                          std::uint64_t largest = (1U << 31) - 1) {
  std::istringstream in(text);
  std::vector<std::uint64_t> result;
  bool is_valid = true;
  for (std::string word; in >> word;) {
    result.push_back(std::strtoull(word.c_str(), nullptr, 10));
    is_valid = is_valid && word.find_first_not_of("0123456789") == word.npos && 0 < result.back() &&
               result.back() <= largest;
  }
  if (!is_valid || result.empty())
    throw Failure("has a header in which " + in_quotes(text) +
                  " stands for positive integers; correct it");
  return result;
}

void require_complete_meta_image(const std::string& path) {
  static constexpr std::size_t longest = 255; // bytes with the end of a text; VTK crashes at more
  std::ifstream file(path, std::ios::binary);
  std::map<std::string, std::string> header;
  // ElementDataFile is the last line.
  for (std::string line; header.count("ElementDataFile") == 0 && std::getline(file, line);) {
    const std::size_t mark = line.find_first_of("=:");
    if (mark == std::string::npos || line[mark] == ':')
      throw Failure("has a line without '=' in its header; is it damaged?");
    std::istringstream key(line.substr(0, mark));
    std::string name;
    key >> name;
    std::string value = line.substr(mark + 1);
    value.erase(0, value.find_first_not_of(" \t"));
    value.erase(value.find_last_not_of(" \t\r") + 1);
    if (std::max(mark + 1, line.size() - mark) > longest)
      throw Failure("has a line in its header that is too long for VTK; shorten it to " +
                    std::to_string(longest) + " characters");
    header[name] = value;
  }
  std::uint64_t bytes = bytes_of(header["ElementType"]);
  const std::vector<std::uint64_t> sizes = header_numbers(header["DimSize"]);
  if (header_numbers(header["NDims"]) != std::vector<std::uint64_t>{sizes.size()} ||
      sizes.size() > 4)
    throw Failure("has another number of sizes than NDims in its header; correct it");
  for (const std::uint64_t size : sizes)
    bytes *= size;
  if (header.count("ElementNumberOfChannels") > 0)
    bytes *= header_numbers(header["ElementNumberOfChannels"]).front();
  const bool is_compressed = header["CompressedData"] == "True";
  if (is_compressed)
    bytes = header.count("CompressedDataSize") > 0
                ? header_numbers(header["CompressedDataSize"], std::uint64_t(1) << 40).front()
                : 0;
  const std::string data = header["ElementDataFile"];
  if (data.empty())
    throw Failure("has no ElementDataFile in its header; is it truncated?");
  const bool is_local = data == "LOCAL";
  const std::uint64_t begin = is_local ? std::uint64_t(file.tellg()) : 0;
  if (fs::file_size(is_local ? fs::path(path) : fs::path(path).parent_path() / data) <
      begin + bytes)
    fail();
}

/// Decodes a PNG picture, and checks its chunks up to the last one. The reader of VTK crashes after
/// an error.
void require_valid_png(const std::string& path) {
  static constexpr std::size_t signature = 8, type = 4; // bytes
  std::ifstream file(path, std::ios::binary);
  file.seekg(signature);
  for (std::string chunk; chunk.compare(0, type, "IEND") != 0;) {
    const auto number = [&] {
      unsigned char bytes[4] = {};
      file.read(reinterpret_cast<char*>(bytes), 4);
      return std::uint32_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
    };
    chunk.resize(type + std::min<std::uintmax_t>(number(), fs::file_size(path)));
    if (!file.read(chunk.data(), std::streamsize(chunk.size())) ||
        number() != crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), uInt(chunk.size())))
      throw Failure("is a damaged PNG picture; write it again");
  }
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) != 0) {
    accept_content(PNG_IMAGE_PIXEL_SIZE(image.format) * double(image.width) * image.height,
                   double(fs::file_size(path)));
    std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  }
  const std::string error = PNG_IMAGE_FAILED(image) ? image.message : "";
  png_image_free(&image);
  if (!error.empty())
    throw Failure("is a damaged PNG picture: " + error);
}

/// Checks the header of a portable map. The reader of VTK does not end if a number is missing.
void require_valid_pnm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic, numbers;
  file >> magic;
  for (int i = 0; i < 3; ++i) {
    for (std::string comment; file >> std::ws && file.peek() == '#';)
      std::getline(file, comment);
    std::string word;
    file >> word;
    numbers += word + ' ';
  }
  if (header_numbers(numbers).size() != 3)
    throw Failure("has no width, height and largest value at its beginning; is it damaged?");
}

/// Checks the header of a NRRD file. The reader of VTK does not end, or crashes, if it is damaged.
void require_valid_nrrd(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line, sizes, dimension;
  std::getline(file, line); // with the version
  if (line.size() < 8 || line.compare(0, 7, "NRRD000") != 0 || line.find('\0') != line.npos)
    throw Failure("does not begin with NRRD0001 to NRRD0005; is it damaged?");
  while (std::getline(file, line) && !line.empty() && line != "\r") {
    if (line.find('\0') != line.npos || (line[0] != '#' && line.find(':') == line.npos))
      throw Failure("has a line without ':' in its header; is it damaged?");
    if (line.compare(0, 6, "sizes:") == 0)
      sizes = line.substr(6);
    if (line.compare(0, 10, "dimension:") == 0)
      dimension = line.substr(10);
  }
  if (!file)
    throw Failure("has a header without an empty line at its end; is it truncated?");
  const std::size_t n = header_numbers(sizes).size();
  if (header_numbers(dimension) != std::vector<std::uint64_t>{n} || n > 4)
    throw Failure("has another number of sizes than its dimension; correct its header");
}

/// Checks the numbers of a NIfTI header, or of the older Analyze header. The reader of VTK does not
/// end, or writes outside of its arrays, if the sizes are not positive or the number of bits is
/// wrong.
void require_valid_nifti(const std::string& path) {
  static const std::map<int, int> bits_of_type = {{2, 8},    {4, 16},    {8, 32},    {16, 32},
                                                  {64, 64},  {128, 24},  {256, 8},   {512, 16},
                                                  {768, 32}, {1024, 64}, {1280, 64}, {2304, 32}};
  std::string bytes(540, '\0');                   // of the second version; the first one has 348
  const gzFile file = gzopen(path.c_str(), "rb"); // also reads what is not compressed
  const int n = file == nullptr ? 0 : gzread(file, bytes.data(), unsigned(bytes.size()));
  gzclose(file);
  bool is_swapped = false;
  const auto number = [&](std::size_t at, auto result) {
    std::string part = bytes.substr(at, sizeof result);
    if (is_swapped)
      std::reverse(part.begin(), part.end());
    std::memcpy(&result, part.data(), sizeof result);
    return double(result);
  };
  const auto has_size = [&](int size) { return n >= size && number(0, std::int32_t()) == size; };
  if (!has_size(348) && !has_size(540))
    is_swapped = true;
  const bool is_second = has_size(540);
  if (!is_second && !has_size(348))
    throw Failure("is not in the NIfTI format, or is damaged");
  const auto size = [&](std::size_t i) {
    return is_second ? number(16 + 8 * i, std::int64_t()) : number(40 + 2 * i, std::int16_t());
  };
  const auto type = bits_of_type.find(int(number(is_second ? 12 : 70, std::int16_t())));
  const double begin = is_second ? number(168, std::int64_t()) : number(108, float());
  bool is_valid = type != bits_of_type.end() && size(0) >= 1 && size(0) <= 7 &&
                  number(is_second ? 14 : 72, std::int16_t()) == type->second && begin >= 0 &&
                  begin <= 1 << 30;
  for (std::size_t i = 1; is_valid && double(i) <= size(0); ++i)
    is_valid = size(i) >= 1;
  if (!is_valid)
    throw Failure("has wrong numbers in its NIfTI header; write it again");
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

  /// Checks that all directories, and the strips or tiles of their images, are in the file. VTK
  /// reports no error if strips are missing, and makes up their rows.
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
      double rows = 0, rows_of_strip = 0;
      for (std::uint64_t i = 0; i < entries; ++i) {
        const std::uint64_t entry = first + i * entry_size, tag = number(entry, 2);
        if (tag == strip_offsets || tag == tile_offsets)
          places = values(entry);
        else if (tag == strip_sizes || tag == tile_sizes)
          sizes = values(entry);
        else if (tag == image_rows || tag == strip_rows)
          for (const std::uint64_t value : values(entry))
            (tag == image_rows ? rows : rows_of_strip) = double(value);
      }
      for (std::size_t i = 0; i < places.size() && i < sizes.size(); ++i)
        if (sizes[i] > m_size || places[i] > m_size - sizes[i])
          fail();
      // The size of tiles is in other tags. Without sizes, an image has one strip.
      if (!places.empty() && rows_of_strip > 0 && double(places.size()) * rows_of_strip < rows)
        fail();
      at = number(first + entries * entry_size, word);
    }
  }

private:
  static constexpr std::uint64_t image_rows = 257, strip_offsets = 273, strip_rows = 278,
                                 strip_sizes = 279, tile_offsets = 324, tile_sizes = 325;

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

} // namespace

void require_complete(const std::string& path, const std::string& format) {
  if (format == "mha" || format == "mhd")
    require_complete_meta_image(path);
  else if (format == "nrrd" || format == "nhdr")
    require_valid_nrrd(path);
  else if (format == "png")
    require_valid_png(path);
  else if (format == "pgm" || format == "ppm")
    require_valid_pnm(path);
  else if (format == "nii" || format == "nii.gz")
    require_valid_nifti(path);
  else if (format == "tif" || format == "tiff")
    Tiff_file(path).require_complete();
}

} // namespace dsc_files

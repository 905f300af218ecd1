// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/voxel_images.h"

#include "input/translations.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <zlib.h>

#include <memory>

namespace dsc {
namespace {

namespace internal = DSC::internal;

/// A file of the INR format: lines KEY=VALUE, the line ##}, and the values of the voxels.
class Inr_file
{
public:
  explicit Inr_file(const std::string& path) : m_path(path), m_file(nullptr, gzclose) {
    std::error_code error; // also for what is no regular file
    m_bytes_of_file = double(std::filesystem::file_size(path, error));
    if (!error)
      m_file.reset(gzopen(path.c_str(), "rb"));
    if (m_file == nullptr)
      throw Input_error("cannot open " + path +
                        "; check that it is a file, exists and is readable");
    read_header();
  }

  /// Returns the image, and prints what it does not use of the header.
  /// \throws Input_error if the header is wrong, or the number of bytes differs from the header
  CGAL::Image_3 read(std::size_t most_channels) {
    const Word word = take_word();
    std::uint64_t announced = word.bytes;
    std::array<std::uint64_t, 3> sizes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      announced *= sizes[axis] = dimension(std::array{"XDIM", "YDIM", "ZDIM"}[axis]);
    const std::string channels = take("VDIM").value_or("1");
    const auto number_of_channels = internal::number_of_word<std::uint64_t>(channels);
    if (!number_of_channels || *number_of_channels == 0)
      fail("has VDIM=" + internal::in_quotes(channels) +
           " in its header; write a number of 1 or more");
    if (*number_of_channels > most_channels)
      fail(most_channels == 1 ? "has more than one value per voxel (VDIM); write only the label"
                              : "has too many values per voxel (VDIM); write at most " +
                                    std::to_string(most_channels));
    announced *= *number_of_channels;
    static constexpr double largest_ratio = 1e4; // of sides of voxels; meshes are too large then
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    std::array<double, 3> sides;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string key = std::array{"VX", "VY", "VZ"}[axis];
      const double side = sides[axis] = number<double>(key, "1");
      if (!(side > 0))
        fail("has an invalid voxel size: " + key + " is not positive; correct the header");
      if (sizes[axis] > 1) {
        least = (std::min)(least, side);
        largest = (std::max)(largest, side);
      }
    }
    if (largest > largest_ratio * least)
      fail("has voxels that are more than 10000 times as long as wide; correct the header");
    std::array<float, 3> translation;
    for (std::size_t axis = 0; axis < 3; ++axis)
      translation[axis] = number<float>(std::array{"TX", "TY", "TZ"}[axis], "0");
    for (const char* key : {"RX", "RY", "RZ"})
      if (number<float>(key, "0") != 0)
        fail("has a rotation (" + std::string(key) + "), which is not supported; remove it");
    if (std::string why = internal::why_too_large(double(announced), m_bytes_of_file); !why.empty())
      fail(why);
    CGAL::Image_3 result(_createImage(sizes[0], sizes[1], sizes[2], *number_of_channels, sides[0],
                                      sides[1], sides[2], word.bytes, word.kind, word.sign));
    _image* const image = result.image();
    if (image == nullptr || image->data == nullptr)
      throw std::bad_alloc();
    image->tx = translation[0];
    image->ty = translation[1];
    image->tz = translation[2];
    auto* const data = static_cast<char*>(image->data);
    const std::uint64_t size = read_bytes(data, announced);
    if (size < announced)
      fail("lacks " + std::to_string(announced - size) + " of the " + std::to_string(announced) +
           " bytes that its header announces; is it truncated?");
    Unused_content unused;
    for (const auto& [key, value] : m_values)
      unused.add("header line " + internal::in_quotes(key));
    const std::uint64_t behind = count_bytes(most_bytes_behind);
    unused.add(noun(behind, "byte after the last voxel", "bytes after the last voxel"), behind);
    print_unused(m_path, unused);
    if (word.order != _getEndianness())
      for (char* voxel = data; voxel != data + announced; voxel += word.bytes)
        std::reverse(voxel, voxel + word.bytes);
    return result;
  }

private:
  /// How the file stores a value.
  struct Word
  {
    std::size_t bytes;
    WORD_KIND kind;
    SIGN sign;
    ENDIANNESS order;
  };

  [[noreturn]] void fail(const std::string& what) const { throw Input_error(m_path + " " + what); }

  /// \throws Input_error if the file, not its content, cannot be read
  void require_readable() const {
    int code = Z_OK;
    gzerror(m_file.get(), &code);
    if (code == Z_ERRNO)
      throw Input_error("cannot read " + m_path + " to its end; check the disk");
  }

  /// Returns the next line, without its end; `nullopt` if there is none.
  std::optional<std::string> line() {
    std::string result;
    constexpr std::size_t longest = 4096; // a file that is not an image may have no line ends
    while (result.size() < longest) {
      const int c = gzgetc(m_file.get());
      if (c < 0) {
        require_readable();
        return std::nullopt;
      }
      if (c == '\n')
        return result;
      result += static_cast<char>(c);
    }
    return std::nullopt;
  }

  void read_header() {
    const std::string magic = "#INRIMAGE-4#{";
    const std::optional<std::string> first = line();
    if (first == magic + '\r')
      fail("has Windows line endings, so its voxels are damaged, too; copy it in binary mode");
    if (first != magic)
      fail("does not begin with " + magic +
           "; give an INR image (images in other formats cannot be compressed)");
    bool has_values = true;
    for (std::optional<std::string> text; (text = line());) {
      if (text->compare(0, 3, "##}") == 0)
        return;
      has_values = has_values && !text->empty() && text->front() != '#';
      const std::size_t mark = text->find('=');
      if (has_values && mark == std::string::npos)
        fail("has the header line " + internal::in_quotes(*text) + " without '='; correct it");
      if (has_values && !m_values.emplace(text->substr(0, mark), text->substr(mark + 1)).second)
        fail("has the header line " + internal::in_quotes(*text) +
             " for a second time; remove one of them");
    }
    fail("has a header without the line ##} at its end; is it truncated?");
  }

  /// Returns and removes the value of a key.
  std::optional<std::string> take(const std::string& key) {
    const auto found = m_values.find(key);
    if (found == m_values.end())
      return std::nullopt;
    std::string value = found->second;
    m_values.erase(found);
    return value;
  }

  std::string need(const std::string& key) {
    const std::optional<std::string> value = take(key);
    if (!value)
      fail("has no " + key + " in its header; add it");
    return *value;
  }

  /// \tparam Number the type that CGAL stores
  template <class Number> Number number(const std::string& key, const std::string& otherwise) {
    const std::string text = take(key).value_or(otherwise);
    const std::optional<Number> value = internal::number_of_word<Number>(text);
    if (!value || !std::isfinite(*value))
      fail("has " + key + '=' + internal::in_quotes(text) + " in its header, which " +
           internal::why_no_number<Number>(text));
    return *value;
  }

  std::uint64_t dimension(const std::string& key) {
    constexpr std::uint64_t largest = 1 << 20; // so that the number of bytes fits into 64 bits
    const std::string text = need(key);
    const auto value = internal::number_of_word<std::uint64_t>(text);
    if (!value || *value == 0 || *value > largest)
      fail("has " + key + '=' + internal::in_quotes(text) +
           " in its header; write a number from 1 to 1048576");
    return *value;
  }

  Word take_word() {
    const std::string type = need("TYPE"), size = need("PIXSIZE"), order = need("CPU");
    const auto begins_with = [](const std::string& text, const std::string& begin) {
      return text.compare(0, begin.size(), begin) == 0;
    };
    const bool is_real = begins_with(type, "float");
    if (!is_real && !begins_with(type, "signed fixed") && !begins_with(type, "unsigned fixed"))
      fail("has the unknown voxel type " + internal::in_quotes(type) +
           "; write unsigned fixed, signed fixed or float");
    if (order != "decm" && order != "alpha" && order != "pc" && order != "sun" && order != "sgi")
      fail("has the unknown byte order CPU=" + internal::in_quotes(order) + "; write decm or sun");
    const std::array<std::uint64_t, 3> sizes = is_real ? std::array<std::uint64_t, 3>{32, 64, 64}
                                                       : std::array<std::uint64_t, 3>{8, 16, 32};
    const bool is_big = order == "sun" || order == "sgi";
    for (const std::uint64_t bits : sizes)
      if (begins_with(size, std::to_string(bits) + " bits"))
        return {bits / 8, is_real ? WK_FLOAT : WK_FIXED,
                begins_with(type, "unsigned") ? SGN_UNSIGNED : SGN_SIGNED,
                is_big ? END_BIG : END_LITTLE};
    fail("has the unsupported voxel size " + internal::in_quotes(size) + "; write " +
         (is_real ? "32 bits or 64 bits" : "8 bits, 16 bits or 32 bits"));
  }

  static constexpr std::uint64_t most_bytes_behind = 1 << 26; // the last voxel

  /// Reads bytes. Returns their number, which is less than `most` at the end of the file.
  std::uint64_t read_bytes(char* data, std::uint64_t most) {
    static constexpr std::uint64_t part = 1 << 20;
    std::uint64_t result = 0;
    for (int n = 1; n > 0 && result < most;
         result += static_cast<std::uint64_t>((std::max)(n, 0))) {
      DSC::Progress_scope::check();
      n = gzread(m_file.get(), data + result,
                 static_cast<unsigned>((std::min)(most - result, part)));
      require_readable();
      if (n < 0)
        fail("has damaged or truncated compressed data; copy the file again");
    }
    return result;
  }

  /// Counts the bytes until the end of the file.
  std::uint64_t count_bytes(std::uint64_t most) {
    std::vector<char> buffer(1 << 20);
    std::uint64_t result = 0;
    while (const std::uint64_t n = read_bytes(buffer.data(), buffer.size()))
      if ((result += n) > most)
        fail("has more bytes than its header announces; is its header damaged?");
    return result;
  }

  std::string m_path;
  std::unique_ptr<gzFile_s, int (*)(gzFile)> m_file;
  std::map<std::string, std::string> m_values;
  double m_bytes_of_file = 0;
};

} // namespace

CGAL::Image_3 read_inr(const std::string& path, std::size_t most_channels) {
  return Inr_file(path).read(most_channels);
}

DSC::Sampling_grid<3> grid_of(const CGAL::Image_3& image) {
  return {{image.xdim(), image.ydim(), image.zdim()},
          {image.vx(), image.vy(), image.vz()},
          {image.tx(), image.ty(), image.tz()}};
}

} // namespace dsc

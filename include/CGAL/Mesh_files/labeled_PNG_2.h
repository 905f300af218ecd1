// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_LABELED_PNG_2_H
#define CGAL_MESH_FILES_LABELED_PNG_2_H

#include <CGAL/Complex_construction/Labeled_image_2.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <png.h>

#include <cstring>
#include <new>

namespace CGAL {
namespace Deformable_simplicial_complexes::internal {

struct Png_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Reader of a picture in memory. Errors of libpng are thrown as exceptions through libpng.
class Png_labels
{
public:
  explicit Png_labels(const std::string& bytes)
      : m_bytes(bytes), m_png(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)),
        m_info(m_png == nullptr ? nullptr : png_create_info_struct(m_png)) {
    if (m_info == nullptr) {
      png_destroy_read_struct(&m_png, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(m_png, this, read);
  }
  ~Png_labels() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
  Png_labels(const Png_labels&) = delete;
  Png_labels& operator=(const Png_labels&) = delete;

  // Returns the image. Throws Png_error.
  Labeled_image_2 image() {
    static constexpr png_uint_32 largest_side = 1 << 20; // as for other images
    png_set_user_limits(m_png, largest_side, largest_side);
    png_read_info(m_png, m_info);
    const png_byte colors = png_get_color_type(m_png, m_info);
    if (colors != PNG_COLOR_TYPE_GRAY && colors != PNG_COLOR_TYPE_PALETTE)
      throw Png_error(
          std::string(colors == PNG_COLOR_TYPE_GRAY_ALPHA  ? "has gray values with transparency"
                      : colors == PNG_COLOR_TYPE_RGB_ALPHA ? "has colors with transparency"
                                                           : "has colors") +
          ": labels are gray values or indices of a palette; convert it to one of these");
    if (png_get_valid(m_png, m_info, PNG_INFO_tRNS) != 0)
      m_unused.add("transparent colors or gray values", number_of_transparent());
    const bool is_wide = png_get_bit_depth(m_png, m_info) == 16;
    png_set_packing(m_png);
    const int passes = png_set_interlace_handling(m_png);
    png_read_update_info(m_png, m_info);
    Labeled_image_2 result;
    result.width = png_get_image_width(m_png, m_info);
    result.height = png_get_image_height(m_png, m_info);
    const std::size_t row = png_get_rowbytes(m_png, m_info);
    if (std::string why =
            why_too_large(double(row) * double(result.height), double(m_bytes.size()));
        !why.empty())
      throw Png_error(why);
    std::vector<std::vector<png_byte>> rows(passes > 1 ? result.height : 1,
                                            std::vector<png_byte>(row));
    result.labels.reserve(result.width * result.height);
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t y = 0; y < result.height; ++y) {
        Progress_scope::check();
        auto& pixels = rows[passes > 1 ? y : 0];
        png_read_row(m_png, pixels.data(), nullptr);
        for (std::size_t x = 0; pass + 1 == passes && x < result.width; ++x)
          result.labels.push_back(is_wide ? 256 * pixels[2 * x] + pixels[2 * x + 1] : pixels[x]);
      }
    png_read_end(m_png, nullptr);
    m_unused.add("bytes after the image", m_bytes.size() - m_position);
    return result;
  }

  const Unused_content& unused() const { return m_unused; }

private:
  std::size_t number_of_transparent() {
    png_bytep opacities = nullptr; // of the colors of the palette
    int number = 0;
    png_get_tRNS(m_png, m_info, &opacities, &number, nullptr);
    if (png_get_color_type(m_png, m_info) == PNG_COLOR_TYPE_GRAY)
      return 1;
    return std::size_t(std::count_if(opacities, opacities + number,
                                     [](png_byte opacity) { return opacity < 255; }));
  }

  static void read(png_structp png, png_bytep to, std::size_t size) {
    auto& self = *static_cast<Png_labels*>(png_get_io_ptr(png));
    if (size > self.m_bytes.size() - self.m_position)
      png_error(png, "the file is truncated");
    std::memcpy(to, self.m_bytes.data() + self.m_position, size);
    self.m_position += size;
  }
  [[noreturn]] static void fail(png_structp, png_const_charp what) {
    throw Png_error(std::string("cannot be read: ") + what + "; write the file again");
  }
  static void ignore(png_structp, png_const_charp) {}

  const std::string& m_bytes;
  std::size_t m_position = 0;
  Unused_content m_unused;
  png_structp m_png;
  png_infop m_info;
};

} // namespace Deformable_simplicial_complexes::internal

namespace IO {

/*!
\ingroup PkgMeshFilesRef

Reads an image of labels from portable network graphics (`.png`). The labels are the gray values, or
the indices of colors in the palette. Programs that include this header must link with libpng.
Linear in the number of pixels.

\param path name of the file
\param unused the unused content of the file is added to it, unless it is null: the transparency of
       gray values or of colors in the palette, and bytes after the image
\throws Deformable_simplicial_complexes::File_error if the file cannot be read, or is not such an
        image

\sa `read_labeled_image()`
*/
inline Deformable_simplicial_complexes::Labeled_image_2
read_labeled_PNG(const std::string& path,
                 Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const std::string bytes = internal::file_contents(path);
  try {
    internal::Png_labels reader(bytes);
    auto image = reader.image();
    if (unused)
      unused->add(reader.unused());
    return image;
  } catch (const internal::Png_error& error) {
    throw Deformable_simplicial_complexes::File_error(path + ": " + error.what(), path);
  }
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_MESH_FILES_LABELED_PNG_2_H

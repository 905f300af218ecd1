// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_LABELED_IMAGE_2_H
#define CGAL_MESH_FILES_LABELED_IMAGE_2_H

#include <CGAL/Complex_construction/Labeled_image_2.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <cctype>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

Reads an image of labels from a portable gray map (`.pgm`). The gray values are the labels. Linear
in the size of the file.

\param path name of the file
\param unused the unused content of the file is added to it, unless it is null: bytes after the
       pixels, such as other images
\throws Deformable_simplicial_complexes::File_error if the file cannot be read, or is not such an
        image
*/
inline Deformable_simplicial_complexes::Labeled_image_2
read_labeled_image(const std::string& path,
                   Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const std::string bytes = internal::file_contents(path);
  std::size_t position = 2;
  const auto fail = [&](const std::string& what) {
    throw Deformable_simplicial_complexes::File_error(path + ": " + what, path);
  };
  if ((bytes.compare(0, 2, "P2") != 0 && bytes.compare(0, 2, "P5") != 0) ||
      (bytes.size() > 2 && std::isdigit(static_cast<unsigned char>(bytes[2])) != 0))
    fail("the file does not begin with P2 or P5; convert it to a portable graymap (PGM)");
  const bool is_binary = bytes[1] == '5';
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const auto number = [&](std::size_t maximum) {
    while (position < bytes.size() && (std::isspace(byte(position)) || bytes[position] == '#'))
      position = bytes[position] == '#' ? (std::min)(bytes.find('\n', position), bytes.size())
                                        : position + 1;
    if (position == bytes.size() || !std::isdigit(byte(position)))
      fail("a number is missing; is the file truncated?");
    std::size_t result = 0;
    for (; position < bytes.size() && std::isdigit(byte(position)); ++position)
      if ((result = 10 * result + (byte(position) - '0')) > maximum)
        fail("a number is too large; correct it");
    return result;
  };
  static constexpr std::size_t largest_side = 1 << 20, largest_gray = 65535;
  Deformable_simplicial_complexes::Labeled_image_2 image;
  image.width = number(largest_side);
  image.height = number(largest_side);
  const std::size_t gray = number(largest_gray), size = image.width * image.height;
  if (size == 0 || gray == 0)
    fail("the width, the height or the largest gray value is 0; correct it");
  const std::size_t bytes_of_pixel = is_binary && gray > 255 ? 2 : 1;
  if (is_binary && position < bytes.size() && !std::isspace(byte(position)))
    fail("there is no white space between the largest gray value and the pixels; insert it");
  position += is_binary;
  if (bytes.size() < position || bytes.size() - position < bytes_of_pixel * size)
    fail("there are fewer pixels than the header announces; is the file truncated?");
  image.labels.reserve(size);
  while (image.labels.size() < size) {
    Deformable_simplicial_complexes::Progress_scope::check();
    if (!is_binary) {
      image.labels.push_back(int(number(gray)));
    } else {
      int value = byte(position++);
      if (bytes_of_pixel == 2)
        value = 256 * value + byte(position++);
      if (std::size_t(value) > gray)
        fail("a number is too large; correct it");
      image.labels.push_back(value);
    }
  }
  while (position < bytes.size() && std::isspace(byte(position)))
    ++position;
  if (unused)
    unused->add("bytes after the pixels", bytes.size() - position);
  return image;
}

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_LABELED_IMAGE_2_H

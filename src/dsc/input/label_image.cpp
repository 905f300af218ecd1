// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/label_image.h"

#include "input/translations.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>

namespace dsc {
namespace {

using Grid = CGAL::Deformable_simplicial_complexes::Sampling_grid<3>;

/// Writes labels of voxels for VTK, as an image with raw data.
void write_vti(const std::string& path, const Grid& grid, const std::vector<int>& labels) {
  std::ofstream out(path, std::ios::binary);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<ImageData WholeExtent=\"";
  for (std::size_t axis = 0; axis < 3; ++axis)
    out << "0 " << grid.size[axis] - 1 << (axis < 2 ? " " : "\" Origin=\"");
  for (std::size_t axis = 0; axis < 3; ++axis)
    out << grid.origin[axis] << (axis < 2 ? " " : "\" Spacing=\"");
  for (std::size_t axis = 0; axis < 3; ++axis)
    out << grid.spacing[axis] << (axis < 2 ? " " : "\">\n<Piece Extent=\"");
  for (std::size_t axis = 0; axis < 3; ++axis)
    out << "0 " << grid.size[axis] - 1 << (axis < 2 ? " " : "\">\n");
  const bool is_small = std::all_of(labels.begin(), labels.end(),
                                    [](int label) { return 0 <= label && label <= 65535; });
  out << "<PointData Scalars=\"label\"><DataArray type=\"" << (is_small ? "UInt16" : "Int32")
      << "\" Name=\"label\" format=\"appended\" offset=\"0\"/></PointData>\n"
      << "</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_";
  const auto write = [&](auto number) {
    out.write(reinterpret_cast<const char*>(&number), sizeof number);
  };
  write(std::uint64_t(labels.size() * (is_small ? 2 : 4)));
  for (const int label : labels)
    if (is_small)
      write(std::uint16_t(label));
    else
      write(std::int32_t(label));
  out << "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace

void write_label_image(const std::string& path, const Grid& grid, const std::vector<int>& labels,
                       const std::string& like) {
  const std::string image = temporary_file("image.vti");
  write_vti(image, grid, labels);
  write_foreign(image, path, like);
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/voxel_images.h"

#include "input/files.h"
#include "input/translations.h"

#include <CGAL/Mesh_files/replace_file.h>

namespace dsc {
namespace {

/// Returns the values of an image as numbers, the channels of a voxel next to each other.
template <class Number> std::vector<float> values_of(const void* data, std::size_t n) {
  const auto* const values = static_cast<const Number*>(data);
  return std::vector<float>(values, values + n);
}

std::vector<float> values_of(const CGAL::Image_3& image, std::size_t channels) {
  const std::size_t n = image.size() * channels;
  const bool is_signed = image.image()->sign == SGN_SIGNED;
  const void* const data = image.data();
  if (image.image()->wordKind == WK_FLOAT)
    return image.image()->wdim == 8 ? values_of<double>(data, n) : values_of<float>(data, n);
  switch (image.image()->wdim) {
  case 1:
    return is_signed ? values_of<std::int8_t>(data, n) : values_of<std::uint8_t>(data, n);
  case 2:
    return is_signed ? values_of<std::int16_t>(data, n) : values_of<std::uint16_t>(data, n);
  default:
    return is_signed ? values_of<std::int32_t>(data, n) : values_of<std::uint32_t>(data, n);
  }
}

using Grid = DSC::Sampling_grid<3>;

/// Writes labels of voxels for VTK, as an image with raw data.
void write_vti(std::ostream& out, const Grid& grid, const std::vector<int>& labels) {
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

Grid read_label_image(const std::string& path, std::vector<int>& labels) {
  const CGAL::Image_3 image = read_inr(path);
  for (std::size_t z = 0; z < image.zdim(); ++z)
    for (std::size_t y = 0; y < image.ydim(); ++y)
      for (std::size_t x = 0; x < image.xdim(); ++x)
        labels.push_back(int(image.value(x, y, z)));
  return grid_of(image);
}

Image_statistics image_statistics(const std::string& path) {
  std::vector<int> labels;
  Image_statistics result = {read_label_image(path, labels), {}};
  for (const int label : labels)
    ++result.voxels[label];
  return result;
}

Read_image read_gray_image(const std::string& path, bool has_channels) {
  static constexpr std::size_t most_channels = 16;
  const std::string format = extension(path);
  const bool is_native = format == "inr" || (format == "gz" && !is_foreign(path));
  const std::string file = is_native ? path : translate_image(path, has_channels);
  const CGAL::Image_3 image = read_inr(file, most_channels);
  const std::size_t channels = image.image()->vdim;
  const std::vector<float> values = values_of(image, channels);
  Read_image result;
  result.image.grid = grid_of(image);
  result.image.channels.resize(channels);
  for (std::size_t k = 0; k < channels; ++k)
    for (std::size_t i = k; i < values.size(); i += channels)
      result.image.channels[k].push_back(values[i]);
  for (std::size_t i = 0; i < values.size() / channels; ++i)
    for (std::size_t k = 0; k < channels; ++k)
      if (!std::isfinite(values[i * channels + k])) {
        result.image.mask.resize(values.size() / channels, 1);
        result.number_without_values += result.image.mask[i];
        result.image.mask[i] = 0;
      }
  return result;
}

DSC::Gray_image<2> layer_of(Read_image image) {
  const auto& grid = image.image.grid;
  return {{{grid.size[0], grid.size[1]},
           {grid.spacing[0], grid.spacing[1]},
           {grid.origin[0], grid.origin[1]}},
          std::move(image.image.channels),
          std::move(image.image.mask)};
}

void write_label_image(const std::string& path, const Grid& grid, const std::vector<int>& labels,
                       const std::string& like) {
  const std::string image = temporary_file("image.vti");
  DSC::replace_file(image, [&](std::ostream& out) { write_vti(out, grid, labels); });
  write_foreign(image, path, like);
}

} // namespace dsc

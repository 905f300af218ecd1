// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Translation.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>
#include <utility>

namespace dsc_files {
namespace {

/// Values of voxels in space, the first axis fastest.
template <class Value> struct Voxels
{
  std::array<std::size_t, 3> size;
  std::array<double, 3> spacing, origin; ///< the origin is the center of the first voxel
  std::vector<Value> values;
};

/// Returns the array with the values of the voxels, which are the points or the cells.
vtkDataArray* values_of(vtkImageData* image, bool& are_cells) {
  for (vtkDataSetAttributes* attributes :
       {static_cast<vtkDataSetAttributes*>(image->GetPointData()),
        static_cast<vtkDataSetAttributes*>(image->GetCellData())}) {
    are_cells = attributes == image->GetCellData();
    vtkDataArray* array = attributes->GetScalars();
    if (array == nullptr && attributes->GetNumberOfArrays() > 0)
      array = attributes->GetArray(0);
    if (array != nullptr && array->GetNumberOfTuples() > 0)
      return array;
  }
  throw Failure("contains an image without values; is its size in the header correct?");
}

std::vector<double> component(vtkDataArray* array, int which) {
  std::vector<double> result(std::size_t(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = array->GetComponent(vtkIdType(i), which);
  return result;
}

/// Returns the number of thresholds that each value reaches.
std::vector<int> classes_of(const std::vector<double>& values, const std::string& option,
                            Translation& result) {
  const std::vector<double> thresholds = thresholds_of(option, values);
  std::vector<int> labels;
  labels.reserve(values.size());
  for (const double value : values) // not a number gets label 0
    labels.push_back(int(std::count_if(thresholds.begin(), thresholds.end(),
                                       [&](double threshold) { return value >= threshold; })));
  result.leave_out(std::size_t(std::count_if(values.begin(), values.end(),
                                             [](double value) { return std::isnan(value); })),
                   "voxel without a value, which gets label 0",
                   "voxels without a value, which get label 0");
  if (option.compare(0, 4, "otsu") == 0) {
    std::ostringstream text;
    text << "chosen thresholds: ";
    for (std::size_t i = 0; i < thresholds.size(); ++i)
      text << (i == 0 ? "" : ", ") << thresholds[i];
    result.notes.push_back(text.str());
  }
  return labels;
}

/// Returns the values as labels.
std::vector<int> integers_of(vtkDataArray* array) {
  std::vector<int> labels;
  labels.reserve(std::size_t(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double value = array->GetComponent(i, 0);
    if (!(value == std::floor(value)))
      throw Failure("contains gray values, such as " + std::to_string(value) +
                    ", and no labels; choose labels by --threshold");
    if (std::abs(value) > (std::numeric_limits<int>::max)())
      throw Failure("contains a label that does not fit into 32 bits");
    labels.push_back(int(value));
  }
  return labels;
}

/// Returns the index of each color among the colors of the image, in the order of their values.
std::vector<int> palette_of(vtkDataArray* array, Translation& result) {
  static constexpr std::size_t most_colors = 256;
  using Color = std::array<int, 4>;
  const auto color = [&](vtkIdType i) {
    Color c = {};
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      c[std::size_t(k)] = int(array->GetComponent(i, k));
    return c;
  };
  std::set<Color> colors;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    colors.insert(color(i));
    if (colors.size() > most_colors)
      throw Failure("contains more than 256 colors and no labels; choose labels by --threshold");
  }
  const std::vector<Color> palette(colors.begin(), colors.end());
  std::ostringstream text;
  for (std::size_t i = 0; i < palette.size() && i < 10; ++i) {
    text << (i == 0 ? "" : ", ") << "label " << i << " is the color";
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      text << ' ' << palette[i][std::size_t(k)];
  }
  result.notes.push_back(text.str() + (palette.size() > 10 ? ", ..." : ""));
  std::vector<int> labels;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    labels.push_back(
        int(std::lower_bound(palette.begin(), palette.end(), color(i)) - palette.begin()));
  return labels;
}

/// Returns whether values are red, green and blue, perhaps with opacity.
bool has_colors(vtkDataArray* array) {
  const int components = array->GetNumberOfComponents();
  const bool is_of_picture =
      array->GetDataType() == VTK_UNSIGNED_CHAR || array->GetDataType() == VTK_UNSIGNED_SHORT;
  return is_of_picture && (components == 3 || components == 4);
}

/// Returns whether values are gray values with opacity, as in pictures of 8 bits.
bool has_opacity_of_gray(vtkDataArray* array) {
  return array->GetDataType() == VTK_UNSIGNED_CHAR && array->GetNumberOfComponents() == 2;
}

/// Returns the luminance of ITU-R BT.709 of colors, and the first component of other values.
std::vector<double> luminance_of(vtkDataArray* array, Translation& result) {
  std::vector<double> gray = component(array, 0);
  if (!has_colors(array))
    return gray;
  result.leave_out(array->GetNumberOfComponents() == 4 ? 1 : 0, "channel (opacity)", "");
  const std::vector<double> green = component(array, 1), blue = component(array, 2);
  for (std::size_t i = 0; i < gray.size(); ++i)
    gray[i] = .2126 * gray[i] + .7152 * green[i] + .0722 * blue[i];
  return gray;
}

std::vector<int> label_values(vtkDataArray* array, const Options& options, Translation& result) {
  const int components = array->GetNumberOfComponents();
  if (components > 1 && !has_colors(array))
    throw Failure("contains " + std::to_string(components) + " values for each voxel; write one");
  if (options.thresholds.empty())
    return components == 1 ? integers_of(array) : palette_of(array, result);
  return classes_of(luminance_of(array, result), options.thresholds, result);
}

/// Returns the channels of an image: the luminance of colors unless all channels are asked for, and
/// all components of other images.
std::vector<std::vector<double>> channels_of(vtkDataArray* array, const Options& options,
                                             Translation& result) {
  const int components = array->GetNumberOfComponents();
  if (has_colors(array) && options.values == "gray")
    return {luminance_of(array, result)};
  const bool has_opacity = has_opacity_of_gray(array) || (has_colors(array) && components == 4);
  result.leave_out(has_opacity ? 1 : 0, "channel (opacity)", "");
  std::vector<std::vector<double>> channels;
  for (int k = 0; k < components - (has_opacity ? 1 : 0); ++k)
    channels.push_back(component(array, k));
  return channels;
}

/// Finds the axis of an image along each axis of space, and its direction, 1 or -1. Returns false
/// if the axes are rotated: then the axes of the image are used.
bool find_axes(vtkImageData* image, std::array<int, 3>& sources, std::array<double, 3>& signs) {
  static constexpr double rounding = 1e-4; // of numbers that files store in 32 bits
  sources = {0, 1, 2};
  signs = {1, 1, 1};
  std::array<int, 3> found = {-1, -1, -1};
  std::array<double, 3> directions = {};
  for (int axis = 0; axis < 3; ++axis)
    for (int j = 0; j < 3; ++j) {
      const double x = image->GetDirectionMatrix()->GetElement(axis, j);
      if (std::abs(x) < rounding)
        continue;
      if (std::abs(std::abs(x) - 1) > rounding || found[std::size_t(axis)] >= 0)
        return false;
      found[std::size_t(axis)] = j;
      directions[std::size_t(axis)] = x < 0 ? -1 : 1;
    }
  if (std::set<int>(found.begin(), found.end()) != std::set<int>{0, 1, 2})
    return false;
  sources = found;
  signs = directions;
  return true;
}

/// Returns the values along the axes of space, which the axes of the image permute and reverse.
template <class Value>
Voxels<Value> along_axes_of_space(vtkImageData* image, bool are_cells, std::vector<Value> values,
                                  Translation& translation) {
  std::array<int, 3> sources;
  std::array<double, 3> signs;
  if (!find_axes(image, sources, signs))
    translation.unused.push_back("rotation of the axes in space");
  int dimensions[3];
  image->GetDimensions(dimensions);
  std::array<std::size_t, 3> size, strides;
  for (std::size_t j = 0; j < 3; ++j)
    size[j] = std::size_t((std::max)(1, dimensions[j] - (are_cells ? 1 : 0)));
  strides = {1, size[0], size[0] * size[1]};
  int extent[6];
  image->GetExtent(extent);
  Voxels<Value> result;
  std::array<std::ptrdiff_t, 3> steps = {};
  std::ptrdiff_t first = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int source = sources[std::size_t(axis)];
    const auto a = std::size_t(axis), j = std::size_t(source);
    const double spacing = image->GetSpacing()[source], direction = signs[a] * spacing;
    const double first_center = image->GetOrigin()[axis] +
                                direction * (extent[2 * source] + (are_cells ? .5 : 0.)),
                 last_center = first_center + direction * double(size[j] - 1);
    result.size[a] = size[j];
    result.spacing[a] = std::abs(spacing);
    result.origin[a] = (std::min)(first_center, last_center);
    steps[a] = direction < 0 ? -std::ptrdiff_t(strides[j]) : std::ptrdiff_t(strides[j]);
    if (direction < 0)
      first += std::ptrdiff_t(strides[j] * (size[j] - 1));
  }
  if (sources == std::array<int, 3>{0, 1, 2} && first == 0) { // large images are not copied
    result.values = std::move(values);
    return result;
  }
  result.values.reserve(values.size());
  for (std::size_t z = 0; z < result.size[2]; ++z)
    for (std::size_t y = 0; y < result.size[1]; ++y)
      for (std::size_t x = 0; x < result.size[0]; ++x)
        result.values.push_back(
            values[std::size_t(first + std::ptrdiff_t(x) * steps[0] + std::ptrdiff_t(y) * steps[1] +
                               std::ptrdiff_t(z) * steps[2])]);
  return result;
}

template <class Number> void write_numbers(std::ostream& out, const std::vector<int>& values) {
  for (const int value : values) {
    const auto number = Number(value);
    out.write(reinterpret_cast<const char*>(&number), sizeof number);
  }
}

/// Writes the header of an INR file.
/// \param type, bits of a value
template <class Value>
void write_inr_header(const Voxels<Value>& voxels, std::size_t channels, const char* type, int bits,
                      std::ostream& out) {
  static constexpr std::size_t block = 256; // bytes; the header fills blocks
  std::ostringstream header;
  header.precision(std::numeric_limits<double>::max_digits10);
  header << "#INRIMAGE-4#{\nXDIM=" << voxels.size[0] << "\nYDIM=" << voxels.size[1]
         << "\nZDIM=" << voxels.size[2] << "\nVDIM=" << channels << "\nTYPE=" << type
         << "\nPIXSIZE=" << bits << " bits\nCPU=decm";
  const char* const names = "XYZ";
  for (std::size_t axis = 0; axis < 3; ++axis)
    header << "\nV" << names[axis] << '=' << voxels.spacing[axis] << "\nT" << names[axis] << '='
           << voxels.origin[axis];
  header << '\n';
  const std::string end = "##}\n";
  std::string text = header.str();
  text.append((block - (text.size() + end.size()) % block) % block, '\n');
  out << text << end;
}

void write_inr(const Voxels<int>& labels, std::ostream& out) {
  const auto [least, largest] = std::minmax_element(labels.values.begin(), labels.values.end());
  const int bits = *least < 0 || *largest > 65535 ? 32 : *largest > 255 ? 16 : 8;
  write_inr_header(labels, 1, bits == 32 ? "signed fixed" : "unsigned fixed", bits, out);
  if (bits == 8)
    write_numbers<std::uint8_t>(out, labels.values);
  else if (bits == 16)
    write_numbers<std::uint16_t>(out, labels.values);
  else
    write_numbers<std::int32_t>(out, labels.values);
}

/// Writes a layer as rows from top to bottom.
void write_pgm(const Voxels<int>& labels, std::ostream& out) {
  const auto [least, largest] = std::minmax_element(labels.values.begin(), labels.values.end());
  if (*least < 0 || *largest > 65535)
    throw Failure("contains labels of pixels outside 0 to 65535; choose labels by --threshold");
  const bool is_wide = *largest > 255;
  const std::size_t width = labels.size[0], height = labels.size[1];
  out << "P5\n" << width << ' ' << height << '\n' << (is_wide ? 65535 : 255) << '\n';
  for (std::size_t y = height; y-- > 0;)
    for (std::size_t x = 0; x < width; ++x) {
      const int label = labels.values[y * width + x];
      if (is_wide)
        out.put(char(label / 256));
      out.put(char(label % 256));
    }
}

/// Finds the array with the values of the voxels, and adds the others to the unused contents.
vtkDataArray* used_values_of(vtkImageData* image, bool& are_cells, Translation& result) {
  vtkDataArray* const array = values_of(image, are_cells);
  for (vtkFieldData* attributes : {static_cast<vtkFieldData*>(image->GetPointData()),
                                   static_cast<vtkFieldData*>(image->GetCellData())})
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      if (attributes->GetAbstractArray(i) != array && attributes->GetArrayName(i) != nullptr)
        result.unused.push_back(std::string("array (") + attributes->GetArrayName(i) + ')');
  return array;
}

} // namespace

Translation write_channels(vtkImageData* image, const Options& options) {
  Translation result;
  bool are_cells = false;
  vtkDataArray* const array = used_values_of(image, are_cells, result);
  std::vector<Voxels<double>> channels;
  for (const std::vector<double>& channel : channels_of(array, options, result)) {
    Translation repeated; // what is unused is the same for all channels
    channels.push_back(along_axes_of_space(image, are_cells, channel, repeated));
    if (channels.size() == 1)
      result.unused.insert(result.unused.end(), repeated.unused.begin(), repeated.unused.end());
  }
  result.path = options.folder + "/image.inr";
  Output_file out(result.path);
  write_inr_header(channels.front(), channels.size(), "float", 32, out);
  for (std::size_t i = 0; i < channels.front().values.size(); ++i)
    for (const Voxels<double>& channel : channels) {
      const auto value = float(channel.values[i]);
      out.write(reinterpret_cast<const char*>(&value), sizeof value);
    }
  out.close();
  return result;
}

Translation write_image(vtkImageData* image, const Options& options) {
  Translation result;
  bool are_cells = false;
  vtkDataArray* const array = used_values_of(image, are_cells, result);
  const Voxels<int> labels =
      along_axes_of_space(image, are_cells, label_values(array, options, result), result);
  const bool is_layer = labels.size[2] == 1;
  result.path = options.folder + (is_layer ? "/image.pgm" : "/image.inr");
  if (is_layer && (labels.spacing != std::array<double, 3>{1, 1, 1} || labels.origin[0] != 0 ||
                   labels.origin[1] != 0))
    result.unused.push_back("size and place of the pixels");
  Output_file out(result.path);
  if (is_layer)
    write_pgm(labels, out);
  else
    write_inr(labels, out);
  out.close();
  return result;
}

} // namespace dsc_files

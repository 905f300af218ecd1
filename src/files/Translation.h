// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_TRANSLATION_H
#define DSC_FILES_TRANSLATION_H

#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

class vtkDataSet;
class vtkImageData;

namespace dsc_files {

/// A file cannot be translated. The message is the rest of a sentence that begins with its name.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// How a file is read.
struct Options
{
  std::string input;
  std::string folder;     ///< of the translation
  std::string labels;     ///< name of the cell array with labels, for cells in the plane
  std::string values;     ///< of an image that are kept: `gray` or `color`; empty for labels
  std::string thresholds; ///< of gray values: numbers, `otsu` or `otsu:K`; empty for labels
};

/// A file in a format that the package reads.
struct Translation
{
  std::string path;
  std::vector<std::string> unused;  ///< contents of the input that are not in the file
  std::vector<std::string> notes;   ///< choices that the user should know
  std::map<int, std::string> names; ///< of labels, in the input

  /// Adds a number of items to the unused contents, unless there are none.
  void leave_out(std::size_t number, const std::string& singular, const std::string& plural) {
    if (number > 0)
      unused.push_back(std::to_string(number) + ' ' + (number == 1 ? singular : plural));
  }
};

/// Translates points: tables with columns x, y and z, and normal columns if there are any. Points
/// that are not finite, as in organized clouds, are left out. Writes `points.xyz` or `points.pwn`.
/// \throws Failure if the file cannot be read
Translation translate_csv(const Options& options); ///< text with commas, semicolons or spaces
Translation translate_pcd(const Options& options); ///< of the Point Cloud Library, text or binary

/// Translates the polygons of a GeoJSON file (RFC 7946) into `regions.wkt`, in their order.
/// \throws Failure if the file cannot be read
Translation translate_geojson(const Options& options);

/// Writes the cells of highest dimension of a dataset: tetrahedra (`cells.vtu`), a triangulated
/// surface (`surface.off`, with names of labels `surface.obj`), regions of labeled triangles in a
/// plane z = const (`regions.poly`) or points (`points.xyz`, with normals `points.pwn`). Other
/// cells in space are divided into tetrahedra. \param names of labels
/// \throws Failure if there are no such cells
Translation write_cells(vtkDataSet* data, const std::map<int, std::string>& names,
                        const Options& options);

/// Writes an image as labels of voxels (`image.inr`) or, if it has a single layer, of pixels
/// (`image.pgm`). Labels are the values of the image, gray values between thresholds, or the colors
/// in the order of their values.
/// An image whose axes are rotated in space is written along its own axes.
/// \throws Failure if the values are no labels
Translation write_image(vtkImageData* image, const Options& options);

/// Writes the values of an image as numbers (`image.inr`), several channels beside each other.
/// \param options `values` tells whether colors become gray values
Translation write_channels(vtkImageData* image, const Options& options);

/// Writes a grid (.vtu), a surface (.ply) or an image of labels (.vti) in a format of another
/// program: .vtk for all, .vtp for surfaces, .vti, .nii, .nii.gz, .mha, .tif or .inr for
/// images. The folder of the output must be empty.
/// \param like image whose axes, and position in space, the new image gets; its voxels have the same
///        centers. If empty, the axes of the new image are the ones of space.
/// \throws Failure if the file cannot be written, or the format does not fit
void write_foreign(const std::string& input, const std::string& output, const std::string& like);

/// A translation that is written. Numbers have all digits.
struct Output_file : std::ofstream
{
  explicit Output_file(const std::string& path) : std::ofstream(path, std::ios::binary) {
    precision(std::numeric_limits<double>::max_digits10);
  }

  /// \throws Failure if not all bytes could be written
  void close() {
    std::ofstream::close();
    if (!*this)
      throw Failure("cannot be translated: the disk for temporary files is full");
  }
};

/// Returns the increasing thresholds of an option: numbers separated by commas, `otsu`, or `otsu:K`
/// for K thresholds that are chosen by the values.
/// \throws Failure if the option cannot be read
std::vector<double> thresholds_of(const std::string& option, const std::vector<double>& values);

} // namespace dsc_files

#endif // DSC_FILES_TRANSLATION_H

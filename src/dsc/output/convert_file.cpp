// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Inputs.h"
#include "input/files.h"
#include "input/labeled_tetrahedra.h"
#include "input/run_start.h"
#include "input/surface.h"
#include "input/translations.h"
#include "input/voxel_images.h"
#include "motions/mesh_at_rest.h"
#include "motions/tracked_complex_3.h"
#include "output/label_titles.h"
#include "programs/option_values.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Grid = DSC::Sampling_grid<3>;

bool is_one_of(const std::string& format, std::initializer_list<const char*> formats) {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

void require_format(const std::string& input, const std::string& content, const std::string& output,
                    std::initializer_list<const char*> formats) {
  if (is_one_of(extension(output), formats))
    return;
  std::string known;
  for (const std::string format : formats)
    known += (known.empty() ? "." : ", .") + (format == "gz" ? "nii.gz" : format);
  throw Usage_error(input + " contains " + content + ", which '" + output +
                    "' cannot contain; write " + known);
}

void convert_surface(const std::string& input, const std::string& output,
                     const std::string& labels) {
  require_format(input, "a surface", output, {"off", "obj", "ply", "stl", "vtp", "vtk"});
  DSC::Surface_parts parts;
  const Surface surface = read_surface(input, labels == "none" ? nullptr : &parts);
  DSC::Interface_surface_3<Complex> result;
  for (const Surface_point& p : surface.points)
    result.points.emplace_back(p.x(), p.y(), p.z());
  result.triangles = surface.triangles;
  DSC::Label_names names;
  for (std::size_t i = 0; i < parts.names.size(); ++i)
    if (!parts.names[i].empty())
      names[int(i) + 1] = parts.names[i];
  result.labels.assign(surface.triangles.size(), {1, 0});
  for (std::size_t i = 0; i < parts.of_triangles.size(); ++i)
    result.labels[i][0] = int(parts.of_triangles[i]) + 1;
  tell_lost_names(output, names);
  const bool is_foreign_format = is_one_of(extension(output), {"vtp", "vtk"});
  const std::string path = is_foreign_format ? temporary_file("surface.ply") : output;
  CGAL::IO::write_named_interface(path, result, names);
  if (is_foreign_format)
    write_foreign(path, output);
}

void convert_tetrahedra(const std::string& input, const std::string& output,
                        const std::string& labels) {
  require_format(input, "tetrahedra", output,
                 {"vtu", "mesh", "off", "obj", "ply", "stl", "png", "vtk"});
  Labeled_tetrahedra mesh = read_tetrahedra(input, labels);
  const Mesh_at_rest complex(input, mesh);
  const bool is_foreign_format = extension(output) == "vtk";
  const std::string path = is_foreign_format ? temporary_file("cells.vtu") : output;
  Unused_content unused;
  const Mesh_content content = complex.content(std::move(mesh), extension(path), unused);
  print_unused(input, unused);
  complex.write(path, content);
  if (is_foreign_format)
    write_foreign(path, output);
}

void convert_image(const std::string& input, const std::string& output) {
  require_format(input, "an image", output,
                 {"inr", "mha", "nii", "gz", "tif", "tiff", "vti", "vtk"});
  std::vector<int> labels;
  const Grid grid = read_label_image(input, labels);
  write_label_image(output, grid, labels);
}

} // namespace

void All_inputs::convert(const std::string& input, const std::string& output,
                         const std::string& labels, const std::string& thresholds) const {
  const std::string native = native_file(input, labels, thresholds);
  Run_start start;
  start.inputs = {native};
  if (!std::ifstream(native))
    throw Input_error("cannot open " + input + "; check that the file exists and is readable");
  if (dimension_of(start) == 2) {
    require_format(input, "regions in the plane", output, {"wkt", "poly", "svg", "vtu"});
    return track_figure(start, std::nullopt)->write(output);
  }
  require_extension(native, {"off", "obj", "ply", "stl", "mesh", "vtu", "inr", "gz"});
  switch (input_kind(native)) {
  case Input_kind::tetrahedra:
    return convert_tetrahedra(native, output, labels);
  case Input_kind::image:
    return convert_image(native, output);
  default:
    return convert_surface(native, output, labels);
  }
}

void All_inputs::convert_to_image(const std::string& checkpoint, const std::string& output,
                                  const std::string& grid) const {
  require_format(checkpoint, "a complex", output,
                 {"inr", "mha", "nii", "gz", "tif", "tiff", "vti", "vtk"});
  std::string metadata;
  const auto tracked = track_checkpoint(checkpoint, metadata);
  const auto* const in_space = dynamic_cast<const Tracked_complex_3*>(tracked.get());
  if (in_space == nullptr)
    throw Usage_error("--grid applies only in space; write .svg or .vtu");
  const std::string native = native_file(grid, "", is_foreign(grid) ? "0" : "");
  if (extension(native) != "inr" && extension(native) != "gz")
    throw Input_error(grid + " is no image of voxels with several layers; --grid needs one");
  tell_lost_names(output, tracked->label_names);
  std::vector<int> unused;
  const Grid voxels = read_label_image(native, unused);
  write_label_image(output, voxels, DSC::sample_labels(in_space->complex, voxels),
                    native == grid ? "" : grid);
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Inputs.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/labeled_tetrahedra.h"
#include "input/run_start.h"
#include "input/surface.h"
#include "input/translations.h"
#include "input/voxel_images.h"
#include "motions/mesh_at_rest.h"
#include "motions/tracked_complex_3.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Grid = DSC::Sampling_grid<3>;

void require_output(const std::string& input, const std::string& what, const std::string& output,
                    unsigned native, unsigned foreign) {
  if (!has_format(output, Use::write, native, foreign))
    throw Usage_error(input + " contains " + what + ", which '" + output +
                      "' cannot contain; write " + formats_with(Use::write, native, foreign));
}

void convert_surface(const std::string& input, const std::string& output,
                     const std::string& labels) {
  require_output(input, "a surface", output, content::surface, content::surface);
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
  const bool is_foreign_format = has_format(output, Use::write, 0, content::surface);
  const std::string path = is_foreign_format ? temporary_file("surface.ply") : output;
  CGAL::IO::write_named_interface(path, result, names);
  if (is_foreign_format)
    write_foreign(path, output);
}

void convert_tetrahedra(const std::string& input, const std::string& output,
                        const std::string& labels) {
  require_output(input, "tetrahedra", output,
                 content::tetrahedra | content::surface | content::picture,
                 content::tetrahedra | content::surface);
  Labeled_tetrahedra mesh = read_tetrahedra(input, labels);
  const Mesh_at_rest complex(input, mesh);
  const bool has_cells = has_format(output, Use::write, content::tetrahedra, content::tetrahedra);
  if (!has_cells && complex.statistics().interface_facets == 0)
    throw Input_error(input +
                      ": all tetrahedra have the same label, so there is no interface; write " +
                      formats_with(Use::write, content::tetrahedra, content::tetrahedra));
  const bool is_foreign_format = has_format(output, Use::write, 0, content::surface);
  const std::string path =
      is_foreign_format ? temporary_file(has_cells ? "cells.vtu" : "surface.ply") : output;
  Unused_content unused;
  const Mesh_content content = complex.content(std::move(mesh), extension(path), unused);
  print_unused(input, unused);
  complex.write(path, content);
  if (is_foreign_format)
    write_foreign(path, output);
}

void convert_image(const std::string& input, const std::string& output) {
  require_output(input, "an image", output, 0, content::voxels);
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
    require_output(input, "regions in the plane", output, content::regions, 0);
    return track_figure(start, std::nullopt)->write(output);
  }
  require_format(native, Use::read, content::starts, content::starts);
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
  require_output(checkpoint, "a complex", output, 0, content::voxels);
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

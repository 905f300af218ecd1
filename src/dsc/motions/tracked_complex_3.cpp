// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/tracked_complex_3.h"

#include "input/files.h"
#include "motions/tracked_whole_impl.h"
#include "output/angle_statistics.h"
#include "output/label_titles.h"
#include "output/picture.h"
#include "programs/errors.h"
#include "programs/option_values.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Interface_remeshing/subdivide_interface_3.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <array>
#include <utility>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

Statistics Tracked_complex_3::statistics() const {
  const double scale = complex.normalization().scale;
  Statistics statistics = {};
  statistics.dimension = 3;
  statistics.vertices = complex.number_of_vertices();
  statistics.cells = complex.number_of_cells();
  statistics.interface_facets = complex.interface_facets().size();
  for (const auto& [label, area, euler_characteristic] : complex.label_interfaces())
    statistics.labels.push_back({label, complex.number_of_cells(label),
                                 complex.volume(label) * scale * scale * scale,
                                 area * scale * scale, complex.number_of_components(label),
                                 euler_characteristic, name_of(label)});
  set_angles(complex, statistics);
  statistics.min_quality = worst_quality();
  return statistics;
}

namespace {

using Complex = Tracked_complex_3::Complex;

void write_picture_png(const std::string& path, const Complex& complex) {
  Picture picture;
  picture.is_in_space = true;
  for (const auto& f : complex.interface_facets()) {
    Picture_polygon triangle = {{}, color_of_label(f.first->label())};
    for (const auto v : complex.facet_vertices(f))
      triangle.corners.push_back(DSC::coordinates_of<3>(complex.user_position(v)));
    picture.polygons.push_back(std::move(triangle));
  }
  write_picture(path, picture);
}

/// Returns the velocities at the points of a subdivided surface, as the arrays vx, vy and vz.
/// The subdivision is linear in the points, and its weights depend on the connectivity only. So the
/// velocities are subdivided like points.
/// \param velocities three coordinates for each point of the surface
std::vector<DSC::Mesh_array>
subdivided_velocities(DSC::Interface_surface_3<Tracked_complex_3::Complex> surface,
                      const std::vector<double>& velocities, int subdivisions) {
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    surface.points[i] = {velocities[3 * i], velocities[3 * i + 1], velocities[3 * i + 2]};
  surface = DSC::subdivide_interface(std::move(surface), subdivisions);
  std::vector<DSC::Mesh_array> result = {
      {"vx", "Float32", 1, {}}, {"vy", "Float32", 1, {}}, {"vz", "Float32", 1, {}}};
  for (const auto& velocity : surface.points)
    for (int axis = 0; axis < 3; ++axis)
      result[std::size_t(axis)].values.push_back(velocity[axis]);
  return result;
}

} // namespace

void Tracked_complex_3::write(const std::string& path) const {
  require_extension(path, {"off", "obj", "ply", "stl", "vtu", "mesh", "png"});
  const std::string format = extension(path);
  tell_lost_names(path, label_names);
  if (format == "vtu")
    write_volume_vtu(path);
  else if (format == "png")
    write_picture_png(path, complex);
  else if (format == "mesh")
    CGAL::IO::write_MEDIT(path, complex);
  else
    CGAL::IO::write_interface(path, DSC::extract_interface(complex), label_names);
}

void Tracked_complex_3::write_subdivided(const std::string& path, int subdivisions) const {
  const auto surface = DSC::extract_interface(complex);
  const auto smooth = DSC::subdivide_interface(surface, subdivisions);
  const DSC::Mesh_arrays values = arrays.of_interface();
  if (values.points.empty())
    CGAL::IO::write_interface(path, smooth, label_names);
  else
    CGAL::IO::write_interface(
        path, smooth, subdivided_velocities(surface, values.points[0].values, subdivisions));
}

template class Tracked_whole<Complex>;

} // namespace dsc

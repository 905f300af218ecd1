// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/tracked_complex_3.h"

#include "motions/tracked_whole_impl.h"
#include "output/complex_output_3.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Interface_remeshing/subdivide_interface_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

Statistics Tracked_complex_3::statistics() const { return statistics_of(complex); }

namespace {

using Complex = Tracked_complex_3::Complex;

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
  write_complex(path, complex, arrays.of_cells());
}

void Tracked_complex_3::write_subdivided(const std::string& path, int subdivisions) const {
  const auto surface = DSC::extract_interface(complex);
  const auto smooth = DSC::subdivide_interface(surface, subdivisions);
  const DSC::Mesh_arrays values = arrays.of_interface();
  if (values.points.empty())
    CGAL::IO::write_interface(path, smooth);
  else
    CGAL::IO::write_interface(
        path, smooth, subdivided_velocities(surface, values.points[0].values, subdivisions));
}

template class Tracked_whole<Complex>;

} // namespace dsc

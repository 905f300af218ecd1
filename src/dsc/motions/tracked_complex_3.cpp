// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/tracked_complex_3.h"

#include "input/files.h"
#include "input/translations.h"
#include "motions/arrays_on.h"
#include "motions/run_position.h"
#include "motions/tracked_whole_impl.h"
#include "output/complex_output_3.h"

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Interface_remeshing/subdivide_interface_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

namespace dsc {

Statistics Tracked_complex_3::statistics() const { return statistics_of(complex, label_names); }

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

void Tracked_complex_3::carry(Mesh_arrays carried) {
  m_carried = std::move(carried);
  arrays.of_cells = [this] { return m_carried; };
}

void Tracked_complex_3::grow_domain() {
  const std::optional<Labeled_tetrahedra> before =
      carries_arrays() ? std::make_optional(tetrahedra_of(complex, m_carried)) : std::nullopt;
  Tracked_whole::grow_domain();
  if (before)
    m_carried = arrays_on(complex, *before);
}

void Tracked_complex_3::keep() {
  Tracked_whole::keep();
  m_kept_arrays = m_carried;
}

void Tracked_complex_3::forget() {
  Tracked_whole::forget();
  m_kept_arrays.reset();
}

void Tracked_complex_3::go_back() {
  Tracked_whole::go_back();
  if (m_kept_arrays)
    m_carried = std::move(*m_kept_arrays);
  m_kept_arrays.reset();
}

void Tracked_complex_3::write_interface_vtu(const std::string& path) const {
  if (m_carried.points.empty())
    return Tracked_whole::write_interface_vtu(path);
  const DSC::Vertex_numbers numbers(complex, complex.vertices());
  std::vector<std::size_t> rows;
  for (const auto v : complex.interface_vertices())
    rows.push_back(numbers(v));
  Mesh_arrays on_interface;
  for (const DSC::Mesh_array& array : m_carried.points)
    on_interface.points.push_back(array.selected(rows));
  CGAL::IO::write_interface_VTU(path, complex, with_names(std::move(on_interface)));
}

void Tracked_complex_3::write_checkpoint(const std::string& path,
                                         const std::string& metadata) const {
  Tracked_whole::write_checkpoint(path, with_arrays(metadata, m_carried));
}

void Tracked_complex_3::write(const std::string& path) const {
  write_complex(path, complex, with_names(arrays.of_cells()));
  if (extension(path) == "vtu" || extension(path) == "png")
    return;
  for (const auto* list : {&m_carried.points, &m_carried.cells})
    for (const DSC::Mesh_array& array : *list)
      print_note(path, "does not contain the array '" + array.name + "'; write .vtu");
}

void Tracked_complex_3::write_subdivided(const std::string& path, int subdivisions) const {
  const auto surface = DSC::extract_interface(complex);
  const auto smooth = DSC::subdivide_interface(surface, subdivisions);
  const DSC::Mesh_arrays values = arrays.of_interface();
  if (values.points.empty())
    CGAL::IO::write_named_interface(path, smooth, label_names);
  else
    CGAL::IO::write_interface(
        path, smooth, subdivided_velocities(surface, values.points[0].values, subdivisions));
}

template class Tracked_whole<Complex>;

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_WHOLE_IMPL_H
#define DSC_TRACKED_WHOLE_IMPL_H

#include "motions/tracked_whole.h"
#include "output/angle_statistics.h"

#include <CGAL/Complex_construction/grow_domain.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Mesh_files/VTU_2.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/checkpoint.h>

namespace dsc {

template <class Complex_> bool Tracked_whole<Complex_>::has_room() const {
  return DSC::has_room_around_interface(complex);
}

template <class Complex_> void Tracked_whole<Complex_>::grow_domain() { DSC::grow_domain(complex); }

template <class Complex_> void Tracked_whole<Complex_>::go_back() {
  if (!m_kept)
    return;
  complex.clear(); // to save memory
  complex.restore(*m_kept);
  m_kept.reset();
}

template <class Complex_>
std::size_t Tracked_whole<Complex_>::missing_facets(double edge_per_thickness) const {
  return DSC::missing_facets(complex, edge_per_thickness);
}

template <class Complex_> double Tracked_whole<Complex_>::worst_quality() const {
  return least_quality(complex);
}

template <class Complex_>
std::vector<Surface_point> Tracked_whole<Complex_>::interface_points() const {
  std::vector<Surface_point> points;
  for (const typename Complex::Vertex_handle v : complex.interface_vertices()) {
    const auto p = complex.user_position(v);
    points.emplace_back(p.x(), p.y(), Complex::dimension == 3 ? p[Complex::dimension - 1] : 0);
  }
  return points;
}

template <class Complex_> double Tracked_whole<Complex_>::sweep_seconds() const {
  using Vertex_handle = typename Complex::Vertex_handle;
  return seconds_of_sweep(complex.cells(), [&](typename Complex::Cell_handle c) {
    const bool is_positive = complex.is_positive(
        c, [](Vertex_handle v) -> const typename Complex::Point& { return v->point(); });
    return is_positive + complex.quality(c, [&](Vertex_handle v) { return complex.position(v); });
  });
}

template <class Complex_>
void Tracked_whole<Complex_>::write_interface_vtu(const std::string& path) const {
  CGAL::IO::write_interface_VTU(path, complex, with_names(arrays.of_interface()));
}

template <class Complex_>
void Tracked_whole<Complex_>::write_volume_vtu(const std::string& path) const {
  CGAL::IO::write_VTU(path, complex, with_names(arrays.of_cells()));
}

template <class Complex_>
void Tracked_whole<Complex_>::write_checkpoint(const std::string& path,
                                               const std::string& metadata) const {
  CGAL::IO::write_checkpoint(path, complex.state(), metadata);
}

} // namespace dsc

#endif // DSC_TRACKED_WHOLE_IMPL_H

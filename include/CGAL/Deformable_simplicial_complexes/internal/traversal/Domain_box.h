// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_DOMAIN_BOX_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_DOMAIN_BOX_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The box that is the domain of a complex. Domains of other shapes have no box: their boundary is
// fixed, and points are not clamped.
template <class Complex> class Domain_box
{
public:
  using Point = typename Complex::Point;
  static constexpr int d = Complex::dimension;

  // Linear in the size of the boundary.
  explicit Domain_box(const Complex& complex) {
    if constexpr (Complex::Domain::has_outside) {
      if (complex.number_of_cells() == 0)
        return;
      m_is_box = true;
      std::vector<typename Complex::Cell_handle> star;
      complex.star(complex.triangulation().infinite_vertex(), star);
      for (auto c : star)
        for (int i = 0; i <= d; ++i)
          if (const auto v = c->vertex(i); !complex.is_infinite(v)) {
            m_is_box = m_is_box && (v->boundary_class() & Boundary_class::fixed) == 0;
            m_extent.add(complex.position(v));
          }
    }
  }

  bool is_box() const { return m_is_box; }
  const Extent<d>& extent() const { return m_extent; }

  // Moves a point outside the box to the nearest point of the box. Returns whether the point was
  // moved.
  bool clamp(Point& p) const {
    if (!m_is_box)
      return false;
    std::array<double, d> coordinates = coordinates_of<d>(p);
    bool is_outside = false;
    for (int axis = 0; axis < d; ++axis) {
      const double x = coordinates[axis];
      coordinates[axis] = std::clamp(x, m_extent.lower(axis), m_extent.upper(axis));
      is_outside = is_outside || coordinates[axis] != x;
    }
    if (is_outside)
      p = point_at<Complex>(coordinates);
    return is_outside;
  }

  // Returns the indices of the vertices that would leave the box, if no vertex of the interface is
  // on a side. Otherwise, sides are walls, and no vertex leaves the box.
  template <class Vertex_handle>
  std::vector<std::size_t> leaving(const std::vector<Vertex_handle>& vertices,
                                   std::vector<Point> destinations) const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i]->boundary_class() != Boundary_class::inside)
        return {};
      if (clamp(destinations[i]))
        result.push_back(i);
    }
    return result;
  }

private:
  Extent<d> m_extent;
  bool m_is_box = false;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_DOMAIN_BOX_H

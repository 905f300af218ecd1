// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CONFORMING_TETRAHEDRALIZER_3_H
#define CGAL_CONFORMING_TETRAHEDRALIZER_3_H

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/internal/building/points_in_space_3.h>
#include <CGAL/Mesh_support/internal/cgal/conforming_triangulation_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Unique_hash_map.h>

#include <map>
#include <new>

namespace CGAL {

/*!
\ingroup PkgComplexConstructionRef

Constrained tetrahedralizer that uses CGAL's conforming constrained Delaunay triangulation
(`CGAL::make_conforming_constrained_Delaunay_triangulation_3()`). It needs \cgal 6.1 or newer, and
no other library.

It adds points on edges of the input where these edges are not in a Delaunay triangulation, which
divides triangles. The added points are rounded to `double`, so that divided triangles are flat up
to rounding. Away from triangles, it adds points at distances of about the edge lengths of near
triangles. Tetrahedra can be degenerate up to rounding where triangles are divided or parts are
thin. The functions that build complexes improve them.

A call cannot be interrupted, and its time and memory are not bounded. Both can be very large if
a thin part has flat sides of many triangles that are rounded, such as a rotated plate. Use
`Tetgen_tetrahedralizer_3` for such surfaces.

\cgalModels{ConstrainedTetrahedralizer_3}
*/
class Conforming_tetrahedralizer_3
{
public:
  /*!
  Fills the space inside a closed surface with tetrahedra. The surface may enclose other ones. A
  call with the same input gives the same result.

  \tparam Kernel kernel of the triangulation; its number type is `double` and its predicates are
          exact
  \param points vertices of the triangles
  \param triangles indices into `points`
  \pre Points are finite and differ. Triangles meet only in common vertices and edges.
  \return see `ConstrainedTetrahedralizer_3`; `facets` has a value
  \throws Deformable_simplicial_complexes::Tetrahedralization_error if CGAL reports a failure, or a
          tetrahedron is degenerate because of rounding
  */
  template <class Kernel = Exact_predicates_inexact_constructions_kernel>
  Deformable_simplicial_complexes::Tetrahedralization_3
  operator()(const std::vector<std::array<double, 3>>& points,
             const std::vector<std::array<std::size_t, 3>>& triangles) const {
    namespace DSC = Deformable_simplicial_complexes;
    static_assert(DSC::has_conforming_triangulation_3 || sizeof(Kernel) == 0,
                  "Conforming_tetrahedralizer_3 needs CGAL 6.1 or newer: update CGAL, or use "
                  "Tetgen_tetrahedralizer_3");
    using Triangulation = DSC::Conforming_triangulation_3<Kernel>;
    std::vector<typename Kernel::Point_3> corners;
    for (const auto& p : points)
      corners.emplace_back(p[0], p[1], p[2]);
    static constexpr double size = 2, distance = .5; // nothing else makes well-shaped tetrahedra
    for (const auto& p : DSC::internal::points_in_space(points, triangles, size, distance))
      corners.emplace_back(p[0], p[1], p[2]);
    try {
      return converted<Kernel>(Triangulation(corners, triangles), points, triangles);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const DSC::Error&) {
      throw;
    } catch (const std::exception& e) {
      throw DSC::Tetrahedralization_error(
          std::string("the conforming triangulation failed, ") + e.what() +
          ": separate vertices and surfaces that are very close, or remesh the surfaces");
    }
  }

private:
  // Returns the cells inside the outermost constrained facets, and the constrained facets. Throws
  // `Tetrahedralization_error` if a cell is not positively oriented, or facets are missing.
  template <class Kernel, class Constrained>
  static Deformable_simplicial_complexes::Tetrahedralization_3
  converted(const Constrained& constrained, const std::vector<std::array<double, 3>>& points,
            const std::vector<std::array<std::size_t, 3>>& triangles) {
    using Cell_handle = typename Constrained::Triangulation::Cell_handle;
    using Vertex_handle = typename Constrained::Triangulation::Vertex_handle;
    using Deformable_simplicial_complexes::Tetrahedralization_error;
    const auto& triangulation = constrained.triangulation();
    Deformable_simplicial_complexes::Tetrahedralization_3 result = {points, {}, {}, {}};

    std::map<std::array<double, 3>, std::size_t> indices;
    for (std::size_t i = 0; i < points.size(); ++i)
      indices.emplace(points[i], i);
    const auto index = [&](Vertex_handle v) {
      const std::array p = {v->point().x(), v->point().y(), v->point().z()};
      const auto [found, is_new] = indices.emplace(p, result.points.size());
      if (is_new)
        result.points.push_back(p);
      return found->second;
    };

    Unique_hash_map<Cell_handle, bool> is_outside(false);
    std::vector<Cell_handle> outside = {triangulation.infinite_cell()};
    is_outside[outside.front()] = true;
    for (std::size_t i = 0; i < outside.size(); ++i)
      for (int k = 0; k < 4; ++k)
        if (const Cell_handle c = outside[i]->neighbor(k);
            !is_outside[c] &&
            (triangulation.is_infinite(c) || !constrained.is_facet_constrained(outside[i], k))) {
          is_outside[c] = true;
          outside.push_back(c);
        }
    for (const Cell_handle c : triangulation.finite_cell_handles()) {
      if (is_outside[c])
        continue;
      if (triangulation.tetrahedron(c).orientation() != POSITIVE)
        throw Tetrahedralization_error(
            "rounding of added points inverts tetrahedra: remesh the surfaces near thin parts");
      result.tetrahedra.push_back(
          {index(c->vertex(0)), index(c->vertex(1)), index(c->vertex(2)), index(c->vertex(3))});
    }

    // Twice the area vectors of triangles, without the facets found.
    std::vector<typename Kernel::Vector_3> normals, uncovered;
    const auto edge = [&](std::size_t i, std::size_t j) {
      const auto &p = result.points[i], &q = result.points[j];
      return typename Kernel::Vector_3(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    };
    for (const auto& t : triangles)
      normals.push_back(cross_product(edge(t[0], t[1]), edge(t[0], t[2])));
    uncovered = normals;
    for (const auto& facet : constrained.constrained_facets()) {
      const auto v = triangulation.vertices(facet);
      const std::size_t t = constrained.face_constraint_index(facet);
      std::array<std::size_t, 3> f = {index(v[0]), index(v[1]), index(v[2])};
      auto normal = cross_product(edge(f[0], f[1]), edge(f[0], f[2]));
      if (normal * normals[t] < 0) {
        std::swap(f[1], f[2]);
        normal = -normal;
      }
      uncovered[t] = uncovered[t] - normal;
      result.facets.push_back(f);
      result.triangles_of_facets.push_back(t);
    }
    static constexpr double tolerance = 1e-6; // relative to squared lengths
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& t = triangles[i];
      const double extent = edge(t[0], t[1]).squared_length() + edge(t[0], t[2]).squared_length();
      if (!(uncovered[i].squared_length() <= tolerance * tolerance * extent * extent))
        throw Tetrahedralization_error(
            "the conforming triangulation lost parts of triangles: remesh the surfaces");
    }
    return result;
  }
};

} // namespace CGAL

#endif // CGAL_CONFORMING_TETRAHEDRALIZER_3_H

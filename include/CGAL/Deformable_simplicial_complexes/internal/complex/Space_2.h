// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_SPACE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_SPACE_2_H

#include <CGAL/Deformable_simplicial_complexes/internal/arguments/complex_arguments.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hilbert_policy_tags.h>
#include <CGAL/Hilbert_sort_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/determinant.h>

#include <cmath>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Types, constants and functions of the plane, with names that do not depend on the dimension.
// Cells are triangles, and facets are edges.
template <class Traits, class Tds> class Space_2
{
public:
  static constexpr int dimension = 2;

  using Geom_traits = Traits;
  using Triangulation_data_structure = Tds;
  using Triangulation = Triangulation_2<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cell_handle = typename Triangulation::Face_handle;
  using Point = typename Traits::Point_2;
  using Vector = typename Traits::Vector_2;
  template <class Kernel, class Map>
  using Hilbert_sorter =
      Hilbert_sort_2<Spatial_sort_traits_adapter_2<Kernel, Map>, Hilbert_sort_median_policy>;

  // For each vertex, the vertices of the opposite edge; the cell is on the left of this edge.
  static constexpr int facet_vertices[3][2] = {{1, 2}, {2, 0}, {0, 1}};
  // For each vertex, an even permutation of the vertices of a cell that begins with it.
  static constexpr int even_permutation[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
  // The edges of a facet; in 2D, the facet itself.
  static constexpr int facet_edges[1][2] = {{0, 1}};

  static auto orientation(const Traits& traits) { return traits.orientation_2_object(); }

  // Returns the signed area of a triangle, up to rounding.
  static double measure(const Point& p, const Point& q, const Point& r) {
    const Vector v = q - p, w = r - p;
    return CGAL::determinant(v.x(), v.y(), w.x(), w.y()) / 2;
  }

  // Returns the area of the triangle between an edge, given as seen from outside, and a point
  // inside.
  static double measure_of_cone(const std::array<Point, 2>& facet, const Point& apex) {
    return measure(facet[0], facet[1], apex);
  }

  static double facet_measure(const std::array<Point, 2>& facet) {
    return std::sqrt((facet[1] - facet[0]).squared_length());
  }

  // Returns the outward normal of a facet; its length is the length of the facet.
  static Vector facet_normal(const std::array<Point, 2>& facet) {
    const Vector edge = facet[1] - facet[0];
    return {edge.y(), -edge.x()};
  }

  // Returns the area of a regular triangle.
  static double regular_measure(double edge) { return edge * edge * std::sqrt(3.) / 4; }

  // Outward normals of the edges of a triangle, with the lengths of the edges, and twice the area.
  struct Frame
  {
    std::array<Vector, 3> normals;
    double parallelotope;
  };
  static Frame frame(const std::array<Point, 3>& p) {
    const Vector a = p[1] - p[0], b = p[2] - p[0];
    return {{facet_normal({p[1], p[2]}), facet_normal({p[2], p[0]}), facet_normal({p[0], p[1]})},
            a.x() * b.y() - a.y() * b.x()};
  }

  // Returns an estimate of the area of a cell whose largest normal has the given squared length.
  static double measure_of_extent(double squared_normal) { return squared_normal; }

  static double length(const Vector& v) { return std::hypot(v.x(), v.y()); }

  // Returns the determinant of the 2x2 matrix with entries `entry(row, column)`.
  template <class Number, class Entry> static Number determinant(const Entry& entry) {
    return CGAL::determinant<Number>(entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1));
  }

  // Returns whether the adjacency of vertices and cells is consistent.
  static bool is_sewn(const Triangulation_data_structure& tds, bool verbose) {
    return tds.is_valid(verbose);
  }
  static auto all_cells(const Triangulation& t) { return t.all_face_handles(); }
  static auto finite_cells(const Triangulation& t) { return t.finite_face_handles(); }
  static const auto& cell_container(const Triangulation_data_structure& tds) { return tds.faces(); }
  static Cell_handle create_cell(Triangulation_data_structure& tds) { return tds.create_face(); }
  static void delete_cell(Triangulation_data_structure& tds, Cell_handle c) { tds.delete_face(c); }

  // Returns in `cells` the two cells incident to the edge between two vertices of a cell. The given
  // cell comes first.
  static void cells_around_edge(const Triangulation&, Cell_handle c, int i, int j,
                                std::vector<Cell_handle>& cells) {
    cells = {c, c->neighbor(3 - i - j)};
  }

  // Returns whether a closed, connected 1-manifold with these numbers of vertices and facets is a
  // circle, which is always true.
  static bool is_sphere(std::size_t vertices, std::size_t facets) { return vertices == facets; }
};

// The space of the arguments of a complex.
template <class Traits, class Tds,
          class Kernel = std::conditional_t<require_kernel<Traits>(), Traits,
                                            Exact_predicates_inexact_constructions_kernel>,
          class Default_tds =
              Triangulation_data_structure_2<Deformable_simplicial_complex_vertex_base_2<Kernel>,
                                             Deformable_simplicial_complex_face_base_2<Kernel>>,
          class Given_tds = typename Default::Get<
              std::conditional_t<is_kernel<Traits>, Tds, Default>, Default_tds>::type>
using Space_of_2 =
    Space_2<Kernel, std::conditional_t<require_bases<Given_tds, typename Kernel::Point_2>(),
                                       Given_tds, Default_tds>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_SPACE_2_H

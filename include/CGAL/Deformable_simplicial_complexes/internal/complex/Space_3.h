// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_SPACE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_SPACE_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/arguments/complex_arguments.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hilbert_policy_tags.h>
#include <CGAL/Hilbert_sort_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/determinant.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Types, constants and functions of three-dimensional space, with names that do not depend on the
// dimension. Cells are tetrahedra, and facets are triangles.
template <class Traits, class Tds> class Space_3
{
public:
  static constexpr int dimension = 3;

  using Geom_traits = Traits;
  using Triangulation_data_structure = Tds;
  using Triangulation = Triangulation_3<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cell_handle = typename Triangulation::Cell_handle;
  using Point = typename Traits::Point_3;
  using Vector = typename Traits::Vector_3;
  template <class Kernel, class Map>
  using Hilbert_sorter =
      Hilbert_sort_3<Spatial_sort_traits_adapter_3<Kernel, Map>, Hilbert_sort_median_policy>;

  // For each vertex, the vertices of the opposite facet, counterclockwise seen from outside the
  // cell.
  static constexpr int facet_vertices[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

  // For each vertex, an even permutation of the vertices of a cell that begins with it.
  static constexpr int even_permutation[4][4] = {
      {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  // The edges of a facet.
  static constexpr int facet_edges[3][2] = {{0, 1}, {1, 2}, {2, 0}};

  static auto orientation(const Traits& traits) { return traits.orientation_3_object(); }

  // Returns the signed volume of a tetrahedron, up to rounding.
  static double measure(const Point& p, const Point& q, const Point& r, const Point& s) {
    return cross_product(q - p, r - p) * (s - p) / 6;
  }

  // Returns the volume of the tetrahedron between a facet, given as seen from outside, and a point
  // inside. The point is the last argument, which avoids a loss of precision if the point is far
  // away.
  static double measure_of_cone(const std::array<Point, 3>& facet, const Point& apex) {
    return measure(facet[2], facet[1], facet[0], apex);
  }

  static double facet_measure(const std::array<Point, 3>& facet) {
    return std::sqrt(cross_product(facet[1] - facet[0], facet[2] - facet[0]).squared_length()) / 2;
  }

  // Returns the outward normal of a facet; its length is twice the area of the facet.
  static Vector facet_normal(const std::array<Point, 3>& facet) {
    return cross_product(facet[1] - facet[0], facet[2] - facet[0]);
  }

  // Returns the volume of a regular tetrahedron.
  static double regular_measure(double edge) { return edge * edge * edge / (6 * std::sqrt(2.)); }

  // Outward normals of the facets of a tetrahedron, with lengths of twice the areas, and six times
  // the volume.
  struct Frame
  {
    std::array<Vector, 4> normals;
    double parallelotope;
  };
  static Frame frame(const std::array<Point, 4>& p) {
    const Tetrahedron_frame<Point> t(p[0], p[1], p[2], p[3]);
    return {t.area_vectors(), t.six_volumes};
  }

  // Returns an estimate of the volume of a cell whose largest normal has the given squared length.
  static double measure_of_extent(double squared_normal) {
    return std::sqrt(squared_normal * std::sqrt(squared_normal));
  }

  static double length(const Vector& v) { return std::hypot(v.x(), v.y(), v.z()); }

  // Returns the determinant of the 3x3 matrix with entries `entry(row, column)`.
  template <class Number, class Entry> static Number determinant(const Entry& entry) {
    return CGAL::determinant<Number>(entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 0),
                                     entry(1, 1), entry(1, 2), entry(2, 0), entry(2, 1),
                                     entry(2, 2));
  }

  // Returns whether the adjacency of vertices and cells is consistent. The test corresponds to the
  // validity test of the data structure, but can be interrupted.
  static bool is_sewn(const Triangulation_data_structure& tds, bool verbose) {
    static constexpr std::size_t fewest = 5; // vertices of the smallest triangulated 3-sphere
    std::size_t vertices = 0, cells = 0, edges = 0;
    for (auto v = tds.vertices_begin(); v != tds.vertices_end(); ++v, ++vertices) {
      Progress_scope::check();
      if (!tds.is_valid(Vertex_handle(v), verbose))
        return false;
    }
    for (auto c = tds.cells_begin(); c != tds.cells_end(); ++c, ++cells) {
      Progress_scope::check();
      if (!tds.is_valid(Cell_handle(c), verbose))
        return false;
    }
    for (auto e = tds.edges_begin(); e != tds.edges_end(); ++e, ++edges)
      Progress_scope::check();
    // Euler's relation; each cell has two facets, because each facet has two cells.
    return vertices >= fewest && vertices == tds.number_of_vertices() && vertices + cells == edges;
  }
  static auto all_cells(const Triangulation& t) { return t.all_cell_handles(); }
  static auto finite_cells(const Triangulation& t) { return t.finite_cell_handles(); }
  static const auto& cell_container(const Triangulation_data_structure& tds) { return tds.cells(); }
  static Cell_handle create_cell(Triangulation_data_structure& tds) { return tds.create_cell(); }
  static void delete_cell(Triangulation_data_structure& tds, Cell_handle c) { tds.delete_cell(c); }

  // Returns in `cells` all cells incident to the edge between two vertices of a cell. The given
  // cell comes first.
  static void cells_around_edge(const Triangulation& t, Cell_handle c, int i, int j,
                                std::vector<Cell_handle>& cells) {
    cells.clear();
    auto around = t.tds().incident_cells(c, i, j);
    const auto first = around;
    do
      cells.push_back(around);
    while (++around != first);
  }

  // Returns whether a closed, connected 2-manifold with these numbers of vertices and facets is a
  // sphere. There are three edges for two facets, so V - E + F = V - F / 2.
  static bool is_sphere(std::size_t vertices, std::size_t facets) {
    return 2 * vertices == facets + 4;
  }
};

// The space of the arguments of a complex.
template <class Traits, class Tds,
          class Kernel = std::conditional_t<require_kernel<Traits>(), Traits,
                                            Exact_predicates_inexact_constructions_kernel>,
          class Default_tds =
              Triangulation_data_structure_3<Deformable_simplicial_complex_vertex_base_3<Kernel>,
                                             Deformable_simplicial_complex_cell_base_3<Kernel>>,
          class Given_tds = typename Default::Get<
              std::conditional_t<is_kernel<Traits>, Tds, Default>, Default_tds>::type>
using Space_of_3 =
    Space_3<Kernel, std::conditional_t<require_bases<Given_tds, typename Kernel::Point_3>(),
                                       Given_tds, Default_tds>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_SPACE_3_H

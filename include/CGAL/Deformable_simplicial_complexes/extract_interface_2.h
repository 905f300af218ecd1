// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXTRACT_INTERFACE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXTRACT_INTERFACE_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Extracted_facets.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is the interface of a planar complex, or a part of it, as segments that share points, in user
coordinates: the twin of `Interface_surface_3`.

On a torus, each connected part is unwrapped: points may be outside the box, and a part that goes
around is cut open, with several points for the vertices there.

\tparam Complex is an instance of `Deformable_simplicial_complex_2`.
*/
template <class Complex> struct Interface_curve_2
{
  using Point_2 = typename Complex::Approximate_point_2; ///< has coordinates of type `double`
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Label = typename Complex::Label;                 ///< name of a phase

  /// the points in user coordinates, by increasing time stamp of their vertices; on a torus,
  /// further images of these follow
  std::vector<Point_2> points;

  /// indices into `points`; the first label of the segment is on its left
  std::vector<std::array<std::size_t, 2>> segments;

  /// for each segment the label on its left and that on its right
  std::vector<std::array<Label, 2>> labels;

  /// for each point the vertex it is the position of
  std::vector<Vertex_handle> vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

extracts the whole interface of a planar complex, with the larger label on the left.

\param dsc is the complex; it is not changed.
\return the segments in the order of `dsc.interface_facets()`.

Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class Domain>
Interface_curve_2<Deformable_simplicial_complex_2<Traits, Tds, Domain>>
extract_interface(const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc) {
  internal::Extracted_facets<Deformable_simplicial_complex_2<Traits, Tds, Domain>> extracted(
      dsc, dsc.interface_facets(), false);
  return {std::move(extracted.points), std::move(extracted.facets), std::move(extracted.labels),
          std::move(extracted.vertices)};
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

extracts the interface between two labels as a curve: otherwise as above.

\param dsc is the complex; it is not changed.
\param a, b two labels; the larger one is on the left.

Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class Domain>
Interface_curve_2<Deformable_simplicial_complex_2<Traits, Tds, Domain>>
extract_interface(const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc, int a, int b) {
  internal::Extracted_facets<Deformable_simplicial_complex_2<Traits, Tds, Domain>> extracted(
      dsc, dsc.interface_facets(a, b), false);
  return {std::move(extracted.points), std::move(extracted.facets), std::move(extracted.labels),
          std::move(extracted.vertices)};
}

namespace internal {

// Adds a cell and all that are connected with it through facets between cells of its label to
// `found`, and returns them.
template <class Complex>
std::vector<typename Complex::Cell_handle>
connected_cells(const Complex& complex, typename Complex::Cell_handle first,
                std::set<typename Complex::Cell_handle>& found) {
  found.insert(first);
  std::vector<typename Complex::Cell_handle> result = {first};
  for (std::size_t k = 0; k < result.size(); ++k)
    for (int i = 0; i < Complex::corners; ++i) {
      const auto next = result[k]->neighbor(i);
      if (!complex.is_infinite(next) && next->label() == first->label() &&
          found.insert(next).second)
        result.push_back(next);
    }
  return result;
}

// The boundaries of the parts of labels: for each connected component of cells of a label closed
// ways with that on their left, which pass no vertex twice.
template <class Complex> class Label_boundary_2
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Way = std::vector<Vertex_handle>;

  // Of the cells whose labels are wanted.
  template <class Wanted>
  Label_boundary_2(const Complex& complex, const Wanted& is_wanted) : m_complex(complex) {
    std::set<Cell_handle> found;
    for (Cell_handle first : complex.cells()) {
      if (!is_wanted(complex.label(first)) || found.count(first) > 0)
        continue;
      m_parts.push_back({complex.label(first), {}});
      for (Cell_handle c : connected_cells(complex, first, found))
        for (int i = 0; i < 3; ++i)
          if (is_side(c, i) && m_followed.insert({c, i}).second)
            follow(c, i);
    }
  }

  struct Part
  {
    typename Complex::Label label;
    std::vector<Way> ways;
  };

  // One for each component, in the order of their first cells.
  const std::vector<Part>& parts() const { return m_parts; }

  // Whether a way goes counterclockwise around what it bounds, exactly: as it does at its first
  // vertex from the left.
  bool is_outer(const Way& way) const {
    std::size_t first = 0;
    for (std::size_t i = 1; i < way.size(); ++i)
      if (way[i]->point() < way[first]->point())
        first = i;
    const auto point = [&](std::size_t i) { return way[i % way.size()]->point(); };
    return m_complex.orientation()(point(first + way.size() - 1), point(first), point(first + 1)) ==
           COUNTERCLOCKWISE;
  }

private:
  bool is_side(Cell_handle c, int i) const {
    const Cell_handle d = c->neighbor(i);
    return m_complex.is_infinite(d) || d->label() != c->label();
  }

  // Edge after edge, always with the next one of the same fan of cells. What lies between two
  // visits to a vertex is a way of its own.
  void follow(Cell_handle c, int i) {
    auto& ways = m_parts.back().ways;
    Way way;
    std::map<Vertex_handle, std::size_t> place; // in the way
    do {
      const Vertex_handle a = c->vertex((i + 1) % 3);
      const auto [first, is_new] = place.emplace(a, way.size());
      if (!is_new) {
        ways.emplace_back(way.begin() + std::ptrdiff_t(first->second), way.end());
        for (auto v = way.begin() + std::ptrdiff_t(first->second) + 1; v != way.end(); ++v)
          place.erase(*v);
        way.resize(first->second);
      }
      way.push_back(a);
      int next = (i + 1) % 3; // the edge that begins where this one ends
      const Vertex_handle b = c->vertex((i + 2) % 3);
      while (!is_side(c, next)) {
        c = c->neighbor(next);
        next = (c->index(b) + 2) % 3;
      }
      i = next;
    } while (m_followed.insert({c, i}).second);
    ways.push_back(std::move(way));
  }

  const Complex& m_complex;
  std::set<typename Complex::Facet> m_followed;
  std::vector<Part> m_parts;
};

using Extracted_polygon_2 = Polygon_with_holes_2<Exact_predicates_inexact_constructions_kernel>;

// Those of the labels that are wanted.
template <class Complex, class Wanted>
std::map<int, std::vector<Extracted_polygon_2>> polygons_of_labels(const Complex& dsc,
                                                                   const Wanted& is_wanted) {
  using Polygon = Extracted_polygon_2::Polygon_2;
  std::map<int, std::vector<Extracted_polygon_2>> result;
  const Label_boundary_2<Complex> boundary(dsc, is_wanted);
  for (const auto& part : boundary.parts()) {
    Polygon outer;
    std::vector<Polygon> holes;
    for (const auto& way : part.ways) {
      Polygon polygon;
      for (auto v : way) {
        const auto p = dsc.user_position(v);
        polygon.push_back({p.x(), p.y()});
      }
      if (boundary.is_outer(way))
        outer = std::move(polygon);
      else
        holes.push_back(std::move(polygon));
    }
    result[part.label].emplace_back(std::move(outer), holes.begin(), holes.end());
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

extracts the region of a label as polygons with holes in user coordinates, one for each connected
component. Holes may touch each other and the outer boundary in vertices.

\param dsc is the complex, whose domain is no torus, where a region need not be a polygon. It is not
       changed.
\param label a label; if no cell has it the result is empty.

n log n in the number of cells.
*/
template <class Traits, class Tds, class Domain>
std::vector<Polygon_with_holes_2<Exact_predicates_inexact_constructions_kernel>>
extract_polygons(const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc, int label) {
  static_assert(Domain::has_outside, "a region of a torus need not be a polygon");
  return internal::polygons_of_labels(dsc, [label](int other) { return other == label; })[label];
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

extracts the regions of all labels at once, as above: by their labels.

\param dsc is the complex, whose domain is no torus. It is not changed.

n log n in the number of cells.
*/
template <class Traits, class Tds, class Domain>
std::map<int, std::vector<Polygon_with_holes_2<Exact_predicates_inexact_constructions_kernel>>>
extract_polygons(const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc) {
  static_assert(Domain::has_outside, "a region of a torus need not be a polygon");
  return internal::polygons_of_labels(dsc, [](int) { return true; });
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXTRACT_INTERFACE_2_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_EXTRACT_INTERFACE_2_H
#define CGAL_INTERFACE_REMESHING_EXTRACT_INTERFACE_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Interface_remeshing/internal/extraction/Extracted_facets.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <map>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

The interface of a complex in 2D, or a part of it, as segments that share points, in user
coordinates. The class `Interface_surface_3` is the counterpart in 3D.

On a torus, each connected component of the interface is unwrapped, so that points may be outside
the box. A component that winds around the torus is cut open; vertices at the cut have several
points.

\tparam Complex an instance of `Deformable_simplicial_complex_2`
*/
template <class Complex> struct Interface_curve_2
{
  /// point with coordinates of type `double`
  using Point_2 = typename Complex::Point_2;
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Label = typename Complex::Label;                 ///< name of a phase

  /// points in user coordinates, by increasing time stamp of their vertices; on a torus, further
  /// images of the vertices follow
  std::vector<Point_2> points;

  /// indices into `points`; the first label of the segment is on its left
  std::vector<std::array<std::size_t, 2>> segments;

  /// labels on the left and on the right of each segment
  std::vector<std::array<Label, 2>> labels;

  /// vertex at each point
  std::vector<Vertex_handle> vertices;
};

/*!
\ingroup PkgInterfaceRemeshingRef

Extracts the whole interface of a complex in 2D, with the larger label on the left. Linear in the
number of cells, and n log n in the size of the interface.

\param dsc the complex; it is not changed
\return the segments, in the order of `dsc.interface_facets()`
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
\ingroup PkgInterfaceRemeshingRef

Extracts the interface between two labels as a curve. Linear in the number of cells, and n log n in
the size of the interface.

\param dsc the complex; it is not changed
\param a, b two labels; the larger one is on the left
\return the segments, in the order of `dsc.interface_facets(a, b)`
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

// Returns a cell and all cells that are connected with it through facets between cells of its
// label. Adds them to `found`.
template <class Complex>
std::vector<typename Complex::Cell_handle>
connected_cells(const Complex& complex, typename Complex::Cell_handle first,
                std::set<typename Complex::Cell_handle>& found) {
  found.insert(first);
  std::vector<typename Complex::Cell_handle> result = {first};
  for (std::size_t k = 0; k < result.size(); ++k)
    for (int i = 0; i < Complex::corners; ++i) {
      const auto next = result[k]->neighbor(i);
      if (!complex.is_infinite(next) && next->subdomain_index() == first->subdomain_index() &&
          found.insert(next).second)
        result.push_back(next);
    }
  return result;
}

// Boundaries of the connected components of labels. For each component, they are closed polylines
// with the component on their left. A polyline passes each vertex once.
template <class Complex> class Label_boundary_2
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Polyline = std::vector<Vertex_handle>;

  // Computes the boundaries of all components whose label fulfills `is_selected(label)`.
  template <class Selected>
  Label_boundary_2(const Complex& complex, const Selected& is_selected) : m_complex(complex) {
    std::set<Cell_handle> found;
    for (Cell_handle first : complex.cells()) {
      if (!is_selected(complex.label(first)) || found.count(first) > 0)
        continue;
      m_components.push_back({complex.label(first), {}});
      for (Cell_handle c : connected_cells(complex, first, found))
        for (int i = 0; i < 3; ++i)
          if (is_side(c, i) && m_followed.insert({c, i}).second)
            follow(c, i);
    }
  }

  struct Component
  {
    typename Complex::Label label;
    std::vector<Polyline> polylines;
  };

  // Returns the components, in the order of their first cells.
  const std::vector<Component>& components() const { return m_components; }

  // Returns whether a polyline is counterclockwise, that is, an outer boundary. The test is the
  // exact orientation at the leftmost vertex.
  bool is_outer(const Polyline& polyline) const {
    std::size_t first = 0;
    for (std::size_t i = 1; i < polyline.size(); ++i)
      if (polyline[i]->point() < polyline[first]->point())
        first = i;
    const auto point = [&](std::size_t i) { return polyline[i % polyline.size()]->point(); };
    return m_complex.orientation()(point(first + polyline.size() - 1), point(first),
                                   point(first + 1)) == COUNTERCLOCKWISE;
  }

private:
  bool is_side(Cell_handle c, int i) const {
    const Cell_handle d = c->neighbor(i);
    return m_complex.is_infinite(d) || d->subdomain_index() != c->subdomain_index();
  }

  // Follows the boundary edge by edge; the next edge is always in the same fan of cells. The part
  // between two visits to a vertex becomes a polyline of its own.
  void follow(Cell_handle c, int i) {
    auto& polylines = m_components.back().polylines;
    Polyline polyline;
    std::map<Vertex_handle, std::size_t> place; // index in the polyline
    do {
      const Vertex_handle a = c->vertex((i + 1) % 3);
      const auto [first, is_new] = place.emplace(a, polyline.size());
      if (!is_new) {
        polylines.emplace_back(polyline.begin() + std::ptrdiff_t(first->second), polyline.end());
        for (auto v = polyline.begin() + std::ptrdiff_t(first->second) + 1; v != polyline.end();
             ++v)
          place.erase(*v);
        polyline.resize(first->second);
      }
      polyline.push_back(a);
      int next = (i + 1) % 3; // edge that begins at the end of the present one
      const Vertex_handle b = c->vertex((i + 2) % 3);
      while (!is_side(c, next)) {
        c = c->neighbor(next);
        next = (c->index(b) + 2) % 3;
      }
      i = next;
    } while (m_followed.insert({c, i}).second);
    polylines.push_back(std::move(polyline));
  }

  const Complex& m_complex;
  std::set<typename Complex::Facet> m_followed;
  std::vector<Component> m_components;
};

using Extracted_polygon_2 = Polygon_with_holes_2<Exact_predicates_inexact_constructions_kernel>;

// Returns the polygons of the labels that fulfill `is_selected(label)`.
template <class Complex, class Selected>
std::map<int, std::vector<Extracted_polygon_2>> polygons_of_labels(const Complex& dsc,
                                                                   const Selected& is_selected) {
  using Polygon = Extracted_polygon_2::Polygon_2;
  std::map<int, std::vector<Extracted_polygon_2>> result;
  const Label_boundary_2<Complex> boundary(dsc, is_selected);
  for (const auto& component : boundary.components()) {
    Polygon outer;
    std::vector<Polygon> holes;
    for (const auto& polyline : component.polylines) {
      Polygon polygon;
      for (auto v : polyline) {
        const auto p = dsc.user_position(v);
        polygon.push_back({p.x(), p.y()});
      }
      if (boundary.is_outer(polyline))
        outer = std::move(polygon);
      else
        holes.push_back(std::move(polygon));
    }
    result[component.label].emplace_back(std::move(outer), holes.begin(), holes.end());
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Extracts the region of a label as polygons with holes in user coordinates, one for each connected
component. Holes may touch each other and the outer boundary in vertices. n log n in the number of
cells.

\param dsc the complex, which is not changed. Its domain is not a torus, since a region of a torus
       need not be a polygon.
\param label a label
\return the polygons; empty if no cell has the label
*/
template <class Traits, class Tds, class Domain>
std::vector<Polygon_with_holes_2<Exact_predicates_inexact_constructions_kernel>>
extract_polygons(const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc, int label) {
  static_assert(Domain::has_outside, "a region of a torus need not be a polygon");
  return internal::polygons_of_labels(dsc, [label](int other) { return other == label; })[label];
}

/*!
\ingroup PkgInterfaceRemeshingRef

Extracts the regions of all labels, as above. n log n in the number of cells.

\param dsc the complex, which is not changed; its domain is not a torus
\return the polygons of each label
*/
template <class Traits, class Tds, class Domain>
std::map<int, std::vector<Polygon_with_holes_2<Exact_predicates_inexact_constructions_kernel>>>
extract_polygons(const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc) {
  static_assert(Domain::has_outside, "a region of a torus need not be a polygon");
  return internal::polygons_of_labels(dsc, [](int) { return true; });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_EXTRACT_INTERFACE_2_H

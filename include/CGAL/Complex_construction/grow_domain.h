// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_GROW_DOMAIN_H
#define CGAL_COMPLEX_CONSTRUCTION_GROW_DOMAIN_H

#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Domain_box.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

/*
The cells of a complex in a box, and a layer of cells with label 0 between the box and a larger box
with the same center. Each boundary facet and its image in the larger box bound a frustum. The
frustum is divided like a prism: simplex i has the vertices 0 to i of the facet, by increasing
index, and the images of the vertices i to d - 1. Adjacent frusta are thus divided consistently.
*/
template <class Complex> class Box_layer
{
public:
  static constexpr int d = Complex::dimension;
  using Cell = std::array<std::size_t, d + 1>;
  using State = typename Complex::State;
  using Point = typename Complex::Point;

  Box_layer(const Complex& complex, const State& state, const Extent<d>& box, double factor)
      : m_complex(complex), m_box(box), m_factor(factor), m_images(state.points.size(), none) {
    for (const auto& p : state.points)
      m_points.push_back(point_at<Complex>(p));
    for (std::size_t c = 0; c < state.cells.size(); ++c)
      if (std::count(state.cells[c].begin(), state.cells[c].end(), 0u) == 0) {
        Cell cell;
        std::transform(state.cells[c].begin(), state.cells[c].end(), cell.begin(),
                       [](std::uint32_t v) { return v - 1; });
        m_cells.push_back(cell);
        m_labels.push_back(state.cell_labels[c]);
      }
    for (const auto& cell : state.cells)
      if (std::count(cell.begin(), cell.end(), 0u) != 0)
        add_frustum(cell, state);
  }

  // Returns the points. The points of the complex come first, in the order of the state.
  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Cell>& cells() const { return m_cells; }
  const std::vector<typename Complex::Label>& labels() const { return m_labels; }

private:
  static constexpr std::size_t none = -1;

  // Adds the cells of the frustum at an infinite cell.
  void add_frustum(const std::array<std::uint32_t, d + 1>& infinite, const State& state) {
    std::array<std::size_t, d> facet, images;
    auto out = facet.begin();
    for (const std::uint32_t v : infinite)
      if (v != 0)
        *out++ = v - 1;
    std::sort(facet.begin(), facet.end());
    for (int i = 0; i < d; ++i)
      images[i] = image(facet[i], state.points[facet[i]]);
    for (int i = 0; i < d; ++i) {
      Cell cell;
      std::copy(facet.begin(), facet.begin() + i + 1, cell.begin());
      std::copy(images.begin() + i, images.end(), cell.begin() + i + 1);
      if (orientation(cell) == NEGATIVE)
        std::swap(cell[0], cell[1]);
      m_cells.push_back(cell);
      m_labels.push_back(0);
    }
  }

  Orientation orientation(const Cell& cell) const {
    return m_complex.domain().orientation(m_complex,
                                          [&](int i) -> const Point& { return m_points[cell[i]]; });
  }

  // Returns the image of a boundary vertex. The image lies on the same sides of the box as the
  // vertex.
  std::size_t image(std::size_t v, const std::array<double, d>& p) {
    if (m_images[v] != none)
      return m_images[v];
    std::array<double, d> coordinates;
    for (int axis = 0; axis < d; ++axis) {
      const double center = m_box.lower(axis) / 2 + m_box.upper(axis) / 2;
      // Equal coordinates on a side have equal images.
      coordinates[axis] = center + m_factor * (p[axis] - center);
    }
    m_images[v] = m_points.size();
    m_points.push_back(point_at<Complex>(coordinates));
    return m_images[v];
  }

  const Complex& m_complex;
  Extent<d> m_box;
  double m_factor;
  std::vector<std::size_t> m_images; // by vertex
  std::vector<Point> m_points;
  std::vector<Cell> m_cells;
  std::vector<typename Complex::Label> m_labels;
};

// Copies the data that the user has added to the base of a simplex. The values that the
// complex computes are kept.
template <class Complex>
void copy_added_data(typename Complex::Vertex_handle from, typename Complex::Vertex_handle to) {
  const auto kept = *to;
  *to = *from;
  static_cast<Vertex_data&>(*to) = kept;
  to->set_cell(kept.cell());
  to->set_point(kept.point());
}
template <class Complex>
void copy_added_data(typename Complex::Cell_handle from, typename Complex::Cell_handle to) {
  const auto kept = *to;
  *to = *from;
  static_cast<Cell_data&>(*to) = kept;
  static_cast<Cell_failures&>(*to) = kept;
  for (int i = 0; i <= Complex::dimension; ++i) {
    to->set_vertex(i, kept.vertex(i));
    to->set_neighbor(i, kept.neighbor(i));
  }
}

// Copies these data to the same simplices of another complex.
// \param ranks time stamps in `to` of the vertices of `from`, in their order; new vertices follow
template <class Complex>
void copy_added_data(const Complex& from, Complex& to, const std::vector<std::size_t>& ranks) {
  const std::vector<typename Complex::Vertex_handle> old = from.vertices(), all = to.vertices();
  std::vector<typename Complex::Vertex_handle> original(to.vertex_id_bound()); // by id
  for (std::size_t i = 0; i < old.size(); ++i) {
    const auto v = all[ranks[i] - 1];
    copy_added_data<Complex>(old[i], v);
    original[v->id()] = old[i];
  }
  std::vector<typename Complex::Cell_handle> star;
  for (auto c : to.cells())
    if (const auto first = original[c->vertex(0)->id()]; first != nullptr) {
      from.star(first, star);
      for (auto candidate : star) {
        int common = 0;
        for (int i = 0; i <= Complex::dimension; ++i)
          common += candidate->has_vertex(original[c->vertex(i)->id()]);
        if (common == Complex::dimension + 1)
          copy_added_data<Complex>(candidate, c);
      }
    }
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Returns whether the interface keeps a distance from the boundary of the domain, a box. Linear in the
size of the interface and of the boundary.

\param dsc the complex
\param fraction distance from each side, as a fraction of the length of the box perpendicular to the
       side
\return whether all vertices of the interface are farther from all sides; `true` if the domain is
        not a box
*/
template <class Complex>
bool has_room_around_interface(const Complex& dsc, double fraction = .125) {
  const internal::Domain_box<Complex> box(dsc);
  if (!box.is_box())
    return true;
  for (auto v : dsc.interface_vertices())
    for (int axis = 0; axis < Complex::dimension; ++axis) {
      const double x = dsc.position(v)[axis], low = box.extent().lower(axis),
                   high = box.extent().upper(axis), room = fraction * (high - low);
      if (!(x - low > room && high - x > room))
        return false;
    }
  return true;
}

/*!
\ingroup PkgComplexConstructionRef

Returns whether a motion of the interface would leave the domain, a box. Linear in the size of the
interface and of the boundary.

\param dsc the complex
\param interface_ its interface
\param destinations of the vertices of the interface
\return whether a destination is outside the box, and no vertex of the interface is on its sides,
        which are walls otherwise
\throws Invalid_destination_error if a destination is not finite
*/
template <class Complex>
bool leaves_domain(const Complex& dsc, const Interface_vertices<Complex>& interface_,
                   const std::vector<typename Complex::Point>& destinations) {
  require_finite(destinations, "a destination"); // or the domain would grow up to the largest one
  return !internal::Domain_box<Complex>(dsc).leaving(interface_.vertices, destinations).empty();
}

/*!
\ingroup PkgComplexConstructionRef

Enlarges the domain, a box, about its center, so that an interface near its boundary can move on.
The space between the old and the new box is filled with cells of label 0. The old vertices and
cells keep the data that the user has added to their bases, until the improvement of the mesh, which
follows, replaces them. The vertices of the interface, the normalization,
`dsc.mean_interface_edge()` and `dsc.minimum_interface_edge()` are bitwise unchanged. The volumes of
all labels except 0 are unchanged up to rounding. n log n in the number of cells.

\param dsc the complex. Handles are invalidated, and component events not taken yet are lost.
\param factor factor by which the sides of the box are multiplied, larger than 1
\throws Error if the factor is not finite or not larger than 1, the domain is not a box, or the new
        box is too large for a complex; the complex is then unchanged
*/
template <class Complex> void grow_domain(Complex& dsc, double factor = 1.5) {
  if (!(factor > 1) || !std::isfinite(factor))
    throw Error("the growth factor of the domain is out of range: use more than 1");
  const internal::Domain_box<Complex> box(dsc);
  if (!box.is_box())
    throw Error("the domain is not a box and cannot grow: build the complex in a box");
  const auto before = dsc.state();
  const internal::Box_layer<Complex> layer(dsc, before, box.extent(), factor);
  Complex grown(dsc);
  const auto vertices = grown.assign(layer.points(), layer.cells(), layer.labels());
  for (std::size_t i = 0; i < before.spacings.size(); ++i)
    if (before.spacings[i] > 0)
      internal::Simplex_access::set_spacing(vertices[i], before.spacings[i]);
  std::vector<std::size_t> ranks; // restore() keeps this order
  for (auto v : vertices)
    ranks.push_back(v->time_stamp());
  auto after = grown.state();
  after.mean_interface_edge = before.mean_interface_edge;
  after.minimum_interface_edge = before.minimum_interface_edge;
  grown.restore(after);
  internal::copy_added_data(dsc, grown, ranks);
  Construction_options<Complex::dimension> options;
  options.thin_parts.edge_per_thickness = 0; // the interface stays
  internal::improve_new_mesh(grown, options);
  dsc = std::move(grown);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_GROW_DOMAIN_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_CARRIED_VERTEX_VALUES_H
#define CGAL_INTERFACE_REMESHING_CARRIED_VERTEX_VALUES_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>

#include <CGAL/property_map.h>

#include <cmath>
#include <functional>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgInterfaceRemeshingRef
/// The gradient by which `Carried_vertex_values` finds the value of a vertex that smoothing moves.
enum class Carried_gradient {
  /// The gradient in the cell at the new position. The value is a mean of old values, so it exceeds
  /// none of them. Local extrema are flattened.
  of_cell,
  /// The mean gradient around the vertex. The error is of second order at smooth functions, and
  /// local extrema are preserved. Values can exceed the old ones.
  mean,
};

/*!
\ingroup PkgInterfaceRemeshingRef

Visitor that transfers values on vertices, such as temperatures, when the mesh changes. Between
vertices, the values are those of the function that is linear in each cell. A vertex that is
created, or moved by mesh optimization, gets the value of this function at its new position. Linear
functions thus stay the same, up to rounding. All other vertices keep their values, also if a
deformation moves them.

If the new position is outside the old cells, mostly because of rounding, the linear function of the
nearest cell is extrapolated.

\tparam Complex an instance of `Deformable_simplicial_complex_2` or
        `Deformable_simplicial_complex_3`
\tparam VertexValueMap model of `ReadWritePropertyMap` with the key type `Complex::Vertex_handle`.
        The visitor copies the map. Removed vertices keep their values, and handles of new vertices
        may equal those of removed vertices; identify vertices by their time stamps. Values can be
        added, `v + w`, and multiplied, `2. * v`.
*/
template <class Complex, class VertexValueMap>
class Carried_vertex_values : public Deformation_visitor<Complex>
{
public:
  using Cell_handle = typename Complex::Cell_handle;     ///< cell of the complex
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Point = typename Complex::Point;                 ///< point of the complex
  using Cavity = typename Complex::Cavity;               ///< cavity of the complex
  using Value = typename boost::property_traits<VertexValueMap>::value_type; ///< value on a vertex

  /// Constructs the visitor in constant time. It reads and writes values only when the mesh
  /// changes. The complex must outlive the visitor.
  /// \pre each finite vertex has a value when the mesh changes around it
  Carried_vertex_values(const Complex& complex, const VertexValueMap& values)
      : m_complex(complex), m_values(values) {}

  /// Constructs the visitor for values that are defined only in some cells, such as the cells of a
  /// phase. Where such cells are near, only their linear functions are used.
  /// \param complex, values as above
  /// \param has_values `bool has_values(Cell_handle c)` with a finite cell `c`
  /// \param gradient the gradient for vertices that smoothing moves
  Carried_vertex_values(const Complex& complex, const VertexValueMap& values,
                        std::function<bool(Cell_handle)> has_values,
                        Carried_gradient gradient = Carried_gradient::of_cell)
      : m_complex(complex), m_values(values), m_has_values(std::move(has_values)),
        m_gradient(gradient) {}

  /// Not copyable; pass the visitor by `std::ref()`.
  Carried_vertex_values(const Carried_vertex_values&) = delete;
  /// Not copyable; pass the visitor by `std::ref()`.
  Carried_vertex_values& operator=(const Carried_vertex_values&) = delete;

  /// Interpolates the values of new and of moved vertices, each in time linear in the number of
  /// removed cells.
  void before_replacement(const Cavity& cavity) override {
    m_interpolated.clear();
    for (std::size_t i = 0; i < cavity.vertices().size(); ++i) {
      const auto& v = cavity.vertices()[i];
      const bool is_new = v.handle == Vertex_handle();
      if (is_new || (!m_complex.is_infinite(v.handle) && !(v.handle->point() == v.position)))
        m_interpolated.emplace_back(i, interpolate(cavity.removed(), v.position));
    }
  }
  /// Stores the interpolated values.
  void after_replacement(const Cavity& cavity) override {
    for (const auto& [i, value] : m_interpolated)
      put(m_values, cavity.vertices()[i].handle, value);
  }

  /// Interpolates the value at the target, in time linear in the number of cells around the vertex.
  void before_smoothing(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const Point& target) override {
    m_interpolated.clear();
    m_interpolated.emplace_back(0, m_gradient == Carried_gradient::mean
                                       ? extrapolate(v, star, target)
                                       : interpolate(star, target));
  }
  /// Stores the interpolated value.
  void after_smoothing(Vertex_handle v, const std::vector<Cell_handle>&) override {
    put(m_values, v, m_interpolated.front().second);
  }

private:
  using Position = typename Complex::Point;
  using Coordinates = std::array<double, Complex::corners>;

  // Returns the value at p of the function that is linear in each cell. Returns the value of the
  // nearest vertex if all cells are flat up to rounding.
  Value interpolate(const std::vector<Cell_handle>& cells, const Position& p) const {
    Cell_handle nearest;
    Coordinates best{};
    double deepest = 0;
    for (Cell_handle c : cells) {
      Coordinates b;
      if (!find_barycentric_coordinates(c, p, b))
        continue;
      const double depth = *std::min_element(b.begin(), b.end());
      if (nearest == Cell_handle() || depth > deepest) {
        deepest = depth;
        nearest = c;
        best = b;
      }
    }
    if (nearest == Cell_handle())
      return get(m_values, nearest_vertex(cells, p));
    Value result = best[0] * get(m_values, nearest->vertex(0));
    for (int i = 1; i < Complex::corners; ++i)
      result = result + best[i] * get(m_values, nearest->vertex(i));
    return result;
  }

  // Returns the value at p of the linear function with the value of a vertex, and with the mean
  // gradient in the cells around the vertex, weighted by their measures.
  Value extrapolate(Vertex_handle v, const std::vector<Cell_handle>& star,
                    const Position& p) const {
    Value sum = 0. * get(m_values, v);
    double all = 0;
    for (Cell_handle c : star) {
      Coordinates b;
      if (!find_barycentric_coordinates(c, p, b))
        continue;
      const double measure = m_complex.measure(c);
      all += measure;
      for (int i = 0; i < Complex::corners; ++i)
        sum = sum + measure * b[i] * get(m_values, c->vertex(i));
    }
    return all > 0 ? (1 / all) * sum : interpolate(star, p);
  }

  // Computes barycentric coordinates with the sum 1. Returns false if the cell is infinite, has no
  // values, or is flat up to rounding.
  bool find_barycentric_coordinates(Cell_handle c, const Position& p, Coordinates& result) const {
    if (m_complex.is_infinite(c) || (m_has_values && !m_has_values(c)))
      return false;
    const auto corners = internal::cell_corners(m_complex, c, p);
    double sum = 0;
    for (int i = 0; i < Complex::corners; ++i) {
      auto moved = corners;
      moved[i] = p;
      sum += result[i] = internal::signed_measure<typename Complex::Space>(moved);
    }
    for (double& b : result)
      b /= sum;
    return sum > 0 &&
           std::all_of(result.begin(), result.end(), [](double x) { return std::isfinite(x); });
  }

  Vertex_handle nearest_vertex(const std::vector<Cell_handle>& cells, const Position& p) const {
    Vertex_handle result;
    double least = 0;
    for (Cell_handle c : cells)
      for (int i = 0; i < Complex::corners; ++i) {
        const Vertex_handle v = c->vertex(i);
        if (m_complex.is_infinite(v))
          continue;
        const double distance = (m_complex.position_near(p, v) - p).squared_length();
        if (result == Vertex_handle() || distance < least) {
          least = distance;
          result = v;
        }
      }
    return result;
  }

  const Complex& m_complex;
  VertexValueMap m_values;
  std::function<bool(Cell_handle)> m_has_values; // empty if all cells have values
  Carried_gradient m_gradient = Carried_gradient::of_cell;
  std::vector<std::pair<std::size_t, Value>> m_interpolated; // index and value
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_CARRIED_VERTEX_VALUES_H

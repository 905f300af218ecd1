// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CARRIED_VERTEX_VALUES_3_H
#define CGAL_CARRIED_VERTEX_VALUES_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/geometry/cell_corners.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/geometry/overlap_volume_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

A visitor by which values on vertices, such as temperatures, follow changes of the mesh. Values
between vertices are those of the function that is linear in each cell. A vertex that is created, or
that is moved by the improvement of the mesh, gets the value that this function had there: a linear
function stays the same, up to rounding. All other vertices keep their values, also where they move
with a deformation: values are carried along.

Where the new position is outside the old cells, by rounding for the most part, the linear function
of the nearest one goes on.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam VertexValueMap model of `ReadWritePropertyMap` with the key type `Complex::Vertex_handle`.
        It is copied. Vertices that are gone keep their values, and handles of new ones may equal
        those of old ones: identify vertices by their time stamps. Values can be added, `v + w`, and
        multiplied, `2. * v`.

\cgalModels `DeformationVisitor_3`
*/
template <class Complex, class VertexValueMap>
class Carried_vertex_values_3 : public Deformation_visitor_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;     ///< cell of the complex
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Point_3 = typename Complex::Point_3;             ///< as in the complex
  using Cavity = typename Complex::Cavity;               ///< as in the complex
  using Value = typename boost::property_traits<VertexValueMap>::value_type; ///< of a vertex

  /// Reads and writes values when the mesh changes. The complex must outlive the visitor.
  /// \pre each finite vertex has a value when the mesh changes around it. Constant time.
  Carried_vertex_values_3(const Complex& complex, const VertexValueMap& values)
      : m_complex(complex), m_values(values) {}

  /// Not to be copied: pass it by `std::ref()`.
  Carried_vertex_values_3(const Carried_vertex_values_3&) = delete;
  /// Not to be copied: pass it by `std::ref()`.
  Carried_vertex_values_3& operator=(const Carried_vertex_values_3&) = delete;

  /// Interpolates values of new and of moved vertices, each in the number of removed cells.
  void before_replacement(const Cavity& cavity) {
    m_interpolated.clear();
    for (std::size_t i = 0; i < cavity.vertices().size(); ++i) {
      const auto& v = cavity.vertices()[i];
      const bool is_new = v.handle == Vertex_handle();
      if (is_new || (!m_complex.is_infinite(v.handle) && !(v.handle->point() == v.point)))
        m_interpolated.emplace_back(i, interpolate(cavity.removed(), v.position));
    }
  }
  /// Gives them their values.
  void after_replacement(const Cavity& cavity) {
    for (const auto& [i, value] : m_interpolated)
      put(m_values, cavity.vertices()[i].handle, value);
  }

  /// Interpolates the value at the target, in the number of cells around.
  void before_smoothing(Vertex_handle, const std::vector<Cell_handle>& star,
                        const Point_3& target) {
    const auto position = m_complex.geom_traits().construct_approximate_point_3_object()(target);
    m_interpolated.clear();
    m_interpolated.emplace_back(0, interpolate(star, position));
  }
  /// Gives it to the vertex.
  void after_smoothing(Vertex_handle v, const std::vector<Cell_handle>&) {
    put(m_values, v, m_interpolated.front().second);
  }

private:
  using Position = typename Complex::Approximate_point_3;
  using Coordinates = std::array<double, 4>;

  // The value at p of the function that is linear in each cell; that of the nearest vertex if
  // rounding leaves no cell a volume.
  Value interpolate(const std::vector<Cell_handle>& cells, const Position& p) const {
    Cell_handle nearest;
    Coordinates best{};
    double deepest = 0;
    for (Cell_handle c : cells) {
      if (m_complex.is_infinite(c))
        continue;
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
    for (int i = 1; i < 4; ++i)
      result = result + best[i] * get(m_values, nearest->vertex(i));
    return result;
  }

  // Their sum is 1; false if the cell has no volume but for rounding.
  bool find_barycentric_coordinates(Cell_handle c, const Position& p, Coordinates& result) const {
    namespace internal = Deformable_simplicial_complexes::internal;
    const auto corners = internal::cell_corners(m_complex, c);
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      auto moved = corners;
      moved[i] = p;
      sum += result[i] = internal::signed_volume(moved);
    }
    for (double& b : result)
      b /= sum;
    return sum > 0 && std::isfinite(result[0] + result[1] + result[2] + result[3]);
  }

  Vertex_handle nearest_vertex(const std::vector<Cell_handle>& cells, const Position& p) const {
    Vertex_handle result;
    double least = 0;
    for (Cell_handle c : cells)
      for (int i = 0; i < 4; ++i) {
        const Vertex_handle v = c->vertex(i);
        if (m_complex.is_infinite(v))
          continue;
        const double distance = (m_complex.position(v) - p).squared_length();
        if (result == Vertex_handle() || distance < least) {
          least = distance;
          result = v;
        }
      }
    return result;
  }

  const Complex& m_complex;
  VertexValueMap m_values;
  std::vector<std::pair<std::size_t, Value>> m_interpolated; // by vertex of the cavity
};

} // namespace CGAL

#endif // CGAL_CARRIED_VERTEX_VALUES_3_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_FACE_OFFSETTING_3_H
#define CGAL_INTERFACE_FLOWS_FACE_OFFSETTING_3_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/Vertex_quadric_3.h>
#include <CGAL/Deformable_simplicial_complexes/interface_triangles_3.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Adds the sides of the domain that a vertex is on: planes that do not move. Returns whether it is
// on one.
template <class Quadric> bool hold_in_sides(Boundary_class::Bits sides, Quadric& quadric) {
  const double weight = quadric.sum_of_weights();
  for (int axis = 0; axis < 3; ++axis)
    if (Boundary_class::fixes(sides, axis))
      quadric.add({axis == 0 ? 1. : 0., axis == 1 ? 1. : 0., axis == 2 ? 1. : 0.}, weight);
  return sides != Boundary_class::inside;
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Wavefrontal motion by face offsetting (X. Jiao, *Face offsetting: A unified approach for explicit
moving interfaces*, Journal of Computational Physics 220, 2007): the planes of the facets move along
their normals, and vertices go where their planes meet, each facet weighted by its angle at the
vertex. Labelled phases grow into the outside, label 0, or shrink if the speed is negative; facets
between other labels, and the sides of the domain, hold their vertices in their planes.

Edges and corners that the front runs away from become round, as in Huygens' principle: their
vertices keep the distance of the offset. Those that it runs into stay sharp. `Normal_offset` is
simpler, and smooths both. Call `improve_interface()` before each step: where a front grows round or
shrinks, facets become too large or vanish, and steps of a quarter of an edge or less leave it the
time to see to that before a deformation has to, which does not know about sharp edges.

\cgalModels `InterfaceStep`
*/
class Face_offset_3
{
public:
  /// \param speed length per unit of time, in the coordinates of the complex.
  /// \param eigenvalue_threshold what is an edge, see `improve_interface()`; in [0, 1).
  /// \throws Error if the threshold is out of its range.
  explicit Face_offset_3(double speed, double eigenvalue_threshold = .025)
      : m_speed(speed), m_threshold(eigenvalue_threshold) {
    check_eigenvalue_threshold(m_threshold);
  }

  /// computes where vertices go, as `InterfaceStep` says. Linear in the size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point_3>& positions, double /*t*/,
                  double dt,
                  std::vector<typename Complex::Approximate_point_3>& destinations) const {
    using Vector = typename Complex::Approximate_vector_3;
    const double offset = m_speed * dt;
    struct Vertex
    {
      Vertex_quadric_3<Vector> quadric;
      bool is_held = false; // by a facet that does not move
      Vector displacement = Vector(0, 0, 0), direction = Vector(0, 0, 0);
      double weight = 0, weighted_length = 0;
    };
    std::vector<Vertex> vertices(positions.size());
    const auto triangles = weighted_triangles(interface_, positions);
    for (const auto& triangle : triangles) {
      const double sign = sign_of_growth(interface_.triangles[triangle.index]);
      for (int i = 0; i < 3; ++i) {
        Vertex& v = vertices[interface_.triangles[triangle.index].vertices[i]];
        v.quadric.add(triangle.unit_normal, triangle.angles[i], sign * offset);
        v.is_held = v.is_held || sign == 0;
      }
    }
    static constexpr double short_part = .1; // of the offset, where its facets cancel each other
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      Vertex& v = vertices[i];
      v.is_held =
          internal::hold_in_sides(interface_.vertices[i]->boundary_class(), v.quadric) || v.is_held;
      v.quadric.analyse(m_threshold);
      v.displacement = v.quadric.displacement();
      const double length = std::sqrt(v.displacement.squared_length());
      v.direction = length > short_part * std::abs(offset) ? v.displacement / length
                                                           : v.quadric.mean_direction();
    }
    // How far along its direction the facets take a vertex: where it moves away from a facet, that
    // is the offset, else as far as it takes to have the offset from the plane.
    for (const auto& triangle : triangles) {
      const auto& corner = interface_.triangles[triangle.index].vertices;
      for (int i = 0; i < 3; ++i) {
        Vertex& v = vertices[corner[i]];
        const auto& p = positions[corner[i]];
        const auto edge_to = [&](int j) {
          return interface_.domain.near(p, positions[corner[j % 3]]) - p;
        };
        const Vector into_facet = edge_to(i + 1) + edge_to(i + 2);
        const double cosine = std::abs(triangle.unit_normal * v.direction);
        const bool is_rounded = v.quadric.rank() < 2 || into_facet * v.direction < 0;
        const double angle = triangle.angles[i];
        v.weight += angle * (is_rounded ? 1 : cosine * cosine);
        v.weighted_length += angle * (is_rounded ? 1 : cosine) * std::abs(offset);
      }
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Vertex& v = vertices[i];
      destinations.push_back(v.is_held || !(v.weight > 0)
                                 ? positions[i] + v.displacement
                                 : positions[i] + v.weighted_length / v.weight * v.direction);
    }
  }

private:
  double m_speed, m_threshold;
};

/*!
\ingroup PkgInterfaceFlowsRef

Advective motion by face offsetting: facets go where a velocity field takes their corners, and
vertices to where the planes of these facets meet, but only as far as these planes define it. The
interface goes the same way as with the field itself, but its vertices do not slide along it, so
that they stay as evenly distributed as they are. See `Face_offset_3` for the source.

\tparam Field model of `VelocityField`
\cgalModels `InterfaceStep`
*/
template <class Field> class Advective_face_offset_3
{
public:
  /// \param field the velocities.
  /// \param eigenvalue_threshold what is an edge, see `improve_interface()`; in [0, 1).
  /// \throws Error if the threshold is out of its range.
  explicit Advective_face_offset_3(Field field, double eigenvalue_threshold = .025)
      : m_field(std::move(field)), m_threshold(eigenvalue_threshold) {
    check_eigenvalue_threshold(m_threshold);
  }

  /// computes where vertices go, as `InterfaceStep` says. Paths are integrated by
  /// `Integration_scheme::rk4`. Linear in the size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point_3>& positions, double t,
                  double dt,
                  std::vector<typename Complex::Approximate_point_3>& destinations) const {
    using Vector = typename Complex::Approximate_vector_3;
    const auto advected = internal::integrate_with_fixed_steps(interface_, positions, m_field, t,
                                                               dt, Integration_scheme::rk4);
    std::vector<Vertex_quadric_3<Vector>> quadrics(positions.size());
    for (const auto& triangle : weighted_triangles(interface_, advected))
      for (int i = 0; i < 3; ++i) {
        const std::size_t v = interface_.triangles[triangle.index].vertices[i];
        quadrics[v].add(triangle.unit_normal, triangle.angles[i],
                        (advected[v] - positions[v]) * triangle.unit_normal);
      }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      internal::hold_in_sides(interface_.vertices[v]->boundary_class(), quadrics[v]);
      quadrics[v].analyse(m_threshold);
      destinations.push_back(positions[v] + quadrics[v].displacement());
    }
  }

private:
  Field m_field;
  double m_threshold;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_FACE_OFFSETTING_3_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_FACE_OFFSETTING_3_H
#define CGAL_INTERFACE_FLOWS_FACE_OFFSETTING_3_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>
#include <CGAL/Interface_remeshing/Vertex_quadric_3.h>
#include <CGAL/Interface_remeshing/interface_triangles_3.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Adds the planes of the sides of the domain that contain a vertex. These planes do not move.
// Returns whether there is such a side.
template <class Quadric> bool constrain_to_sides(Boundary_class::Bits sides, Quadric& quadric) {
  const double weight = quadric.sum_of_weights();
  for (int axis = 0; axis < 3; ++axis)
    if (Boundary_class::fixes(sides, axis))
      quadric.add({axis == 0 ? 1. : 0., axis == 1 ? 1. : 0., axis == 2 ? 1. : 0.}, weight);
  return sides != Boundary_class::inside;
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Wavefrontal motion by face offsetting \cgalCite{cgal:j-fouae-07}. The planes of the facets move
along their normals. A vertex moves to the intersection of the planes of its facets, where each
facet is weighted by its angle at the vertex. Labeled phases grow into the outside, label 0. With a
negative speed they shrink. Some planes do not move: the sides of the domain, and facets between two
labels other than 0. Their vertices stay in these planes.

As in Huygens' principle, edges and corners become round where the front moves away from them. Their
vertices move by the distance of the offset. Edges and corners stay sharp where the front moves
towards them. `Normal_offset` is simpler and rounds all of them.

Call `improve_interface()` before each step, and choose steps of at most a quarter of an edge
length. Facets become too large where the front grows, and degenerate where it shrinks.
`improve_interface()` preserves sharp edges when it changes such facets. A deformation removes
degenerate facets without regard to sharp edges.

\cgalModels{InterfaceStep}
*/
class Face_offset_3
{
public:
  /// \param speed length per unit of time, in the coordinates of the complex
  /// \param eigenvalue_threshold eigenvalues of the quadric of a vertex up to this part of the
  ///        largest one count as zero. Sharper edges and corners stay sharp. The range is [0, 1).
  /// \throws Error if `eigenvalue_threshold` is out of its range.
  explicit Face_offset_3(double speed, double eigenvalue_threshold = .025)
      : m_speed(speed), m_threshold(eigenvalue_threshold) {
    check_eigenvalue_threshold(m_threshold);
  }

  /// Computes the destinations of all vertices, see `InterfaceStep`. The time is linear in the size
  /// of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Point_3>& positions, double /*t*/, double dt,
                  std::vector<typename Complex::Point_3>& destinations) const {
    using Vector = typename Complex::Vector_3;
    const double offset = m_speed * dt;
    struct Vertex
    {
      Vertex_quadric_3<Vector> quadric;
      bool is_constrained = false; // by a facet or a side of the domain that does not move
      Vector displacement = Vector(0, 0, 0), direction = Vector(0, 0, 0);
      double weight = 0, weighted_length = 0;
    };
    std::vector<Vertex> vertices(positions.size());
    const auto triangles = weighted_triangles(interface_, positions);
    for (const auto& triangle : triangles) {
      const double sign = sign_of_growth(interface_.facets()[triangle.index]);
      for (int i = 0; i < 3; ++i) {
        Vertex& v = vertices[interface_.facets()[triangle.index].vertices[i]];
        v.quadric.add(triangle.unit_normal, triangle.angles[i], sign * offset);
        v.is_constrained = v.is_constrained || sign == 0;
      }
    }
    static constexpr double short_part = .1; // of the offset; below it, offsets cancel each other
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      Vertex& v = vertices[i];
      v.is_constrained =
          internal::constrain_to_sides(interface_.vertices[i]->boundary_class(), v.quadric) ||
          v.is_constrained;
      v.quadric.analyse(m_threshold);
      v.displacement = v.quadric.displacement();
      const double length = std::sqrt(v.displacement.squared_length());
      v.direction = length > short_part * std::abs(offset) ? v.displacement / length
                                                           : v.quadric.mean_direction();
    }
    // Computes the length of the displacement of each vertex along its direction, as a weighted
    // mean over its facets. Where the vertex moves away from a facet, the length is the offset.
    // Otherwise it is the length for which the vertex has the offset from the plane of the facet.
    for (const auto& triangle : triangles) {
      const auto& corner = interface_.facets()[triangle.index].vertices;
      for (int i = 0; i < 3; ++i) {
        Vertex& v = vertices[corner[i]];
        const auto& p = positions[corner[i]];
        const auto edge_to = [&](int j) {
          return interface_.domain.nearest_image(p, positions[corner[j % 3]]) - p;
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
      destinations.push_back(v.is_constrained || !(v.weight > 0)
                                 ? positions[i] + v.displacement
                                 : positions[i] + v.weighted_length / v.weight * v.direction);
    }
  }

private:
  double m_speed, m_threshold;
};

/*!
\ingroup PkgInterfaceFlowsRef

Advective motion by face offsetting. A velocity field moves the corners of each facet. A vertex
moves to the intersection of the planes of the moved facets, within the directions that these planes
determine. The interface moves as with the field itself, but its vertices do not slide along the
interface. Their distribution therefore stays as uniform as it is. The source is the paper that
`Face_offset_3` names.

\tparam Field model of `VelocityField`
\cgalModels{InterfaceStep}
*/
template <class Field> class Advective_face_offset_3
{
public:
  /// \param field the velocity field
  /// \param eigenvalue_threshold eigenvalues of the quadric of a vertex up to this part of the
  ///        largest one count as zero. The range is [0, 1).
  /// \throws Error if `eigenvalue_threshold` is out of its range.
  explicit Advective_face_offset_3(Field field, double eigenvalue_threshold = .025)
      : m_field(std::move(field)), m_threshold(eigenvalue_threshold) {
    check_eigenvalue_threshold(m_threshold);
  }

  /// Computes the destinations of all vertices, see `InterfaceStep`. Paths are integrated by
  /// `Integration_scheme::rk4`. The time is linear in the size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Point_3>& positions, double t, double dt,
                  std::vector<typename Complex::Point_3>& destinations) const {
    using Vector = typename Complex::Vector_3;
    const auto advected = internal::integrate_with_fixed_steps(interface_, positions, m_field, t,
                                                               dt, Integration_scheme::rk4);
    std::vector<Vertex_quadric_3<Vector>> quadrics(positions.size());
    for (const auto& triangle : weighted_triangles(interface_, advected))
      for (int i = 0; i < 3; ++i) {
        const std::size_t v = interface_.facets()[triangle.index].vertices[i];
        quadrics[v].add(triangle.unit_normal, triangle.angles[i],
                        (advected[v] - positions[v]) * triangle.unit_normal);
      }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      internal::constrain_to_sides(interface_.vertices[v]->boundary_class(), quadrics[v]);
      quadrics[v].analyse(m_threshold);
      destinations.push_back(positions[v] + quadrics[v].displacement());
    }
  }

private:
  Field m_field;
  double m_threshold;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_FACE_OFFSETTING_3_H

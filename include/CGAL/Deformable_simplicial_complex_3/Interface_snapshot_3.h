// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERFACE_SNAPSHOT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERFACE_SNAPSHOT_3_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

The vertices and facets of an interface, numbered, as velocities see them. Positions are kept apart:
an integrator asks for velocities at positions that the vertices never take.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Interface_snapshot_3
{
  /// A facet of the interface; its vertices are indices into `Interface_snapshot_3::vertices`.
  struct Triangle
  {
    std::array<std::size_t, 3> vertices; ///< counterclockwise seen from the front
    typename Complex::Label behind;      ///< the larger label
    typename Complex::Label in_front;    ///< the smaller label
  };

  std::vector<typename Complex::Vertex_handle> vertices; ///< by increasing time stamp
  std::vector<Triangle> triangles;                       ///< in the order of `interface_facets()`

  /// Takes the snapshot. n log n in the size of the interface, plus a pass over the cells.
  explicit Interface_snapshot_3(const Complex& complex) : vertices(complex.interface_vertices()) {
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
      vertices[i]->set_scratch_index(i);
    for (const auto& f : complex.interface_facets()) {
      const auto v = complex.facet_vertices(f);
      triangles.push_back({{v[0]->scratch_index(), v[1]->scratch_index(), v[2]->scratch_index()},
                           f.first->label(),
                           f.first->neighbor(f.second)->label()});
    }
  }

  /// Where the vertices are.
  std::vector<typename Complex::Approximate_point_3> positions(const Complex& complex) const {
    std::vector<typename Complex::Approximate_point_3> result;
    for (auto v : vertices)
      result.push_back(complex.position(v));
    return result;
  }
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERFACE_SNAPSHOT_3_H

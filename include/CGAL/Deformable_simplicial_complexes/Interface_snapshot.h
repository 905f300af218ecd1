// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_SNAPSHOT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_SNAPSHOT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

The vertices of an interface, numbered, as velocities see them. Positions are kept apart: an
integrator asks for velocities at positions that the vertices never take.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Interface_vertices
{
  std::vector<typename Complex::Vertex_handle> vertices; ///< by increasing time stamp

  /// Where the vertices are.
  std::vector<typename Complex::Approximate_point> positions(const Complex& complex) const {
    std::vector<typename Complex::Approximate_point> result;
    for (auto v : vertices)
      result.push_back(complex.position(v));
    return result;
  }

protected:
  /// Takes them, and numbers them.
  explicit Interface_vertices(const Complex& complex) : vertices(complex.interface_vertices()) {
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
      vertices[i]->set_scratch_index(i);
  }

  /// The numbers of the vertices of a facet.
  static std::array<std::size_t, Complex::dimension> numbers(const Complex& complex,
                                                             const typename Complex::Facet& f) {
    std::array<std::size_t, Complex::dimension> result;
    const auto v = complex.facet_vertices(f);
    for (int i = 0; i < Complex::dimension; ++i)
      result[i] = v[i]->scratch_index();
    return result;
  }
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

The vertices and facets of an interface: `Interface_snapshot_3`, `Interface_snapshot_2`.

\tparam Complex a deformable simplicial complex
\tparam dimension its dimension
*/
template <class Complex, int dimension = Complex::dimension> struct Interface_snapshot;

/// The vertices and facets of an interface in space.
template <class Complex> struct Interface_snapshot<Complex, 3> : public Interface_vertices<Complex>
{
  /// A facet of the interface; its vertices are indices into `vertices`.
  struct Triangle
  {
    std::array<std::size_t, 3> vertices; ///< counterclockwise seen from the front
    typename Complex::Label behind;      ///< the larger label
    typename Complex::Label in_front;    ///< the smaller label
  };

  std::vector<Triangle> triangles; ///< in the order of `interface_facets()`

  /// Takes the snapshot. n log n in the size of the interface, plus a pass over the cells.
  explicit Interface_snapshot(const Complex& complex) : Interface_vertices<Complex>(complex) {
    for (const auto& f : complex.interface_facets())
      triangles.push_back(
          {this->numbers(complex, f), f.first->label(), f.first->neighbor(f.second)->label()});
  }
};

/// The vertices and edges of an interface in the plane.
template <class Complex> struct Interface_snapshot<Complex, 2> : public Interface_vertices<Complex>
{
  /// An edge of the interface; its vertices are indices into `vertices`.
  struct Segment
  {
    std::array<std::size_t, 2> vertices; ///< the larger label is on the left
    typename Complex::Label behind;      ///< the larger label
    typename Complex::Label in_front;    ///< the smaller label
  };

  std::vector<Segment> segments; ///< in the order of `interface_facets()`

  /// Takes the snapshot. n log n in the size of the interface, plus a pass over the cells.
  explicit Interface_snapshot(const Complex& complex) : Interface_vertices<Complex>(complex) {
    for (const auto& f : complex.interface_facets())
      segments.push_back(
          {this->numbers(complex, f), f.first->label(), f.first->neighbor(f.second)->label()});
  }
};

} // namespace Deformable_simplicial_complexes

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// The vertices and triangles of an interface in space.
template <class Complex>
using Interface_snapshot_3 = Deformable_simplicial_complexes::Interface_snapshot<Complex, 3>;

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// The vertices and segments of an interface in the plane.
template <class Complex>
using Interface_snapshot_2 = Deformable_simplicial_complexes::Interface_snapshot<Complex, 2>;

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_SNAPSHOT_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_SNAPSHOT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_SNAPSHOT_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if destinations of interface vertices are invalid, such as points with coordinates
that are not finite. No vertex has been moved then.
*/
class Invalid_destination_error : public Error
{
public:
  /// Constructs the error; `vertices` is returned by `vertices()`.
  Invalid_destination_error(const std::string& message, std::vector<std::size_t> vertices)
      : Error(message), m_vertices(std::move(vertices)) {}

  /// Returns the indices of the offending vertices, in the order of `interface_vertices()`.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The vertices of an interface, numbered, as seen by velocities. Positions are stored separately,
since an integrator evaluates velocities at positions where the vertices never are.

\tparam Complex_ a deformable simplicial complex
*/
template <class Complex_> struct Interface_vertices
{
  using Complex = Complex_; ///< the complex

  /// Facet of the interface. Its vertices are indices into `vertices`.
  struct Facet
  {
    /// counterclockwise seen from the front in 3D; with the larger label on the left in 2D
    std::array<std::size_t, Complex::dimension> vertices;
    typename Complex::Label behind;   ///< the larger label
    typename Complex::Label in_front; ///< the smaller label
  };

  std::vector<typename Complex::Vertex_handle> vertices; ///< by increasing time stamp
  typename Complex::Domain
      domain; ///< domain of the complex; on a torus, facets see images of their vertices

  /// Returns the positions of the vertices.
  std::vector<typename Complex::Point> positions(const Complex& complex) const {
    std::vector<typename Complex::Point> result;
    for (auto v : vertices)
      result.push_back(complex.position(v));
    return result;
  }

  /// Returns the corners of a facet, as seen from its first corner.
  /// \param facet a facet
  /// \param positions of the vertices
  std::array<typename Complex::Point, Complex::dimension>
  corners(const Facet& facet, const std::vector<typename Complex::Point>& positions) const {
    std::array<typename Complex::Point, Complex::dimension> result;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = domain.nearest_image(positions[facet.vertices[0]], positions[facet.vertices[i]]);
    return result;
  }

  /// Lists the vertices of the interface. n log n in their number, plus linear in the number of
  /// vertices of the complex. The second parameter is not used; `Interface_snapshot` has the same
  /// parameters and uses it.
  explicit Interface_vertices(const Complex& complex, const For_each_index& = For_each_index())
      : vertices(complex.interface_vertices()), domain(complex.domain()) {}

protected:
  /// Returns the facets, in the order of `interface_facets()`.
  std::vector<Facet> facets_of(const Complex& complex, const For_each_index& for_each_index) const {
    const Vertex_numbers numbers(complex, vertices);
    const auto facets = complex.interface_facets(for_each_index);
    std::vector<Facet> result(facets.size());
    for_each_index(facets.size(), [&](std::size_t k) {
      const auto& f = facets[k];
      result[k].behind = f.first->subdomain_index();
      result[k].in_front = f.first->neighbor(f.second)->subdomain_index();
      const auto v = complex.facet_vertices(f);
      for (int i = 0; i < Complex::dimension; ++i)
        result[k].vertices[i] = numbers(v[i]);
    });
    return result;
  }
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The vertices and facets of an interface.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Interface_snapshot : public Interface_vertices<Complex>
{
  using typename Interface_vertices<Complex>::Facet;

  /// Takes the snapshot. n log n in the size of the interface, plus linear in the number of cells.
  /// `for_each_index` is a loop over indices, on any threads.
  explicit Interface_snapshot(const Complex& complex,
                              const For_each_index& for_each_index = For_each_index())
      : Interface_vertices<Complex>(complex, for_each_index),
        m_facets(this->facets_of(complex, for_each_index)) {}

  /// Returns the facets, in the order of `interface_facets()`.
  const std::vector<Facet>& facets() const { return m_facets; }
  /// Returns the facets, to be changed.
  std::vector<Facet>& facets() { return m_facets; }

private:
  std::vector<Facet> m_facets;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_SNAPSHOT_H

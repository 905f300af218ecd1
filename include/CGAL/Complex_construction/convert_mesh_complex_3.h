// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_CONVERT_MESH_COMPLEX_3_H
#define CGAL_COMPLEX_CONSTRUCTION_CONVERT_MESH_COMPLEX_3_H

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The cells of a mesh complex that belong to it, with their subdomains as labels. Points are in the
// order of their first use by cells.
template <class Complex> struct Labeled_tetrahedra_3
{
  std::vector<typename Complex::Point_3> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<typename Complex::Label> labels;

  template <class MeshComplex> explicit Labeled_tetrahedra_3(const MeshComplex& mesh) {
    // never iterated over, so results do not depend on addresses
    std::unordered_map<const void*, std::size_t> numbers;
    for (auto c = mesh.cells_in_complex_begin(); c != mesh.cells_in_complex_end(); ++c) {
      auto& tetrahedron = tetrahedra.emplace_back();
      for (int i = 0; i < 4; ++i) {
        const auto v = c->vertex(i);
        const auto [known, is_new] = numbers.emplace(&*v, points.size());
        if (is_new) {
          const auto& p = v->point(); // a weighted point of the triangulation
          points.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
        }
        tetrahedron[i] = known->second;
      }
      labels.push_back(typename Complex::Label(mesh.subdomain_index(c)));
    }
  }
};

// A map from pairs of labels to indices of surface patches.
template <class MeshComplex> class Patch_indices_3
{
public:
  using Index = typename MeshComplex::Surface_patch_index;
  using Subdomain = typename MeshComplex::Subdomain_index;
  using Labels = std::pair<int, int>; // the smaller label first

  explicit Patch_indices_3(const std::vector<Labels>& all) {
    for (const Labels& labels : all)
      m_numbers.emplace(labels, 0);
    int number = 0;
    for (auto& [labels, n] : m_numbers)
      n = ++number;
  }

  Index operator()(const Labels& labels) const {
    if constexpr (std::is_constructible_v<Index, std::pair<Subdomain, Subdomain>>)
      return Index(std::pair<Subdomain, Subdomain>(labels.first, labels.second));
    else
      return Index(m_numbers.at(labels));
  }

private:
  std::map<Labels, int> m_numbers;
};

// Fills an empty mesh complex with the cells of a complex. Cells with labels other than 0 and
// interface facets become part of the mesh complex.
template <class Complex, class MeshComplex>
void copy_to_mesh_complex(const Complex& complex, MeshComplex& mesh) {
  using Triangulation = typename MeshComplex::Triangulation;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cell_handle = typename Triangulation::Cell_handle;
  Triangulation& triangulation = mesh.triangulation();
  auto& tds = triangulation.tds();
  tds.clear();
  tds.set_dimension(3);

  const auto& source = complex.triangulation();
  std::map<typename Complex::Vertex_handle, std::size_t> numbers;
  std::vector<Vertex_handle> vertices;
  for (const auto v : source.all_vertex_handles()) {
    numbers.emplace(v, vertices.size());
    vertices.push_back(tds.create_vertex());
    if (source.is_infinite(v)) {
      triangulation.set_infinite_vertex(vertices.back());
      continue;
    }
    const auto p = complex.user_position(v);
    vertices.back()->set_point(
        typename Triangulation::Point(typename Triangulation::Bare_point(p.x(), p.y(), p.z())));
  }

  using Source_cell = typename Complex::Cell_handle;
  std::vector<Source_cell> sources;
  std::map<Source_cell, Cell_handle> copies;
  for (const auto c : source.all_cell_handles()) {
    std::array<Vertex_handle, 4> corners;
    for (int i = 0; i < 4; ++i)
      corners[i] = vertices[numbers.at(c->vertex(i))];
    const Cell_handle copy = tds.create_cell(corners[0], corners[1], corners[2], corners[3]);
    for (const Vertex_handle v : corners)
      v->set_cell(copy);
    sources.push_back(c);
    copies.emplace(c, copy);
  }
  for (const Source_cell c : sources)
    for (int i = 0; i < 4; ++i)
      copies.at(c)->set_neighbor(i, copies.at(c->neighbor(i)));

  for (const Source_cell c : sources) {
    const Cell_handle copy = copies.at(c);
    if (source.is_infinite(c) || c->subdomain_index() == 0)
      continue;
    mesh.add_to_complex(copy, typename MeshComplex::Subdomain_index(c->subdomain_index()));
    for (int i = 0; i < 4; ++i) {
      mesh.set_dimension(copy->vertex(i), 3);
      mesh.set_index(
          copy->vertex(i),
          typename MeshComplex::Index(typename MeshComplex::Subdomain_index(c->subdomain_index())));
    }
  }
  const auto facets = complex.interface_facets();
  std::vector<std::pair<int, int>> sides;
  for (const auto& [c, i] : facets) {
    const int a = c->subdomain_index(), b = c->neighbor(i)->subdomain_index();
    sides.emplace_back((std::min)(a, b), (std::max)(a, b));
  }
  const Patch_indices_3<MeshComplex> patch_index(sides);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Cell_handle copy = copies.at(facets[f].first);
    const auto index = patch_index(sides[f]);
    mesh.add_to_complex(copy, facets[f].second, index);
    for (int k = 0; k < 4; ++k)
      if (k != facets[f].second) {
        mesh.set_dimension(copy->vertex(k), 2);
        mesh.set_index(copy->vertex(k), typename MeshComplex::Index(index));
      }
  }
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from the cells of a `Mesh_complex_3_in_triangulation_3`, as returned by
`make_mesh_3()`. The subdomains become labels. Tetrahedra of label 0 fill the space around the
cells, in a box. n log n in the number of tetrahedra, plus the tetrahedralization and the
improvement.

Curves and corners of the mesh are not kept, since a complex has labels only. Facets between cells
of the same subdomain are not kept either.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam MeshComplex model of `MeshComplex_3InTriangulation_3`, whose subdomain indices are integers
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param mesh mesh with at least one cell
\param tetrahedralizer tetrahedralizer that fills the space around the cells
\param np named parameters of `make_deformable_simplicial_complex_3()` from surfaces

\throws Error as `make_deformable_simplicial_complex_3()` from tetrahedra in a box. Indices of cells
        count from `mesh.cells_in_complex_begin()`. Indices of vertices follow the order in which
        these cells first use them.
*/
template <class Complex, class MeshComplex, class Tetrahedralizer,
          class NP = parameters::Default_named_parameters>
Complex make_complex_from_mesh_complex_3(const MeshComplex& mesh,
                                         const Tetrahedralizer& tetrahedralizer,
                                         const NP& np = parameters::default_values()) {
  const internal::Labeled_tetrahedra_3<Complex> cells(mesh);
  return make_deformable_simplicial_complex_3<Complex>(cells.points, cells.tetrahedra, cells.labels,
                                                       tetrahedralizer, np);
}

/*!
\ingroup PkgComplexConstructionRef

Makes a `Mesh_complex_3_in_triangulation_3` from a complex. The cells with labels other than 0
become subdomains. The result also contains the interface. All cells of the complex are cells of the
triangulation. The triangulation is valid, but in general neither regular nor Delaunay; do not use
functions that insert points into it. n log n in the number of labels, linear in the number of
cells.

Vertices of the interface have dimension 2; other vertices in subdomains have dimension 3. If
surface patch indices can be constructed from a `std::pair` of subdomain indices, as those of
`Labeled_mesh_domain_3`, patches are pairs of labels, the smaller label first. Otherwise, patches
are numbered from 1, in the order of these pairs.

\tparam MeshComplex a default constructible model of `MeshComplex_3InTriangulation_3`, such as
        `Mesh_complex_3_in_triangulation_3`, whose subdomain indices are integers
\tparam Complex an instance of `Deformable_simplicial_complex_3` with a box as its domain

\param complex the complex; the result is in user coordinates, see `Complex::normalization()`
*/
template <class MeshComplex, class Complex>
MeshComplex extract_mesh_complex_3(const Complex& complex) {
  MeshComplex result;
  internal::copy_to_mesh_complex(complex, result);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_CONVERT_MESH_COMPLEX_3_H

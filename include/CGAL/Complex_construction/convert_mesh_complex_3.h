// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_CONVERT_MESH_COMPLEX_3_H
#define CGAL_COMPLEX_CONSTRUCTION_CONVERT_MESH_COMPLEX_3_H

#include <CGAL/license/Complex_construction.h>

#include <CGAL/Complex_construction/internal/conversion/copy_to_mesh_complex_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {

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

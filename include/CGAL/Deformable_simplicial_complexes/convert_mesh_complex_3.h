// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CONVERT_MESH_COMPLEX_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CONVERT_MESH_COMPLEX_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/conversion/Labelled_tetrahedra_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/conversion/copy_to_mesh_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex of the cells that are part of a `Mesh_complex_3_in_triangulation_3`, as
`make_mesh_3()` returns it, with the subdomains as labels; tetrahedra of label 0 fill the space
around them, in a box.

Curves and corners of the mesh are not kept, as a complex knows labels only; nor are facets between
cells of the same subdomain.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam MeshComplex model of `MeshComplex_3InTriangulation_3`, whose subdomain indices are integers
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param mesh not empty
\param tetrahedralizer fills the space around
\param np named parameters of `make_deformable_simplicial_complex_3()` from surfaces

\throws Error as `make_deformable_simplicial_complex_3()` from
        tetrahedra in a box; indices count `mesh.cells_in_complex_begin()` and on, and their
vertices in the order in which these name them first

n log n in the number of tetrahedra, plus the tetrahedralization and the improvement.
*/
template <class Complex, class MeshComplex, class Tetrahedralizer,
          class NP = parameters::Default_named_parameters>
Complex make_complex_from_mesh_complex_3(const MeshComplex& mesh,
                                         const Tetrahedralizer& tetrahedralizer,
                                         const NP& np = parameters::default_values()) {
  const internal::Labelled_tetrahedra_3<Complex> cells(mesh);
  return make_deformable_simplicial_complex_3<Complex>(cells.points, cells.tetrahedra, cells.labels,
                                                       tetrahedralizer, np);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a `Mesh_complex_3_in_triangulation_3` of a complex: of its cells with labels other than 0,
which become subdomains, and of its interface. All cells are cells of the triangulation, which thus
is a valid one, but in general not regular or Delaunay: functions that insert points into it are not
for use.

Vertices of the interface have dimension 2, others in subdomains 3. Surface patches are pairs of
labels, the smaller first, if their index is constructed from a `std::pair` of subdomain indices, as
that of `Labeled_mesh_domain_3` is; otherwise they are counted from 1, in the order of these pairs.

\tparam MeshComplex a default constructible model of `MeshComplex_3InTriangulation_3`, such as
        `Mesh_complex_3_in_triangulation_3`, whose subdomain indices are integers
\tparam Complex an instance of `Deformable_simplicial_complex_3` with a box as its domain

\param complex in its user's coordinates in the result, see `Complex::normalization()`

n log n in the number of labels, linear in the number of cells.
*/
template <class MeshComplex, class Complex>
MeshComplex extract_mesh_complex_3(const Complex& complex) {
  MeshComplex result;
  internal::copy_to_mesh_complex(complex, result);
  return result;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CONVERT_MESH_COMPLEX_3_H

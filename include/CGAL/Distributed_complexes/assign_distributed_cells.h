// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_ASSIGN_DISTRIBUTED_CELLS_H
#define CGAL_DISTRIBUTED_COMPLEXES_ASSIGN_DISTRIBUTED_CELLS_H

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/internal/ranks/Cell_assembler.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Labeled cells that a rank contributes to a distributed complex. Each cell of the complex is given
by one rank. A vertex has the same id and the same position on all ranks that give cells around it.

\tparam Complex the type of a complex on one rank
*/
template <class Complex> struct Cells_of_rank
{
  std::vector<std::uint64_t> ids;              ///< of the vertices, each once, less than 2^62
  std::vector<typename Complex::Point> points; ///< of the vertices
  /// corners of the cells, as indices into `ids`, positively oriented
  std::vector<std::array<std::size_t, Complex::dimension + 1>> cells;
  std::vector<typename Complex::Label> labels; ///< of the cells
};

/*!
\ingroup PkgDistributedComplexesRef

Replaces a distributed complex by cells that all ranks contribute, such as the parts of a mesh that
each rank reads. No rank needs to hold the whole complex. The cells are divided along a
space-filling curve. n log n in the number of cells of a rank. Collective.

\param dsc the complex; it is empty after an error
\param cells the cells of this rank; they can be empty
\throws Error on all ranks if sizes or indices do not fit, a cell is not positively oriented, a facet
        has more than two cells, or the cells do not fill a box
*/
template <class Complex>
void assign_cells(Distributed_complex<Complex>& dsc, const Cells_of_rank<Complex>& cells) {
  internal::Cell_assembler<Complex> assembler(dsc.mesh());
  try {
    assembler.place(cells);
    assembler.complete();
  } catch (...) { // on all ranks
    dsc.mesh().clear();
    throw;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_ASSIGN_DISTRIBUTED_CELLS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_H

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Improves cells where no single operation helps any more: `run()`, then `report()` of what was
// done.
template <class Complex, int dimension = Complex::dimension> class Patch_improver;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_H

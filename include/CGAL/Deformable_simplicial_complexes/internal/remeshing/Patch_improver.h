// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_H

#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Patch_improver_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Patch_improver_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Improves cells that no single operation improves further: `run()`, then `report()` returns what
// was done.
template <class Complex>
using Patch_improver = std::conditional_t<Complex::dimension == 2, Patch_improver_2<Complex>,
                                          Patch_improver_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_H

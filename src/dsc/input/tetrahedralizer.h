// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TETRAHEDRALIZER_H
#define DSC_TETRAHEDRALIZER_H

#ifdef DSC_WITH_TETGEN
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#else
#include <CGAL/Conforming_tetrahedralizer_3.h>
#endif

namespace dsc {

/// Fills the space around surfaces: with TetGen, or without it in programs that do not contain it.
#ifdef DSC_WITH_TETGEN
using Tetrahedralizer = CGAL::Tetgen_tetrahedralizer_3;
#else
using Tetrahedralizer = CGAL::Conforming_tetrahedralizer_3;
#endif

} // namespace dsc

#endif // DSC_TETRAHEDRALIZER_H

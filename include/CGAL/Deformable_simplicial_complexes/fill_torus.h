// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FILL_TORUS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FILL_TORUS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/Deformable_simplicial_complexes/fill_grid.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/torus_grid.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Makes a complex on a torus, for make_deformable_simplicial_complex_2 and _3.
template <class Complex, class LabelAt, class NamedParameters>
Complex fill_torus(const Torus_domain<Complex::dimension>& domain, double edge,
                   const LabelAt& label_at, const NamedParameters& np) {
  return fill_grid(Complex(domain), torus_grid(domain.periods(), edge), label_at, np);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FILL_TORUS_H

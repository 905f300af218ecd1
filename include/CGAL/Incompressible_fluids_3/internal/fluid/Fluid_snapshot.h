// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_SNAPSHOT_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_SNAPSHOT_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The states of a fluid and of its complex, to be restored.
template <class Fluid, class Complex> class Fluid_snapshot
{
public:
  // Saves both states. Takes O(n log n) time.
  Fluid_snapshot(const Complex& complex, const Fluid& fluid)
      : m_complex(complex.state()), m_fluid(fluid.state()) {}

  // Restores both states, bitwise. The handles of the complex are invalidated if the complex has
  // changed since. The function cannot be interrupted. Takes O(n log n) time.
  void restore(Complex& complex, Fluid& fluid) const {
    const Progress_pause pause;
    if (complex.state() != m_complex) {
      complex.clear(); // first, to save memory
      complex.restore(m_complex);
    }
    fluid.restore(m_fluid);
  }

private:
  typename Complex::State m_complex;
  typename Fluid::State m_fluid;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_SNAPSHOT_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_OF_DIMENSION_H
#define DSC_FLUID_OF_DIMENSION_H

#include "input/expression.h"
#include "motions/tracked_complex_2.h"
#include "motions/tracked_complex_3.h"

#include <CGAL/Incompressible_fluid_2.h>
#include <CGAL/Incompressible_fluid_3.h>
#include <CGAL/Incompressible_fluids_3/compiled_2.h>
#include <CGAL/Incompressible_fluids_3/compiled_3.h>

namespace dsc {

/// The complex of a scene in the plane or in space.
template <int dimension>
using Tracked_complex_of = std::conditional_t<dimension == 2, Tracked_complex_2, Tracked_complex_3>;

/// A fluid in a complex of either dimension.
template <class Complex> using Fluid = DSC::Incompressible_fluid<Complex, DSC::Saddle_point_solver>;

/// Returns the coordinates of a point or vector. In the plane, the third one is 0.
template <class Coordinates> std::array<double, 3> coordinates_of(const Coordinates& p) {
  std::array<double, 3> result = {};
  for (int i = 0; i < p.dimension(); ++i)
    result[std::size_t(i)] = p[i];
  return result;
}

/// Returns the barycenter of a cell. In the plane, its third coordinate is 0.
template <class Complex>
std::array<double, 3> middle_of(const Complex& complex, typename Complex::Cell_handle c) {
  std::array<double, 3> result = {};
  for (int i = 0; i < Complex::corners; ++i) {
    const auto p = coordinates_of(complex.position(c->vertex(i)));
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[axis] += p[axis];
  }
  for (double& x : result)
    x /= Complex::corners;
  return result;
}

} // namespace dsc

#endif // DSC_FLUID_OF_DIMENSION_H

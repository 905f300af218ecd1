// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_FLUID_OBJECT_H
#define DSC_PYTHON_FLUID_OBJECT_H

#include "Guarded.h"
#include "arrays.h"

#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace dsc_python {

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

/// A fluid with its own complex. The fluid refers to the complex, so the complex does not move.
template <class Complex> struct Owned_fluid
{
  std::unique_ptr<Complex> complex;
  std::unique_ptr<DSC::Incompressible_fluid<Complex>> fluid;
};

/// A fluid for Python.
template <class Complex> using Fluid_object = Guarded<Owned_fluid<Complex>>;

/// Returns coordinates in space. In the plane, the third coordinate is 0.
template <std::size_t d> std::array<double, 3> in_space(const std::array<double, d>& coordinates) {
  std::array<double, 3> result = {};
  std::copy(coordinates.begin(), coordinates.end(), result.begin());
  return result;
}

/// Returns the first d coordinates of a point or a vector in space, as an array of shape (d,).
template <int d, class Coordinates> py::array_t<double> array_of_first(const Coordinates& c) {
  return array_of<double>(std::size_t(d), [&](std::size_t i) { return c[int(i)]; });
}

/// Returns a vector of rotation, such as a torque: a number in the plane, an array in space.
template <int d> py::object rotation_to_python(const Vector_3& v) {
  if constexpr (d == 2)
    return py::float_(v.z());
  else
    return array_of_first<3>(v);
}

} // namespace dsc_python

#endif // DSC_PYTHON_FLUID_OBJECT_H

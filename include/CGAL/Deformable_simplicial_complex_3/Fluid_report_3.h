// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_FLUID_REPORT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_FLUID_REPORT_3_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref
What a step of a fluid did, and what it is like now.
\tparam Complex an instance of `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Fluid_report_3
{
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  double time = 0; ///< now
  double dt = 0;   ///< of the step
  double kinetic_energy = 0, potential_energy = 0, surface_energy = 0;
  Vector momentum = Vector(0, 0, 0), angular_momentum = Vector(0, 0, 0);
  double fastest = 0;
  double change_of_velocity = 0; ///< the largest of a vertex in the step
  double correction = 0; ///< the largest change of a velocity for the sake of momenta
  double volume_error = 0;
  double lost_volume = 0;
  unsigned iterations = 0, solutions = 0;
  std::size_t held = 0;
  std::vector<Vector> forces_on_solids;
  Deformation_report<Complex> deformation;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_FLUID_REPORT_3_H

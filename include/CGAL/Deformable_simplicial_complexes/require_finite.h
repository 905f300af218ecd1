// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REQUIRE_FINITE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REQUIRE_FINITE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Throws an exception if points or vectors are not finite. Linear in their number.

\param values points or vectors, one for each vertex of an interface
\param name name of one value in the message of the exception, such as `a velocity`
\throws Invalid_destination_error with the indices of all values that have an infinite or NaN
        coordinate
*/
template <class Values> void require_finite(const Values& values, const std::string& name) {
  std::vector<std::size_t> refused;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!has_finite_coordinates(values[i]))
      refused.push_back(i);
  if (!refused.empty())
    throw Invalid_destination_error(name + " is not finite; check the velocities and the time step",
                                    refused);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REQUIRE_FINITE_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H

#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The change of the interface facets by an operation.
struct Changed_facets
{
  double worst_before = std::numeric_limits<double>::infinity(); // quality of a facet
  double worst_after = std::numeric_limits<double>::infinity();  // 0 if a facet is inverted
  double swept_volume = 0; // volume between the interface before and after; in the plane, area
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H

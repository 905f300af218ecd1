// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_SEEDED_SEGMENTS_2_H
#define CGAL_COMPLEX_CONSTRUCTION_SEEDED_SEGMENTS_2_H

#include <CGAL/license/Complex_construction.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

A set of segments that divide the plane, and seeds: points in some of the regions between the
segments, with the labels of these regions. Bounded regions without a seed get the label
`enclosed_label`. If the unbounded region has no seed, it gets label 0. Any number of segments may
meet in a point, as in a foam or in files of the format of Triangle (`.poly`).

\tparam Point a point type, such as `Deformable_simplicial_complex_2::Point_2`
*/
template <class Point> struct Seeded_segments_2
{
  std::vector<Point> points;                        ///< ends of the segments
  std::vector<std::array<std::size_t, 2>> segments; ///< indices into `points`
  std::vector<std::pair<Point, int>> seeds;         ///< points in regions, with their labels
  int enclosed_label = 0;                           ///< label of bounded regions without a seed
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_SEEDED_SEGMENTS_2_H

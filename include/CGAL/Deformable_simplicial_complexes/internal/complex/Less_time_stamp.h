// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_LESS_TIME_STAMP_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_LESS_TIME_STAMP_H

namespace CGAL::Deformable_simplicial_complexes::internal {

// A function object that compares items by time stamp, that is, in the order of creation; see
// `Item_numbers`.
struct Less_time_stamp
{
  template <class Handle> bool operator()(Handle a, Handle b) const {
    return a->time_stamp() < b->time_stamp();
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_LESS_TIME_STAMP_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_SUPPORT_INTERNAL_THREADS_SPARSE_CHECK_H
#define CGAL_MESH_SUPPORT_INTERNAL_THREADS_SPARSE_CHECK_H

#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A counter that checks for an interrupt once in many steps, for loops whose steps are faster than
// the check.
class Sparse_check
{
public:
  void operator()() {
    static constexpr unsigned period = 1 << 12; // steps between two checks
    if (++m_steps % period == 0)
      Progress_scope::check();
  }

private:
  unsigned m_steps = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_THREADS_SPARSE_CHECK_H

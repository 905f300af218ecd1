// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_SUPPORT_INTERNAL_THREADS_STOPWATCH_H
#define CGAL_MESH_SUPPORT_INTERNAL_THREADS_STOPWATCH_H

#include <chrono>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A clock that measures wall-clock time in seconds, from lap to lap.
class Stopwatch
{
public:
  // Adds the seconds since the last lap, or since construction.
  void lap(double& seconds) {
    const Clock::time_point now = Clock::now();
    seconds += std::chrono::duration<double>(now - m_start).count();
    m_start = now;
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point m_start = Clock::now();
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_THREADS_STOPWATCH_H

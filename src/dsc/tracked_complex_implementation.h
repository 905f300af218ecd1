// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_IMPLEMENTATION_H
#define DSC_TRACKED_COMPLEX_IMPLEMENTATION_H

#include "tracked_complex.h"

#include <CGAL/Deformable_simplicial_complex_3.h>

#include <chrono>

namespace dsc {

/// What is behind the wall, for the files that compile a part of it.
struct Tracked_complex::Implementation
{
  CGAL::Deformable_simplicial_complex_3<> complex;
};

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_IMPLEMENTATION_H

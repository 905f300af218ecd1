// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_UNTANGLING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_UNTANGLING_H

#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Proposed_motion.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Proposes other points for a free vertex, and keeps the point with the best star quality. The
// candidates are the mean motion of the interface vertices around and the mean of the neighbors,
// each with step lengths 1 and 1/2.
template <class Complex>
void relocate(Proposed_motion<Complex>& motion, typename Proposed_motion<Complex>::Number i) {
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Approximate_vector;
  using Position = typename Complex::Approximate_point;
  const Complex& complex = motion.complex();
  const Vertex_handle v = motion.vertex(i);
  std::vector<Cell_handle> star;
  complex.star(v, star);
  star.erase(std::remove_if(star.begin(), star.end(),
                            [&](Cell_handle c) { return complex.is_infinite(c); }),
             star.end());
  Vector sum_of_motions(CGAL::NULL_VECTOR), mean(CGAL::NULL_VECTOR);
  int moving = 0;
  const Position start = complex.position(v);
  for (Cell_handle c : star) {
    for (int j = 0; j < Complex::corners; ++j) {
      const Vertex_handle w = c->vertex(j);
      if (w == v)
        continue;
      const Position seen = complex.domain().near(start, motion.position(w));
      mean = mean + (seen - CGAL::ORIGIN) / double(Complex::dimension * star.size());
      if (w->is_interface()) {
        sum_of_motions = sum_of_motions + complex.displacement(w, motion.position(w));
        ++moving;
      }
    }
  }
  double worst = motion.worst_quality(star, -std::numeric_limits<double>::infinity());
  const auto propose = [&](double fraction, const Position& target) {
    if (!has_finite_coordinates(target))
      return;
    const auto before = motion.point(i);
    const Position from = motion.position(v);
    motion.set_point(
        i, complex.admissible_destination(
               v, complex.exact(from + fraction * (complex.domain().near(from, target) - from))));
    const double after = motion.worst_quality(star, worst);
    if (after > worst)
      worst = after;
    else
      motion.set_point(i, before);
  };
  for (double fraction : {.5, 1.}) {
    if (moving > 0)
      propose(fraction, start + sum_of_motions / moving);
    propose(fraction, CGAL::ORIGIN + mean);
  }
}

// Relocates the free vertices of cells that would be inverted. Returns the cells that would still
// be inverted.
template <class Complex>
std::vector<typename Complex::Cell_handle>
untangle(Proposed_motion<Complex>& motion, std::vector<typename Complex::Cell_handle> cells) {
  static constexpr int rounds = 2; // more rounds are slow and seldom help
  const auto is_free = [&](auto i) { return !motion.vertex(i)->is_interface(); };
  auto suspects = cells;
  for (int round = 0; round < rounds && !cells.empty(); ++round) {
    const auto free = motion.vertices_of(cells, is_free);
    for (auto i : free)
      relocate(motion, i);
    const auto around = motion.stars(free);
    suspects.insert(suspects.end(), around.begin(), around.end());
    cells = motion.bad_cells(around);
  }
  return motion.bad_cells(suspects);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_UNTANGLING_H

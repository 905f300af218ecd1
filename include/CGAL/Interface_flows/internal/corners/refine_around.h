// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_REFINE_AROUND_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_REFINE_AROUND_H

#include <CGAL/license/Interface_flows.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Interface_remeshing/refine_cells.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Bisects cells until the edges at a vertex are short enough. Returns the number of splits. Linear
// in the number of cells at the vertex and at split edges.
template <class Complex>
std::size_t refine_around(Complex& complex, typename Complex::Vertex_handle vertex, double longest,
                          Any_visitor<Complex>& visitor) {
  static constexpr std::size_t most = 1000; // splits; a hundred halve an edge thirty times
  const auto is_coarse = [&](typename Complex::Cell_handle c) {
    if (complex.is_infinite(c))
      return false;
    for (int i = 0; i < Complex::corners; ++i)
      if (Complex::Space::length(complex.displacement(vertex, c->vertex(i))) > longest)
        return true;
    return false;
  };
  Cavity<Complex> cavity(complex);
  Improvement_report report;
  std::vector<typename Complex::Cell_handle> star;
  while (report.split < most) {
    star.clear();
    complex.star(vertex, star);
    const auto cell = std::find_if(star.begin(), star.end(), is_coarse);
    if (cell == star.end() || !split_terminal_edge(complex, *cell, cavity, visitor, report))
      break;
  }
  return report.split;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_REFINE_AROUND_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_CLOSED_SETS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_CLOSED_SETS_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the closed sets of a system whose other members are complete. The weight of a closed set
// is the mean diagonal entry of c for its pressures. Takes almost linear time.
inline std::vector<Saddle_point_system::Closed_set> closed_sets(const Saddle_point_system& system) {
  static constexpr double rounding = 1e-4; // of the force of a constant pressure
  // The greatest force of a constant pressure on a liquid without any boundary, which fills a
  // torus, relative to the forces of the pressures of single vertices.
  static constexpr double rounding_of_sums = 1e-12;
  using Vector = Saddle_point_system::Vector;
  using Closed_set = Saddle_point_system::Closed_set;
  const Eigen::Index n = system.nodal.rows(), m = system.c.rows();
  // The forces of a constant pressure 1 on vertices, before and after the projection.
  const Vector pushes = system.b.transpose() * Vector::Ones(m);
  Vector free_pushes = pushes;
  system.project(free_pushes);
  // Pressures that act on a common vertex belong to the same set.
  const auto group_of_vertex = [m](Eigen::Index v) { return std::size_t(m + v); };
  Disjoint_sets groups(std::size_t(m + n));
  for (Eigen::Index p = 0; p < m; ++p)
    for (Saddle_point_system::Matrix::InnerIterator i(system.b, p); i; ++i)
      groups.join(std::size_t(p), group_of_vertex(i.col() / 3));
  struct Sums
  {
    double area = 0, free_area = 0, all = 0; // sums of squares of forces
    Closed_set set;
  };
  std::vector<Sums> sums(groups.size());
  for (Eigen::Index v = 0; v < n; ++v) {
    Sums& s = sums[groups.find(group_of_vertex(v))];
    s.area += pushes.segment<3>(3 * v).squaredNorm();
    s.free_area += free_pushes.segment<3>(3 * v).squaredNorm();
  }
  for (Eigen::Index p = 0; p < m; ++p) {
    Sums& s = sums[groups.find(std::size_t(p))];
    for (Saddle_point_system::Matrix::InnerIterator i(system.b, p); i; ++i)
      s.all += i.value() * i.value();
    s.set.pressures.push_back(p);
    s.set.weight += system.c.coeff(p, p);
  }
  std::vector<Closed_set> result;
  for (Sums& s : sums)
    if (!s.set.pressures.empty() && (s.free_area <= rounding * rounding * s.area ||
                                     s.free_area <= rounding_of_sums * rounding_of_sums * s.all)) {
      s.set.weight /= double(s.set.pressures.size());
      result.push_back(std::move(s.set));
    }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_CLOSED_SETS_H

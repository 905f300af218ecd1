// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SOLVERS_CLOSED_PRESSURES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SOLVERS_CLOSED_PRESSURES_H

#include <CGAL/Deformable_simplicial_complex_3/Saddle_point_system.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The liquids without a surface that could move: those of which a pressure that is the same
// everywhere pushes nothing, but for the rounding of walls that are round. It may be anything, and
// the system is singular, or, worse, nearly so. Added to c is what asks for a mean of zero, and
// changes nothing else: if the walls ask for another volume, that is what is left of it.
class Closed_pressures
{
public:
  using System = Saddle_point_system;
  using Vector = System::Vector;

  // bt is the transpose of b. Linear.
  void find(const System& system, const System::Matrix& bt) {
    static constexpr double rounding = 1e-4; // of the area of the surface
    using Row = System::Matrix::InnerIterator;
    const Eigen::Index n = system.nodal.rows(), m = system.c.rows();
    m_sets.clear();
    if (system.held.empty())
      return;
    // How much pressures that are one everywhere push vertices, freely.
    Vector pushes = bt * Vector::Ones(m), free_pushes = pushes;
    system.project(free_pushes);
    std::vector<char> is_met(std::size_t(m), false), is_vertex_met(std::size_t(n), false);
    for (Eigen::Index first = 0; first < m; ++first) {
      if (is_met[std::size_t(first)])
        continue;
      Set set;
      double area = 0, free_area = 0; // squares
      set.members.push_back(first);
      is_met[std::size_t(first)] = true;
      for (std::size_t k = 0; k < set.members.size(); ++k) {
        const Eigen::Index p = set.members[k];
        set.weight += system.c.coeff(p, p);
        for (Row i(system.b, p); i; ++i) {
          const Eigen::Index v = i.col() / 3;
          if (is_vertex_met[std::size_t(v)])
            continue;
          is_vertex_met[std::size_t(v)] = true;
          area += pushes.segment<3>(3 * v).squaredNorm();
          free_area += free_pushes.segment<3>(3 * v).squaredNorm();
          for (Row j(bt, 3 * v); j; ++j)
            if (!is_met[std::size_t(j.col())]) {
              is_met[std::size_t(j.col())] = true;
              set.members.push_back(j.col());
            }
        }
      }
      set.weight /= double(set.members.size());
      if (free_area <= rounding * rounding * area)
        m_sets.push_back(std::move(set));
    }
  }

  // Makes the least pressure of each set 0, by which no wall has to pull for the sake of pressure.
  void raise(Vector& pressures) const {
    for (const Set& set : m_sets) {
      double least = std::numeric_limits<double>::infinity();
      for (Eigen::Index p : set.members)
        least = (std::min)(least, pressures(p));
      add(set, -least, pressures, 0);
    }
  }

  // What c is more, times pressures, which begin somewhere in a vector.
  void subtract(const Vector& in, Eigen::Index begin, Vector& out) const {
    for (const Set& set : m_sets)
      add(set, -set.weight * mean(set, in, begin), out, begin);
  }

  // About the inverse for means, which other preconditioners are to leave alone.
  void remove_means(Vector& pressures) const {
    for (const Set& set : m_sets)
      add(set, -mean(set, pressures, 0), pressures, 0);
  }
  void add_inverse(const Vector& in, Eigen::Index begin, Vector& out) const {
    for (const Set& set : m_sets)
      add(set, mean(set, in, begin) / set.weight, out, begin);
  }

private:
  struct Set
  {
    std::vector<Eigen::Index> members;
    double weight = 0;
  };

  static double mean(const Set& set, const Vector& vector, Eigen::Index begin) {
    double sum = 0;
    for (Eigen::Index p : set.members)
      sum += vector(begin + p);
    return sum / double(set.members.size());
  }
  static void add(const Set& set, double value, Vector& vector, Eigen::Index begin) {
    for (Eigen::Index p : set.members)
      vector(begin + p) += value;
  }

  std::vector<Set> m_sets;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SOLVERS_CLOSED_PRESSURES_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_SMALL_ANGLE_REMOVER_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_SMALL_ANGLE_REMOVER_2_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_insertion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <CGAL/determinant.h>
#include <CGAL/number_utils.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the sine of the smallest angle of a triangle; 0 if two corners coincide.
template <class Point> double smallest_sine(const std::array<Point, 3>& p) {
  std::array<double, 3> squared; // lengths of the edges
  for (int i = 0; i < 3; ++i)
    squared[i] = (p[(i + 1) % 3] - p[i]).squared_length();
  std::sort(squared.begin(), squared.end());
  const double product = std::sqrt(squared[1] * squared[2]);
  return product > 0 ? std::abs(determinant(p[1] - p[0], p[2] - p[0])) / product : 0;
}

// A function object that removes triangles with an angle below a bound. For each triangle, it
// chooses the flip, collapse or vertex insertion that maximizes the smallest angle. The interface
// does not change.
template <class Complex> class Small_angle_remover_2
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Cells = Work_list<Cell_handle>;

  // Creates a remover. `angle` is the bound in degrees. The destinations are those of the remover
  // in 3D.
  Small_angle_remover_2(Complex& complex, Deformation_visitor<Complex>& visitor,
                        const Destinations<Complex>& /*destinations*/,
                        const Rigid_components<Complex>& rigid_components, double angle,
                        double quality_threshold, const For_each_index& for_each_index)
      : m_complex(complex), m_visitor(visitor), m_rigid_components(rigid_components),
        m_for_each_index(for_each_index), m_target(std::sin(angle * CGAL_PI / 180)),
        m_quality_threshold(quality_threshold), m_cavity(complex), m_best(complex) {}

  const Improvement_report& report() const { return m_report; }
  std::size_t number_of_relocated() const { return 0; }

  // Returns the triangles below the quality threshold with a small angle, see
  // `Rigid_components::cells_not_stayed()`.
  Cells bad_cells() const {
    if (!(m_target > 0))
      return {};
    return m_rigid_components.cells_not_stayed(
        m_quality_threshold, [&](Cell_handle c) { return is_bad(c); }, m_for_each_index);
  }

  template <class Relabel> void run(const Relabel& /*relabel*/) {
    static constexpr unsigned rounds = 10;
    work_in_rounds(m_complex, bad_cells(), rounds, [&](Cell_handle c, Cells& touched) {
      if (is_bad(c) && improve(c))
        for (Cell_handle created : m_best.created())
          if (!m_complex.is_infinite(created) && is_bad(created))
            touched.push(created);
    });
  }

private:
  bool is_bad(Cell_handle c) const {
    return sine(c) < m_target && !m_rigid_components.has_moved_as_a_whole(c);
  }

  double sine(Cell_handle c) const {
    return smallest_sine<typename Complex::Point>(
        {m_complex.corner(c, 0), m_complex.corner(c, 1), m_complex.corner(c, 2)});
  }

  // Improves a triangle. Returns whether an operation was applied.
  bool improve(Cell_handle c) {
    m_best.clear();
    m_best_sine = 0;
    m_least_sine = worth_it(sine(c));
    for (int i = 0; i < 3; ++i)
      consider(propose_edge_flip(m_complex, c, i, m_cavity));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        consider(i != j && !c->vertex(i)->is_interface() &&
                 propose_edge_collapse(m_complex, c, i, j, 0, m_cavity));
    if (m_best_sine < m_target)
      consider(propose_vertex_insertion(m_complex, c, m_cavity));
    if (m_best.removed().empty())
      return false;
    commit_proposal(m_complex, m_best, m_visitor, m_report);
    return true;
  }

  // Returns the sine that an operation must exceed: the bound or 1.1 times the previous sine,
  // whichever is smaller, but at least the previous sine.
  double worth_it(double before) const {
    static constexpr double better = 1.1;
    return (std::max)(before, (std::min)(better * before, m_target));
  }

  // Stores the proposal in `m_cavity` as the best one, if it is better than the best proposal so
  // far.
  void consider(bool is_proposed) {
    if (!is_proposed)
      return;
    double before = std::numeric_limits<double>::infinity(), after = before;
    for (Cell_handle c : m_cavity.removed())
      if (!m_complex.is_infinite(c))
        before = (std::min)(before, sine(c));
    for (const auto& t : m_cavity.planned())
      if (t.quality < std::numeric_limits<double>::infinity()) { // all vertices are finite
        const auto p = [&](int i) { return m_cavity.vertices()[t.vertices[i]].position; };
        after = (std::min)(after, smallest_sine<typename Complex::Point>({p(0), p(1), p(2)}));
      }
    if (after > (std::max)({worth_it(before), m_least_sine, m_best_sine})) {
      m_best_sine = after;
      std::swap(m_best, m_cavity);
    }
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Rigid_components<Complex>& m_rigid_components;
  const For_each_index& m_for_each_index;
  double m_target, m_quality_threshold;
  Cavity<Complex> m_cavity, m_best;
  double m_best_sine = 0, m_least_sine = 0;
  Improvement_report m_report;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_SMALL_ANGLE_REMOVER_2_H

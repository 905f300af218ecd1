// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_STEP_PLAN_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_STEP_PLAN_H

#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <Eigen/Dense>

#include <cstddef>
#include <deque>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An accelerator for fixed-point iterations x = g(x). It combines the last values of g so that the
// difference g(x) - x is least (D. G. Anderson, "Iterative procedures for nonlinear integral
// equations", J. ACM 12, 1965).
class Fixed_point_accelerator
{
public:
  using Vector = Eigen::VectorXd;

  // Takes a point x and its value g. Returns the next point for an evaluation of g.
  Vector next(const Vector& x, const Vector& g) {
    static constexpr std::size_t memory = 20;
    m_values.push_back(g);
    m_changes.push_back(g - x);
    if (m_values.size() > memory + 1) {
      m_values.pop_front();
      m_changes.pop_front();
    }
    const std::size_t n = m_values.size() - 1;
    if (n == 0)
      return g;
    Eigen::MatrixXd value_differences(x.size(), n), change_differences(x.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
      const auto column = Eigen::Index(k);
      value_differences.col(column) = m_values[k + 1] - m_values[k];
      change_differences.col(column) = m_changes[k + 1] - m_changes[k];
    }
    return g - value_differences * change_differences.colPivHouseholderQr().solve(m_changes.back());
  }

  // Removes all values, after which the next point is g.
  void forget() {
    m_values.clear();
    m_changes.clear();
  }

private:
  std::deque<Vector> m_values, m_changes;
};

// The state of a fluid and a copy of its complex, with all data of the user, to be restored.
template <class Fluid, class Complex> class Fluid_snapshot
{
public:
  // Copies the complex, and saves the state of the fluid. Takes O(n log n) time.
  Fluid_snapshot(const Complex& complex, const Fluid& fluid)
      : m_complex(complex), m_fluid(fluid.state()) {}

  // Restores both, bitwise. The handles of the complex are invalidated if the complex has changed
  // since. The function cannot be interrupted. Takes O(n log n) time.
  void restore(Complex& complex, Fluid& fluid) const {
    const Progress_pause pause;
    if (complex.state() != m_complex.state()) {
      complex.clear(); // first, to save memory
      complex = m_complex;
    }
    fluid.restore(m_fluid);
  }

private:
  Complex m_complex;
  typename Fluid::State m_fluid;
};

// The change of the mesh in an attempt at a time step, in addition to the motion.
enum class Mesh_treatment {
  chosen,    // the mesh is adapted as the options of the step define
  improved,  // tetrahedra are improved before the attempt
  adapted,   // the interface and edges are adapted, and tetrahedra improved, before the attempt
  preserved, // the mesh changes only where the motion is otherwise impossible
};

// The sequence of attempts at a time step. The step is divided into consecutive parts. If an
// attempt fails, the next attempt has half the length, and the mesh is improved or adapted before
// it. If changes of the mesh cause the failure, the next attempt has the same length, with the mesh
// preserved. If the mesh was already preserved, the length is halved. Parts are dyadic fractions of
// the step, so their ends are exact. There are at most 2^halvings parts. At most 2 * halvings + 1
// failures are followed by another attempt.
class Step_plan
{
public:
  static constexpr unsigned halvings = 5; // the shortest part is a 32nd of the step

  bool is_done() const { return m_begin == units; }
  bool is_first() const { return m_begin == 0; }
  // Returns the length of the next part, in units of the step.
  double length() const { return double(m_size) / units; }
  // Returns the end of the next part, in units of the step.
  double end() const { return double(m_begin + m_size) / units; }
  Mesh_treatment mesh() const { return m_mesh; }
  unsigned parts() const { return m_parts; } // the number of parts done

  // Continues with the next part, after the present one succeeded.
  void succeed() {
    m_begin += m_size;
    ++m_parts;
    if (m_mesh != Mesh_treatment::preserved)
      m_mesh = Mesh_treatment::chosen;
  }

  // Prepares another attempt, after the present one failed and was undone. Returns whether there is
  // one.
  bool fail(Fluid_failure cause) {
    if (cause == Fluid_failure::mesh && m_mesh != Mesh_treatment::preserved) {
      m_mesh = Mesh_treatment::preserved;
      return true;
    }
    if (m_size == 1)
      return false;
    m_size /= 2;
    if (cause != Fluid_failure::mesh) {
      m_mesh = m_adapts ? Mesh_treatment::adapted : Mesh_treatment::improved;
      m_adapts = !m_adapts;
    }
    return true;
  }

private:
  static constexpr unsigned units = 1u << halvings; // number of the shortest parts in a step

  unsigned m_begin = 0, m_size = units, m_parts = 0;
  Mesh_treatment m_mesh = Mesh_treatment::chosen;
  bool m_adapts = false; // whether the next treatment is adaptation; otherwise it is improvement
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_STEP_PLAN_H

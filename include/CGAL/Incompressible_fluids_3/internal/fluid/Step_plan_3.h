// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_STEP_PLAN_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_STEP_PLAN_3_H

#include <CGAL/Incompressible_fluids_3/fluid_errors.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What happens to the mesh in an attempt at a time step, beside the motion.
enum class Mesh_treatment_3 {
  chosen,    // as the options of the step ask for
  improved,  // tetrahedra are improved before the attempt
  adapted,   // interface and edges are adapted, and tetrahedra improved, before the attempt
  preserved, // the mesh changes only where the motion is impossible otherwise
};

// The attempts at a time step. The step is divided into parts, which follow each other. A part that
// fails is attempted again with another treatment of the mesh and half the length; where changes of
// the mesh alone are the cause, first with the mesh preserved and the same length. Parts are dyadic
// fractions of the step, so their ends are exact. There are at most 2^halvings parts and
// 2 * halvings + 1 failures.
class Step_plan_3
{
public:
  static constexpr unsigned halvings = 5; // the shortest part is a 32nd of the step

  bool is_done() const { return m_begin == units; }
  bool is_first() const { return m_begin == 0; }
  // Of the next part, in units of the step.
  double length() const { return double(m_size) / units; }
  double end() const { return double(m_begin + m_size) / units; }
  Mesh_treatment_3 mesh() const { return m_mesh; }
  unsigned parts() const { return m_parts; } // done

  // The part is done.
  void succeed() {
    m_begin += m_size;
    ++m_parts;
    if (m_mesh != Mesh_treatment_3::preserved)
      m_mesh = Mesh_treatment_3::chosen;
  }

  // The part has been undone. Returns whether there is another attempt.
  bool fail(Fluid_failure_3 cause) {
    if (cause == Fluid_failure_3::mesh && m_mesh != Mesh_treatment_3::preserved) {
      m_mesh = Mesh_treatment_3::preserved;
      return true;
    }
    if (m_size == 1)
      return false;
    m_size /= 2;
    if (cause != Fluid_failure_3::mesh) {
      m_mesh = m_adapts ? Mesh_treatment_3::adapted : Mesh_treatment_3::improved;
      m_adapts = !m_adapts;
    }
    return true;
  }

private:
  static constexpr unsigned units = 1u << halvings; // of a step

  unsigned m_begin = 0, m_size = units, m_parts = 0;
  Mesh_treatment_3 m_mesh = Mesh_treatment_3::chosen;
  bool m_adapts = false; // adaptation, improvement of tetrahedra alone: the other one is next
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_STEP_PLAN_3_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IMPROVEMENT_MESH_CARE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IMPROVEMENT_MESH_CARE_2_H

#include <CGAL/Deformable_simplicial_complex_2/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_care.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_parts.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/vertex_smoothing.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// In the plane: flips of edges and smoothing of vertices off the interface, which thus keeps its
// edges.
template <class Complex> class Mesh_care<Complex, 2>
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Cells = Work_list<Cell_handle>;

  Mesh_care(Complex& complex, Any_visitor<Complex>& visitor, const Destinations<Complex>&,
            const Rigid_parts<Complex>&, const Deformation_options<Complex>& options)
      : m_complex(complex), m_visitor(visitor), m_threshold(options.quality_threshold),
        m_cavity(complex) {}

  void begin_pass() {}
  bool is_bad(Cell_handle c) const { return c->quality() < m_threshold; }
  void remove_obstacle(Cell_handle, bool, Cells&) {}
  void remove_degenerating_facets(Cells&) {}

  void improve(Cells cells) {
    static constexpr unsigned rounds = 3;
    work_in_rounds(m_complex, std::move(cells), rounds, [&](Cell_handle c, Cells& touched) {
      if (is_bad(c) && !flip(c, touched))
        smooth(c, touched);
    });
  }

  Cells cells_with_small_angles() const { return {}; }
  bool keeps_small_angles(Cell_handle) const { return false; }
  template <class Relabel> void remove_small_angles(const Relabel&) {}

  const Improvement_report& report() const { return m_report; }
  std::size_t number_of_relocated() const { return 0; }

private:
  bool flip(Cell_handle c, Cells& touched) {
    for (int i = 0; i < Complex::corners; ++i)
      if (propose_edge_flip(m_complex, c, i, m_cavity)) {
        commit_proposal(m_complex, m_cavity, m_visitor, m_report);
        push_finite(m_complex, m_cavity.created(), touched);
        return true;
      }
    return false;
  }

  void smooth(Cell_handle c, Cells& touched) {
    typename Complex::Point target;
    for (int i = 0; i < Complex::corners; ++i) {
      const Vertex_handle v = c->vertex(i);
      m_complex.star(v, m_star);
      if (!propose_smart_laplacian(m_complex, v, m_star, target))
        continue;
      smooth_vertex(m_complex, v, m_star, target, m_visitor);
      ++m_report.smoothed;
      push_finite(m_complex, m_star, touched);
    }
  }

  Complex& m_complex;
  Any_visitor<Complex>& m_visitor;
  double m_threshold;
  Cavity<Complex> m_cavity;
  std::vector<Cell_handle> m_star;
  Improvement_report m_report;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IMPROVEMENT_MESH_CARE_2_H

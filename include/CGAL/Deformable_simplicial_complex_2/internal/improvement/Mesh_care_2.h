// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IMPROVEMENT_MESH_CARE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IMPROVEMENT_MESH_CARE_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Own_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_care.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_parts.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// In the plane: Algorithm 3, and the removal of short edges and of free vertices that are trapped.
template <class Complex> class Mesh_care<Complex, 2>
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Cells = Work_list<Cell_handle>;

  Mesh_care(Complex& complex, Any_visitor<Complex>& visitor,
            const Destinations<Complex>& destinations, const Rigid_parts<Complex>&,
            const Deformation_options<Complex>& options)
      : m_relabeling_threshold(options.relabeling_threshold),
        m_improver(complex, visitor, destinations, options.quality_threshold) {}

  void begin_pass() {}
  bool is_bad(Cell_handle c) const { return m_improver.is_bad(c); }

  void remove_obstacle(Cell_handle c, bool may_remove_facets, Cells& touched) {
    if (may_remove_facets && m_improver.remove_short_edge(c, touched))
      return;
    if (c->quality() < m_relabeling_threshold)
      m_improver.remove_trapped_vertex(c, touched);
  }

  void remove_degenerating_facets(Cells&) {}

  void improve(Cells cells) {
    static constexpr unsigned rounds = 3;
    m_improver.improve(std::move(cells), rounds);
    m_improver.settle();
  }

  Cells cells_with_small_angles() const { return {}; }
  bool keeps_small_angles(Cell_handle) const { return false; }
  template <class Relabel> void remove_small_angles(const Relabel&) {}

  const Improvement_report& report() const { return m_improver.report(); }
  std::size_t number_of_relocated() const { return 0; }

private:
  double m_relabeling_threshold;
  Mesh_improver<Complex> m_improver;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IMPROVEMENT_MESH_CARE_2_H

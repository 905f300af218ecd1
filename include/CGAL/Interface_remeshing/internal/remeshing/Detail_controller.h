// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_DETAIL_CONTROLLER_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_DETAIL_CONTROLLER_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/Detail_options.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Failed_collapses.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Splits long edges and collapses short edges, cell by cell. No collapse creates an edge that would
// be split.
template <class Complex> class Detail_controller
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  Detail_controller(Complex& complex, Deformation_visitor<Complex>& visitor,
                    const Detail_options<Complex>& options)
      : m_complex(complex), m_visitor(visitor), m_options(options),
        m_unit(target_edge_length(complex, options.sizing_field)),
        m_short_unit(shortest_target_edge_length(complex, options.sizing_field)),
        m_tolerance(complex), m_cavity(complex) {}

  const Improvement_report& report() const { return m_report; }

  // Processes all selected cells, then the cells created by these operations, and so on, up to the
  // largest number of rounds.
  void run() {
    Work_list<Cell_handle> cells;
    for (Cell_handle c : m_complex.finite_cells())
      cells.push(c);
    work_in_rounds(m_complex, std::move(cells), m_options.number_of_iterations,
                   [&](Cell_handle c, Work_list<Cell_handle>& touched) {
                     if ((!m_options.where || m_options.where(c)) && (split(c) || collapse(c)))
                       push_finite(m_complex, m_cavity.created(), touched);
                   });
  }

  // Returns whether an edge of the cell is too long or too short.
  bool has_edge_to_change(Cell_handle c) const {
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j)
        if (length_by_split_threshold(c, i, j) > 1 || is_short(c, i, j))
          return true;
    return false;
  }

private:
  // Splits the edge of the cell that exceeds its threshold most. Returns false if none was split.
  bool split(Cell_handle c) {
    int a = 0, b = 0;
    double longest = 1;
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j) {
        if (m_complex.has_constrained_end(c, i, j))
          continue;
        const double length = length_by_split_threshold(c, i, j);
        if (length > longest) {
          longest = length;
          a = i;
          b = j;
        }
      }
    if (a == b || !propose_edge_split(m_complex, c, a, b, .5, m_cavity))
      return false;
    commit_split(m_complex, m_cavity, c->vertex(a), c->vertex(b), m_visitor, m_report);
    m_failed_collapses.update(m_cavity.created());
    return true;
  }

  bool collapse(Cell_handle c) {
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j)
        if (!m_complex.has_constrained_end(c, i, j) && is_short(c, i, j) &&
            (collapse(c, i, j) || collapse(c, j, i)))
          return true;
    return false;
  }

  bool collapse(Cell_handle c, int i, int j) {
    const Vertex_handle removed = c->vertex(i), kept = c->vertex(j);
    if (m_failed_collapses.contains(removed, kept))
      return false;
    if (!propose_edge_collapse(m_complex, c, i, j, m_options.collapse_quality, m_cavity) ||
        !m_tolerance.allows(m_cavity) || makes_long_edge()) {
      m_failed_collapses.add(removed, kept);
      return false;
    }
    commit_proposal(m_complex, m_cavity, m_visitor, m_report);
    m_failed_collapses.update(m_cavity.created());
    return true;
  }

  // Returns the length of an edge relative to its split threshold; 0 for an edge that is never
  // split.
  double length_by_split_threshold(Cell_handle c, int i, int j) const {
    const Vertex_handle v = c->vertex(i), w = c->vertex(j);
    const bool is_interface = v->is_interface() && w->is_interface() &&
                              Mesh_operations<Complex>::is_interface_edge(m_complex, c, i, j);
    return length_by_split_threshold(v, w, is_interface);
  }

  double length_by_split_threshold(Vertex_handle v, Vertex_handle w, bool is_interface) const {
    if (is_interface)
      return m_options.change_interface ? length(v, w, m_unit) / m_options.interface_split_length
                                        : 0;
    // Far from the interface, the input has no target edge length unless there is a sizing field.
    const bool has_target = m_unit.is_sizing_field() || (v->is_interface() && is_tied(w)) ||
                            (w->is_interface() && is_tied(v));
    return has_target ? length(v, w, m_unit) / m_options.split_length : 0;
  }

  bool is_short(Cell_handle c, int i, int j) const {
    const Vertex_handle v = c->vertex(i), w = c->vertex(j);
    if (!is_tied(v) && !is_tied(w))
      return length(v, w, m_unit) < m_options.collapse_length;
    return m_options.change_interface && v->is_interface() && w->is_interface() &&
           length(v, w, m_short_unit) < m_options.interface_collapse_length &&
           Mesh_operations<Complex>::is_interface_edge(m_complex, c, i, j);
  }

  // Returns whether the planned collapse creates an edge that would be split. All vertices around
  // the vanishing vertex become neighbors of the kept vertex. An edge between interface vertices is
  // tested with both thresholds, because it may become an interface edge.
  bool makes_long_edge() const {
    const Vertex_handle kept = m_cavity.kept_vertex();
    return std::any_of(m_cavity.vertices().begin(), m_cavity.vertices().end(), [&](const auto& u) {
      const Vertex_handle v = u.handle;
      return v != kept && v != m_cavity.vanishing_vertex() && !m_complex.is_infinite(v) &&
             (length_by_split_threshold(v, kept, false) > 1 ||
              (v->is_interface() && kept->is_interface() &&
               length_by_split_threshold(v, kept, true) > 1));
    });
  }

  // Returns whether a vertex is on the interface or on the boundary of the domain.
  bool is_tied(Vertex_handle v) const { return v->is_interface() || m_complex.is_boundary(v); }

  double length(Vertex_handle v, Vertex_handle w, const Edge_unit<Complex>& unit) const {
    return length_in_units(m_complex, v, w, unit);
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Detail_options<Complex>& m_options;
  Edge_unit<Complex> m_unit;       // of edge lengths
  Edge_unit<Complex> m_short_unit; // of interface edges to be collapsed
  Interface_tolerance<Complex> m_tolerance;
  Cavity<Complex> m_cavity;
  Failed_collapses<Complex> m_failed_collapses;
  Improvement_report m_report;
};

// Implements `control_detail()`.
template <class Complex>
Improvement_report run_detail_control(Complex& dsc, const Detail_options<Complex>& options) {
  options.check();
  Deformation_visitor<Complex> no_visitor;
  Detail_controller<Complex> controller(dsc, options.visitor ? *options.visitor : no_visitor,
                                        options);
  controller.run();
  return controller.report();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_DETAIL_CONTROLLER_H

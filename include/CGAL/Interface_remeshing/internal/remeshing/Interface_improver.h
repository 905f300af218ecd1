// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_INTERFACE_IMPROVER_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_INTERFACE_IMPROVER_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Changed_facets.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Interface_remeshing/Interface_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/interface/curved_midpoint.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Interface_remesher.h>
#include <CGAL/Interface_remeshing/junction_split_2.h>
#include <CGAL/Interface_remeshing/null_space_smoothing_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An `Interface_remesher` with the operations that depend on the dimension.
template <class Complex> class Interface_improver : public Interface_remesher<Complex>
{
  using Base = Interface_remesher<Complex>;

public:
  using Base::Base;
  using typename Base::Cell_handle;

  // Replaces interface facets without moving vertices: flips edges between facets, and removes
  // small facet angles. The vertices of a curve can be connected in one way only.
  void reconnect() {
    if constexpr (Complex::dimension == 3) {
      flip_edges();
      remove_small_angles();
    }
  }

  // Splits each junction of more than three phases into several junctions of three. There is no
  // such operation in space.
  void split_junctions() {
    if constexpr (Complex::dimension == 2)
      for (auto v : this->m_complex.interface_vertices()) {
        Progress_scope::check();
        while (propose_junction_split(this->m_complex, v, this->m_cavity,
                                      this->m_options.interface_energy)) {
          this->commit();
          const auto other = this->m_cavity.vertices().back().handle;
          for (auto junction : {v, other})
            junction->set_spacing(float(this->m_complex.interface_edge_length(junction)));
        }
      }
  }

private:
  void flip_edges() {
    this->for_each_interface_edge([&](Cell_handle c, int i, int j) {
      const Interface_edge_3<Complex> edge(this->m_complex, c, i, j);
      return edge.is_in_sheet() && edge.violates_delaunay_criterion() &&
             edge.bend() < Base::radians(this->m_options.flip_angle) &&
             propose_interface_edge_flip(this->m_complex, c, i, j, this->m_cavity,
                                         this->m_options.quality_threshold) &&
             this->m_tolerance.allows(this->m_cavity) && this->commit();
    });
  }

  // Removes small angles of facets. An edge of the facet is flipped or collapsed, whichever sweeps
  // the smaller volume, if this improves the worst of the changed facets.
  void remove_small_angles() {
    work_in_rounds(this->m_complex, this->cells_at_interface(), 1,
                   [&](Cell_handle c, Work_list<Cell_handle>&) {
                     for (int k = 0; k < 4; ++k)
                       if (this->m_complex.is_interface(typename Complex::Facet(c, k)) &&
                           has_small_angle(c, k) && remove_small_angle(c, k))
                         return;
                   });
  }

  bool has_small_angle(Cell_handle c, int k) const {
    const auto v = this->m_complex.facet_vertices({c, k});
    const auto p = this->m_complex.position(v[0]);
    return smallest_angle(std::array<typename Complex::Approximate_point_3, 3>{
               p, this->m_complex.position_near(p, v[1]), this->m_complex.position_near(p, v[2])}) <
           Base::radians(this->m_options.minimum_facet_angle);
  }

  bool remove_small_angle(Cell_handle c, int k) {
    Cavity<Complex> best(this->m_complex);
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::optional<Changed_facets>& change) {
      if (!change || !(change->worst_after > change->worst_before) ||
          !(change->swept_volume < least))
        return;
      least = change->swept_volume;
      std::swap(best, this->m_cavity);
    };
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j && i != k && j != k) {
          consider(this->propose_collapse(c, i, j));
          if (i < j)
            consider(propose_flip(c, i, j));
        }
    std::swap(best, this->m_cavity);
    return least < std::numeric_limits<double>::infinity() && this->commit();
  }

  std::optional<Changed_facets> propose_flip(Cell_handle c, int i, int j) {
    if (this->m_complex.has_constrained_end(c, i, j))
      return std::nullopt;
    const Interface_edge_3<Complex> edge(this->m_complex, c, i, j);
    if (!edge.is_in_sheet() || edge.bend() > Base::radians(this->m_options.feature_angle))
      return std::nullopt;
    const auto change = facets_changed_by_flip(edge);
    if (!this->is_small(change, c, i, j) ||
        !propose_interface_edge_flip(this->m_complex, c, i, j, this->m_cavity) ||
        !this->m_tolerance.allows(this->m_cavity))
      return std::nullopt;
    return change;
  }
};

// Implements `improve_interface()`.
template <class Complex>
Improvement_report remesh_interface(Complex& dsc,
                                    const Interface_improvement_options<Complex>& options) {
  options.check();
  const Progress_phase phase("improving the interface");
  Any_visitor<Complex> no_visitor;
  Interface_improver<Complex> improver(dsc, options.visitor ? *options.visitor : no_visitor,
                                       options);
  for (unsigned i = 0; i < options.number_of_iterations; ++i) {
    if (options.split_junctions)
      improver.split_junctions();
    improver.split_long_edges();
    improver.collapse_short_edges();
    improver.reconnect();
    improver.smooth_vertices();
    improver.improve_cells();
  }
  return improver.report();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_INTERFACE_IMPROVER_H

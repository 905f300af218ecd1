// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_DEFORM_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_DEFORM_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/Interface_deformer.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Does passes of Algorithm 1 until the vertices have arrived and the given cells are improved, the
// maximum number of passes is reached, or `go_further(pass)` returns false. Returns the report.
template <class Complex>
Deformation_report<Complex> do_passes(Interface_deformer<Complex>& deformer,
                                      Any_visitor<Complex>& visitor, unsigned maximum) {
  using Seconds = typename Deformation_report<Complex>::Seconds;
  unsigned pass = 0;
  bool is_stopped = false;
  deformer.lap(&Seconds::rest);
  while (deformer.has_work(pass + 1) && deformer.is_progressing() && pass < maximum &&
         !(is_stopped = !visitor.go_further(pass + 1))) {
    ++pass;
    Progress_scope::check();
    deformer.begin_pass(pass);
    deformer.move_together(pass);
    deformer.move_one_by_one();
    deformer.lap(&Seconds::motion);
    deformer.relabel_degenerate_cells(pass);
    deformer.lap(&Seconds::relabeling);
    deformer.remove_obstacles(pass);
    deformer.remove_degenerating_facets();
    deformer.lap(&Seconds::obstacles);
    deformer.improve();
    deformer.lap(&Seconds::improvement);
  }
  if (pass > 0 && !is_stopped) {
    deformer.remove_small_angles(pass);
    deformer.exchange_neighbors();
    deformer.lap(&Seconds::small_angles);
  }
  if (pass > 0)
    deformer.measure_new_spacings();
  Deformation_report<Complex> report = deformer.report(pass);
  report.stopped = is_stopped;
  return report;
}

// Moves interface vertices to their destinations in passes (Algorithm 1). Returns the report.
template <class Complex>
Deformation_report<Complex>
deform(Complex& dsc, const std::vector<typename Complex::Vertex_handle>& vertices,
       const std::vector<typename Complex::Approximate_point>& destinations,
       const Deformation_options<Complex>& options) {
  options.check();
  require_interface_edge(dsc);
  Any_visitor<Complex> no_visitor;
  Any_visitor<Complex>& visitor = options.visitor ? *options.visitor : no_visitor;
  const Progress_phase phase("moving the interface");
  const For_each_index for_each_index(options.number_of_threads);
  Interface_deformer<Complex> deformer(dsc, visitor, options, for_each_index);
  deformer.set_destinations(vertices, destinations);
  return do_passes(deformer, visitor, options.maximum_number_of_passes);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_DEFORM_H

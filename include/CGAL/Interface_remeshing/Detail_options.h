// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_DETAIL_OPTIONS_H
#define CGAL_INTERFACE_REMESHING_DETAIL_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Options of `control_detail()`. The named parameters of that function have the same names. Lengths
are in units of the target edge length. "The paper" is the one by Misztal and B&aelig;rentzen
\cgalCite{cgal:mb-taitd-12}.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Detail_options
{
  /// Target edge length, a positive function of position in the coordinates of the complex,
  /// evaluated at midpoints of edges. As a named parameter, `double sizing_field(Point
  /// p)`, callable as `const`. If empty, it is `dsc.mean_interface_edge()` everywhere.
  typename Edge_unit<Complex>::Sizing_field sizing_field;
  /// Selects the cells whose edges are split and collapsed, such as the cells of some labels. As a
  /// named parameter, `bool where(Cell_handle c)`. An edge inside a label is an edge of all cells
  /// around it. If empty, these are all cells.
  std::function<bool(typename Complex::Cell_handle)> where;
  /// Longer edges inside a label are split, greater than 0. The value of the paper.
  double split_length = 4;
  /// Shorter edges inside a label are collapsed, at least 0. As in the paper, the mesh becomes as
  /// coarse as its quality allows.
  double collapse_length = std::numeric_limits<double>::infinity();
  /// No collapse creates a cell of lower quality, in [0, 1]. The value of the paper.
  double collapse_quality = .25;
  /// Whether edges of the interface are split and collapsed, too.
  bool change_interface = false;
  /// Longer edges of the interface are split, greater than 0. The value of the paper.
  double interface_split_length = 2;
  /// Shorter edges of the interface are collapsed, at least 0; without a sizing field, in units of
  /// `dsc.minimum_interface_edge()`. The value of the paper.
  double interface_collapse_length = .5;
  /// Largest number of rounds. Each round processes the cells changed by the previous one.
  unsigned number_of_iterations = 10;
  /// Visitor of the changes; it must outlive the call. None if null.
  Deformation_visitor<Complex>* visitor = nullptr;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (!(split_length > 0 && interface_split_length > 0))
      throw Error("the length of edges to be split is out of range: use more than 0");
    if (!(collapse_length >= 0 && interface_collapse_length >= 0))
      throw Error("the length of edges to be collapsed is out of range: use 0 or more");
    require_quality(collapse_quality);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_DETAIL_OPTIONS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_OPTIONS_OF_CONSTRUCTION_H
#define DSC_PYTHON_OPTIONS_OF_CONSTRUCTION_H

#include "options.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Complex_construction/Construction_options.h>

#include <array>
#include <optional>
#include <utility>

namespace dsc_python {

template <int d> using Box = std::pair<std::array<double, d>, std::array<double, d>>;

inline CGAL::Bbox_2 bbox_of(const Box<2>& box) {
  return {box.first[0], box.first[1], box.second[0], box.second[1]};
}

inline CGAL::Bbox_3 bbox_of(const Box<3>& box) {
  return {box.first[0], box.first[1], box.first[2], box.second[0], box.second[1], box.second[2]};
}

/// Reads the options of the functions that make a complex.
template <int d>
CGAL::Deformable_simplicial_complexes::Construction_options<d>
construction_options(const py::dict& options) {
  CGAL::Deformable_simplicial_complexes::Construction_options<d> result;
  Options rest(options);
  std::optional<Box<d>> box;
  rest.read("box", box);
  if (box)
    result.enclosing_box = bbox_of(*box);
  rest.read_all(result);
  return result;
}

} // namespace dsc_python

#endif // DSC_PYTHON_OPTIONS_OF_CONSTRUCTION_H

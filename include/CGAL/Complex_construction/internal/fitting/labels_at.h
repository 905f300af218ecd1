// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_FITTING_LABELS_AT_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_FITTING_LABELS_AT_H

#include <CGAL/license/Complex_construction.h>

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <type_traits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the labels at points, given by a function of a point or of a vector of points. On a
// torus, the function is called with points of the box.
template <class Complex, class LabelAt>
std::vector<typename Complex::Label>
labels_at(const Complex& complex, const LabelAt& label_at,
          std::vector<typename Complex::Approximate_point> points) {
  using Labels = std::vector<typename Complex::Label>;
  for (auto& p : points)
    p = complex.domain().canonical(p);
  Labels result;
  if constexpr (std::is_invocable_v<const LabelAt&, typename Complex::Approximate_point>) {
    for (const auto& p : points) {
      Progress_scope::check();
      result.push_back(label_at(p));
    }
  } else if (!points.empty()) {
    result = label_at(points);
    if (result.size() != points.size())
      throw Error("the number of labels differs from the number of points: give one label for each "
                  "point");
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_FITTING_LABELS_AT_H

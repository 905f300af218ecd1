// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H
#define CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H

#include <CGAL/license/Interface_flows.h>

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Interface_flows/internal/grains/junctions.h>
#include <CGAL/Interface_remeshing/shared_measures.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

The measures of a label, such as a grain of a polycrystal.
*/
struct Grain_statistics
{
  int label = 0;             ///< the label
  double measure = 0;        ///< the volume, in the plane the area
  double boundary = 0;       ///< the area of its interface, in the plane the length
  std::size_t neighbors = 0; ///< the number of labels that share a facet with it
  /// The number of vertices at which three labels or more meet, in the plane: the number of sides
  /// of a grain inside the domain. In space, 0.
  std::size_t corners = 0;
  /// The number of right angles at its corners on the boundary of a box, in the plane: between its
  /// interface and a side, or between two sides. In space, 0.
  std::size_t right_angles = 0;
  /// The length of the lines at which three labels or more meet, in space. In the plane, 0. Lines
  /// on sides of the domain do not count.
  double triple_lines = 0;
  /// The mean width in space, \f$\frac{1}{2\pi}\sum l\,(\pi-\theta)\f$ over the edges of its
  /// interface, with the length l and the inner dihedral angle \f$\theta\f$. It is 4 r for a ball,
  /// for the definition of R. D. MacPherson and D. J. Srolovitz, *The von Neumann relation
  /// generalized to coarsening of three-dimensional microstructures*, Nature 446, 2007. In the
  /// plane, 0. At edges on sides of the domain, a right angle replaces \f$\pi\f$, so that the mean
  /// width is half of that of the grain with its mirror image.
  double mean_width = 0;

  /// Returns the rate of growth with unit tension and mobility, for a grain whose interfaces meet
  /// at angles of 120 degrees: \f$\frac{\pi}{3}(n-6)\f$ in the plane (J. von Neumann,
  /// W. W. Mullins), and \f$-2\pi(L-\frac{1}{6}M)\f$ in space, with the mean width L and the length
  /// M of triple lines. At the sides of a box, interfaces end at right angles. Then the mirror
  /// images of a grain complete it, and each right angle in the plane adds \f$\frac{\pi}{2}\f$.
  /// \param dimension the dimension of the complex, 2 or 3
  double growth(int dimension) const {
    return dimension == 2 ? CGAL_PI / 3 * (double(corners) + 1.5 * double(right_angles) - 6)
                          : -2 * CGAL_PI * (mean_width - triple_lines / 6);
  }
};

namespace internal {

// Adds the corners of each label: vertices with three labels or more around them, ends of the
// interface on the boundary of the domain, and corners of a box.
template <class Complex>
void add_corners(const Complex& complex, std::map<int, Grain_statistics>& grains) {
  static constexpr std::size_t junction = 3;
  for (auto v : complex.finite_vertices()) {
    const auto sides = v->boundary_class();
    const bool is_on_box = complex.is_boundary(v) && (sides & Boundary_class::fixed) == 0;
    if (!v->is_interface() && !(is_on_box && Boundary_class::fixes_all(sides, 2)))
      continue;
    const auto labels = labels_around(complex, v);
    for (int label : labels) {
      grains[label].corners += labels.size() >= junction;
      grains[label].right_angles += labels.size() < junction && is_on_box;
    }
  }
}

// Adds the mean width and the triple lines of each label. Edges with one label are skipped.
template <class Complex>
void add_edges(const Complex& complex, std::map<int, Grain_statistics>& grains) {
  visit_interface_edges(complex, [&](const auto& ends, const auto& angles) {
    if (angles.size() == 1)
      return;
    static constexpr std::size_t junction = 3;
    const double length = std::sqrt(complex.displacement(ends[0], ends[1]).squared_length());
    const auto sides = ends[0]->boundary_class() & ends[1]->boundary_class();
    const bool is_on_side = (sides & ~Boundary_class::fixed) != 0;
    const double straight = is_on_side ? CGAL_PI / 2 : CGAL_PI;
    for (const auto& [label, angle] : angles) {
      grains[label].mean_width += length * (straight - angle) / (2 * CGAL_PI);
      grains[label].triple_lines += angles.size() >= junction && !is_on_side ? length : 0;
    }
  });
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Returns the measures of all labels of a complex, by increasing label. n log n in the number of
cells.

\throws Interrupted_error if the callback of a `Progress_scope` returned `false`
*/
template <class Complex> std::vector<Grain_statistics> grain_statistics(const Complex& complex) {
  std::map<int, Grain_statistics> grains;
  for (int label : complex.labels())
    grains[label].measure = complex.measure(label);
  for (const auto& [labels, area] : shared_measures(complex))
    for (const int label : {labels.first, labels.second}) {
      grains[label].boundary += area;
      ++grains[label].neighbors;
    }
  if constexpr (Complex::dimension == 2)
    internal::add_corners(complex, grains);
  else
    internal::add_edges(complex, grains);
  std::vector<Grain_statistics> result;
  for (auto& [label, grain] : grains) {
    grain.label = label;
    result.push_back(grain);
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H

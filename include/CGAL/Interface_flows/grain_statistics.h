// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H
#define CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H

#include <CGAL/license/Interface_flows.h>

#include <CGAL/Deformable_simplicial_complexes/shared_measures.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

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
  /// The length of the lines at which three labels or more meet, in space. In the plane, 0.
  double triple_lines = 0;
  /// The mean width in space, \f$\frac{1}{2\pi}\sum l\,(\pi-\theta)\f$ over the edges of its
  /// boundary, with the length l and the inner dihedral angle \f$\theta\f$. It is 4 r for a ball,
  /// for the definition of R. D. MacPherson and D. J. Srolovitz, *The von Neumann relation
  /// generalized to coarsening of three-dimensional microstructures*, Nature 446, 2007. In the
  /// plane, 0.
  double mean_width = 0;

  /// Returns the rate of growth with unit tension and mobility, for a grain that does not touch the
  /// boundary of the domain and whose interfaces meet at angles of 120 degrees: \f$\frac{\pi}{3}
  /// (n-6)\f$ in the plane (J. von Neumann, W. W. Mullins), and
  /// \f$-2\pi(L-\frac{1}{6}M)\f$ in space, with the mean width L and the length M of triple lines.
  /// \param dimension the dimension of the complex, 2 or 3
  double growth(int dimension) const {
    return dimension == 2 ? CGAL_PI / 3 * (double(corners) - 6)
                          : -2 * CGAL_PI * (mean_width - triple_lines / 6);
  }
};

namespace internal {

// Adds the corners of each label: vertices with three labels or more around them.
template <class Complex>
void add_corners(const Complex& complex, std::map<int, Grain_statistics>& grains) {
  for (auto v : complex.interface_vertices()) {
    const auto labels = labels_around(complex, v);
    static constexpr std::size_t junction = 3;
    for (int label : labels)
      grains[label].corners += labels.size() >= junction;
  }
}

// Adds the mean width and the triple lines of each label. The inner angle of a label at an edge is
// the sum of the dihedral angles of its cells there. Edges with one label are skipped, also on the
// boundary of the domain.
template <class Complex>
void add_edges(const Complex& complex, std::map<int, Grain_statistics>& grains) {
  struct Angle
  {
    std::size_t from, to; // time stamps of the ends
    int label;
    double length, angle;
  };
  std::vector<Angle> angles;
  for (auto c : complex.cells()) {
    std::array<typename Complex::Approximate_point, Complex::corners> p;
    for (int i = 0; i < Complex::corners; ++i)
      p[i] = complex.corner(c, i);
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j) {
        const auto a = c->vertex(i), b = c->vertex(j);
        if (!(a->is_interface() && b->is_interface()))
          continue;
        int k = 0;
        while (k == i || k == j)
          ++k;
        const int l = 6 - i - j - k;
        const auto edge = p[j] - p[i], one = cross_product(edge, p[k] - p[i]),
                   other = cross_product(edge, p[l] - p[i]);
        const double angle =
            std::atan2(std::sqrt(cross_product(one, other).squared_length()), one * other);
        const auto ends = std::minmax({a->time_stamp(), b->time_stamp()});
        angles.push_back(
            {ends.first, ends.second, c->label(), std::sqrt(edge.squared_length()), angle});
      }
  }
  const auto key = [](const Angle& a) { return std::make_tuple(a.from, a.to, a.label); };
  std::sort(angles.begin(), angles.end(),
            [&](const Angle& a, const Angle& b) { return key(a) < key(b); });
  for (auto first = angles.begin(); first != angles.end();) {
    auto last = first;
    std::vector<std::pair<int, double>> of_labels;
    for (; last != angles.end() && last->from == first->from && last->to == first->to; ++last) {
      if (of_labels.empty() || of_labels.back().first != last->label)
        of_labels.emplace_back(last->label, 0);
      of_labels.back().second += last->angle;
    }
    static constexpr std::size_t junction = 3;
    for (const auto& [label, angle] : of_labels)
      if (of_labels.size() > 1) {
        grains[label].mean_width += first->length * (CGAL_PI - angle) / (2 * CGAL_PI);
        grains[label].triple_lines += of_labels.size() >= junction ? first->length : 0;
      }
    first = last;
  }
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Returns the measures of all labels of a complex, by increasing label. n log n in the number of
cells.
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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H

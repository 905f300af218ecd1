// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H
#define CGAL_INTERFACE_FLOWS_GRAIN_STATISTICS_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/shared_measures.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {

// A junction: an edge where three labels or more meet, in the plane a vertex.
//
// \tparam Complex a deformable simplicial complex
template <class Complex> struct Junction
{
  // The ends of the edge, the older one first; in the plane, the vertex.
  std::array<typename Complex::Vertex_handle, Complex::dimension - 1> vertices;
  // The angle of each label in radians: the sum of the dihedral angles of its cells at the edge,
  // in the plane of their angles at the vertex. Inside the domain, the sum is \f$2\pi\f$.
  std::map<typename Complex::Label, double> angles;
};

// Returns the angle between the parts of two vectors that are perpendicular to an edge.
template <class Vector> double angle_at_edge(const Vector& edge, const Vector& a, const Vector& b) {
  const Vector u = cross_product(edge, a), v = cross_product(edge, b);
  return std::atan2(std::sqrt(cross_product(u, v).squared_length()), u * v);
}

// Calls visit(vertices, label, angle) for the edges of a cell, in the plane for its vertices, that
// can be junctions. The older vertex of an edge is the first one.
template <class Complex, class Visit>
void visit_angles(const Complex& complex, typename Complex::Cell_handle c, const Visit& visit) {
  static constexpr int d = Complex::dimension;
  std::array<typename Complex::Point, d + 1> p;
  for (int i = 0; i <= d; ++i)
    p[i] = complex.corner(c, i);
  for (int i = 0; i <= d; ++i) {
    if (!c->vertex(i)->is_interface())
      continue;
    if constexpr (d == 2) {
      const auto a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
      visit(std::array{c->vertex(i)}, std::atan2(a.x() * b.y() - a.y() * b.x(), a * b));
    } else {
      for (int j = i + 1; j <= d; ++j) {
        if (!c->vertex(j)->is_interface())
          continue;
        int k = 0;
        while (k == i || k == j)
          ++k;
        const int l = 6 - i - j - k;
        std::array ends = {c->vertex(i), c->vertex(j)};
        if (ends[1]->time_stamp() < ends[0]->time_stamp())
          std::swap(ends[0], ends[1]);
        visit(ends, angle_at_edge(p[j] - p[i], p[k] - p[i], p[l] - p[i]));
      }
    }
  }
}

// Visits the edges whose ends are on the interface, in the plane the vertices of the interface,
// with the angle of each label, see `Junction::angles`. n log n in the number of cells at the
// interface, plus linear in the number of cells.
//
// \param complex the complex
// \param visit `visit(vertices, angles)` is called in the order of the time stamps of the vertices, with
//        `Junction::vertices` and a vector of pairs of a label and its angle, by increasing label.
//        There is a single pair if an edge is not on the interface, also on the boundary of the
//        domain.
// \throws Interrupted_error if the callback of a `Progress_scope` returned `false`
template <class Complex, class Visit>
void visit_interface_edges(const Complex& complex, const Visit& visit) {
  static constexpr int n = Complex::dimension - 1;
  using Label = typename Complex::Label;
  using Vertices = std::array<typename Complex::Vertex_handle, n>;
  struct Angle
  {
    std::array<std::size_t, n> time_stamps;
    Label label;
    double angle;
    Vertices vertices;
  };
  std::vector<Angle> angles;
  for (auto c : complex.cells()) {
    Progress_scope::check();
    visit_angles(complex, c, [&](const Vertices& vertices, double angle) {
      std::array<std::size_t, n> time_stamps;
      for (int i = 0; i < n; ++i)
        time_stamps[i] = vertices[i]->time_stamp();
      angles.push_back({time_stamps, c->subdomain_index(), angle, vertices});
    });
  }
  // Stable, so that sums do not depend on the implementation.
  std::stable_sort(angles.begin(), angles.end(), [](const Angle& a, const Angle& b) {
    return std::tie(a.time_stamps, a.label) < std::tie(b.time_stamps, b.label);
  });
  std::vector<std::pair<Label, double>> of_labels;
  for (auto first = angles.begin(); first != angles.end();) {
    const Vertices vertices = first->vertices;
    const auto time_stamps = first->time_stamps;
    of_labels.clear();
    for (; first != angles.end() && first->time_stamps == time_stamps; ++first) {
      if (of_labels.empty() || of_labels.back().first != first->label)
        of_labels.emplace_back(first->label, 0);
      of_labels.back().second += first->angle;
    }
    visit(vertices, of_labels);
  }
}

// Returns the junctions of a complex with their angles, ordered by the time stamps of their
// vertices. In equilibrium, the angles equal the angles of `Interface_energy::young_angles()`. n
// log n in the number of cells at the interface, plus linear in the number of cells.
//
// \throws Interrupted_error if the callback of a `Progress_scope` returned `false`
template <class Complex> std::vector<Junction<Complex>> junctions(const Complex& complex) {
  std::vector<Junction<Complex>> result;
  visit_interface_edges(complex, [&](const auto& vertices, const auto& angles) {
    static constexpr std::size_t fewest = 3; // labels
    if (angles.size() >= fewest)
      result.push_back({vertices, {angles.begin(), angles.end()}});
  });
  return result;
}

} // namespace internal

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
  internal::visit_interface_edges(complex, [&](const auto& ends, const auto& angles) {
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

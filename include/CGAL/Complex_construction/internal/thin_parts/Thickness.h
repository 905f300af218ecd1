// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_THIN_PARTS_THICKNESS_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_THIN_PARTS_THICKNESS_H

#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the corners of a facet, as seen from its cell.
template <class Complex>
std::array<typename Complex::Point, Complex::dimension>
facet_corners(const Complex& complex, const typename Complex::Facet& facet) {
  std::array<typename Complex::Point, Complex::dimension> result;
  for (int i = 0, k = 0; i < Complex::corners; ++i)
    if (i != facet.second)
      result[k++] = complex.corner(facet.first, i);
  return result;
}

// Returns the same facet, seen from the cell on its other side.
template <class Complex> typename Complex::Facet other_side(const typename Complex::Facet& facet) {
  const auto neighbor = facet.first->neighbor(facet.second);
  return {neighbor, neighbor->index(facet.first)};
}

template <class Complex>
double longest_facet_edge(const Complex& complex, const typename Complex::Facet& facet) {
  const auto p = facet_corners(complex, facet);
  double result = 0;
  for (const auto& [i, j] : Complex::Space::facet_edges)
    result = (std::max)(result, Complex::Space::length(p[i] - p[j]));
  return result;
}

// Relative difference of lengths that count as equal, so that the unit of length does not matter.
inline constexpr double rounding_of_lengths = 1e-9;

// The thickness of a phase at a facet of the interface, on the side of the cell of the facet: the
// distances to the next facets of the interface along the inner normal, from the barycenter and
// from points near the corners. The domain is not a torus.
template <class Complex> class Thickness
{
public:
  using Facet = typename Complex::Facet;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;
  static constexpr int d = Complex::dimension;

  // Larger distances than `most` are not measured.
  Thickness(const Complex& complex, const Facet& facet, double most)
      : m_complex(complex), m_most(most) {
    const auto p = facet_corners(complex, facet);
    Vector normal = Complex::Space::facet_normal(p);
    const double length = Complex::Space::length(normal);
    if (!(length > 0))
      return;
    normal = normal / length;
    if ((m_complex.corner(facet.first, facet.second) - p[0]) * normal < 0)
      normal = -normal;
    for (int k = 0; k <= d; ++k) {         // the last one is the barycenter
      static constexpr double nearby = .8; // weight of the corner
      Vector offset(NULL_VECTOR);
      for (int i = 1; i < d; ++i)
        offset = offset + (k == d   ? 1. / d
                           : k == i ? nearby
                                    : (1 - nearby) / (d - 1)) *
                              (p[i] - p[0]);
      walk(facet, p[0] + offset, normal);
    }
  }

  // Returns whether the thickness is about the same at all points, and at most `most` at one.
  bool is_small() const {
    return m_number == d + 1 && m_smallest <= m_most &&
           m_largest <= (1 + rounding_of_lengths) * ratio * m_smallest;
  }

  double value() const { return m_smallest; } // at the thinnest point

  // A place on a facet opposite.
  struct Opposite
  {
    Facet facet;
    Point place;
  };
  const std::vector<Opposite>& opposite() const { return m_opposite; }

private:
  static constexpr double ratio = 3; // a wedge has no thickness at its edge

  // Walks from a point of a facet through cells, until the interface or the boundary of the domain.
  void walk(Facet from, const Point& start, const Vector& direction) {
    static constexpr int most_cells = 1000; // rounding could lead in a circle
    for (int step = 0; step < most_cells; ++step) {
      const auto [cell, entry] = from;
      int exit = -1;
      double distance = std::numeric_limits<double>::infinity();
      for (int i = 0; i < Complex::corners; ++i) {
        if (i == entry)
          continue;
        const auto p = facet_corners(m_complex, Facet(cell, i));
        Vector outward = Complex::Space::facet_normal(p);
        if ((m_complex.corner(cell, i) - p[0]) * outward > 0)
          outward = -outward;
        const double speed = direction * outward;
        if (const double t = ((p[0] - start) * outward) / speed; speed > 0 && t < distance) {
          distance = t;
          exit = i;
        }
      }
      if (exit < 0 || !(distance <= ratio * m_most))
        return;
      from = other_side<Complex>(Facet(cell, exit));
      if (m_complex.is_infinite(from.first))
        return;
      if (m_complex.is_interface(Facet(cell, exit))) {
        ++m_number;
        m_smallest = (std::min)(m_smallest, distance);
        m_largest = (std::max)(m_largest, distance);
        m_opposite.push_back({Facet(cell, exit), start + distance * direction});
        return;
      }
    }
  }

  const Complex& m_complex;
  double m_most;
  int m_number = 0; // of points with a facet opposite
  double m_smallest = std::numeric_limits<double>::infinity(), m_largest = 0;
  std::vector<Opposite> m_opposite;
};

// A facet of the interface with an edge that is too long for the thickness on one of its sides.
template <class Complex> struct Coarse_facet
{
  typename Complex::Facet facet;
  double edge;                                                    // length of its longest edge
  double longest = std::numeric_limits<double>::infinity();       // that is wanted everywhere
  std::vector<std::pair<typename Complex::Point, double>> places; // and at places

  // Returns the length that is wanted at the thinnest place.
  double shortest() const {
    double result = longest;
    for (const auto& place : places)
      result = (std::min)(result, place.second);
    return result;
  }

  // Estimates the number of facets into which the facet must be divided: bisection halves its edges
  // in each direction.
  double parts() const { return std::pow(edge / shortest(), Complex::dimension - 1); }

  // Multiplies the lengths that are wanted.
  void relax(double factor) {
    longest *= factor;
    for (auto& place : places)
      place.second *= factor;
  }
};

// The facets with edges that are too long, and an estimate of the number of facets that would
// replace them.
template <class Complex> struct Coarse_facets
{
  std::vector<Coarse_facet<Complex>> facets; // by decreasing length of the longest edge
  double parts = 0;
};

// Finds the facets of the interface with an edge longer than a number of thicknesses. If more than
// `most` facets would replace them, all lengths that are wanted are multiplied by a factor.
template <class Complex>
Coarse_facets<Complex> coarse_facets(const Complex& complex, double edge_per_thickness,
                                     std::size_t most) {
  using Facet = typename Complex::Facet;
  std::map<std::pair<std::size_t, int>, Coarse_facet<Complex>> found;
  // Returns the entry of a facet if its edges are longer than `longest`.
  static constexpr double any = std::numeric_limits<double>::infinity();
  const auto entry = [&](Facet facet, double longest) -> Coarse_facet<Complex>* {
    const double edge = longest_facet_edge(complex, facet);
    if (!(edge > (1 + rounding_of_lengths) * longest))
      return nullptr;
    if (const Facet other = other_side<Complex>(facet);
        other.first->time_stamp() < facet.first->time_stamp())
      facet = other;
    return &found
                .try_emplace({facet.first->time_stamp(), facet.second},
                             Coarse_facet<Complex>{facet, edge, any, {}})
                .first->second;
  };
  for (const Facet& facet : complex.interface_facets())
    for (const Facet& side : {facet, other_side<Complex>(facet)}) {
      Progress_scope::check();
      const Thickness<Complex> thickness(complex, side,
                                         longest_facet_edge(complex, side) / edge_per_thickness);
      if (!thickness.is_small())
        continue;
      const double longest = edge_per_thickness * thickness.value();
      if (Coarse_facet<Complex>* coarse = entry(side, longest))
        coarse->longest = (std::min)(coarse->longest, longest);
      for (const auto& [opposite, place] : thickness.opposite())
        if (Coarse_facet<Complex>* coarse = entry(opposite, longest))
          coarse->places.emplace_back(place, longest);
    }
  Coarse_facets<Complex> result;
  for (const auto& [key, facet] : found)
    result.parts += facet.parts();
  const double factor =
      (std::max)(1., std::pow(result.parts / double(most), 1. / (Complex::dimension - 1)));
  for (auto& [key, facet] : found) {
    facet.relax(factor);
    if (facet.edge > facet.shortest())
      result.facets.push_back(std::move(facet));
  }
  std::stable_sort(result.facets.begin(), result.facets.end(),
                   [](const auto& a, const auto& b) { return a.edge > b.edge; });
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_THIN_PARTS_THICKNESS_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_VORONOI_LABELS_H
#define CGAL_INTERFACE_FLOWS_VORONOI_LABELS_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

The labels of a Voronoi diagram in a box from the origin, such as the grains of a polycrystal. A
point has the label of the nearest seed. Labels are 1, 2, 3 and so on. The seeds are random, with a
minimum distance from each other, and depend on the number of the random sequence only.

\tparam Complex a deformable simplicial complex. If its domain is a torus, the box is this torus.
*/
template <class Complex> class Voronoi_labels
{
public:
  static constexpr int d = Complex::dimension; ///< dimension, 2 or 3
  using Point = typename Complex::Point;       ///< a point

  /// The default of the minimum distance of seeds, relative to the side of a cube of the mean size
  /// of a cell. Grains have about equal sizes with larger values, and any sizes with 0.
  static constexpr double default_distance = .6;

  /// Chooses the seeds. The expected time is n log n in their number for boxes of similar sides.
  /// \param number the number of seeds, at least 1
  /// \param sides the sides of the box, positive and finite
  /// \param is_periodic whether the box is a torus
  /// \param sequence the number of the random sequence
  /// \param distance the minimum distance of two seeds, relative to the side of a cube (in the
  ///        plane, of a square) of the mean size of a cell; in [0, .7]
  /// \throws Error if an argument is out of its range
  Voronoi_labels(std::size_t number, const std::array<double, d>& sides, bool is_periodic,
                 std::uint32_t sequence = 1, double distance = default_distance)
      : m_sides(sides), m_is_periodic(is_periodic) {
    double measure = 1;
    for (double side : sides)
      measure *= side;
    if (number == 0 || !(measure > 0) || !std::isfinite(measure))
      throw Error("the number of grains or the size of their box is out of range: use at least one "
                  "grain, and positive, finite sides");
    static constexpr double densest = .7; // random seeds do not get denser
    if (!(distance >= 0 && distance <= densest))
      throw Error("the minimum distance of the seeds of grains is out of range: use 0 to 0.7");
    const double cell = std::pow(measure / double(number), 1. / d);
    std::size_t buckets = 1;
    for (int axis = 0; axis < d; ++axis) {
      m_counts[axis] = std::size_t((std::max)(1., (std::min)(double(number), sides[axis] / cell)));
      buckets *= m_counts[axis];
    }
    m_buckets.resize(buckets);
    const double least = distance * distance * cell * cell;
    std::mt19937 random(sequence);
    while (m_seeds.size() < number) {
      std::array<double, d> p;
      for (int axis = 0; axis < d; ++axis)
        p[axis] = sides[axis] * (random() / 4294967296.);
      if (least == 0 || m_seeds.empty() || nearest(p).second >= least) {
        m_buckets[bucket_of(p)].push_back(m_seeds.size());
        m_seeds.push_back(p);
      }
    }
  }

  /// Returns the label of a point. The expected time is constant for boxes of similar sides.
  /// \pre The point is in the box.
  int operator()(const Point& p) const { return int(nearest(coordinates_of<d>(p)).first) + 1; }

  /// Returns the sides of the box.
  const std::array<double, d>& sides() const { return m_sides; }

  /// Returns the number of labels.
  std::size_t number() const { return m_seeds.size(); }

private:
  using Coordinates = std::array<double, d>;
  using Index = std::array<std::ptrdiff_t, d>;

  Index index_of(const Coordinates& p) const {
    Index result;
    for (int axis = 0; axis < d; ++axis) {
      const auto count = std::ptrdiff_t(m_counts[axis]);
      result[axis] = (std::min)(
          count - 1,
          (std::max)(std::ptrdiff_t(0), std::ptrdiff_t(p[axis] / m_sides[axis] * double(count))));
    }
    return result;
  }
  std::size_t bucket_of(const Coordinates& p) const { return number_of(index_of(p)); }
  std::size_t number_of(const Index& index) const {
    std::size_t result = 0;
    for (int axis = d; axis-- > 0;)
      result = result * m_counts[axis] + std::size_t(index[axis]);
    return result;
  }

  double squared_distance(const Coordinates& p, const Coordinates& q) const {
    double result = 0;
    for (int axis = 0; axis < d; ++axis) {
      double x = std::abs(p[axis] - q[axis]);
      if (m_is_periodic)
        x = (std::min)(x, m_sides[axis] - x);
      result += x * x;
    }
    return result;
  }

  // Returns the nearest seed and its squared distance. Searches cubes of buckets around the point,
  // until the next cube cannot contain a nearer seed.
  std::pair<std::size_t, double> nearest(const Coordinates& p) const {
    std::pair<std::size_t, double> result(0, std::numeric_limits<double>::infinity());
    const Index center = index_of(p);
    double width = std::numeric_limits<double>::infinity(); // of a bucket
    std::ptrdiff_t most = 0;
    for (int axis = 0; axis < d; ++axis) {
      width = (std::min)(width, m_sides[axis] / double(m_counts[axis]));
      most = (std::max)(most, std::ptrdiff_t(m_counts[axis]));
    }
    for (std::ptrdiff_t ring = 0; ring <= most; ++ring) {
      if (ring > 0 && result.second <= (double(ring) - 1) * width * (double(ring) - 1) * width)
        break;
      Index offset;
      offset.fill(-ring);
      for (bool is_left = true; is_left;) {
        if (std::any_of(offset.begin(), offset.end(),
                        [ring](std::ptrdiff_t o) { return o == ring || o == -ring; }))
          visit(p, center, offset, result);
        int axis = 0;
        while (axis < d && offset[axis] == ring)
          offset[axis++] = -ring;
        is_left = axis < d;
        if (is_left)
          ++offset[axis];
      }
    }
    return result;
  }

  void visit(const Coordinates& p, Index index, const Index& offset,
             std::pair<std::size_t, double>& result) const {
    for (int axis = 0; axis < d; ++axis) {
      const auto count = std::ptrdiff_t(m_counts[axis]);
      index[axis] += offset[axis];
      if (m_is_periodic)
        index[axis] = ((index[axis] % count) + count) % count;
      else if (index[axis] < 0 || index[axis] >= count)
        return;
    }
    for (std::size_t seed : m_buckets[number_of(index)])
      if (const double square = squared_distance(p, m_seeds[seed]);
          square < result.second || (square == result.second && seed < result.first))
        result = {seed, square};
  }

  std::array<double, d> m_sides;
  bool m_is_periodic;
  std::array<std::size_t, d> m_counts; // of buckets along each axis
  std::vector<std::vector<std::size_t>> m_buckets;
  std::vector<Coordinates> m_seeds;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_VORONOI_LABELS_H

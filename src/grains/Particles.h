// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PARTICLES_H
#define DSC_PARTICLES_H

#include "Grain_run.h"
#include "errors.h"

#include <CGAL/Deformable_simplicial_complexes/coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace dsc {

/// Returns the radius of the particles of a run.
template <int d> double particle_radius(const Grain_run& run) {
  return run.particle_radius * std::pow(double(run.number), -1. / d);
}

/// Balls of the same radius at random places of a torus or a box of size 1, apart from each other
/// and from the sides of the box.
/// \tparam d the dimension
template <int d> class Particles
{
public:
  /// \throws Input_error if there is no room
  explicit Particles(const Grain_run& run)
      : m_radius(particle_radius<d>(run)), m_is_periodic(run.is_periodic) {
    static constexpr double apart = 3, margin = 1.5;   // radii from another center, from a side
    static constexpr std::size_t most_attempts = 1000; // for each particle
    std::mt19937 random(run.seed + 1);                 // not the sequence of the grains
    const double begin = run.is_periodic ? 0 : margin * m_radius;
    std::size_t attempts = 0; // since the last particle
    while (m_centers.size() < run.particles) {
      if (++attempts > most_attempts || apart * m_radius >= 1)
        throw Input_error("there is no room for the particles; choose fewer or smaller ones");
      Center p;
      for (double& x : p)
        x = begin + (1 - 2 * begin) * (random() / 4294967296.);
      if (std::none_of(m_centers.begin(), m_centers.end(),
                       [&](const Center& q) { return distance(p, q) < apart * m_radius; })) {
        m_centers.push_back(p);
        attempts = 0;
      }
    }
  }

  /// Returns whether a point is in a particle.
  template <class Point> bool contain(const Point& p) const {
    const Center x = CGAL::Deformable_simplicial_complexes::coordinates_of<d>(p);
    return std::any_of(m_centers.begin(), m_centers.end(),
                       [&](const Center& q) { return distance(x, q) < m_radius; });
  }

private:
  using Center = std::array<double, d>;

  double distance(const Center& p, const Center& q) const {
    double result = 0;
    for (int axis = 0; axis < d; ++axis) {
      double x = std::abs(p[axis] - q[axis]);
      if (m_is_periodic)
        x = std::min(x, 1 - x);
      result += x * x;
    }
    return std::sqrt(result);
  }

  double m_radius;
  bool m_is_periodic;
  std::vector<Center> m_centers;
};

} // namespace dsc

#endif // DSC_PARTICLES_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_GRAIN_ORIENTATIONS_H
#define CGAL_INTERFACE_FLOWS_GRAIN_ORIENTATIONS_H

#include <CGAL/Mesh_support/Error.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

The surface energy of a grain boundary by W. T. Read and W. Shockley, *Dislocation models of crystal
grain boundaries*, Physical Review 78, 1950, relative to that of a boundary with a large angle:
\f$\frac{\theta}{\theta_m}(1-\ln\frac{\theta}{\theta_m})\f$ below the angle \f$\theta_m\f$, and 1
above. Surface tensions must be positive, so a smallest energy replaces smaller values.

\param angle the misorientation of the two grains, in radians, at least 0
\param largest the angle \f$\theta_m\f$ in radians, positive. The default is 15 degrees
\param least the smallest energy, positive
\throws Error if an argument is out of its range
*/
inline double read_shockley_energy(double angle, double largest = 15 * CGAL_PI / 180,
                                   double least = .05) {
  if (!(angle >= 0) || !(largest > 0) || !(least > 0))
    throw Error(
        "an argument of the energy of Read and Shockley is out of range: use an angle of 0 or "
        "more, a positive largest angle and a positive least energy");
  const double x = angle / largest;
  return x >= 1 ? 1 : (std::max)(least, x > 0 ? x * (1 - std::log(x)) : 0);
}

/*!
\ingroup PkgInterfaceFlowsRef

Random orientations of cubic crystals, one for each label from 1 on. In the plane, crystals are
rotated about the normal of the plane. In space, orientations are distributed uniformly.

\tparam d the dimension, 2 or 3
*/
template <int d> class Grain_orientations
{
public:
  /// Chooses the orientations of a number of grains. They depend on the number of the random
  /// sequence only.
  /// \throws Error if the number is 0
  explicit Grain_orientations(std::size_t number, std::uint32_t sequence = 1) {
    if (number == 0)
      throw Error("there are no grains with orientations: use at least one");
    std::mt19937 random(sequence);
    const auto uniform = [&random] { return random() / 4294967296.; };
    for (std::size_t k = 0; k < number; ++k)
      if constexpr (d == 2)
        m_rotations.emplace_back(Eigen::AngleAxisd(CGAL_PI / 2 * uniform(), axis()));
      else {
        const double u = uniform(), v = uniform(), w = uniform();
        m_rotations.push_back(uniform_rotation(u, v, w));
      }
  }

  /// Returns the misorientation of two grains: the least angle, in radians, of a rotation that
  /// takes the lattice of one to that of the other. It is at most 45 degrees in the plane and 62.8
  /// degrees in space. Labels without an orientation, such as 0, have that of the first label.
  double misorientation(int a, int b) const {
    const Eigen::Quaterniond q = rotation(a).conjugate() * rotation(b);
    std::array<double, 4> x = {std::abs(q.w()), std::abs(q.x()), std::abs(q.y()), std::abs(q.z())};
    double cosine = 0; // of half the least angle
    if constexpr (d == 2)
      cosine = (std::max)((std::max)(x[0], x[3]), (x[0] + x[3]) * std::sqrt(.5));
    else {
      // The 24 rotations of the cube: about its sides, its diagonals and its edges
      std::sort(x.begin(), x.end());
      cosine = (std::max)((std::max)(x[3], (x[2] + x[3]) * std::sqrt(.5)),
                          (x[0] + x[1] + x[2] + x[3]) / 2);
    }
    return 2 * std::acos((std::min)(1., cosine));
  }

private:
  static Eigen::Vector3d axis() { return Eigen::Vector3d::UnitZ(); }

  // Returns a rotation from three numbers in [0, 1). K. Shoemake, Uniform random rotations,
  // Graphics Gems III, 1992.
  static Eigen::Quaterniond uniform_rotation(double u, double v, double w) {
    const double a = std::sqrt(1 - u), b = std::sqrt(u), p = 2 * CGAL_PI * v, q = 2 * CGAL_PI * w;
    return {b * std::cos(q), a * std::sin(p), a * std::cos(p), b * std::sin(q)};
  }

  const Eigen::Quaterniond& rotation(int label) const {
    const auto k = std::size_t((std::max)(1, label)) - 1;
    return m_rotations[k < m_rotations.size() ? k : 0];
  }

  std::vector<Eigen::Quaterniond, Eigen::aligned_allocator<Eigen::Quaterniond>> m_rotations;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_GRAIN_ORIENTATIONS_H

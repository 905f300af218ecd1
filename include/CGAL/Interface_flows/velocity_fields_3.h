// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_VELOCITY_FIELDS_3_H
#define CGAL_INTERFACE_FLOWS_VELOCITY_FIELDS_3_H

#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Kernel_traits.h>

#include <CGAL/Interface_flows/velocity_fields_2.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

The deformation flow of LeVeque (*High-resolution conservative algorithms for advection in
incompressible flow*, SIAM Journal on Numerical Analysis 33, 1996). Enright and others use it as a
test of interface tracking. The velocity has the factor \f$\cos(\pi t / T)\f$ with the period T. The
flow stretches a ball to a thin sheet until t = T / 2. Then the velocity changes its direction, and
at t = T each point is back at its start. The field preserves volumes and maps the unit cube
\f$[0, 1]^3\f$ to itself.

\cgalModels{VelocityField}
*/
class Enright_velocity_3
{
public:
  using Point_3 = Epick::Point_3;   ///< a point of the unit cube
  using Vector_3 = Epick::Vector_3; ///< a vector in the same coordinates

  /// \param period the period T. The value 3 is common; 1 is the flow of section 4.1.4 of the
  ///        paper.
  /// \pre `period` is positive.
  explicit Enright_velocity_3(double period = 3) : m_period(period) {}

  /// Returns the velocity at the point p, of any kernel of doubles, at the time t.
  template <class Point = Point_3>
  auto operator()(const Point& p, double t) const ->
      typename Kernel_traits<Point>::Kernel::Vector_3 {
    using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;
    const double sx = std::sin(CGAL_PI * p.x()), cx = std::cos(CGAL_PI * p.x());
    const double sy = std::sin(CGAL_PI * p.y()), cy = std::cos(CGAL_PI * p.y());
    const double sz = std::sin(CGAL_PI * p.z()), cz = std::cos(CGAL_PI * p.z());
    const double f = 4 * sx * sy * sz * std::cos(CGAL_PI * t / m_period);
    return f * Vector(2 * sx * cy * cz, -cx * sy * cz, -cx * cy * sz);
  }

private:
  double m_period;
};

/*!
\ingroup PkgInterfaceFlowsRef

The single vortex of Bell, Colella and Glaz in each plane of constant z: the curl of
\f$\psi = -\sin^2(\pi x) \sin^2(\pi y) / \pi\f$, multiplied by \f$\cos(\pi t / T)\f$ with the period
T. The velocity changes its direction at t = T / 2, and at t = T each point is back at its start.
The field preserves volumes and maps the unit square of each plane to itself.

\cgalModels{VelocityField}
*/
class Single_vortex_velocity_3
{
public:
  using Point_3 = Epick::Point_3;   ///< a point of the unit cube
  using Vector_3 = Epick::Vector_3; ///< a vector in the same coordinates

  /// \param period the period T.
  /// \pre `period` is positive.
  explicit Single_vortex_velocity_3(double period = 8) : m_in_plane(period) {}

  /// Returns the velocity at the point p, of any kernel of doubles, at the time t.
  template <class Point = Point_3>
  auto operator()(const Point& p, double t) const ->
      typename Kernel_traits<Point>::Kernel::Vector_3 {
    const auto in_plane = m_in_plane(Epick::Point_2(p.x(), p.y()), t);
    return {in_plane.x(), in_plane.y(), 0};
  }

private:
  Single_vortex_velocity_2 m_in_plane;
};

/*!
\ingroup PkgInterfaceFlowsRef

A velocity field that resembles turbulence and preserves volumes. It is the curl of a random
potential: a sum of waves of the same length in random directions (after R. Bridson, J. Houriham and
M. Nordenstam, *Curl-noise for procedural fluid flow*, SIGGRAPH 2007). The field depends on the
arguments of the constructor only. Between machines, it differs by the rounding of sine and cosine.

\cgalModels{VelocityField}
*/
class Curl_noise_velocity_3
{
public:
  using Point_3 = Epick::Point_3;   ///< a point of the complex
  using Vector_3 = Epick::Vector_3; ///< a vector in the same coordinates

  /// \param wave_length the length of each wave, in the coordinates of the complex
  /// \param speed the root mean square of the speed
  /// \param seed the seed of the random numbers
  /// \param number_of_waves the number of waves in the sum
  /// \pre `wave_length` and `number_of_waves` are positive.
  Curl_noise_velocity_3(double wave_length, double speed, std::uint64_t seed = 0,
                        unsigned number_of_waves = 16) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return std::ldexp(double(random() >> 11), -53); };
    const auto direction = [&] {
      const double z = 2 * uniform() - 1, angle = 2 * CGAL_PI * uniform();
      const double r = std::sqrt(1 - z * z);
      return Vector_3(r * std::cos(angle), r * std::sin(angle), z);
    };
    double mean_square = 0;
    for (unsigned i = 0; i < number_of_waves; ++i) {
      const Vector_3 along = direction(), potential = direction();
      m_waves.push_back({2 * CGAL_PI / wave_length * along, cross_product(along, potential),
                         2 * CGAL_PI * uniform()});
      mean_square += m_waves.back().velocity.squared_length() / 2; // mean cosine²: 1/2
    }
    for (Wave& wave : m_waves)
      wave.velocity = speed / std::sqrt(mean_square) * wave.velocity;
  }

  /// Returns the velocity at the point p, of any kernel of doubles. It does not depend on the time.
  template <class Point = Point_3>
  auto operator()(const Point& p, double /*t*/) const ->
      typename Kernel_traits<Point>::Kernel::Vector_3 {
    const Vector_3 place(p.x(), p.y(), p.z());
    Vector_3 result(0, 0, 0);
    for (const Wave& wave : m_waves)
      result = result + std::cos(wave.number * place + wave.phase) * wave.velocity;
    return {result.x(), result.y(), result.z()};
  }

private:
  struct Wave
  {
    Vector_3 number;   // wave vector, in radians per length
    Vector_3 velocity; // perpendicular to the wave vector
    double phase;
  };

  std::vector<Wave> m_waves;
};

/*!
\ingroup PkgInterfaceFlowsRef

A velocity field for a complex that was normalized. It converts a field from the coordinates of the
user to the coordinates of the complex.

\tparam Complex the type of the complex
\tparam Field model of `VelocityField`
\cgalModels{VelocityField}
*/
template <class Complex, class Field> class Velocity_in_user_coordinates_3
{
public:
  using Point_3 = typename Complex::Point_3;   ///< a point of the complex
  using Vector_3 = typename Complex::Vector_3; ///< a vector in the same coordinates

  /// \param complex the complex. Its normalization is copied.
  /// \param field the velocity field in the coordinates of the user
  Velocity_in_user_coordinates_3(const Complex& complex, Field field)
      : m_normalization(complex.normalization()), m_field(std::move(field)) {}

  /// Returns the velocity at the point p at the time t.
  Vector_3 operator()(const Point_3& p, double t) const {
    const Point_3 q = ORIGIN + (m_normalization.translation + m_normalization.scale * (p - ORIGIN));
    return m_field(q, t) / m_normalization.scale;
  }

private:
  typename Complex::Normalization m_normalization;
  Field m_field;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_VELOCITY_FIELDS_3_H

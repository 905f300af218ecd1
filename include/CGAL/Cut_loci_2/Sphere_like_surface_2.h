// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_SPHERE_LIKE_SURFACE_2_H
#define CGAL_CUT_LOCI_2_SPHERE_LIKE_SURFACE_2_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A function of the unit sphere in stereographic coordinates of another sphere, which a linear map
// and the projection from the origin take to it: the origin of the chart is a pole.
template <class Embedding> class Stereographic_embedding_2
{
public:
  using Direction = std::array<double, 3>;

  // The frame is the image of an orthonormal one; the pole is its last vector.
  Stereographic_embedding_2(const Embedding& embedding, const std::array<Direction, 3>& frame,
                            double shift)
      : m_embedding(embedding), m_frame(frame), m_shift(shift) {}

  template <class T> std::array<T, 3> direction(const T& u, const T& v) const {
    using std::sqrt;
    const T x = u - m_shift, y = v - m_shift, along = 1. - x * x - y * y;
    std::array<T, 3> n;
    for (std::size_t i = 0; i < 3; ++i)
      n[i] = 2. * m_frame[0][i] * x + 2. * m_frame[1][i] * y + m_frame[2][i] * along;
    const T factor = 1. / sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return {factor * n[0], factor * n[1], factor * n[2]};
  }

  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    return m_embedding(direction(u, v));
  }

private:
  Embedding m_embedding;
  std::array<Direction, 3> m_frame;
  double m_shift;
};

} // namespace internal

/*!
\ingroup PkgCutLoci2Ref

A closed surface without holes, such as an ellipsoid, as the image of the unit sphere, for
`Geodesic_front_2` and `cut_locus_2()`. One chart cannot cover it: the chart is a stereographic
one from the source, which covers all but the source; its middle is opposite to the source, where
the cut locus lies. Geodesics leave the source in the opposite chart. A linear map of directions
makes the metric at the source the same in all directions.

\tparam Embedding has
        `template <class T> std::array<T, 3> operator()(const std::array<T, 3>& n) const`
        for directions n of unit length and numbers `T` as of `Embedded_surface_2`
\tparam Differentiated the metric of an embedding of a chart: `double` is enough for `T` if it says
        so
\cgalModels{RiemannianMetric_2}
*/
template <class Embedding, template <class> class Differentiated = Embedded_surface_2>
class Sphere_like_surface_2
{
  using Chart = internal::Stereographic_embedding_2<Embedding>;

public:
  using Direction = std::array<double, 3>;           ///< of the unit sphere
  using Metric = Differentiated<Chart>;              ///< of a chart
  using Domain = Torus_domain<2>;                    ///< around the chart
  using Point_2 = Simple_cartesian<double>::Point_2; ///< of the chart

  /// \param embedding is copied.
  /// \param source the direction whose image the geodesics begin in, not 0, of any length
  /// \throws Error if the direction is 0 or not finite
  Sphere_like_surface_2(const Embedding& embedding, const Direction& source)
      : m_frame(isotropic(embedding, frame_at(source))),
        m_far(embedding, opposite(m_frame), half_width), m_far_metric(m_far),
        m_near_metric(Chart(embedding, m_frame, 0)) {}

  /// The metric at a point of the chart.
  Metric_jet_2 operator()(double u, double v) const { return m_far_metric(u, v); }

  /// The box in which the front moves, with the point opposite to the source in its
  /// middle. A neighborhood of the source lies outside: directions at less than 28 degrees from
  /// it, where the linear map is the identity.
  Domain domain() const { return Domain({2 * half_width, 2 * half_width}); }

  /// The direction whose image a point of the chart stands for.
  Direction direction(const Point_2& p) const { return m_far.direction(p.x(), p.y()); }

  /// Its image.
  std::array<double, 3> image(const Point_2& p) const { return m_far(p.x(), p.y()); }

  /// Of the box.
  static constexpr double half_width = 4;

  /// \cond SKIP_IN_MANUAL
  const Metric& metric_at_source() const { return m_near_metric; } // (0, 0)
  /// \endcond

private:
  using Frame = std::array<Direction, 3>;

  // An orthonormal frame with the direction as its last vector.
  static Frame frame_at(const Direction& source) {
    const double length = std::hypot(source[0], source[1], source[2]);
    if (!(length > 0) || !std::isfinite(length))
      throw Error("the point of the sphere is the origin, or not finite: choose another one");
    Frame f;
    for (std::size_t i = 0; i < 3; ++i)
      f[2][i] = source[i] / length;
    std::size_t across = 0; // the axis that is least along it
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(f[2][i]) < std::abs(f[2][across]))
        across = i;
    const double part = f[2][across], rest = std::sqrt(1 - part * part);
    for (std::size_t i = 0; i < 3; ++i)
      f[0][i] = ((i == across ? 1 : 0) - part * f[2][i]) / rest;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      f[1][i] = f[2][j] * f[0][k] - f[2][k] * f[0][j];
    }
    return f;
  }

  // Returns a frame in whose chart the metric is the same in all directions at the pole, with the
  // same area: what is long in one direction is not lost in a small part of the chart.
  static Frame isotropic(const Embedding& embedding, const Frame& frame) {
    const Metric_jet_2 g = Metric(Chart(embedding, frame, 0))(0, 0);
    const double determinant = g.E * g.G - g.F * g.F;
    if (!(g.E > 0 && determinant > 0) || !std::isfinite(determinant))
      return frame; // refused where geodesics begin
    const double root = std::sqrt(std::sqrt(determinant)), along = root / std::sqrt(g.E),
                 across = 1 / along;
    Frame result = frame;
    for (std::size_t i = 0; i < 3; ++i) {
      result[0][i] = along * frame[0][i];
      result[1][i] = across * (frame[1][i] - g.F / g.E * frame[0][i]);
    }
    return result;
  }

  static Frame opposite(Frame frame) {
    for (double& x : frame[2])
      x = -x;
    return frame;
  }

  Frame m_frame;
  Chart m_far;
  Metric m_far_metric, m_near_metric;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_CUT_LOCI_2_SPHERE_LIKE_SURFACE_2_H

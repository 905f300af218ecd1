// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_SPHERE_LIKE_SURFACE_2_H
#define CGAL_CUT_LOCI_2_SPHERE_LIKE_SURFACE_2_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// An embedding of the unit sphere in stereographic coordinates of a second sphere. A linear map
// takes the second sphere to an ellipsoid, and the projection from the origin takes this ellipsoid
// to the unit sphere.
template <class Embedding> class Stereographic_embedding_2
{
public:
  using Direction = std::array<double, 3>;

  // \param frame the image of an orthonormal frame under the linear map; its last vector is the
  //        pole
  // \param shift both coordinates of the pole in the chart
  Stereographic_embedding_2(const Embedding& embedding, const std::array<Direction, 3>& frame,
                            double shift)
      : m_embedding(embedding), m_frame(frame), m_shift(shift) {}

  const Embedding& embedding() const { return m_embedding; }

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

A closed surface of genus 0, such as an ellipsoid, as the image of the unit sphere. It is an
argument of `Geodesic_front_2` and `cut_locus_2()`.

No chart covers such a surface. The class uses the stereographic chart whose center is opposite to
the source. This chart covers all points except the source. The cut locus lies near its center.
Geodesics leave the source in a second stereographic chart around the source. A linear map of
directions makes the metric at the source isotropic.

\tparam Embedding has
        `template <class T> std::array<T, 3> operator()(const std::array<T, 3>& n) const` for
        directions `n` of unit length. `T` is a number type as for `Embedded_surface_2`.
\tparam Differentiated the class template of the metric of an embedding of a chart. `Embedding` must
        accept only the number types that this template uses.
\cgalModels{RiemannianMetric_2}
*/
template <class Embedding, template <class> class Differentiated = Embedded_surface_2>
class Sphere_like_surface_2
{
  using Chart = internal::Stereographic_embedding_2<Embedding>;

public:
  using Direction = std::array<double, 3>; ///< a vector to a point of the unit sphere
  using Metric = Differentiated<Chart>;    ///< the metric of one of the charts
  using Domain = Torus_domain<2>;          ///< the type of the box
  using Point_2 = Epick::Point_2;          ///< a point of the chart

  /// \param embedding the embedding, which is copied
  /// \param source the direction whose image is the source of the geodesics, of any length
  /// \throws Error if the direction is 0 or not finite.
  Sphere_like_surface_2(const Embedding& embedding, const Direction& source)
      : m_frame(isotropic(embedding, frame_at(source))),
        m_far(embedding, opposite(m_frame), half_width), m_far_metric(m_far),
        m_near_metric(Chart(embedding, m_frame, 0)) {}

  /// Returns the metric at a point of the chart.
  Metric_jet_2 operator()(double u, double v) const { return m_far_metric(u, v); }

  /// Returns the box of the chart. The point opposite to the source is its center. If the linear
  /// map is the identity, the box contains all directions at 28 degrees or more from the source. A
  /// neighborhood of the source lies outside the box.
  Domain domain() const { return Domain({2 * half_width, 2 * half_width}); }

  /// Returns the direction of a point of the chart, of unit length.
  Direction direction(const Point_2& p) const { return m_far.direction(p.x(), p.y()); }

  /// Returns the image of a point of the chart, in space.
  std::array<double, 3> image(const Point_2& p) const { return m_far(p.x(), p.y()); }

  /// half of the width of the box
  static constexpr double half_width = 4;

  /// \cond SKIP_IN_MANUAL
  const Metric& metric_at_source() const { return m_near_metric; } // at (0, 0) of its chart
  /// \endcond

private:
  using Frame = std::array<Direction, 3>;

  // Returns an orthonormal frame with the source direction as its last vector.
  static Frame frame_at(const Direction& source) {
    const double length = std::hypot(source[0], source[1], source[2]);
    if (!(length > 0) || !std::isfinite(length))
      throw Error("the source on the sphere is the origin or is not finite: choose another point");
    Frame f;
    for (std::size_t i = 0; i < 3; ++i)
      f[2][i] = source[i] / length;
    std::size_t across = 0; // axis with the smallest component
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

  // Returns a frame for which the metric at the pole is isotropic and has the same area element. A
  // surface that is long in one direction therefore fits into the chart.
  static Frame isotropic(const Embedding& embedding, const Frame& frame) {
    const Metric_jet_2 g = Metric(Chart(embedding, frame, 0))(0, 0);
    const double determinant = g.E * g.G - g.F * g.F;
    if (!(g.E > 0 && determinant > 0) || !std::isfinite(determinant))
      return frame; // Geodesics_2 throws for this metric
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_CUT_LOCI_2_SPHERE_LIKE_SURFACE_2_H

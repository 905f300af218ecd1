// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_RIEMANNIAN_METRIC_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_RIEMANNIAN_METRIC_2_H

#include <boost/math/differentiation/autodiff.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref
The first fundamental form E du² + 2 F du dv + G dv² of a Riemannian 2-manifold at a point of its
chart, and its derivatives there.
*/
struct Metric_jet_2
{
  double E, F, G;  ///< at the point
  double E_u, E_v; ///< derivatives of E
  double F_u, F_v; ///< derivatives of F
  double G_u, G_v; ///< derivatives of G
};

namespace Deformable_simplicial_complexes {
namespace internal {

// What f(u, v) returns, with its derivatives up to an order in one direction: numbers with one
// variable are a tenth of the work of those with two.
template <std::size_t order, class Function>
auto along(double du, double dv, double u, double v, const Function& f) {
  const auto t = boost::math::differentiation::make_fvar<double, order>(0);
  return f(u + du * t, v + dv * t);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

The metric of a surface in space, found by differentiating its embedding automatically, by
Boost.Math.

\tparam Embedding has `template <class T> std::array<T, 3> operator()(const T& u, const T& v) const`,
        for numbers `T` with the functions of `<cmath>`, found by argument-dependent lookup
\cgalModels{RiemannianMetric_2}
*/
template <class Embedding> class Embedded_surface_2
{
public:
  /// \param embedding is copied.
  explicit Embedded_surface_2(Embedding embedding = Embedding())
      : m_embedding(std::move(embedding)) {}

  /// The metric at a point of the chart.
  Metric_jet_2 operator()(double u, double v) const {
    namespace internal = Deformable_simplicial_complexes::internal;
    const auto by_u = internal::along<2>(1, 0, u, v, m_embedding),
               by_v = internal::along<2>(0, 1, u, v, m_embedding),
               by_both = internal::along<2>(1, 1, u, v, m_embedding);
    Metric_jet_2 g = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      // Coefficients of Taylor series: those of second order are half the derivatives.
      const double r_u = by_u[i].at(1), r_uu = 2 * by_u[i].at(2), r_v = by_v[i].at(1),
                   r_vv = 2 * by_v[i].at(2), r_uv = by_both[i].at(2) - (r_uu + r_vv) / 2;
      g.E += r_u * r_u;
      g.F += r_u * r_v;
      g.G += r_v * r_v;
      g.E_u += 2 * r_uu * r_u;
      g.E_v += 2 * r_uv * r_u;
      g.F_u += r_uu * r_v + r_u * r_uv;
      g.F_v += r_uv * r_v + r_u * r_vv;
      g.G_u += 2 * r_uv * r_v;
      g.G_v += 2 * r_vv * r_v;
    }
    return g;
  }

private:
  Embedding m_embedding;
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

A metric given by its tensor, differentiated automatically, by Boost.Math.

\tparam Tensor has `template <class T> std::array<T, 3> operator()(const T& u, const T& v) const`,
        which returns E, F and G, for numbers `T` as of `Embedded_surface_2`
\cgalModels{RiemannianMetric_2}
*/
template <class Tensor> class Metric_tensor_2
{
public:
  /// \param tensor is copied.
  explicit Metric_tensor_2(Tensor tensor = Tensor()) : m_tensor(std::move(tensor)) {}

  /// The metric at a point of the chart.
  Metric_jet_2 operator()(double u, double v) const {
    namespace internal = Deformable_simplicial_complexes::internal;
    const auto by_u = internal::along<1>(1, 0, u, v, m_tensor),
               by_v = internal::along<1>(0, 1, u, v, m_tensor);
    const auto value = [&](std::size_t i) { return by_u[i].at(0); };
    return {value(0),      value(1),      value(2),      by_u[0].at(1), by_v[0].at(1),
            by_u[1].at(1), by_v[1].at(1), by_u[2].at(1), by_v[2].at(1)};
  }

private:
  Tensor m_tensor;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_RIEMANNIAN_METRIC_2_H

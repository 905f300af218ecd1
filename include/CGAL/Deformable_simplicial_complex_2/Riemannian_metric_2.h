// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_RIEMANNIAN_METRIC_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_RIEMANNIAN_METRIC_2_H

#include <boost/math/differentiation/autodiff.hpp>

#include <array>
#include <cstddef>
#include <tuple>
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

// Calls f with u and v as numbers of one type that carry derivatives up to an order.
template <std::size_t order, class Function>
auto with_derivatives(double u, double v, const Function& f) {
  const auto variables = boost::math::differentiation::make_ftuple<double, order, order>(u, v);
  // Zeros of the other variable make them the same type.
  const auto x = std::get<0>(variables) + 0. * std::get<1>(variables);
  const auto y = std::get<1>(variables) + 0. * std::get<0>(variables);
  return f(x, y);
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
    return Deformable_simplicial_complexes::internal::with_derivatives<2>(
        u, v, [&](const auto& x, const auto& y) {
          const auto r = m_embedding(x, y);
          const auto dot = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
            double sum = 0;
            for (const auto& coordinate : r)
              sum += coordinate.derivative(i, j) * coordinate.derivative(k, l);
            return sum;
          };
          return Metric_jet_2{dot(1, 0, 1, 0),
                              dot(1, 0, 0, 1),
                              dot(0, 1, 0, 1),
                              2 * dot(2, 0, 1, 0),
                              2 * dot(1, 1, 1, 0),
                              dot(2, 0, 0, 1) + dot(1, 0, 1, 1),
                              dot(1, 1, 0, 1) + dot(1, 0, 0, 2),
                              2 * dot(1, 1, 0, 1),
                              2 * dot(0, 2, 0, 1)};
        });
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
    return Deformable_simplicial_complexes::internal::with_derivatives<1>(
        u, v, [&](const auto& x, const auto& y) {
          const auto g = m_tensor(x, y);
          const auto d = [&](std::size_t which, std::size_t i, std::size_t j) {
            return double(g[which].derivative(i, j));
          };
          return Metric_jet_2{d(0, 0, 0), d(1, 0, 0), d(2, 0, 0), d(0, 1, 0), d(0, 0, 1),
                              d(1, 1, 0), d(1, 0, 1), d(2, 1, 0), d(2, 0, 1)};
        });
  }

private:
  Tensor m_tensor;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_RIEMANNIAN_METRIC_2_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H
#define CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H

#include <CGAL/Cut_loci_2/internal/geodesics/Second_order_number_2.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgCutLoci2Ref
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

/*!
\ingroup PkgCutLoci2Ref

The metric of a surface in space. Its derivatives are exact, by automatic differentiation.

\tparam Embedding has `template <class T> std::array<T, 3> operator()(const T& u, const T& v) const`,
        for numbers `T` that doubles are converted to, with the functions of `<cmath>`, found by
        argument-dependent lookup
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
    using Number = internal::Second_order_number_2;
    const std::array<Number, 3> r = m_embedding(Number(u, 1, 0, 0, 0, 0), Number(v, 0, 1, 0, 0, 0));
    Metric_jet_2 g = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (const Number& x : r) {
      g.E += x.u * x.u;
      g.F += x.u * x.v;
      g.G += x.v * x.v;
      g.E_u += 2 * x.uu * x.u;
      g.E_v += 2 * x.uv * x.u;
      g.F_u += x.uu * x.v + x.u * x.uv;
      g.F_v += x.uv * x.v + x.u * x.vv;
      g.G_u += 2 * x.uv * x.v;
      g.G_v += 2 * x.vv * x.v;
    }
    return g;
  }

private:
  Embedding m_embedding;
};

/*!
\ingroup PkgCutLoci2Ref

A metric given by its tensor. Its derivatives are exact, by automatic differentiation.

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
    using Number = internal::Second_order_number_2;
    const std::array<Number, 3> g = m_tensor(Number(u, 1, 0, 0, 0, 0), Number(v, 0, 1, 0, 0, 0));
    return {g[0].value, g[1].value, g[2].value, g[0].u, g[0].v, g[1].u, g[1].v, g[2].u, g[2].v};
  }

private:
  Tensor m_tensor;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H

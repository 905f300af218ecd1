// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Cut_loci_2, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H
#define CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H

#include <CGAL/license/Cut_loci_2.h>

#include <CGAL/Cut_loci_2/internal/geodesics/Second_order_number_2.h>

#include <array>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgCutLoci2Ref
The first fundamental form \f$E\,du^2 + 2F\,du\,dv + G\,dv^2\f$ of a Riemannian 2-manifold at a
point of its chart, and its first derivatives at this point.
*/
struct Metric_jet_2
{
  double E,   ///< coefficient of du²
      F,      ///< half of the coefficient of du dv
      G;      ///< coefficient of dv²
  double E_u, ///< derivative of E by u
      E_v;    ///< derivative of E by v
  double F_u, ///< derivative of F by u
      F_v;    ///< derivative of F by v
  double G_u, ///< derivative of G by u
      G_v;    ///< derivative of G by v
};

/*!
\ingroup PkgCutLoci2Ref

The metric of a surface that is embedded in space. Derivatives are exact up to rounding, by
automatic differentiation.

\tparam Embedding has
        `template <class T> std::array<T, 3> operator()(const T& u, const T& v) const`. `T` is a
        number type that is constructible from `double`. The functions of `<cmath>` are found for
        `T` by argument-dependent lookup.
\cgalModels `RiemannianMetric_2`
*/
template <class Embedding> class Embedded_surface_2
{
public:
  /// \param embedding the embedding, which is copied
  explicit Embedded_surface_2(Embedding embedding = Embedding())
      : m_embedding(std::move(embedding)) {}

  /// Returns the metric at a point of the chart.
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

A metric that is given by its tensor. Derivatives are exact up to rounding, by automatic
differentiation.

\tparam Tensor has `template <class T> std::array<T, 3> operator()(const T& u, const T& v) const`.
        It returns E, F and G. `T` is a number type as for `Embedded_surface_2`.
\cgalModels `RiemannianMetric_2`
*/
template <class Tensor> class Metric_tensor_2
{
public:
  /// \param tensor the tensor, which is copied
  explicit Metric_tensor_2(Tensor tensor = Tensor()) : m_tensor(std::move(tensor)) {}

  /// Returns the metric at a point of the chart.
  Metric_jet_2 operator()(double u, double v) const {
    using Number = internal::Second_order_number_2;
    const std::array<Number, 3> g = m_tensor(Number(u, 1, 0, 0, 0, 0), Number(v, 0, 1, 0, 0, 0));
    return {g[0].value, g[1].value, g[2].value, g[0].u, g[0].v, g[1].u, g[1].v, g[2].u, g[2].v};
  }

private:
  Tensor m_tensor;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H

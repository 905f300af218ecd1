// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H
#define CGAL_CUT_LOCI_2_RIEMANNIAN_METRIC_2_H

#include <array>
#include <cmath>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A number with its first and second derivatives by u and v, for automatic differentiation. The
// functions of <cmath> are found by argument-dependent lookup.
struct Second_order_number_2
{
  double value, u = 0, v = 0, uu = 0, uv = 0, vv = 0;

  Second_order_number_2() : value(0) {}
  Second_order_number_2(double x) : value(x) {}
  Second_order_number_2(double x, double by_u, double by_v, double by_uu, double by_uv,
                        double by_vv)
      : value(x), u(by_u), v(by_v), uu(by_uu), uv(by_uv), vv(by_vv) {}

  using Number = Second_order_number_2;

  // Returns f(x), given f and its first and second derivatives at the value of x.
  static Number chain(const Number& x, double f, double first, double second) {
    return {f,
            first * x.u,
            first * x.v,
            first * x.uu + second * x.u * x.u,
            first * x.uv + second * x.u * x.v,
            first * x.vv + second * x.v * x.v};
  }

  Number operator+() const { return *this; }
  Number operator-() const { return {-value, -u, -v, -uu, -uv, -vv}; }
  Number& operator+=(const Number& b) { return *this = *this + b; }
  Number& operator-=(const Number& b) { return *this = *this - b; }
  Number& operator*=(const Number& b) { return *this = *this * b; }
  Number& operator/=(const Number& b) { return *this = *this / b; }

  friend Number operator+(const Number& a, const Number& b) {
    return {a.value + b.value, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
  }
  friend Number operator-(const Number& a, const Number& b) { return a + -b; }
  friend Number operator*(const Number& a, const Number& b) {
    return {a.value * b.value,
            a.value * b.u + a.u * b.value,
            a.value * b.v + a.v * b.value,
            a.value * b.uu + 2 * a.u * b.u + a.uu * b.value,
            a.value * b.uv + a.u * b.v + a.v * b.u + a.uv * b.value,
            a.value * b.vv + 2 * a.v * b.v + a.vv * b.value};
  }
  friend Number operator/(const Number& a, const Number& b) {
    const double inverse = 1 / b.value, squared = inverse * inverse;
    return a * chain(b, inverse, -squared, 2 * squared * inverse);
  }
  friend Number operator+(const Number& a, double b) {
    return {a.value + b, a.u, a.v, a.uu, a.uv, a.vv};
  }
  friend Number operator+(double a, const Number& b) { return b + a; }
  friend Number operator-(const Number& a, double b) { return a + -b; }
  friend Number operator-(double a, const Number& b) { return -b + a; }
  friend Number operator*(const Number& a, double b) {
    return {a.value * b, a.u * b, a.v * b, a.uu * b, a.uv * b, a.vv * b};
  }
  friend Number operator*(double a, const Number& b) { return b * a; }
  friend Number operator/(const Number& a, double b) { return a * (1 / b); }

  friend bool operator<(const Number& a, const Number& b) { return a.value < b.value; }
  friend bool operator>(const Number& a, const Number& b) { return a.value > b.value; }
  friend bool operator<=(const Number& a, const Number& b) { return a.value <= b.value; }
  friend bool operator>=(const Number& a, const Number& b) { return a.value >= b.value; }
  friend bool operator==(const Number& a, const Number& b) { return a.value == b.value; }
  friend bool operator!=(const Number& a, const Number& b) { return a.value != b.value; }

  friend Number abs(const Number& x) { return x.value < 0 ? -x : x; }
  friend Number fabs(const Number& x) { return abs(x); }
  friend Number sqrt(const Number& x) {
    const double f = std::sqrt(x.value);
    return chain(x, f, .5 / f, -.25 / (f * x.value));
  }
  friend Number cbrt(const Number& x) {
    const double f = std::cbrt(x.value), first = f / (3 * x.value);
    return chain(x, f, first, -2 * first / (3 * x.value));
  }
  friend Number exp(const Number& x) {
    const double f = std::exp(x.value);
    return chain(x, f, f, f);
  }
  friend Number log(const Number& x) {
    return chain(x, std::log(x.value), 1 / x.value, -1 / (x.value * x.value));
  }
  friend Number pow(const Number& x, double power) {
    const auto term = [&](double factor, double exponent) {
      return factor == 0 ? 0 : factor * std::pow(x.value, exponent);
    };
    return chain(x, std::pow(x.value, power), term(power, power - 1),
                 term(power * (power - 1), power - 2));
  }
  friend Number pow(const Number& x, const Number& power) { return exp(power * log(x)); }
  friend Number sin(const Number& x) {
    const double s = std::sin(x.value);
    return chain(x, s, std::cos(x.value), -s);
  }
  friend Number cos(const Number& x) {
    const double c = std::cos(x.value);
    return chain(x, c, -std::sin(x.value), -c);
  }
  friend Number tan(const Number& x) {
    const double t = std::tan(x.value), first = 1 + t * t;
    return chain(x, t, first, 2 * t * first);
  }
  friend Number asin(const Number& x) {
    const double first = 1 / std::sqrt(1 - x.value * x.value);
    return chain(x, std::asin(x.value), first, x.value * first * first * first);
  }
  friend Number acos(const Number& x) {
    const double first = -1 / std::sqrt(1 - x.value * x.value);
    return chain(x, std::acos(x.value), first, x.value * first * first * first);
  }
  friend Number atan(const Number& x) {
    const double first = 1 / (1 + x.value * x.value);
    return chain(x, std::atan(x.value), first, -2 * x.value * first * first);
  }
  // The derivatives are those of atan(y / x) or -atan(x / y), whichever quotient is smaller.
  friend Number atan2(const Number& y, const Number& x) {
    Number result = std::abs(x.value) > std::abs(y.value) ? atan(y / x) : -atan(x / y);
    result.value = std::atan2(y.value, x.value);
    return result;
  }
  friend Number hypot(const Number& x, const Number& y) { return sqrt(x * x + y * y); }
  friend Number sinh(const Number& x) {
    const double f = std::sinh(x.value);
    return chain(x, f, std::cosh(x.value), f);
  }
  friend Number cosh(const Number& x) {
    const double f = std::cosh(x.value);
    return chain(x, f, std::sinh(x.value), f);
  }
  friend Number tanh(const Number& x) {
    const double t = std::tanh(x.value), first = 1 - t * t;
    return chain(x, t, first, -2 * t * first);
  }
};

} // namespace internal

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
\cgalModels{RiemannianMetric_2}
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
\cgalModels{RiemannianMetric_2}
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

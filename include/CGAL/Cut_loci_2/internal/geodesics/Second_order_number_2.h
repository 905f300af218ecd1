// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Cut_loci_2, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_SECOND_ORDER_NUMBER_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_SECOND_ORDER_NUMBER_2_H

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_SECOND_ORDER_NUMBER_2_H

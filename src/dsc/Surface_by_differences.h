// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_BY_DIFFERENCES_H
#define DSC_SURFACE_BY_DIFFERENCES_H

#include <CGAL/Deformable_simplicial_complex_2/Riemannian_metric_2.h>

#include <array>
#include <utility>

namespace dsc {

/// The metric of an embedding of a chart, by differences of the sixth order: with this width, what
/// they leave out and what rounding adds are both about 1e-12.
template <class Embedding> class Surface_by_differences
{
public:
  explicit Surface_by_differences(Embedding embedding) : m_embedding(std::move(embedding)) {}

  CGAL::Metric_jet_2 operator()(double u, double v) const {
    Vector ru, ruu, rv, rvv, unused, along, across;
    derive(u, v, 1, 0, ru, ruu);
    derive(u, v, 0, 1, rv, rvv);
    derive(u, v, 1, 1, unused, along);
    derive(u, v, 1, -1, unused, across);
    Vector ruv;
    for (int i = 0; i < 3; ++i)
      ruv[i] = (along[i] - across[i]) / 4;
    return {dot(ru, ru),
            dot(ru, rv),
            dot(rv, rv),
            2 * dot(ruu, ru),
            2 * dot(ruv, ru),
            dot(ruu, rv) + dot(ru, ruv),
            dot(ruv, rv) + dot(ru, rvv),
            2 * dot(ruv, rv),
            2 * dot(rvv, rv)};
  }

private:
  using Vector = std::array<double, 3>;

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // The first two derivatives in a direction.
  void derive(double u, double v, int du, int dv, Vector& first, Vector& second) const {
    static constexpr double width = .01;
    static constexpr double firsts[] = {3. / 4, -3. / 20, 1. / 60},
                            seconds[] = {3. / 2, -3. / 20, 1. / 90}, middle = -49. / 18;
    const Vector here = m_embedding(u, v);
    for (int i = 0; i < 3; ++i) {
      first[i] = 0;
      second[i] = middle * here[i] / (width * width);
    }
    for (int k = 1; k <= 3; ++k) {
      const Vector ahead = m_embedding(u + k * width * du, v + k * width * dv),
                   behind = m_embedding(u - k * width * du, v - k * width * dv);
      for (int i = 0; i < 3; ++i) {
        first[i] += firsts[k - 1] * (ahead[i] - behind[i]) / width;
        second[i] += seconds[k - 1] * (ahead[i] + behind[i]) / (width * width);
      }
    }
  }

  Embedding m_embedding;
};

} // namespace dsc

#endif // DSC_SURFACE_BY_DIFFERENCES_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_BY_DIFFERENCES_H
#define DSC_SURFACE_BY_DIFFERENCES_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/number_utils.h>

#include <array>
#include <utility>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// The metric of an embedding of a chart, computed by finite differences of sixth order. The
/// default width of the differences, 1/600 of a full turn, balances truncation and rounding errors.
template <class Embedding> class Surface_by_differences
{
public:
  explicit Surface_by_differences(Embedding embedding)
      : m_embedding(std::move(embedding)), m_widths{width, width} {}

  /// \param periods periods of the chart; the widths of the differences are proportional to them
  Surface_by_differences(Embedding embedding, const std::array<double, 2>& periods)
      : m_embedding(std::move(embedding)), m_widths{periods[0] / turn * width,
                                                    periods[1] / turn * width} {}

  DSC::Metric_jet_2 operator()(double u, double v) const {
    const double a = m_widths[0], b = m_widths[1];
    const Vector here = m_embedding(u, v);
    Vector ru, ruu, rv, rvv, unused, ruv; // derivatives in units of the widths
    derive(here, u, v, a, 0, ru, ruu);
    derive(here, u, v, 0, b, rv, rvv);
    derive(here, u, v, a, b, unused, ruv);
    for (int i = 0; i < 3; ++i)
      ruv[i] = (ruv[i] - ruu[i] - rvv[i]) / 2;
    return {dot(ru, ru) / (a * a),
            dot(ru, rv) / (a * b),
            dot(rv, rv) / (b * b),
            2 * dot(ruu, ru) / (a * a * a),
            2 * dot(ruv, ru) / (a * a * b),
            (dot(ruu, rv) + dot(ru, ruv)) / (a * a * b),
            (dot(ruv, rv) + dot(ru, rvv)) / (a * b * b),
            2 * dot(ruv, rv) / (a * b * b),
            2 * dot(rvv, rv) / (b * b * b)};
  }

private:
  static constexpr double turn = 2 * CGAL_PI, width = .01;

  using Vector = std::array<double, 3>;

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // Computes the first and second derivative along a step (du, dv), in units of the step.
  void derive(const Vector& here, double u, double v, double du, double dv, Vector& first,
              Vector& second) const {
    static constexpr double firsts[] = {3. / 4, -3. / 20, 1. / 60},
                            seconds[] = {3. / 2, -3. / 20, 1. / 90}, middle = -49. / 18;
    for (int i = 0; i < 3; ++i) {
      first[i] = 0;
      second[i] = middle * here[i];
    }
    for (int k = 1; k <= 3; ++k) {
      const Vector ahead = m_embedding(u + k * du, v + k * dv),
                   behind = m_embedding(u - k * du, v - k * dv);
      for (int i = 0; i < 3; ++i) {
        first[i] += firsts[k - 1] * (ahead[i] - behind[i]);
        second[i] += seconds[k - 1] * (ahead[i] + behind[i]);
      }
    }
  }

  Embedding m_embedding;
  std::array<double, 2> m_widths;
};

} // namespace dsc

#endif // DSC_SURFACE_BY_DIFFERENCES_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CUT_LOCI_SURFACE_BY_DIFFERENCES_H
#define DSC_CUT_LOCI_SURFACE_BY_DIFFERENCES_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace dsc {

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Chart_points = std::vector<std::array<double, 2>>; ///< u and v of points of a chart
using Space_points = std::vector<std::array<double, 3>>; ///< points or directions in space

/// An embedding of a chart: returns the images of points.
using Chart_embedding = std::function<Space_points(const Chart_points&)>;

/// An embedding of the unit sphere.
struct Sphere_embedding
{
  std::function<Space_points(const Space_points&)> images; ///< of directions of unit length

  std::array<double, 3> operator()(const std::array<double, 3>& direction) const {
    return images({direction}).front();
  }
};

inline Space_points images(const Chart_embedding& embedding, const Chart_points& points) {
  return embedding(points);
}

inline Space_points
images(const DSC::internal::Stereographic_embedding_2<Sphere_embedding>& embedding,
       const Chart_points& points) {
  Space_points directions;
  for (const auto& [u, v] : points)
    directions.push_back(embedding.direction(u, v));
  return embedding.embedding().images(directions);
}

/// The metric of an embedding of a chart, computed by finite differences of sixth order. The
/// default width of the differences, 1/600 of a full turn, balances truncation and rounding errors.
/// \tparam Embedding `Chart_embedding`, or a chart of a `Sphere_embedding`
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
    // The point itself, then pairs of points on lines along u, along v, and along the diagonal.
    Chart_points points = {{u, v}};
    for (const auto& [du, dv] : {std::pair(a, 0.), std::pair(0., b), std::pair(a, b)})
      for (int k = 1; k <= pairs; ++k) {
        points.push_back({u + k * du, v + k * dv});
        points.push_back({u - k * du, v - k * dv});
      }
    const Space_points samples = images(m_embedding, points);
    Vector ru, ruu, rv, rvv, unused, ruv; // derivatives in units of the widths
    derive(samples, 0, ru, ruu);
    derive(samples, 1, rv, rvv);
    derive(samples, 2, unused, ruv);
    for (std::size_t i = 0; i < 3; ++i)
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
  static constexpr int pairs = 3; // on each line

  using Vector = std::array<double, 3>;

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // Computes the first and second derivative along a line, in units of the step.
  static void derive(const Space_points& samples, std::size_t line, Vector& first, Vector& second) {
    static constexpr double firsts[] = {3. / 4, -3. / 20, 1. / 60},
                            seconds[] = {3. / 2, -3. / 20, 1. / 90}, middle = -49. / 18;
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] = 0;
      second[i] = middle * samples[0][i];
      for (std::size_t k = 0; k < pairs; ++k) {
        const std::size_t pair = 1 + 2 * (pairs * line + k);
        first[i] += firsts[k] * (samples[pair][i] - samples[pair + 1][i]);
        second[i] += seconds[k] * (samples[pair][i] + samples[pair + 1][i]);
      }
    }
  }

  Embedding m_embedding;
  std::array<double, 2> m_widths;
};

} // namespace dsc

#endif // DSC_CUT_LOCI_SURFACE_BY_DIFFERENCES_H

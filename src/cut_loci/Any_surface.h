// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CUT_LOCI_ANY_SURFACE_H
#define DSC_CUT_LOCI_ANY_SURFACE_H

#include "Surface_by_differences.h"

#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>

#include <array>
#include <cstddef>
#include <functional>

namespace dsc {

/// A metric of a chart. Model of `RiemannianMetric_2`.
using Any_metric = std::function<DSC::Metric_jet_2(double u, double v)>;

/// A surface with a periodic chart.
struct Chart_surface
{
  Any_metric metric;
  std::function<std::array<double, 3>(double u, double v)> image;
};

/// Returns a surface by an embedding as `CGAL::Deformable_simplicial_complexes::Embedded_surface_2`
/// requires.
template <class Embedding> Chart_surface chart_surface(const Embedding& embedding) {
  return {DSC::Embedded_surface_2<Embedding>(embedding),
          [embedding](double u, double v) { return embedding(u, v); }};
}

/// Returns a surface by a function for many points.
inline Chart_surface sampled_chart_surface(const Chart_images& images,
                                           const std::array<double, 2>& periods) {
  return {Surface_by_differences(images, periods), [images](double u, double v) {
            Chart_samples points;
            points.fill({u, v});
            return images(points)[0];
          }};
}

/// A surface that is the image of the unit sphere.
struct Sphere_surface
{
  using Direction = std::array<double, 3>;
  using Chart = DSC::internal::Stereographic_embedding_2<Sphere_surface>;

  std::function<Direction(const Direction&)> image;
  std::function<Any_metric(const Chart&)> metric; ///< of a stereographic chart

  Direction operator()(const Direction& n) const { return image(n); }
};

/// Returns a surface by an embedding as `CGAL::Deformable_simplicial_complexes::
/// Sphere_like_surface_2` requires.
template <class Embedding> Sphere_surface sphere_surface(const Embedding& embedding) {
  return {[embedding](const Sphere_surface::Direction& n) { return embedding(n); },
          [embedding](const Sphere_surface::Chart& chart) -> Any_metric {
            const auto embedded = [=](const auto& u, const auto& v) {
              return embedding(chart.direction(u, v));
            };
            return DSC::Embedded_surface_2<decltype(embedded)>(embedded);
          }};
}

/// Returns the images of many directions of unit length.
using Sphere_images = std::function<Space_samples(const Space_samples&)>;

/// Returns a surface by a function for many directions.
inline Sphere_surface sampled_sphere_surface(const Sphere_images& images) {
  return {[images](const Sphere_surface::Direction& n) {
            Space_samples directions;
            directions.fill(n);
            return images(directions)[0];
          },
          [images](const Sphere_surface::Chart& chart) -> Any_metric {
            return Surface_by_differences([=](const Chart_samples& points) {
              Space_samples directions;
              for (std::size_t i = 0; i < points.size(); ++i)
                directions[i] = chart.direction(points[i][0], points[i][1]);
              return images(directions);
            });
          }};
}

/// The metric of a stereographic chart, as `Sphere_like_surface_2` requires.
template <class Chart> class Metric_of_chart
{
public:
  explicit Metric_of_chart(const Chart& chart) : m_metric(chart.embedding().metric(chart)) {}
  DSC::Metric_jet_2 operator()(double u, double v) const { return m_metric(u, v); }

private:
  Any_metric m_metric;
};

} // namespace dsc

#endif // DSC_CUT_LOCI_ANY_SURFACE_H

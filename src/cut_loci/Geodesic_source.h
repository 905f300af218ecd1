// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CUT_LOCI_GEODESIC_SOURCE_H
#define DSC_CUT_LOCI_GEODESIC_SOURCE_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>
#include <CGAL/number_utils.h>

#include <memory>

namespace dsc {

namespace DSC = CGAL::Deformable_simplicial_complexes;

/// Number of points at which a surface is evaluated for its metric: one, and three pairs on each of
/// three lines.
inline constexpr std::size_t samples_of_metric = 19;
using Chart_samples = std::array<std::array<double, 2>, samples_of_metric>; ///< u and v
using Space_samples = std::array<std::array<double, 3>, samples_of_metric>; ///< x, y and z

/// An embedding of a chart: returns the images of the points.
using Chart_images = std::function<Space_samples(const Chart_samples&)>;

/// The metric of an embedding of a chart, computed by finite differences of sixth order. The
/// default width of the differences, 1/600 of a full turn, balances truncation and rounding errors.
class Surface_by_differences
{
public:
  explicit Surface_by_differences(Chart_images images)
      : m_images(std::move(images)), m_widths{width, width} {}

  /// \param periods periods of the chart; the widths of the differences are proportional to them
  Surface_by_differences(Chart_images images, const std::array<double, 2>& periods)
      : m_images(std::move(images)), m_widths{periods[0] / turn * width,
                                              periods[1] / turn * width} {}

  DSC::Metric_jet_2 operator()(double u, double v) const {
    const double a = m_widths[0], b = m_widths[1];
    const std::array<std::array<double, 2>, 3> steps = {{{a, 0}, {0, b}, {a, b}}};
    Chart_samples points;
    points[0] = {u, v};
    for (std::size_t line = 0; line < 3; ++line)
      for (std::size_t k = 0; k < pairs; ++k) {
        const double du = double(k + 1) * steps[line][0], dv = double(k + 1) * steps[line][1];
        points[place(line, k)] = {u + du, v + dv};
        points[place(line, k) + 1] = {u - du, v - dv};
      }
    const Space_samples samples = m_images(points);
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
  static constexpr std::size_t pairs = 3; // on each line

  using Vector = std::array<double, 3>;

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static std::size_t place(std::size_t line, std::size_t pair) {
    return 1 + 2 * (pairs * line + pair);
  }

  // Computes the first and second derivative along a line, in units of the step.
  static void derive(const Space_samples& samples, std::size_t line, Vector& first,
                     Vector& second) {
    static constexpr double firsts[] = {3. / 4, -3. / 20, 1. / 60},
                            seconds[] = {3. / 2, -3. / 20, 1. / 90}, middle = -49. / 18;
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] = 0;
      second[i] = middle * samples[0][i];
      for (std::size_t k = 0; k < pairs; ++k) {
        const double ahead = samples[place(line, k)][i], behind = samples[place(line, k) + 1][i];
        first[i] += firsts[k] * (ahead - behind);
        second[i] += seconds[k] * (ahead + behind);
      }
    }
  }

  Chart_images m_images;
  std::array<double, 2> m_widths;
};

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

/// A point of a closed surface, from which geodesics start. The class hides the type of the
/// surface, so that its functions are compiled once for all programs.
///
/// A spacing is a length in the chart, a step is a length on the surface. The functions throw
/// `CGAL::Deformable_simplicial_complexes::Error` if a parameter is out of its range or the metric
/// is not positive definite, and `Interrupted_error` if a `Progress_scope` is stopped.
class Geodesic_source
{
public:
  using Point = CGAL::Epick::Point_2; ///< of the chart

  /// A distance ball.
  struct Ball
  {
    double radius;
    bool is_everything; ///< whether it covers the surface
  };

  virtual ~Geodesic_source() = default;

  /// Returns a spacing that also resolves short cut loci.
  virtual double default_spacing() const = 0;
  /// Returns half of the spacing, as a length on the surface.
  virtual double default_step(double spacing) const = 0;
  virtual DSC::Cut_locus_2 cut_locus(double spacing, double step) const = 0;
  /// Computes the distance ball of a radius.
  /// \param path picture (.svg) or triangles (.vtu) of the chart; empty for none
  /// \throws std::out_of_range if the radius is smaller than the one of the initial front
  virtual Ball ball(double radius, double spacing, double step, const std::string& path) const = 0;
  /// Writes a picture of the cut locus (.svg).
  virtual void draw(const DSC::Cut_locus_2& locus, const std::string& path) const = 0;
  /// Returns the image of a point of the chart, in space.
  virtual std::array<double, 3> image(const Point& p) const = 0;
};

/// Returns a point of a surface with a periodic chart.
/// \param point u and v
std::unique_ptr<Geodesic_source> source_in_chart(const Chart_surface& surface,
                                                 const std::array<double, 2>& periods,
                                                 const std::array<double, 2>& point);

/// Returns a point of a surface that is the image of the unit sphere.
/// \param direction the point is the image of this direction, of any length
std::unique_ptr<Geodesic_source> source_on_sphere(const Sphere_surface& surface,
                                                  const std::array<double, 3>& direction);

/// A cut locus with the spacing and the step of its computation.
struct Found_cut_locus
{
  DSC::Cut_locus_2 locus;
  double spacing, step;
};

/// Computes the cut locus of a source. With the default spacing, halves the spacing twice at most,
/// until the cut locus is complete.
/// \param spacing, step 0 for the default
Found_cut_locus find_cut_locus(const Geodesic_source& source, double spacing, double step);

} // namespace dsc

#endif // DSC_CUT_LOCI_GEODESIC_SOURCE_H

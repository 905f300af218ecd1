// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Geodesic_source.h"

#include <CGAL/Cut_loci_2/Geodesic_front_2.h>
#include <CGAL/Cut_loci_2/IO/cut_locus_2.h>
#include <CGAL/Mesh_files/SVG_2.h>
#include <CGAL/Mesh_files/VTU_2.h>

namespace dsc {
namespace {

using Point = Geodesic_source::Point;
using Domain = DSC::Torus_domain<2>;
using Sphere = DSC::Sphere_like_surface_2<Sphere_surface, Metric_of_chart>;

/// Returns the smallest length of unit vectors along the axes of a chart.
double scale_of(const DSC::Metric_jet_2& g) { return std::sqrt((std::min)(g.E, g.G)); }

template <class Front>
Geodesic_source::Ball grow(Front front, double radius, double step, const std::string& path) {
  if (radius < front.radius()) {
    std::ostringstream message;
    message << "the radius of the ball is smaller than the radius " << front.radius()
            << " of the initial front; choose a larger radius or a smaller spacing";
    throw std::out_of_range(message.str());
  }
  bool continues = true;
  while (continues && front.radius() < radius)
    continues = front.advance((std::min)(step, radius - front.radius()));
  if (!path.empty() && std::filesystem::path(path).extension() == ".vtu")
    CGAL::IO::write_VTU(path, front.complex());
  else if (!path.empty())
    CGAL::IO::write_SVG(path, front.complex());
  return {front.radius(), !continues};
}

class In_chart : public Geodesic_source
{
public:
  In_chart(const Chart_surface& surface, const std::array<double, 2>& periods,
           const std::array<double, 2>& point)
      : m_surface(surface), m_domain(periods), m_source(point[0], point[1]) {}

  double default_spacing() const override {
    static constexpr double edges = 40; // on the shorter period
    return (std::min)(m_domain.periods()[0], m_domain.periods()[1]) / edges;
  }
  double default_step(double spacing) const override {
    return spacing / 2 * scale_of(m_surface.metric(m_source.x(), m_source.y()));
  }
  DSC::Cut_locus_2 cut_locus(double spacing, double step) const override {
    return DSC::cut_locus_2(m_surface.metric, m_domain, m_source, spacing, step);
  }
  Ball ball(double radius, double spacing, double step, const std::string& path) const override {
    return grow(DSC::Geodesic_front_2<Any_metric>(m_surface.metric, m_domain, m_source, spacing),
                radius, step, path);
  }
  void draw(const DSC::Cut_locus_2& locus, const std::string& path) const override {
    CGAL::IO::write_SVG(path, locus, m_domain, m_source);
  }
  std::array<double, 3> image(const Point& p) const override {
    return m_surface.image(p.x(), p.y());
  }

private:
  Chart_surface m_surface;
  Domain m_domain;
  Point m_source;
};

class On_sphere : public Geodesic_source
{
public:
  On_sphere(const Sphere_surface& surface, const std::array<double, 3>& direction)
      : m_surface(surface, direction) {}

  double default_spacing() const override {
    static constexpr double edges = 40; // on half of the width of the chart
    return Sphere::half_width / edges;
  }
  // Measured opposite to the source.
  double default_step(double spacing) const override {
    return spacing / 2 * scale_of(m_surface(Sphere::half_width, Sphere::half_width));
  }
  DSC::Cut_locus_2 cut_locus(double spacing, double step) const override {
    return DSC::cut_locus_2(m_surface, spacing, step);
  }
  Ball ball(double radius, double spacing, double step, const std::string& path) const override {
    return grow(DSC::Geodesic_front_2<Sphere>(m_surface, spacing), radius, step, path);
  }
  void draw(const DSC::Cut_locus_2& locus, const std::string& path) const override {
    CGAL::IO::write_SVG(path, locus, m_surface);
  }
  std::array<double, 3> image(const Point& p) const override { return m_surface.image(p); }

private:
  Sphere m_surface;
};

} // namespace

std::unique_ptr<Geodesic_source> source_in_chart(const Chart_surface& surface,
                                                 const std::array<double, 2>& periods,
                                                 const std::array<double, 2>& point) {
  return std::make_unique<In_chart>(surface, periods, point);
}

std::unique_ptr<Geodesic_source> source_on_sphere(const Sphere_surface& surface,
                                                  const std::array<double, 3>& direction) {
  return std::make_unique<On_sphere>(surface, direction);
}

Found_cut_locus find_cut_locus(const Geodesic_source& source, double spacing, double step) {
  static constexpr int attempts = 3;
  static constexpr double finer = .5; // relative spacing of the next attempt
  Found_cut_locus result;
  result.spacing = spacing > 0 ? spacing : source.default_spacing();
  for (int i = 1;; ++i) {
    result.step = step > 0 ? step : source.default_step(result.spacing);
    result.locus = source.cut_locus(result.spacing, result.step);
    if (result.locus.is_complete || spacing > 0 || i == attempts)
      return result;
    result.spacing *= finer;
  }
}

} // namespace dsc

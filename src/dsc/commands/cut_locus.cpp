// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface_by_differences.h"
#include "commands/commands.h"
#include "errors.h"
#include "files.h"
#include "interrupt.h"
#include "option_values.h"
#include "report_json.h"
#include "surface_expressions.h"

#include <CGAL/Cut_loci_2/Geodesic_front_2.h>
#include <CGAL/Cut_loci_2/IO/cut_locus_2.h>
#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/SVG_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/VTU_2.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

/// The numbers of the command line, as written.
struct Written_numbers
{
  std::string point, periods = "6.283185307179586,6.283185307179586", spacing, step, radius;
};

struct Cut_locus_options
{
  Written_numbers written;
  std::string surface = "torus"; ///< name, or three expressions in u and v, or in x, y, z
  std::vector<double> point;     ///< u and v, or the direction x, y, z
  std::array<double, 2> periods;
  double spacing =
      0; ///< in the chart; if 0, 1/40 of the shorter period, or of half the width of the chart
  double step = 0;    ///< of the front; if 0, half the spacing, measured on the surface
  double radius = 0;  ///< radius of a ball, which is computed instead of the cut locus
  std::string output; ///< picture file; empty for none
  std::string report; ///< file; empty for none
  bool quiet = false;
};

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<2>;
using Point = CGAL::Simple_cartesian<double>::Point_2;

struct Torus
{
  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::cos;
    using std::sin;
    const T radius = 2. + cos(v);
    return {radius * cos(u), radius * sin(u), 1. * sin(v)};
  }
};

struct Ellipsoid
{
  template <class T> std::array<T, 3> operator()(const std::array<T, 3>& n) const {
    return {1. * n[0], .8 * n[1], .6 * n[2]};
  }
};

// A surface with a periodic chart.
template <class Metric> class On_torus
{
public:
  On_torus(const Metric& metric, const Cut_locus_options& options)
      : m_metric(metric), m_domain(options.periods),
        m_source(options.point.at(0), options.point.at(1)) {}

  double scale() const { return scale_of(m_metric(m_source.x(), m_source.y())); }
  double default_spacing() const {
    return std::min(m_domain.periods()[0], m_domain.periods()[1]) / 40;
  }

  DSC::Cut_locus_2 cut_locus(double spacing, double step) const {
    return DSC::cut_locus_2(m_metric, m_domain, m_source, spacing, step);
  }
  DSC::Geodesic_front_2<Metric> front(double spacing) const {
    return {m_metric, m_domain, m_source, spacing};
  }
  void draw(const DSC::Cut_locus_2& locus, const std::string& path) const {
    CGAL::IO::write_SVG(path, locus, m_domain, m_source);
  }
  void describe(const Point&, Json&) const {}

  static double scale_of(const DSC::Metric_jet_2& g) { return std::sqrt(std::min(g.E, g.G)); }

private:
  Metric m_metric;
  Domain m_domain;
  Point m_source;
};

// A surface that is the image of a sphere. The source is not in the chart.
template <class Surface> class Like_sphere
{
public:
  explicit Like_sphere(const Surface& surface) : m_surface(surface) {}

  double scale() const {
    const double middle = Surface::half_width;
    return On_torus<Surface>::scale_of(m_surface(middle, middle));
  }
  // Returns the default spacing, which also resolves a short cut locus near the center of the
  // chart.
  double default_spacing() const { return Surface::half_width / 40; }

  DSC::Cut_locus_2 cut_locus(double spacing, double step) const {
    return DSC::cut_locus_2(m_surface, spacing, step);
  }
  DSC::Geodesic_front_2<Surface> front(double spacing) const {
    return DSC::Geodesic_front_2<Surface>(m_surface, spacing);
  }
  void draw(const DSC::Cut_locus_2& locus, const std::string& path) const {
    CGAL::IO::write_SVG(path, locus, m_surface);
  }
  void describe(const Point& p, Json& json) const { json["position"] = m_surface.image(p); }

private:
  Surface m_surface;
};

template <class Surface> Json json_of(const DSC::Cut_locus_2& locus, const Surface& surface) {
  Json vertices = Json::array();
  for (const auto& vertex : locus.vertices) {
    vertices.push_back({{"u", vertex.point.x()},
                        {"v", vertex.point.y()},
                        {"distance", vertex.distance},
                        {"multiplicity", vertex.multiplicity}});
    surface.describe(vertex.point, vertices.back());
  }
  return {{"vertices", vertices},
          {"arcs", locus.polylines},
          {"is_complete", locus.is_complete},
          {"doubtful_vertices", locus.doubtful}};
}

Json parameters(const Cut_locus_options& options, double spacing, double step) {
  Json json = {{"command", "cut-locus"},
               {"surface", options.surface},
               {"point", options.point},
               {"spacing", spacing},
               {"step", step}};
  if (options.point.size() == 2)
    json["periods"] = options.periods;
  if (options.radius > 0)
    json["radius"] = options.radius;
  return json;
}

template <class Surface>
int draw_ball(const Cut_locus_options& options, const Surface& surface, double spacing,
              double step) {
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  auto front = surface.front(spacing);
  if (options.radius < front.radius())
    throw Usage_error("--radius is smaller than the radius " + Json(front.radius()).dump() +
                      " of the initial front; choose a larger --radius or a smaller --spacing");
  bool goes_on = true;
  while (goes_on && front.radius() < options.radius)
    goes_on = front.advance(std::min(step, options.radius - front.radius()));
  interruptible.reset();
  const auto& complex = front.complex();
  if (!options.output.empty() && std::filesystem::path(options.output).extension() == ".vtu")
    CGAL::IO::write_VTU(options.output, complex);
  else if (!options.output.empty())
    CGAL::IO::write_SVG(options.output, complex);
  if (!options.report.empty()) {
    Json json;
    json["parameters"] = parameters(options, spacing, step);
    json["ball"] = {{"radius", front.radius()}, {"is_everything", !goes_on}};
    write_json(options.report, json);
  }
  if (!options.quiet)
    std::printf("dsc: ball of radius %.9g%s\n", front.radius(),
                goes_on ? "" : "; it covers the surface");
  return 0;
}

double step_of(const Cut_locus_options& options, double spacing, double scale) {
  return options.step > 0 ? options.step : spacing / 2 * scale;
}

template <class Surface>
int find_cut_locus(const Cut_locus_options& options, const Surface& surface, double spacing) {
  static constexpr int attempts = 3;
  static constexpr double finer = .5; // relative spacing of the next attempt
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  DSC::Cut_locus_2 locus = surface.cut_locus(spacing, step_of(options, spacing, surface.scale()));
  for (int i = 1; i < attempts && !locus.is_complete && options.spacing == 0; ++i) {
    spacing *= finer;
    locus = surface.cut_locus(spacing, step_of(options, spacing, surface.scale()));
  }
  interruptible.reset();
  if (locus.vertices.empty())
    throw std::runtime_error("no cut locus was found; use a smaller --spacing or another chart");
  if (!options.output.empty())
    surface.draw(locus, options.output);
  if (!options.report.empty()) {
    Json json = json_of(locus, surface);
    json["parameters"] = parameters(options, spacing, step_of(options, spacing, surface.scale()));
    write_json(options.report, json);
  }
  if (!options.quiet) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const auto& vertex : locus.vertices) {
      nearest = std::min(nearest, vertex.distance);
      farthest = std::max(farthest, vertex.distance);
    }
    std::printf("dsc: %zu %s with %zu %s, distances %.9g to %.9g%s\n", locus.polylines.size(),
                noun(locus.polylines.size(), "arc", "arcs"), locus.vertices.size(),
                noun(locus.vertices.size(), "vertex", "vertices"), nearest, farthest,
                locus.is_complete ? "" : "; the result is not complete: use a smaller --spacing");
    if (!locus.doubtful.empty()) {
      const auto& p = locus.vertices[locus.doubtful.front()].point;
      std::printf("dsc: %zu doubtful %s, the first at u = %.9g, v = %.9g\n", locus.doubtful.size(),
                  noun(locus.doubtful.size(), "vertex", "vertices"), p.x(), p.y());
    }
  }
  return 0;
}

template <class Surface> int run(const Cut_locus_options& options, const Surface& surface) {
  const double spacing = options.spacing > 0 ? options.spacing : surface.default_spacing();
  return options.radius > 0
             ? draw_ball(options, surface, spacing, step_of(options, spacing, surface.scale()))
             : find_cut_locus(options, surface, spacing);
}

template <class Metric> int run_on_torus(const Cut_locus_options& options, const Metric& metric) {
  if (options.point.size() != 2)
    throw Usage_error("--point needs two numbers for a surface in u and v; write it like 0,0.3");
  return run(options, On_torus<Metric>(metric, options));
}

template <class Embedding, template <class> class Differentiated>
int run_like_sphere(const Cut_locus_options& options, const Embedding& embedding) {
  if (options.point.size() != 3)
    throw Usage_error("--point needs three numbers for a surface in x, y and z: a direction; write "
                      "it like 1,0.5,0");
  using Surface = DSC::Sphere_like_surface_2<Embedding, Differentiated>;
  return run(options, Like_sphere<Surface>(Surface(
                          embedding, {options.point[0], options.point[1], options.point[2]})));
}

int execute(const Cut_locus_options& options) {
  if (!options.output.empty())
    require_writable(options.output);
  require_place("--report", options.report, {options.output});
  if (options.surface == "torus")
    return run_on_torus(options, DSC::Embedded_surface_2<Torus>());
  if (options.surface == "ellipsoid")
    return run_like_sphere<Ellipsoid, DSC::Embedded_surface_2>(options, Ellipsoid());
  const Surface_expressions expressions(options.surface);
  if (expressions.is_of_sphere())
    return run_like_sphere<Surface_expressions, Surface_by_differences>(options, expressions);
  return run_on_torus(options,
                      Surface_by_differences<Surface_expressions>(expressions, options.periods));
}

/// Checks the option `--periods`. A surface in u and v must be periodic, except for a ball of a
/// given radius. Other surfaces must not have the option.
void require_periods(const Cut_locus_options& options, bool are_given) {
  if (options.surface == "torus")
    return;
  const bool is_ellipsoid = options.surface == "ellipsoid";
  if (is_ellipsoid && !are_given)
    return;
  if (is_ellipsoid || Surface_expressions(options.surface).is_of_sphere()) {
    if (are_given)
      throw Usage_error("--periods applies only to a surface in u and v; leave it out");
  } else if (options.radius == 0 &&
             !Surface_expressions(options.surface).repeats_after(options.periods))
    throw Usage_error("the surface '" + options.surface +
                      "' is not periodic with these periods; choose others by --periods");
}

/// Reads the numbers that are given as text.
/// \throws Usage_error
void read(const CLI::App& command, Cut_locus_options& options) {
  const Written_numbers& written = options.written;
  options.point = parse_point(written.point);
  options.periods = parse_pair(written.periods, "--periods");
  if (command.count("--spacing") > 0)
    options.spacing = parse_positive(written.spacing, "--spacing");
  if (command.count("--step") > 0)
    options.step = parse_positive(written.step, "--step");
  if (command.count("--radius") > 0)
    options.radius = parse_positive(written.radius, "--radius");
  require_periods(options, command.count("--periods") > 0);
  if (!options.output.empty() && options.radius > 0)
    require_extension(options.output, {"svg", "vtu"});
  else if (!options.output.empty())
    require_extension(options.output, {"svg"});
}

} // namespace

void add_cut_locus(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Cut_locus_options>();
  CLI::App* command = app.add_subcommand("cut-locus", description_of_cut_locus);
  command
      ->add_option(
          "--surface", options->surface,
          "'torus' (radii 2 and 1), 'ellipsoid' (semi-axes 1, 0.8 and 0.6), or three coordinates "
          "as expressions: in u and v for a periodic surface, like "
          "'(2+cos(v))*cos(u),(2+cos(v))*sin(u),2*sin(v)'; or in the coordinates x, y and z of the "
          "unit sphere, like 'x,y,z*(1+0.2*x)'")
      ->capture_default_str();
  command
      ->add_option("--point", options->written.point,
                   "Source point: u and v, like 0,0.3; for a surface in x, y and z, its direction, "
                   "like 1,0.5,0")
      ->required();
  command->add_option("--periods", options->written.periods,
                      "Periods of a surface in u and v (default: 2 pi each)");
  command->add_option("--spacing", options->written.spacing,
                      "Edge length in the chart (default: 1/40 of the shorter period; 0.1 for a "
                      "surface in x, y and z, whose chart is 8 wide)");
  command->add_option("--radius", options->written.radius,
                      "Compute the distance ball of this radius instead");
  command->add_option("--step", options->written.step,
                      "Step of the geodesics, measured on the surface (default: half the spacing, "
                      "converted to a length on the surface)");
  command->add_option("-o,--output", options->output,
                      "Picture of the chart (.svg); for a ball, also its triangles (.vtu)");
  command->add_option("--report", options->report, "JSON file with vertices, distances and arcs");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([command, options, &exit_code] {
    read(*command, *options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

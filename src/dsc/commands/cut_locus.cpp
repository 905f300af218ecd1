// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Geodesic_source.h"
#include "commands/commands.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/functions_of_points.h"
#include "output/report_json.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/standard_streams.h"

#include <CGAL/number_utils.h>

#include <cstdio>
#include <limits>

namespace dsc {
namespace {

struct Cut_locus_options
{
  std::string surface = "torus"; ///< name, or three expressions in u and v, or in x, y, z
  std::vector<double> point;     ///< u and v, or the direction x, y, z
  std::array<double, 2> periods = {2 * CGAL_PI, 2 * CGAL_PI};
  double spacing =
      0; ///< in the chart; if 0, 1/40 of the shorter period, or of half the width of the chart
  double step = 0;    ///< of the front; if 0, half the spacing, measured on the surface
  double radius = 0;  ///< radius of a ball, which is computed instead of the cut locus
  std::string output; ///< picture file; empty for none
  std::string report; ///< file; empty for none
  bool quiet = false;
};

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

Json json_of(const DSC::Cut_locus_2& locus, const Geodesic_source& source, bool has_positions) {
  Json vertices = Json::array();
  for (const auto& vertex : locus.vertices) {
    vertices.push_back({{"u", vertex.point.x()},
                        {"v", vertex.point.y()},
                        {"distance", vertex.distance},
                        {"multiplicity", vertex.multiplicity}});
    if (has_positions)
      vertices.back()["position"] = source.image(vertex.point);
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

int draw_ball(const Cut_locus_options& options, const Geodesic_source& source) {
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  const double spacing = options.spacing > 0 ? options.spacing : source.default_spacing(),
               step = options.step > 0 ? options.step : source.default_step(spacing);
  Geodesic_source::Ball ball;
  try {
    ball = source.ball(options.radius, spacing, step, options.output);
  } catch (const std::out_of_range& error) {
    throw Usage_error(std::string("--radius: ") + error.what());
  }
  interruptible.reset();
  if (!options.report.empty()) {
    Json json;
    json["parameters"] = parameters(options, spacing, step);
    json["ball"] = {{"radius", ball.radius}, {"is_everything", ball.is_everything}};
    write_json(options.report, json);
  }
  if (!options.quiet)
    std::printf("dsc: ball of radius %.9g%s\n", ball.radius,
                ball.is_everything ? "; it covers the surface" : "");
  return 0;
}

void print_summary(const DSC::Cut_locus_2& locus) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const auto& vertex : locus.vertices) {
    nearest = (std::min)(nearest, vertex.distance);
    farthest = (std::max)(farthest, vertex.distance);
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

int write_cut_locus(const Cut_locus_options& options, const Geodesic_source& source) {
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  const Found_cut_locus found = find_cut_locus(source, options.spacing, options.step);
  interruptible.reset();
  if (found.locus.vertices.empty())
    throw std::runtime_error("no cut locus was found; use a smaller --spacing or another chart");
  if (!options.output.empty())
    source.draw(found.locus, options.output);
  if (!options.report.empty()) {
    Json json = json_of(found.locus, source, options.point.size() == 3);
    json["parameters"] = parameters(options, found.spacing, found.step);
    write_json(options.report, json);
  }
  if (!options.quiet)
    print_summary(found.locus);
  return 0;
}

std::unique_ptr<Geodesic_source> source_in_chart(const Cut_locus_options& options,
                                                 const Chart_surface& surface) {
  if (options.point.size() != 2)
    throw Usage_error("--point needs two numbers for a surface in u and v; write it like 0,0.3");
  return dsc::source_in_chart(surface, options.periods, {options.point[0], options.point[1]});
}

std::unique_ptr<Geodesic_source> source_on_sphere(const Cut_locus_options& options,
                                                  const Sphere_surface& surface) {
  if (options.point.size() != 3)
    throw Usage_error("--point needs three numbers for a surface in x, y and z: a direction; write "
                      "it like 1,0.5,0");
  return dsc::source_on_sphere(surface, {options.point[0], options.point[1], options.point[2]});
}

std::unique_ptr<Geodesic_source> source_of(const Cut_locus_options& options) {
  if (options.surface == "torus")
    return source_in_chart(options, chart_surface(Torus()));
  if (options.surface == "ellipsoid")
    return source_on_sphere(options, sphere_surface(Ellipsoid()));
  const Surface_expressions expressions(options.surface);
  const auto images = [expressions](const auto& points) { return expressions.images(points); };
  if (expressions.is_of_sphere())
    return source_on_sphere(options, sampled_sphere_surface(images));
  return source_in_chart(options, sampled_chart_surface(images, options.periods));
}

int execute(const Cut_locus_options& options) {
  if (!options.output.empty())
    require_writable(options.output);
  require_place("--report", options.report, {options.output});
  const std::unique_ptr<Geodesic_source> source = source_of(options);
  return options.radius > 0 ? draw_ball(options, *source) : write_cut_locus(options, *source);
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
             !lengths_repeat(Surface_expressions(options.surface), options.periods))
    throw Usage_error("the surface '" + options.surface +
                      "' is not periodic with these periods; choose others by --periods");
}

void check(const CLI::App& command, const Cut_locus_options& options) {
  require_periods(options, command.count("--periods") > 0);
  if (!options.output.empty())
    require_format(options.output, Use::write,
                   options.radius > 0 ? content::drawing | content::triangles : content::drawing);
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
  add_value(*command, "--point", options->point, parse_point,
            "Source point: u and v, like 0,0.3; for a surface in x, y and z, its direction, "
            "like 1,0.5,0")
      ->required();
  add_value(*command, "--periods", options->periods, parse_pair,
            "Periods of a surface in u and v (default: 2 pi each)");
  add_value(*command, "--spacing", options->spacing, positive,
            "Edge length in the chart (default: 1/40 of the shorter period; 0.1 for a "
            "surface in x, y and z, whose chart is 8 wide)");
  add_value(*command, "--radius", options->radius, positive,
            "Compute the distance ball of this radius instead");
  add_value(*command, "--step", options->step, positive,
            "Step of the geodesics, measured on the surface (default: half the spacing, "
            "converted to a length on the surface)");
  add_output(*command, "-o,--output", options->output,
             "Picture of the chart (.svg); for a ball, also its triangles (.vtu); - for standard "
             "output");
  add_output(*command, "--report", options->report, "JSON file with vertices, distances and arcs",
             "json");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([command, options, &exit_code] {
    check(*command, *options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

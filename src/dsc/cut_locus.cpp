// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "errors.h"
#include "files.h"
#include "report_json.h"

#include <CGAL/Deformable_simplicial_complex_2/Riemannian_metric_2.h>
#include <CGAL/IO/cut_locus_2.h>
#include <CGAL/cut_locus_2.h>

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace dsc {
namespace {

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<2>;
using Vector = std::array<double, 3>;

struct Torus
{
  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::cos;
    using std::sin;
    const T radius = 2. + cos(v);
    return {radius * cos(u), radius * sin(u), 1. * sin(v)};
  }
};

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The metric of a surface whose coordinates are expressions, by differences of the sixth order:
/// with this width, what they leave out and what rounding adds are both about 1e-12.
class Surface_by_expressions
{
public:
  explicit Surface_by_expressions(const std::string& expressions)
      : m_parser(std::make_shared<Parser>()) {
    int number = 0;
    try {
      mu::Parser& parser = m_parser->parser;
      parser.DefineVar("u", &m_parser->u);
      parser.DefineVar("v", &m_parser->v);
      parser.DefineConst("pi", CGAL_PI);
      parser.SetExpr(expressions);
      parser.Eval(number);
    } catch (const mu::Parser::exception_type& error) {
      throw Usage_error("--surface '" + expressions + "' cannot be read: " + error.GetMsg() +
                        "; write torus, or three expressions in u and v");
    }
    if (number != 3)
      throw Usage_error("--surface '" + expressions + "' has " + std::to_string(number) +
                        " coordinates; write torus, or three expressions in u and v");
  }

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
  struct Parser
  {
    double u = 0, v = 0;
    mu::Parser parser;
  };

  Vector at(double u, double v) const {
    m_parser->u = u;
    m_parser->v = v;
    int number;
    const double* values = m_parser->parser.Eval(number);
    return {values[0], values[1], values[2]};
  }

  // The first two derivatives in a direction.
  void derive(double u, double v, int du, int dv, Vector& first, Vector& second) const {
    static constexpr double width = .01;
    static constexpr double firsts[] = {3. / 4, -3. / 20, 1. / 60},
                            seconds[] = {3. / 2, -3. / 20, 1. / 90}, middle = -49. / 18;
    const Vector here = at(u, v);
    for (int i = 0; i < 3; ++i) {
      first[i] = 0;
      second[i] = middle * here[i] / (width * width);
    }
    for (int k = 1; k <= 3; ++k) {
      const Vector ahead = at(u + k * width * du, v + k * width * dv),
                   behind = at(u - k * width * du, v - k * width * dv);
      for (int i = 0; i < 3; ++i) {
        first[i] += firsts[k - 1] * (ahead[i] - behind[i]) / width;
        second[i] += seconds[k - 1] * (ahead[i] + behind[i]) / (width * width);
      }
    }
  }

  std::shared_ptr<Parser> m_parser; // copies share it
};

Json json_of(const CGAL::Cut_locus_2& locus) {
  Json vertices = Json::array();
  for (const auto& vertex : locus.vertices)
    vertices.push_back({{"u", vertex.point.x()},
                        {"v", vertex.point.y()},
                        {"distance", vertex.distance},
                        {"multiplicity", vertex.multiplicity}});
  return {{"vertices", vertices}, {"arcs", locus.polylines}};
}

} // namespace

int execute(const Cut_locus_options& options) {
  if (!options.output.empty())
    require_writable(options.output);
  if (!options.report.empty())
    require_place_of_report(options.report, {options.output});
  const double spacing =
      options.spacing > 0 ? options.spacing : std::min(options.periods[0], options.periods[1]) / 40;
  const double step = options.step > 0 ? options.step : spacing / 2;
  const CGAL::Simple_cartesian<double>::Point_2 point(options.point[0], options.point[1]);
  const Domain domain({options.periods[0], options.periods[1]});
  const CGAL::Cut_locus_2 locus =
      options.surface == "torus"
          ? CGAL::cut_locus_2(CGAL::Embedded_surface_2<Torus>(), domain, point, spacing, step)
          : CGAL::cut_locus_2(Surface_by_expressions(options.surface), domain, point, spacing,
                              step);
  if (locus.vertices.empty())
    throw std::runtime_error("no cut locus was found: use a smaller --spacing, or another chart");
  if (!options.output.empty())
    CGAL::IO::write_SVG(options.output, locus, domain, point);
  if (!options.report.empty()) {
    Json json = json_of(locus);
    json["parameters"] = {{"command", "cut-locus"}, {"surface", options.surface},
                          {"point", options.point}, {"periods", options.periods},
                          {"spacing", spacing},     {"step", step}};
    write_json(options.report, json);
  }
  if (!options.quiet) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const auto& vertex : locus.vertices) {
      nearest = std::min(nearest, vertex.distance);
      farthest = std::max(farthest, vertex.distance);
    }
    std::printf("dsc: %zu arcs of %zu points, at distances of %.9g to %.9g\n",
                locus.polylines.size(), locus.vertices.size(), nearest, farthest);
  }
  return 0;
}

} // namespace dsc

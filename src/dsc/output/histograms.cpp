// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/histograms.h"

#include <CGAL/Mesh_files/Svg_canvas.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_2;

/// Lengths of a diagram, in pixels.
constexpr double width = 320, height = 200, margin = 50;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

/// Draws a histogram whose axis begins at (left, margin).
void draw(const Histogram& histogram, double left, DSC::Svg_canvas& canvas, DSC::Svg_layer& bars,
          DSC::Svg_layer& axes) {
  const std::vector<double> densities = histogram.densities();
  const double most = std::max(*std::max_element(densities.begin(), densities.end()), 1e-300),
               bar = width / double(densities.size());
  for (std::size_t i = 0; i < densities.size(); ++i) {
    const double x = left + double(i) * bar, top = margin + height * densities[i] / most;
    canvas.add(std::array<Point, 4>{Point(x, margin), Point(x + bar, margin), Point(x + bar, top),
                                    Point(x, top)},
               bars);
  }
  canvas.add(std::array<Point, 2>{Point(left, margin), Point(left + width, margin)}, axes);
  const auto tick = [&](double value) {
    const double place = (value - histogram.low) / (histogram.high - histogram.low);
    canvas.add_text(Point(left + width * place, margin - 16), "middle", number(value));
  };
  static constexpr int ticks = 4;
  for (int i = 0; i <= ticks && !histogram.is_integer; ++i)
    tick(histogram.low + (histogram.high - histogram.low) * i / ticks);
  // Every second integer, so that the names do not overlap.
  for (std::size_t i = 0; i < densities.size() && histogram.is_integer; i += 2)
    tick(histogram.low + .5 + double(i));
  canvas.add_text(Point(left + width / 2, margin - 36), "middle", histogram.quantity);
  canvas.add_text(Point(left - 4, margin + height - 5), "end", number(most));
}

} // namespace

std::vector<double> Histogram::densities() const {
  std::vector<double> result(bins, 0.);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double place = (values[i] - low) / (high - low) * double(bins),
                 weight = weights.empty() ? 1 : weights[i];
    result[std::size_t(std::clamp(place, 0., double(bins - 1)))] += weight;
    sum += weight;
  }
  for (double& density : result)
    density *= sum > 0 ? double(bins) / (sum * (high - low)) : 0;
  return result;
}

void write_histograms(const std::string& path, const std::vector<Histogram>& histograms) {
  const CGAL::Bbox_2 box(0, 0, double(histograms.size()) * (width + margin) + margin / 2,
                         height + 1.5 * margin);
  DSC::Svg_canvas canvas(box, box, box.xmax(), {0, 0});
  DSC::Svg_layer bars = {"bars", "#4d85bd", "#ffffff", 1}, axes = {"axes", "none", "#000000", 1};
  for (std::size_t i = 0; i < histograms.size(); ++i)
    draw(histograms[i], margin + double(i) * (width + margin), canvas, bars, axes);
  canvas.write(path, {bars, axes});
}

} // namespace dsc

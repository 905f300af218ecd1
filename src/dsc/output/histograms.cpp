// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/histograms.h"

#include <CGAL/Mesh_files/replace_file.h>

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace dsc {
namespace {

/// Lengths of a diagram, in pixels.
constexpr double width = 320, height = 200, margin = 50;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

void write(std::ostream& out, const Histogram& histogram, double left) {
  const std::vector<double> densities = histogram.densities();
  const double most = std::max(*std::max_element(densities.begin(), densities.end()), 1e-300),
               bottom = margin / 2 + height, bar = width / double(densities.size());
  for (std::size_t i = 0; i < densities.size(); ++i) {
    const double size = height * densities[i] / most;
    out << "<rect x=\"" << number(left + double(i) * bar) << "\" y=\"" << number(bottom - size)
        << "\" width=\"" << number(bar) << "\" height=\"" << number(size)
        << "\" fill=\"#4d85bd\" stroke=\"#ffffff\"/>\n";
  }
  out << "<path d=\"M" << number(left) << ',' << number(bottom) << "h" << number(width)
      << "\" stroke=\"#000000\"/>\n";
  const auto tick = [&](double value) {
    out << "<text x=\""
        << number(left + width * (value - histogram.low) / (histogram.high - histogram.low))
        << "\" y=\"" << number(bottom + 16) << "\" text-anchor=\"middle\">" << number(value)
        << "</text>\n";
  };
  static constexpr int ticks = 4;
  for (int i = 0; i <= ticks && !histogram.is_integer; ++i)
    tick(histogram.low + (histogram.high - histogram.low) * i / ticks);
  // Every second integer, so that the names do not overlap.
  for (std::size_t i = 0; i < densities.size() && histogram.is_integer; i += 2)
    tick(histogram.low + .5 + double(i));
  out << "<text x=\"" << number(left + width / 2) << "\" y=\"" << number(bottom + 36)
      << "\" text-anchor=\"middle\">" << histogram.quantity << "</text>\n"
      << "<text x=\"" << number(left - 4) << "\" y=\"" << number(margin / 2 + 5)
      << "\" text-anchor=\"end\">" << number(most) << "</text>\n";
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
  const double all = double(histograms.size()) * (width + margin) + margin / 2;
  CGAL::Deformable_simplicial_complexes::replace_file_by_stream(path, [&](std::ostream& out) {
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << number(all) << "\" height=\""
        << number(height + 1.5 * margin) << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    for (std::size_t i = 0; i < histograms.size(); ++i)
      write(out, histograms[i], margin + double(i) * (width + margin));
    out << "</svg>\n";
  });
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface.h"

#include "errors.h"

#include <CGAL/repair_surface_3.h>

#include <cstdio>

namespace dsc {

Repairs repair(std::vector<Surface>& surfaces, const std::vector<std::string>& names) {
  Repairs repairs;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    try {
      repairs.push_back(CGAL::repair_surface_3(surfaces[i]));
    } catch (const CGAL::Deformable_simplicial_complexes::Error& error) {
      throw Input_error(names[i] + ": " + error.what() + ", and cannot be repaired");
    }
  return repairs;
}

std::string what_was_repaired(const CGAL::Surface_repair_report_3& report) {
  if (report.was_sound())
    return "bounds a solid, nothing is repaired";
  std::string text;
  const auto add = [&text](std::size_t number, const char* what) {
    if (number > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(number) + ' ' + what;
  };
  add(report.merged_points, "equal points merged");
  add(report.degenerate_triangles, "flat triangles removed");
  add(report.repeated_triangles, "repeated triangles removed");
  add(report.stitched_points, "points of borders stitched");
  add(report.filled_holes, "holes filled");
  add(report.crossing_pairs, "crossing pairs of triangles");
  if (report.is_wrapped)
    text += (text.empty() ? "" : ", ") + std::string("wrapped");
  char distance[100];
  std::snprintf(distance, sizeof distance, "; moved by at most %.3g, %.3g mean edges",
                report.distance(), report.distance() / report.mean_edge);
  return text + distance;
}

} // namespace dsc

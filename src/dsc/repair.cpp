// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface.h"

#include "errors.h"

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/repair_surface_3.h>

#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dsc {

namespace {

using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::Interrupted_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;

CGAL::Surface_repair_options_3 repair_options(const Surface& surface,
                                              const std::optional<Distance>& largest_hole) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  CGAL::Surface_repair_options_3 options;
  if (!largest_hole)
    return options;
  options.largest_hole = std::numeric_limits<double>::infinity();
  options.longest_border =
      largest_hole->value *
      (largest_hole->in_mean_edges ? internal::mean_side(internal::soup_of(surface)) : 1);
  return options;
}

} // namespace

Repairs repair(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
               const std::optional<Distance>& largest_hole) {
  Repairs repairs;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    try {
      const Surface& surface = surfaces[i];
      repairs.push_back(CGAL::repair_surface_3(surfaces[i], repair_options(surface, largest_hole)));
    } catch (const Interrupted_error&) {
      throw;
    } catch (const Invalid_surface_error& error) {
      const bool has_hole = error.reason() == Invalid_surface_error::Reason::open;
      throw Input_error(names[i] + ": " + error.what() + ", and cannot be repaired" +
                        (has_hole ? "; --largest-hole bounds the holes that are filled" : ""));
    } catch (const Error& error) {
      throw Input_error(names[i] + ": " + error.what() + ", and cannot be repaired");
    }
  return repairs;
}

void wrap(std::vector<Surface>& surfaces, const std::vector<std::string>& names, Repairs& repairs) {
  repairs.resize(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    try {
      const auto report = CGAL::wrap_surface_3(surfaces[i]);
      repairs[i].is_wrapped = true;
      repairs[i].alpha = report.alpha;
      repairs[i].offset = report.offset;
      repairs[i].mean_edge = report.mean_edge;
      repairs[i].distance_from_input += report.distance_from_input;
      repairs[i].distance_to_input += report.distance_to_input;
    } catch (const Interrupted_error&) {
      throw;
    } catch (const Error& error) {
      throw Input_error(names[i] + ": " + error.what() + ", and cannot be repaired");
    }
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
  add(report.split_edges, "edges split at vertices on them");
  add(report.filled_holes, "holes filled");
  add(report.crossing_pairs, "crossing pairs of triangles");
  add(report.united_parts, "crossing parts united");
  add(report.removed_triangles, "triangles that bound nothing removed");
  if (report.is_wrapped)
    text += (text.empty() ? "" : ", ") + std::string("wrapped");
  char distance[100];
  std::snprintf(distance, sizeof distance, "; moved by at most %.3g, %.3g mean edges",
                report.distance(), report.distance() / report.mean_edge);
  return text + distance;
}

} // namespace dsc

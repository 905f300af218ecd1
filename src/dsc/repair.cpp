// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface.h"

#include "errors.h"

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/repair_surface_3.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

namespace {

using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;

DSC::Surface_repair_options_3 repair_options(const Surface& surface,
                                             const std::optional<Distance>& largest_hole) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  DSC::Surface_repair_options_3 options;
  if (!largest_hole)
    return options;
  options.largest_hole = std::numeric_limits<double>::infinity();
  options.longest_border =
      largest_hole->value *
      (largest_hole->in_mean_edges ? internal::mean_side(internal::soup_of(surface)) : 1);
  return options;
}

/// Calls `repair_surface` for each surface.
template <class Function>
Repairs for_each(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
                 const Function& repair_surface) {
  Repairs repairs;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    try {
      repairs.push_back(repair_surface(surfaces[i]));
    } catch (const Invalid_surface_error& error) {
      const bool has_hole = error.reason() == Invalid_surface_error::Reason::open;
      throw Input_error(names[i] + " cannot be repaired: " + error.what() +
                        (has_hole ? "; increase --largest-hole" : ""));
    } catch (const Error& error) {
      throw Input_error(names[i] + " cannot be repaired: " + error.what());
    }
  return repairs;
}

/// Adds the report of a second repair.
void add(DSC::Surface_repair_report_3& sum, const DSC::Surface_repair_report_3& second) {
  sum.merged_points += second.merged_points;
  sum.degenerate_triangles += second.degenerate_triangles;
  sum.repeated_triangles += second.repeated_triangles;
  sum.stitched_points += second.stitched_points;
  sum.split_edges += second.split_edges;
  sum.filled_holes += second.filled_holes;
  sum.crossing_pairs += second.crossing_pairs;
  sum.united_parts += second.united_parts;
  sum.removed_triangles += second.removed_triangles;
  sum.is_wrapped |= second.is_wrapped;
  sum.alpha += second.alpha;
  sum.offset += second.offset;
  if (sum.mean_edge == 0)
    sum.mean_edge = second.mean_edge;
  sum.distance_from_input += second.distance_from_input;
  sum.distance_to_input += second.distance_to_input;
}

void add(Repairs& sums, const Repairs& second) {
  sums.resize(second.size());
  for (std::size_t i = 0; i < second.size(); ++i)
    if (!second[i].was_sound())
      add(sums[i], second[i]);
}

} // namespace

Repairs repair(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
               const std::optional<Distance>& largest_hole) {
  return for_each(surfaces, names, [&](Surface& surface) {
    return DSC::repair_surface_3(surface, repair_options(surface, largest_hole));
  });
}

bool merge_near_vertices(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
                         Repairs& repairs) {
  DSC::Surface_repair_options_3 options;
  options.merge_distance = 1e-6; // in mean edges: what TetGen treats as equal
  const Repairs merged = for_each(
      surfaces, names, [&](Surface& surface) { return DSC::repair_surface_3(surface, options); });
  add(repairs, merged);
  return std::any_of(merged.begin(), merged.end(),
                     [](const auto& report) { return !report.was_sound(); });
}

void wrap(std::vector<Surface>& surfaces, const std::vector<std::string>& names, Repairs& repairs) {
  add(repairs,
      for_each(surfaces, names, [](Surface& surface) { return DSC::wrap_surface_3(surface); }));
}

std::string what_was_repaired(const DSC::Surface_repair_report_3& report) {
  if (report.was_sound())
    return "bounds a solid; no repair is necessary";
  std::string text;
  const auto add = [&text](std::size_t number, const char* singular, const char* plural) {
    if (number > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(number) + ' ' +
              noun(number, singular, plural);
  };
  add(report.merged_points, "duplicate point merged", "duplicate points merged");
  add(report.degenerate_triangles, "degenerate triangle removed", "degenerate triangles removed");
  add(report.repeated_triangles, "duplicate triangle removed", "duplicate triangles removed");
  add(report.stitched_points, "boundary point stitched", "boundary points stitched");
  add(report.split_edges, "edge split at a T-junction", "edges split at T-junctions");
  add(report.filled_holes, "hole filled", "holes filled");
  add(report.crossing_pairs, "pair of intersecting triangles", "pairs of intersecting triangles");
  add(report.united_parts, "intersecting component united", "intersecting components united");
  add(report.removed_triangles, "triangle removed that bounds no solid",
      "triangles removed that bound no solid");
  if (report.is_wrapped)
    text += (text.empty() ? "" : ", ") + std::string("wrapped");
  char distance[100];
  std::snprintf(distance, sizeof distance, "; maximum displacement %.3g (%.3g mean edges)",
                report.distance(), report.distance() / report.mean_edge);
  return text + distance;
}

} // namespace dsc

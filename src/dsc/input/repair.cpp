// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/start_complex.h"
#include "input/surface.h"
#include "programs/errors.h"

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/repair_surface_3.h>

namespace dsc {

namespace {

DSC::Surface_repair_options_3 repair_options(const Surface& surface,
                                             const std::optional<Distance>& largest_hole) {
  namespace internal = DSC::internal;
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
template <class Function> Repairs for_each(Surfaces& surfaces, const Function& repair_surface) {
  Repairs repairs;
  const std::vector<std::string>& names = surfaces.titles;
  for (std::size_t i = 0; i < surfaces.all.size(); ++i)
    try {
      repairs.push_back({names[i], repair_surface(surfaces.all[i])});
    } catch (const DSC::Invalid_surface_error& error) {
      const bool has_hole = error.reason() == DSC::Invalid_surface_error::Reason::open;
      throw Input_error(names[i] + " cannot be repaired: " + message_of(error) +
                        (has_hole ? "; increase --largest-hole" : ""));
    } catch (const DSC::Error& error) {
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
    if (!second[i].report.was_sound())
      add(sums[i].report, second[i].report);
}

Repairs repair(Surfaces& surfaces, const std::optional<Distance>& largest_hole) {
  return for_each(surfaces, [&](Surface& surface) {
    return DSC::repair_surface_3(surface, repair_options(surface, largest_hole));
  });
}

/// Merges points that TetGen would treat as equal. Returns whether a surface was changed.
bool merge_near_vertices(Surfaces& surfaces, Repairs& repairs) {
  DSC::Surface_repair_options_3 options;
  options.merge_distance = 1e-6; // in mean edges: what TetGen treats as equal
  const Repairs merged =
      for_each(surfaces, [&](Surface& surface) { return DSC::repair_surface_3(surface, options); });
  add(repairs, merged);
  return std::any_of(merged.begin(), merged.end(),
                     [](const Repair& repair) { return !repair.report.was_sound(); });
}

/// Wraps the surfaces. TetGen can then fill them.
void wrap(Surfaces& surfaces, Repairs& repairs) {
  add(repairs, for_each(surfaces, [](Surface& surface) { return DSC::wrap_surface_3(surface); }));
}

} // namespace

Surfaces read_and_repair(const Run_start& start, Repairs* repairs) {
  Surfaces surfaces = read_surfaces(start);
  Repairs done = repair(surfaces, start.largest_hole);
  if (repairs)
    *repairs = std::move(done);
  return surfaces;
}

std::unique_ptr<Tracked_complex> track_repaired_surfaces(const Run_options& options,
                                                         Repairs& repairs) {
  Surfaces surfaces = start_surfaces(options.start, read_and_repair(options.start, &repairs),
                                     most_triangles_to_fill);
  for (const bool merges : {false, true})
    try {
      if (!merges || merge_near_vertices(surfaces, repairs))
        return track_surfaces(surfaces, options);
    } catch (const DSC::Tetrahedralization_error& error) {
      if (is_out_of_memory(error))
        throw;
    }
  wrap(surfaces, repairs);
  return track_surfaces(surfaces, options);
}

} // namespace dsc

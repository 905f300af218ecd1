// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/files.h"
#include "input/surface.h"

#include <cstddef>
#include <cstdio>

namespace dsc {

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

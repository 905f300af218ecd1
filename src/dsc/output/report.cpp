// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/report.h"

#include "input/translations.h"

#include <cstdio>

namespace dsc {
namespace {

Json parameters_json(const Run_options& options, const Run_start& start) {
  Json json = motion_json(options.step.motion);
  json["steps"] = options.steps;
  json["triangles"] = value_or_null(start.triangles);
  json["segments"] = value_or_null(start.segments);
  json["edge_per_thickness"] = start.thin_parts.edge_per_thickness;
  json["most_new_facets"] = start.thin_parts.most_new_facets;
  json["repair"] = start.repairs;
  json["fit"] = start.ball && !start.inputs.empty();
  json["domain"] = options.start.mesh_is_domain ? Json("mesh") : value_or_null(options.domain);
  json["grow_domain"] = options.step.grows_domain;
  json["improve_interface"] = options.step.improves_interface;
  json["aggressiveness"] = value_or_null(options.step.aggressiveness);
  json["threads"] = options.threads;
  json["output"] = value_or_null(options.output.folder);
  json["every"] = options.output.every;
  json["resume"] = value_or_null(options.resume);
  return json;
}

Json repairs_json(const Repairs& repairs) {
  Json json = Json::array();
  for (const auto& [surface, r] : repairs)
    json.push_back(
        {{"surface", surface},
         {"merged_points", r.merged_points},
         {"degenerate_triangles", r.degenerate_triangles},
         {"repeated_triangles", r.repeated_triangles},
         {"stitched_points", r.stitched_points},
         {"split_edges", r.split_edges},
         {"filled_holes", r.filled_holes},
         {"crossing_pairs", r.crossing_pairs},
         {"united_parts", r.united_parts},
         {"removed_triangles", r.removed_triangles},
         {"wrap", r.is_wrapped ? Json({{"alpha", r.alpha}, {"offset", r.offset}}) : Json()},
         {"mean_edge", r.mean_edge},
         {"distance_from_input", r.distance_from_input},
         {"distance_to_input", r.distance_to_input}});
  return json;
}

Json balances_json(const std::vector<Label_balance>& balances, const DSC::Label_names& names) {
  Json json = Json::array();
  for (const Label_balance& balance : balances)
    json.push_back(label_json(balance.label, names,
                              {{"volume_before", balance.before},
                               {"volume_after", balance.after},
                               {"volume_swept", balance.swept},
                               {"volume_of_overlaps", balance.overlaps},
                               {"volume_unexplained", balance.unexplained}}));
  return json;
}

} // namespace

Report::Report(const Run_options& options, const Run_start& start, const Repairs& repairs,
               double sweep_seconds, DSC::Label_names names)
    : m_path(options.output.report), m_sweep_seconds(sweep_seconds), m_names(std::move(names)),
      m_json({{"input", with_user_names(start.inputs)},
              {"parameters", parameters_json(options, start)},
              {"tetrahedralizer", DSC_TETRAHEDRALIZER},
              {"repairs", repairs_json(repairs)},
              {"sweep_seconds", sweep_seconds},
              {"steps", Json::array()}}) {}

void Report::add(const Run_position& position, const Step_outcome& outcome,
                 const Statistics& statistics) {
  Json step = {{"step", position.step},
               {"time", position.time},
               {"seconds", outcome.seconds},
               {"sweeps", outcome.seconds / m_sweep_seconds},
               {"complete", outcome.complete},
               {"unfinished_vertices", outcome.unfinished_vertices},
               {"estimated_error", outcome.estimated_error},
               {"stopped_at_boundary", outcome.stopped_at_boundary},
               {"cells_below_floor", outcome.flat_cells},
               {"parts", outcome.parts},
               {"passes", outcome.passes}};
  step.update(statistics_json(statistics));
  step.update({{"split", outcome.split},
               {"collapsed", outcome.collapsed},
               {"flipped", outcome.flipped},
               {"relabeled", outcome.relabeled}});
  step["events"] = Json::array();
  for (const Step_event& event : outcome.events)
    step["events"].push_back(event_json(event.change, event.where, statistics.dimension, m_names));
  step["balance"] = balances_json(outcome.balances, m_names);
  if (outcome.distance_to_start)
    step["distance_to_start"] = {{"mean", outcome.distance_to_start->mean},
                                 {"maximum", outcome.distance_to_start->maximum}};
  m_json["steps"].push_back(std::move(step));
}

void Report::set_balance(const Run_balance& balance) {
  m_json["balance"] = balances_json(balance.labels(), m_names);
}

void Report::write_now_and_then() {
  if (std::chrono::steady_clock::now() >= m_next_write)
    write();
}

void Report::write() {
  write_json(m_path, m_json);
  // Limits the frequency of writing, so that many short steps do not rewrite a long file each time.
  m_next_write = std::chrono::steady_clock::now() + std::chrono::seconds(1);
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

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include <CGAL/Deformable_simplicial_complex_3/internal/files.h>

namespace dsc {
namespace {

template <class T> Json value_or_null(const T& value) {
  return value == T() ? Json() : Json(value);
}

Json parameters_json(const Run_options& options, const Run_position& start) {
  Json json = motion_json(options.motion);
  json["steps"] = options.steps;
  json["triangles"] = value_or_null(start.triangles);
  json["threads"] = options.threads;
  json["output"] = value_or_null(options.output);
  json["every"] = options.every;
  json["resume"] = value_or_null(options.resume);
  return json;
}

Json labels_json(const std::vector<Label_statistics>& labels) {
  Json json = Json::array();
  for (const Label_statistics& label : labels)
    json.push_back({{"label", label.label},
                    {"tetrahedra", label.tetrahedra},
                    {"volume", label.volume},
                    {"area", label.area},
                    {"components", label.components},
                    {"euler_characteristic", label.euler_characteristic}});
  return json;
}

} // namespace

Report::Report(const Run_options& options, const Run_position& start, double sweep_seconds)
    : m_path(options.report), m_sweep_seconds(sweep_seconds),
      m_json({{"input", start.inputs},
              {"parameters", parameters_json(options, start)},
              {"sweep_seconds", sweep_seconds},
              {"steps", Json::array()}}) {}

void Report::add(const Run_position& position, const Step_outcome& outcome,
                 const Statistics& statistics) {
  m_json["steps"].push_back({{"step", position.step},
                             {"time", position.time},
                             {"seconds", outcome.seconds},
                             {"sweeps", outcome.seconds / m_sweep_seconds},
                             {"complete", outcome.complete},
                             {"unfinished_vertices", outcome.unfinished_vertices},
                             {"passes", outcome.passes},
                             {"vertices", statistics.vertices},
                             {"tetrahedra", statistics.tetrahedra},
                             {"interface_triangles", statistics.interface_triangles},
                             {"labels", labels_json(statistics.labels)},
                             {"min_dihedral", statistics.min_dihedral},
                             {"max_dihedral", statistics.max_dihedral},
                             {"dihedral_histogram", statistics.dihedral_histogram},
                             {"dihedrals_outside_6_171", statistics.dihedrals_outside_6_171},
                             {"min_quality", statistics.min_quality},
                             {"split", outcome.split},
                             {"collapsed", outcome.collapsed},
                             {"flipped", outcome.flipped},
                             {"relabeled", outcome.relabeled}});
  if (std::chrono::steady_clock::now() >= m_next_write)
    write();
}

void Report::write() {
  if (m_path.empty())
    return;
  CGAL::Deformable_simplicial_complexes::internal::replace_file_by_stream(
      m_path, [&](std::ostream& out) {
        out << m_json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
      });
  // A thousand short steps shall not write the long file a thousand times.
  m_next_write = std::chrono::steady_clock::now() + std::chrono::seconds(1);
}

} // namespace dsc

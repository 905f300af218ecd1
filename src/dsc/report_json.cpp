// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_json.h"

#include <CGAL/Deformable_simplicial_complexes/internal/IO/files.h>

#include <ostream>
#include <vector>

namespace dsc {
namespace {

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

Json statistics_json(const Statistics& statistics) {
  return {{"vertices", statistics.vertices},
          {"tetrahedra", statistics.tetrahedra},
          {"interface_triangles", statistics.interface_triangles},
          {"labels", labels_json(statistics.labels)},
          {"min_dihedral", statistics.min_dihedral},
          {"max_dihedral", statistics.max_dihedral},
          {"dihedral_histogram", statistics.dihedral_histogram},
          {"dihedrals_outside_6_171", statistics.dihedrals_outside_6_171},
          {"min_quality", statistics.min_quality}};
}

void write_json(const std::string& path, const Json& json) {
  CGAL::Deformable_simplicial_complexes::internal::replace_file_by_stream(
      path, [&](std::ostream& out) {
        out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
      });
}

} // namespace dsc

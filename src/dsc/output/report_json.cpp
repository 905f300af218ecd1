// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/report_json.h"

#include "input/translations.h"
#include "output/label_titles.h"

#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>

namespace dsc {
namespace {

// The names of quantities in the plane and in space.
struct Names
{
  const char *cells, *measure, *interface_measure, *facets;
};
const Names plane = {"triangles", "area", "length", "interface_segments"},
            space = {"tetrahedra", "volume", "area", "interface_triangles"};

Json labels_json(const std::vector<Label_statistics>& labels, const Names& names) {
  Json json = Json::array();
  for (const Label_statistics& label : labels)
    json.push_back(label_json(label.label, {{label.label, label.name}},
                              {{names.cells, label.cells},
                               {names.measure, label.volume},
                               {names.interface_measure, label.area},
                               {"components", label.components},
                               {"euler_characteristic", label.euler_characteristic}}));
  return json;
}

} // namespace

Json label_json(int label, const Label_names& names, const Json& values) {
  Json result = {{"label", label}};
  if (const std::string name = label_name(label, names); !name.empty())
    result["name"] = name;
  result.update(values);
  return result;
}

Json event_json(const DSC::Component_event& event, const std::array<double, 3>& where,
                int dimension, const Label_names& names) {
  const auto volumes = [](const auto& components) {
    Json result = Json::array();
    for (const auto& component : components)
      result.push_back(component.volume);
    return result;
  };
  return label_json(event.label, names,
                    {{"kind", DSC::Component_event::name_of(event.kind)},
                     {"where", std::vector<double>(where.begin(), where.begin() + dimension)},
                     {"volumes_before", volumes(event.before)},
                     {"volumes_after", volumes(event.after)}});
}

Json statistics_json(const Statistics& statistics) {
  const Names& names = statistics.dimension == 2 ? plane : space;
  const std::string angle = statistics.dimension == 2 ? "angle" : "dihedral";
  return {{"vertices", statistics.vertices},
          {names.cells, statistics.cells},
          {names.facets, statistics.interface_facets},
          {"labels", labels_json(statistics.labels, names)},
          {"min_" + angle, statistics.min_angle},
          {"max_" + angle, statistics.max_angle},
          {angle + "_histogram", statistics.angle_histogram},
          {angle + "s_outside_6_171", statistics.angles_outside_6_171},
          {"min_quality", statistics.min_quality}};
}

void write_json(const std::string& path, const Json& json) {
  DSC::replace_file(path, [&](std::ostream& out) {
    out << with_user_names(json.dump(2, ' ', false, Json::error_handler_t::replace)) << '\n';
  });
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Grain_energy.h"

#include <algorithm>

namespace dsc {

double Grain_energy::fastest() const {
  if (kind != Kind::table)
    return 1;
  double result = 0;
  for (const auto& row : table.rows)
    result = std::max(result, row.tension * row.mobility);
  return result;
}

double Grain_energy::tension(double angle) const {
  return kind == Kind::table ? table.tension(angle)
                             : CGAL::Deformable_simplicial_complexes::read_shockley_energy(
                                   angle * degree, largest_angle * degree);
}

Json to_json(const Grain_energy& energy) {
  switch (energy.kind) {
  case Grain_energy::Kind::isotropic:
    return {{"kind", "isotropic"}};
  case Grain_energy::Kind::read_shockley:
    return {{"kind", "read-shockley"}, {"largest_angle", energy.largest_angle}};
  case Grain_energy::Kind::table:
    break;
  }
  Json rows = Json::array();
  for (const auto& row : energy.table.rows)
    rows.push_back({row.angle, row.tension, row.mobility});
  return {{"kind", "table"}, {"rows", rows}};
}

Grain_energy energy_of_json(const Json& json) {
  Grain_energy result;
  if (json.at("kind") == "read-shockley") {
    result.kind = Grain_energy::Kind::read_shockley;
    result.largest_angle = json.at("largest_angle");
  } else if (json.at("kind") == "table") {
    result.kind = Grain_energy::Kind::table;
    for (const Json& row : json.at("rows"))
      result.table.rows.push_back({row.at(0), row.at(1), row.at(2)});
  }
  return result;
}

} // namespace dsc

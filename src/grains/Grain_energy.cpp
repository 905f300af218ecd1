// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Grain_energy.h"

#include "programs/errors.h"

#include <algorithm>
#include <cstddef>
#include <string>

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
  const std::string kind = json.at("kind");
  if (kind == "read-shockley") {
    result.kind = Grain_energy::Kind::read_shockley;
    result.largest_angle = json.at("largest_angle");
  } else if (kind == "table") {
    result.kind = Grain_energy::Kind::table;
    for (const Json& row : json.at("rows"))
      result.table.rows.push_back({row.at(0), row.at(1), row.at(2)});
  }
  const auto& rows = result.table.rows;
  bool is_valid = result.largest_angle > 0 && to_json(result).at("kind") == kind &&
                  (kind == "table") != rows.empty();
  for (std::size_t k = 0; k < rows.size(); ++k)
    is_valid = is_valid && rows[k].tension > 0 && rows[k].mobility > 0 &&
               (k == 0 || rows[k - 1].angle < rows[k].angle);
  if (!is_valid)
    throw Input_error("an energy of grain boundaries is out of its range");
  return result;
}

} // namespace dsc

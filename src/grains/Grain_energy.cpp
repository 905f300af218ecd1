// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Grain_energy.h"

#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>

namespace dsc {

double Grain_energy::fastest() const {
  if (kind != Kind::table)
    return 1;
  double result = 0;
  for (const auto& row : table.rows)
    result = (std::max)(result, row.tension * row.mobility);
  return result;
}

double Grain_energy::tension(double angle) const {
  return kind == Kind::table ? table.tension(angle)
                             : DSC::read_shockley_energy(angle * degree, largest_angle * degree);
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

double Angle_table::value(double angle, double Row::*member) const {
  std::size_t next = 0;
  while (next < rows.size() && rows[next].angle < angle)
    ++next;
  if (next == 0)
    return rows.front().*member;
  if (next == rows.size())
    return rows.back().*member;
  const Row &a = rows[next - 1], &b = rows[next];
  const double part = (angle - a.angle) / (b.angle - a.angle);
  return (1 - part) * a.*member + part * b.*member;
}

Angle_table read_angle_table(const std::string& path) {
  std::istringstream in(DSC::internal::file_contents(path));
  Angle_table result;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> values;
    for (std::string word; words >> word;) {
      const auto value = DSC::internal::number_of_word<double>(word);
      values.push_back(value && std::isfinite(*value) ? *value : -1);
    }
    if (values.empty())
      continue;
    const std::string place = path + ", line " + std::to_string(number) + ": ";
    if (values.size() < 2 || values.size() > 3 || !(values[0] >= 0) || !(values[1] > 0) ||
        !(values.back() > 0))
      throw Input_error(place +
                        "expected an angle in degrees, a positive tension and, if wanted, a "
                        "positive mobility");
    if (!result.rows.empty() && !(result.rows.back().angle < values[0]))
      throw Input_error(place + "the angle is not greater than the one before; sort the lines");
    result.rows.push_back({values[0], values[1], values.size() > 2 ? values[2] : 1});
  }
  if (result.rows.empty())
    throw Input_error(path + " contains no row; write lines of an angle and a tension, like 15 1");
  return result;
}

} // namespace dsc

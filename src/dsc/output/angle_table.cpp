// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/angle_table.h"

#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/number_of_word.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>

namespace dsc {

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
  std::ifstream in(path);
  if (!in)
    throw Input_error("cannot open " + path + "; check that the file exists and is readable");
  Angle_table result;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> values;
    for (std::string word; words >> word;) {
      const auto value =
          CGAL::Deformable_simplicial_complexes::internal::number_of_word<double>(word);
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

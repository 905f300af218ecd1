// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/run_start.h"

#include "input/files.h"

namespace dsc {

int dimension_of(const Run_start& start) {
  const bool is_planar =
      std::any_of(start.inputs.begin(), start.inputs.end(), [](const std::string& input) {
        const std::string format = extension(input);
        return format == "wkt" || format == "poly" || format == "pgm" || format == "png";
      });
  return is_planar || start.figure != Figure::none ? 2 : 3;
}

Input_kind input_kind(const Run_start& start) {
  return start.inputs.empty() ? Input_kind::surfaces : input_kind(start.inputs.front());
}

Input_kind input_kind(const std::string& input) {
  const bool is_file = exists(input);
  if (input.find_first_of("<>") != std::string::npos ||
      (input.find('=') != std::string::npos && !is_file))
    return Input_kind::inequalities;
  const std::string format = extension(input);
  if (format == "mesh" || format == "vtu")
    return Input_kind::tetrahedra;
  return format == "inr" || format == "gz" ? Input_kind::image : Input_kind::surfaces;
}

} // namespace dsc

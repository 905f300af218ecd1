// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"

#include "files.h"

#include <algorithm>

namespace dsc {

int dimension_of(const Run_start& start) {
  const bool is_planar =
      std::any_of(start.inputs.begin(), start.inputs.end(), [](const std::string& input) {
        const std::string format = extension(input);
        return format == "wkt" || format == "poly" || format == "pgm" || format == "png";
      });
  return is_planar || start.figure != Figure::none ? 2 : 3;
}

} // namespace dsc

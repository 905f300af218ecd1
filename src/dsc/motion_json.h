// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_JSON_H
#define DSC_MOTION_JSON_H

#include "options.h"
#include "report_json.h"

namespace dsc {

/// The subcommand and its own options.
inline Json motion_json(const Motion& motion) {
  if (const Rotation* rotation = std::get_if<Rotation>(&motion))
    return {{"command", "rotate"}, {"axis", rotation->axis}, {"angle", rotation->degrees}};
  const Offset& offset = std::get<Offset>(motion);
  return {{"command", "offset"},
          {"distance", offset.distance},
          {"unit", offset.in_mean_edges ? "mean interface edge" : "input"}};
}

} // namespace dsc

#endif // DSC_MOTION_JSON_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_position.h"

#include "motion_json.h"

namespace dsc {

std::string to_metadata(const Run_position& position, const Motion& motion) {
  // Nothing that depends on where a run was interrupted or on how many threads it had, so that
  // checkpoints of the same state are the same.
  Json parameters = motion_json(motion);
  parameters["triangles"] = position.start.triangles;
  if (const std::optional<Ball>& ball = position.start.ball)
    parameters["ball"] = {{"center", ball->center}, {"radius", ball->radius}};
  return Json{{"step", position.step},
              {"time", position.time},
              {"input", position.start.inputs},
              {"parameters", parameters}}
      .dump(-1, ' ', false, Json::error_handler_t::replace); // names may be any bytes
}

Run_position from_metadata(const std::string& metadata) {
  try {
    const Json json = Json::parse(metadata);
    Run_position position;
    position.step = json.at("step");
    position.time = json.at("time");
    position.start.inputs = json.at("input").get<std::vector<std::string>>();
    const Json& parameters = json.at("parameters");
    position.start.triangles = parameters.at("triangles");
    if (parameters.contains("ball")) {
      const Json& ball = parameters.at("ball");
      position.start.ball = Ball{ball.at("center"), ball.at("radius")};
    }
    return position;
  } catch (const Json::exception&) {
    return {};
  }
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Inputs.h"

#include "input/start_complex.h"
#include "input/start_curves.h"
#include "input/translations.h"
#include "motions/run.h"
#include "motions/start_distance.h"

namespace dsc {

std::string All_inputs::native(const std::string& path, const std::string& labels,
                               const std::string& thresholds) const {
  return native_file(path, labels, thresholds);
}

std::unique_ptr<Tracked_complex> All_inputs::start(const Run_options& options,
                                                   Repairs& repairs) const {
  const Run_start& start = options.start;
  if (dimension_of(start) == 2)
    return track_figure(start, options.domain);
  switch (input_kind(start)) {
  case Input_kind::image:
    return track_image(start.inputs.front(), options);
  case Input_kind::tetrahedra:
    return track_tetrahedra(start.inputs.front(), options);
  default:
    return start.repairs ? track_repaired_surfaces(options, repairs) : track_in_space(options);
  }
}

std::unique_ptr<Tracked_complex> All_inputs::resume(const std::string& path,
                                                    std::string& metadata) const {
  return track_checkpoint(path, metadata);
}

Start_distance All_inputs::distance_from(const Run_start& start) const {
  if (dimension_of(start) == 2)
    return Start_distance(start_curves(start));
  return Start_distance(
      start_surfaces(start, start.repairs ? read_and_repair(start, nullptr) : read_surfaces(start))
          .all);
}

} // namespace dsc

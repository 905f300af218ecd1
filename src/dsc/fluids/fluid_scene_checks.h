// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SCENE_CHECKS_H
#define DSC_FLUID_SCENE_CHECKS_H

#include "fluids/fluid_scene.h"
#include "scenes/json_fields.h"

namespace dsc {

/// Checks the consistency of the fields of a scene: labels, pairs of labels, names, and fields that
/// have no effect wherever the liquids move.
/// \param json the scene, for messages
/// \throws Usage_error
void require_consistent(const Fluid_scene& scene, const Json_fields& json);

} // namespace dsc

#endif // DSC_FLUID_SCENE_CHECKS_H

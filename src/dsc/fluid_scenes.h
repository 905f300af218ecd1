// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SCENES_H
#define DSC_FLUID_SCENES_H

#include <string>
#include <vector>

namespace dsc {

/// A scene that the program has.
struct Named_scene
{
  std::string name, json;
};

const std::vector<Named_scene>& named_scenes();

} // namespace dsc

#endif // DSC_FLUID_SCENES_H

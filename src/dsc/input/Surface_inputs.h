// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_INPUTS_H
#define DSC_SURFACE_INPUTS_H

#include "input/Inputs.h"

namespace dsc {

/// Returns the inputs of the program `dsc`: surfaces that bound solids, and inequalities, in space.
const Inputs& surface_inputs();

} // namespace dsc

#endif // DSC_SURFACE_INPUTS_H

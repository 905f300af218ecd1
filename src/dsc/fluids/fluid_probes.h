// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_PROBES_H
#define DSC_FLUID_PROBES_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"
#include "output/report_json.h"

namespace dsc {

/// Returns the values of the probes of a scene by name. A value that does not exist is null.
template <class Complex> Json probes_json(const Fluid_scene& scene, const Fluid<Complex>& fluid);

} // namespace dsc

#endif // DSC_FLUID_PROBES_H

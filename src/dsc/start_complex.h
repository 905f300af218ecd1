// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_COMPLEX_H
#define DSC_START_COMPLEX_H

#include "run.h"
#include "surface.h"
#include "tracked_complex.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace dsc {

/// Returns the initial complex of a run, for any kind of inputs in space or in the plane.
/// \param repairs receives the repairs of the surfaces
/// \throws std::runtime_error if an input cannot be read, or does not define a complex
std::unique_ptr<Tracked_complex> start_complex(const Run_options& options, Repairs& repairs);

/// Returns the complex of a labelled image (.inr, .inr.gz).
/// \param edge target edge length of the interface, in the unit of the image; 0 for the default
/// \param domain lower and upper bounds of the box; the default of the library if not set
std::unique_ptr<Tracked_complex> track_image(const std::string& path, double edge,
                                             const std::optional<std::array<double, 6>>& domain);

} // namespace dsc

#endif // DSC_START_COMPLEX_H

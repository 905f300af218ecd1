// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_PICTURE_H
#define DSC_FLUID_PICTURE_H

#include "fluids/fluid_of_dimension.h"
#include "programs/option_values.h"

namespace dsc {

/// The options of the picture of a fluid.
struct Fluid_picture
{
  std::string path;       ///< empty for no picture
  std::optional<Cut> cut; ///< the plane of the picture, in space only
  std::string quantity;   ///< that determines the colors; empty for the label
};

/// The quantities that can determine the colors of a picture.
const std::vector<std::string>& quantities_of_pictures();

/// Draws a fluid: in the plane and in a cut its cells, otherwise its interface.
/// \return the range of the quantity as text for the summary; empty if there is no quantity
/// \pre in space, a quantity is given only with a cut
/// \throws Input_error if the file cannot be written
template <int dimension>
std::string draw_fluid(const Fluid_picture& picture, const Tracked_complex_of<dimension>& complex,
                       const Fluid<typename Tracked_complex_of<dimension>::Complex>& fluid);

} // namespace dsc

#endif // DSC_FLUID_PICTURE_H

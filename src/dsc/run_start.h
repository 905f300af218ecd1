// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_START_H
#define DSC_RUN_START_H

#include "distance.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dsc {

/// A ball in the coordinates of the input.
struct Ball
{
  std::array<double, 3> center;
  double radius;
};

/// A figure in the plane that needs no file.
enum class Figure { none, disk, slotted_disk };

/// The surfaces, or the figures of the plane, that a run starts from.
struct Run_start
{
  std::vector<std::string> inputs; ///< files
  std::size_t triangles = 0;       ///< of all surfaces together; 0 keeps them as they are
  std::optional<Ball> ball;        ///< that the inputs are fitted into or, without any, that is the
                                   ///< surface
  std::size_t segments = 0;        ///< of all curves together, at least; 0 keeps them as they are
  Figure figure = Figure::none;    ///< without any input in the plane
  bool repairs = false;            ///< surfaces that bound no solid
  std::string labels; ///< name of the array of a .vtu file that holds them, `none` for label 1
                      ///< everywhere; empty for the one with a name that is known
  std::optional<Distance> largest_hole; ///< length of its border that is filled at the most; the
                                        ///< library's bound if not set
  double edge = 0; ///< about how long interface edges are to be, of images and inequalities; 0 for
                   ///< the default of each
};

/// What the inputs of a run in space are; all of them are of the same kind.
enum class Input_kind { surfaces, inequalities, image, tetrahedra };

/// Of a file, or of what is written in its place.
Input_kind input_kind(const std::string& input);
Input_kind input_kind(const Run_start& start);

/// 2 if a run starts in the plane, else 3.
int dimension_of(const Run_start& start);

} // namespace dsc

#endif // DSC_RUN_START_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_START_H
#define DSC_RUN_START_H

#include "programs/option_values.h"

#include <CGAL/Complex_construction/Thin_part_options.h>

#include <optional>

namespace dsc {

/// A ball in the coordinates of the input.
struct Ball
{
  std::array<double, 3> center;
  double radius;
};

/// A figure in the plane that is generated without a file.
enum class Figure { none, disk, slotted_disk };

/// The surfaces, or the figures of the plane, from which a run starts.
struct Run_start
{
  std::vector<std::string> inputs; ///< files
  std::size_t triangles = 0;       ///< of all surfaces together; 0 for no change
  std::optional<Ball> ball;        ///< inputs are fitted into it; without inputs, the initial
                                   ///< surface
  std::size_t segments = 0;        ///< of all curves together, at least; 0 for no change
  Figure figure = Figure::none;    ///< used without inputs in the plane
  bool repairs = false;            ///< whether surfaces that bound no solid are repaired
  std::string thresholds;          ///< of a gray image, as written; empty for labels
  std::string labels; ///< name of the array of a .vtu file with the labels, `none` for label 1
                      ///< everywhere and in all parts of a surface; empty for an array with a
                      ///< known name
  std::optional<Distance> largest_hole; ///< length of the boundary of the largest hole to be
                                        ///< filled; the default of the library if not set
  /// How thin parts are resolved.
  DSC::Thin_part_options thin_parts;
  bool mesh_is_domain =
      false;       ///< whether the domain is the mesh of the input, and no box around it
  double edge = 0; ///< target edge length of the interface for images and inequalities; 0 for
                   ///< the default
};

/// The kind of the inputs of a run in space. All inputs are of the same kind.
enum class Input_kind { surfaces, inequalities, image, tetrahedra };

/// Returns the kind of an input: a file, or the text given in its place.
Input_kind input_kind(const std::string& input);
Input_kind input_kind(const Run_start& start);

/// Returns 2 if a run starts in the plane, 3 otherwise.
int dimension_of(const Run_start& start);

} // namespace dsc

#endif // DSC_RUN_START_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OPTIONS_H
#define DSC_OPTIONS_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dsc {

/// Turn about an axis through the centre of the domain.
struct Rotation
{
  std::array<double, 3> axis; ///< not zero, any length
  double degrees;             ///< per step
};

/// Move along the outward normals.
struct Offset
{
  double distance;    ///< per step, positive outwards
  bool in_mean_edges; ///< the unit: mean interface edges of the input, or that of the input's
                      ///< coordinates
};

using Motion = std::variant<Rotation, Offset>;

/// What `dsc rotate` and `dsc offset` are asked to do.
struct Run_options
{
  Motion motion;
  std::vector<std::string> inputs; ///< surfaces; empty exactly if `resume` is set
  std::string resume;              ///< a checkpoint
  unsigned steps = 10;             ///< to do in this run
  std::size_t triangles = 0;       ///< of all surfaces together; 0 keeps them as they are
  unsigned threads = 1;
  std::string output; ///< folder; empty for no files
  unsigned every = 1;
  std::string report; ///< file; empty for none
  bool quiet = false;
};

/// What `dsc info` is asked to do.
struct Info_options
{
  std::string file;
};

/// What `dsc convert` is asked to do.
struct Convert_options
{
  std::string checkpoint;
  std::string output;
  bool quiet = false;
};

/// What `dsc improve` is asked to do.
struct Improve_options
{
  std::string input;  ///< labelled tetrahedra
  std::string output; ///< may be the input
  bool aggressive = false;
  std::optional<double> threshold; ///< of the quality, in (0, 1]; that of the library if not set
  std::string report;              ///< file; empty for none
  bool quiet = false;
};

using Options = std::variant<Info_options, Run_options, Convert_options, Improve_options>;

} // namespace dsc

#endif // DSC_OPTIONS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_INPUTS_H
#define DSC_SURFACE_INPUTS_H

#include "input/Inputs.h"

namespace dsc {

/// Surfaces that bound solids, and inequalities, in space.
class Surface_inputs : public Inputs
{
public:
  void require_all() const override;
  std::string native(const std::string& path, const std::string& labels,
                     const std::string& thresholds) const override;
  std::unique_ptr<Tracked_complex> start(const Run_options& options,
                                         Repairs& repairs) const override;
  std::unique_ptr<Tracked_complex> resume(const std::string& path,
                                          std::string& metadata) const override;
  Start_distance distance_from(const Run_start& start) const override;
  void convert(const std::string& input, const std::string& output, const std::string& labels,
               const std::string& thresholds) const override;
  void convert_to_image(const std::string& checkpoint, const std::string& output,
                        const std::string& grid) const override;
};

} // namespace dsc

#endif // DSC_SURFACE_INPUTS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Inputs.h"

#include "input/files.h"
#include "input/start_complex.h"
#include "input/translations.h"
#include "motions/run.h"
#include "motions/start_distance.h"
#include "programs/program.h"

namespace dsc {
namespace {

constexpr char plane[] = "the commands for the plane",
               repairs_of_surfaces[] = "the option --repair";

[[noreturn]] void leave(const char* content) { throw Other_program{"dsc-full", content}; }

/// Leaves surfaces that are repaired, curves, and what is no surface.
void require_sound_surfaces(const Run_start& start) {
  if (dimension_of(start) == 2)
    leave(plane);
  if (input_kind(start) == Input_kind::image)
    leave("the reader of voxel images");
  if (input_kind(start) == Input_kind::tetrahedra)
    leave("the readers of tetrahedra");
  if (start.repairs)
    leave(repairs_of_surfaces);
}

class Surface_inputs : public Inputs
{
public:
  void require_all() const override { leave("the readers of other files"); }

  std::string native(const std::string& path, const std::string&,
                     const std::string& thresholds) const override {
    const std::string format = extension(path);
    if (!thresholds.empty() || is_foreign(path) || format == "vtu" || format == "png")
      leave("the readers of files of other programs");
    return path;
  }

  std::unique_ptr<Tracked_complex> start(const Run_options& options, Repairs&) const override {
    require_sound_surfaces(options.start);
    return track_in_space(options);
  }

  std::unique_ptr<Tracked_complex> resume(const std::string& path,
                                          std::string& metadata) const override {
    if (checkpoint_dimension(path) == 2)
      leave(plane);
    return track_checkpoint_3(path, metadata);
  }

  Start_distance distance_from(const Run_start& start) const override {
    require_sound_surfaces(start);
    return Start_distance(start_surfaces(start).all);
  }

  void convert(const std::string&, const std::string&, const std::string&,
               const std::string&) const override {
    leave("conversions of files");
  }

  void convert_to_image(const std::string&, const std::string&, const std::string&) const override {
    leave("conversions to images");
  }
};

} // namespace

const Inputs& surface_inputs() {
  static const Surface_inputs inputs;
  return inputs;
}

} // namespace dsc

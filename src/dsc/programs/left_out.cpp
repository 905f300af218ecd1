// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The functions that the program `dsc` leaves to `dsc-full`.

#include "../convert_file.h"
#include "../files.h"
#include "../native_file.h"
#include "../program.h"
#include "../start_complex.h"
#include "../start_curves.h"
#include "../surface.h"
#include "../tracked_complex.h"
#include "../translations.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc {
namespace {

[[noreturn]] void leave(const char* content) { throw Other_program{"dsc-full", content}; }

constexpr char plane[] = "the commands for the plane", repairs[] = "the option --repair";

} // namespace

std::unique_ptr<Tracked_complex> track_figure(const Run_start&,
                                              const std::optional<std::array<double, 6>>&) {
  leave(plane);
}

std::unique_ptr<Tracked_complex> track_planar_checkpoint(const std::string&, std::string&) {
  leave(plane);
}

std::string native_file(const std::string& path, const std::string&,
                        const std::string& thresholds) {
  const std::string format = extension(path);
  if (!thresholds.empty() || is_foreign(path) || format == "vtu" || format == "png")
    leave("the readers of files of other programs");
  return path;
}

void require_all_readers() { leave("the readers of other files"); }

void convert_file(const std::string&, const std::string&, const std::string&, const std::string&) {
  leave("conversions of files");
}

void convert_to_image(const std::string&, const std::string&, const std::string&) {
  leave("conversions to images");
}

Curves start_curves(const Run_start&) { leave(plane); }

std::unique_ptr<Tracked_complex> track_image(const std::string&, const Run_options&) {
  leave("the reader of voxel images");
}

std::unique_ptr<Tracked_complex> track_tetrahedra(const std::string&, const Run_options&) {
  leave("the readers of tetrahedra");
}

std::vector<Surface> read_and_repair(const Run_start&, Repairs*) { leave(repairs); }

std::unique_ptr<Tracked_complex>
track_repaired_surfaces(const Run_options&, const std::vector<std::string>&, Repairs&) {
  leave(repairs);
}

} // namespace dsc

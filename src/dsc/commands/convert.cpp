// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "errors.h"
#include "files.h"
#include "interrupt.h"
#include "option_values.h"
#include "tracked_complex.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace dsc {
namespace {

struct Convert_options
{
  std::string checkpoint;
  std::string output;
  int subdivisions = 0; ///< of the interface, by Loop's scheme
  bool quiet = false;
};

int execute(const Convert_options& options) {
  require_writable(options.output);
  const Interruptible interruptible(options.quiet);
  std::string metadata;
  const auto complex = track_checkpoint(options.checkpoint, metadata);
  if (options.subdivisions > 0)
    complex->write_subdivided(options.output, options.subdivisions);
  else
    complex->write(options.output);
  if (!options.quiet)
    std::cout << "dsc: wrote " << options.output << '\n';
  return 0;
}

void require_surface_to_subdivide(const std::string& path) {
  const std::string format = extension(path);
  if (format != "off" && format != "obj" && format != "ply" && format != "stl")
    throw Usage_error("--subdivide applies only to surfaces (.off, .obj, .ply, .stl); leave it "
                      "out, or choose one of these formats for OUT");
}

void check(const Convert_options& options) {
  require_extension(options.output,
                    {"off", "obj", "ply", "stl", "vtu", "mesh", "wkt", "poly", "svg", "png"});
  if (options.subdivisions > 0)
    require_surface_to_subdivide(options.output);
}

} // namespace

void add_convert(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Convert_options>();
  CLI::App* command = app.add_subcommand("convert", "Write a checkpoint in another format");
  command->add_option("CHECKPOINT", options->checkpoint, "Checkpoint (.dsc)")->required();
  command
      ->add_option(
          "OUT", options->output,
          "Interface (.off, .obj, .ply, .stl), picture (.png) or tetrahedra (.vtu, .mesh); "
          "in the plane, regions (.wkt, .poly), picture (.svg) or triangles (.vtu)")
      ->required();
  command
      ->add_option("--subdivide", options->subdivisions,
                   "Number of Loop subdivision steps of the interface; "
                   "each step divides a triangle into four")
      ->check(CLI::Range(1, most_subdivisions));
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/start_options.h"
#include "input/Inputs.h"
#include "input/files.h"
#include "input/translations.h"
#include "motions/tracked_complex.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iostream>
#include <memory>
#include <string>

namespace dsc {
namespace {

struct Convert_options
{
  std::string input;  ///< file; `-` for standard input
  std::string output; ///< file; `-` for standard output
  std::string from;   ///< extension of standard input
  std::string to;     ///< extension of standard output
  std::string labels;
  std::string thresholds;
  std::string grid;     ///< image whose voxels get labels; empty for none
  int subdivisions = 0; ///< of the interface, by Loop's scheme
  bool quiet = false;
};

constexpr const char* standard = "-"; // input or output

void convert_checkpoint(const Inputs& inputs, const Convert_options& options) {
  std::string metadata;
  const auto complex = inputs.resume(options.input, metadata);
  if (options.subdivisions > 0)
    complex->write_subdivided(options.output, options.subdivisions);
  else
    complex->write(options.output);
}

void convert(const Inputs& inputs, const Convert_options& options) {
  if (options.output != standard)
    require_place("OUT", options.output, {options.input, options.grid});
  if (!options.grid.empty())
    inputs.convert_to_image(options.input, options.output, options.grid);
  else if (extension(options.input) == "dsc")
    convert_checkpoint(inputs, options);
  else
    inputs.convert(options.input, options.output, options.labels, options.thresholds);
}

/// Copies standard input to a temporary file, or a temporary file to standard output.
void copy(std::istream& from, std::ostream& to) {
  if (from.peek() != std::istream::traits_type::eof())
    to << from.rdbuf();
  if (!to.flush())
    throw Input_error("cannot write all bytes; check that the disk is not full");
}

int execute(const Inputs& inputs, Convert_options options) {
  if (options.quiet)
    keep_silent_about_unused();
  // Before standard input is read.
  if (options.input == standard || extension(options.input) != "dsc" || !options.grid.empty())
    inputs.require_all();
  const Interruptible interruptible(options.quiet);
  const bool prints = options.output == standard;
  if (options.input == standard) {
    options.input = temporary_file("input." + options.from);
    name_in_messages(options.input, "standard input");
    std::ofstream file(options.input, std::ios::binary);
    copy(std::cin, file);
  }
  if (prints) {
    options.output = temporary_file("output." + options.to);
    name_in_messages(options.output, "standard output");
  }
  convert(inputs, options);
  if (prints) {
    std::ifstream file(options.output, std::ios::binary);
    copy(file, std::cout);
  } else if (!options.quiet) {
    std::cout << "dsc: wrote " << options.output << '\n';
  }
  return 0;
}

void require_surface_to_subdivide(const std::string& path) {
  const std::string format = extension(path);
  if (format != "off" && format != "obj" && format != "ply" && format != "stl")
    throw Usage_error("--subdivide applies only to surfaces (.off, .obj, .ply, .stl); leave it "
                      "out, or choose one of these formats for OUT");
}

/// Throws if a format is missing for `-`, or given for a file.
void require_format(const std::string& file, const char* option, const std::string& format) {
  if (file == standard && format.empty())
    throw Usage_error(std::string(option) + " is missing; give the format of - like " + option +
                      " off");
  if (file != standard && !format.empty())
    throw Usage_error(std::string(option) + " applies only to -; leave it out");
}

void check(const Convert_options& options) {
  require_format(options.input, "--from", options.from);
  require_format(options.output, "--to", options.to);
  const std::string output = options.output == standard ? "output." + options.to : options.output,
                    input = options.input == standard ? "input." + options.from : options.input;
  const bool is_checkpoint = extension(input) == "dsc";
  require_extension(output, {"off", "obj", "ply", "stl", "vtu", "mesh", "wkt", "poly", "svg", "png",
                             "inr", "mha", "nii", "gz", "tif", "tiff", "vti", "vtk", "vtp"});
  if (options.subdivisions > 0) {
    require_surface_to_subdivide(output);
    if (!is_checkpoint)
      throw Usage_error("--subdivide applies only to a checkpoint; leave it out");
  }
  if (is_checkpoint && !(options.labels.empty() && options.thresholds.empty()))
    throw Usage_error("--labels and --threshold do not apply to a checkpoint; leave them out");
  if (!is_checkpoint && !options.grid.empty())
    throw Usage_error("--grid applies only to a checkpoint; leave it out");
}

} // namespace

void add_convert(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Convert_options>();
  CLI::App* command =
      app.add_subcommand("convert", "Write a checkpoint, or another file, in another format");
  command
      ->add_option("IN", options->input,
                   "Checkpoint (.dsc), or a surface, tetrahedra, an image or curves as for the "
                   "other commands; - for standard input")
      ->required();
  command
      ->add_option(
          "OUT", options->output,
          "Interface or surface (.off, .obj, .ply, .stl, .vtp), picture (.png), tetrahedra (.vtu, "
          ".mesh, .vtk) or image (.inr, .mha, .nii, .nii.gz, .tif, .vti, .vtk); in the plane, "
          "regions (.wkt, .poly), picture (.svg) or triangles (.vtu); - for standard output")
      ->required();
  command->add_option("--from", options->from, "Format of standard input, like off");
  command->add_option("--to", options->to, "Format of standard output, like stl");
  add_labels_option(*command, options->labels);
  add_threshold_option(*command, options->thresholds);
  command->add_option("--grid", options->grid,
                      "Write the labels of a checkpoint at the voxels of this image");
  command
      ->add_option("--subdivide", options->subdivisions,
                   "Number of Loop subdivision steps of the interface; "
                   "each step divides a triangle into four")
      ->check(CLI::Range(1, most_subdivisions));
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([options, &inputs, &exit_code] {
    check(*options);
    exit_code = execute(inputs, *options);
  });
}

} // namespace dsc

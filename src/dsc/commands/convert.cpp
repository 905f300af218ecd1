// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/start_options.h"
#include "input/Inputs.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/translations.h"
#include "motions/tracked_complex.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <iostream>

namespace dsc {
namespace {

struct Convert_options
{
  std::string input, output; ///< files
  std::string labels;
  std::string thresholds;
  std::string grid;     ///< image whose voxels get labels; empty for none
  int subdivisions = 0; ///< of the interface, by Loop's scheme
  bool quiet = false;
};

void convert_checkpoint(const Inputs& inputs, const Convert_options& options) {
  std::string metadata;
  const auto complex = inputs.resume(options.input, metadata);
  if (has_format(options.output, Use::write, content::surface) &&
      complex->statistics().interface_facets == 0)
    throw Input_error(options.input + " has no interface to write; choose another format");
  if (options.subdivisions > 0)
    complex->write_subdivided(options.output, options.subdivisions);
  else
    complex->write(options.output);
}

void convert(const Inputs& inputs, const Convert_options& options) {
  require_place("OUT", options.output, {options.input, options.grid});
  if (!options.grid.empty())
    inputs.convert_to_image(options.input, options.output, options.grid);
  else if (extension(options.input) == "dsc")
    convert_checkpoint(inputs, options);
  else
    inputs.convert(options.input, options.output, options.labels, options.thresholds);
}

int execute(const Inputs& inputs, const Convert_options& options) {
  if (options.quiet)
    keep_silent_about_unused();
  if (extension(options.input) != "dsc" || !options.grid.empty())
    inputs.require_all();
  const Interruptible interruptible(options.quiet);
  convert(inputs, options);
  if (!options.quiet && with_user_names(options.output) == options.output) // a file
    std::cout << "dsc: wrote " << options.output << '\n';
  return 0;
}

constexpr unsigned native_outputs =
                       content::surface | content::tetrahedra | content::regions | content::picture,
                   foreign_outputs = content::surface | content::tetrahedra | content::voxels;

void check(const Convert_options& options) {
  const bool is_checkpoint = extension(options.input) == "dsc";
  require_format(options.output, Use::write, native_outputs, foreign_outputs);
  if (options.subdivisions > 0) {
    if (!has_format(options.output, Use::write, content::surface, 0))
      throw Usage_error("--subdivide applies only to surfaces (" +
                        formats_with(Use::write, content::surface) +
                        "); leave it out, or choose one of these formats for OUT");
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
  add_input(*command, "IN", options->input,
            "Checkpoint (.dsc), or a surface, tetrahedra, an image or curves as for the other "
            "commands; - for standard input")
      ->required();
  add_output(
      *command, "OUT", options->output,
      "Interface or surface (" + formats_with(Use::write, content::surface, content::surface) +
          "), picture (" + formats_with(Use::write, content::picture) + "), tetrahedra (" +
          formats_with(Use::write, content::tetrahedra, content::tetrahedra) + ") or image (" +
          formats_with(Use::write, 0, content::voxels) + "); in the plane, regions (" +
          formats_with(Use::write, content::regions) + "); - for standard output")
      ->required();
  add_labels_option(*command, options->labels);
  add_threshold_option(*command, options->thresholds);
  add_input(*command, "--grid", options->grid,
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

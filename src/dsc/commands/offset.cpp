// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/run_command.h"
#include "programs/errors.h"
#include "programs/option_values.h"

#include <memory>
#include <string>
#include <variant>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

struct Offset_options
{
  Run_command_options run;
  std::string distance; ///< as written
  bool moves_faces = false;
  std::string corners = "miter";
};

void check_dimension(const Run_options& run, bool is_planar) {
  require_space(run, is_planar, {"--move-faces"});
}

} // namespace

void add_offset(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Offset_options>();
  CLI::App* command =
      add_run_command(app, inputs, "offset", "Move the interface along its normals", options->run);
  command->add_option("--distance", options->distance,
                      "Distance per step, positive outwards; 0.25e is a quarter of the mean "
                      "interface edge of the input; required for a new run");
  command->add_flag(
      "--move-faces", options->moves_faces,
      "Move flat faces as a whole: edges that the motion opens become round, others stay sharp");
  command
      ->add_option("--corners", options->corners,
                   "Corners and edges from which the interface moves away: sharp (miter), or "
                   "arcs, cylinders and spheres (round)")
      ->check(CLI::IsMember(&corner_rules()))
      ->capture_default_str();
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    run.step.motion =
        Offset{run.given.count("--distance") > 0 ? parse_distance(options->distance) : Distance(),
               options->moves_faces, corner_rules().at(options->corners)};
    complete_run_options(options->run, {}, check_dimension, run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/start_options.h"

#include "input/files.h"
#include "input/formats.h"
#include "input/functions_of_points.h"
#include "input/translations.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/standard_streams.h"

#include <climits>

namespace dsc {
namespace {

void require_inputs(const Run_options& run, const Default_start& defaults, bool is_planar) {
  const bool has_input = !run.start.inputs.empty();
  if (run.resume.empty() && !has_input && !defaults.ball && !is_planar)
    throw Usage_error("INPUT is missing; give at least one surface, or a checkpoint by --resume");
  if (!has_input && run.start.repairs)
    throw Usage_error("--repair needs a surface; give at least one INPUT");
  constexpr unsigned planar = content::regions | content::pixels;
  for (const std::string& input : run.start.inputs)
    if (is_planar)
      require_format(input, Use::read, planar, planar);
    else if (input_kind(run.start) != Input_kind::inequalities)
      require_format(input, Use::read, content::starts, content::starts);
}

/// Throws if an option is given that has no meaning in this dimension.
void require_dimension(const Run_options& run, bool is_planar) {
  require_space(run, is_planar, {"--triangles", "--repair", "--largest-hole"});
  if (run.given.count("--segments") == 0)
    return;
  if (!is_planar)
    throw Usage_error("--segments applies only in the plane; leave it out");
  const std::string format = run.start.inputs.empty() ? "" : extension(run.start.inputs[0]);
  if (format == "pgm" || format == "png")
    throw Usage_error("--segments does not apply to images; leave it out");
}

void require_same_kind(const Run_options& run) {
  for (const std::string& input : run.start.inputs)
    if (input_kind(input) != Input_kind::surfaces)
      throw Usage_error(input + " cannot be combined with other kinds of INPUT; give it alone");
}

void require_inequalities(const Run_options& run, const Default_start& defaults) {
  for (const std::string& input : run.start.inputs)
    if (input_kind(input) != Input_kind::inequalities)
      throw Usage_error(
          input + " is not an inequality and cannot be combined with inequalities; leave it out");
  const Inequalities check(run.start.inputs);
  if (!run.domain && !defaults.domain_in_space)
    throw Usage_error("inequalities need a --domain; give its minimum and maximum coordinates like "
                      "-1,-1,-1,1,1,1");
}

/// Throws if an option is given that has no meaning for this kind of input.
void require_kind(const Run_options& run, const Default_start& defaults, bool is_planar) {
  const Input_kind kind = input_kind(run.start);
  const auto is_given = [&](const char* name) { return run.given.count(name) > 0; };
  const std::string format = run.start.inputs.empty() ? "" : extension(run.start.inputs.front());
  const bool has_edge = kind == Input_kind::inequalities || kind == Input_kind::image ||
                        format == "pgm" || format == "png";
  const bool is_image = kind == Input_kind::image || format == "pgm";
  if (is_given("--threshold") && !is_image)
    throw Usage_error("--threshold applies only to images; leave it out");
  if (run.start.mesh_is_domain && kind != Input_kind::tetrahedra)
    throw Usage_error("--domain mesh applies only to tetrahedra; give the coordinates of a box");
  if (is_given("--edge") && !has_edge)
    throw Usage_error("--edge applies only to inequalities and images; leave it out");
  if (is_given("--labels"))
    require_file_with_arrays(run.start.inputs.empty() ? "" : run.start.inputs.front(),
                             run.start.labels);
  if (is_planar || kind == Input_kind::surfaces)
    return require_same_kind(run);
  for (const char* name : {"--triangles", "--fit", "--repair", "--largest-hole"})
    if (is_given(name))
      throw Usage_error(std::string(name) + " applies only to surfaces; leave it out");
  if (kind == Input_kind::inequalities)
    require_inequalities(run, defaults);
  else if (run.start.inputs.size() > 1)
    throw Usage_error("there is more than one INPUT, but tetrahedra and images contain all "
                      "labels; give a single INPUT");
}

void read_domain(std::string text, bool is_planar, Run_options& run) {
  run.step.grows_domain = take_growth(text);
  run.start.mesh_is_domain = text == "mesh";
  if (!run.start.mesh_is_domain && (!text.empty() || !run.step.grows_domain))
    run.domain = parse_domain(text, is_planar ? 2 : 3);
}

/// Returns whether a motion keeps the shape of the interface.
bool is_rigid(const Motion& motion) {
  return std::holds_alternative<Rotation>(motion) || std::holds_alternative<Zalesak>(motion);
}

} // namespace

void require_space(const Run_options& run, bool is_planar,
                   std::initializer_list<const char*> options) {
  for (const char* name : options)
    if (is_planar && run.given.count(name) > 0)
      throw Usage_error(std::string(name) + " applies only in space; leave it out");
}

CLI::Option* add_inputs(CLI::App& command, Run_start& start) {
  return add_input(
      command, "INPUT", start.inputs,
      "Closed surfaces (" + formats_with(Use::read, content::surface, 0) +
          "), inequalities like 'x^2+y^2+z^2<1' or, in the plane, polygons (.wkt), which get the "
          "labels 1, 2, ...; or labeled tetrahedra (" +
          formats_with(Use::read, content::tetrahedra, 0) + ") or a labeled image (" +
          formats_with(Use::read, content::voxels, 0) + "); in the plane, a labeled image (" +
          formats_with(Use::read, content::pixels, 0) +
          ") or segments (.poly). Named parts of a surface, such as solids (.stl) and objects "
          "(.obj), get a label each. - is standard input. Files of other programs are read through "
          "VTK, Gmsh and lib3mf: " +
          formats_with(Use::read, 0, content::starts));
}

void add_start_options(CLI::App& command, Run_start& start, std::string& domain,
                       CLI::Option* resume) {
  command
      .add_option("--triangles", start.triangles,
                  "Simplify or refine the surfaces to about this number of triangles in total")
      ->check(CLI::Range(4, INT_MAX))
      ->excludes(resume);
  command
      .add_option("--segments", start.segments,
                  "Divide planar curves into at least about this number of segments in total")
      ->check(CLI::Range(4, INT_MAX))
      ->excludes(resume);
  command
      .add_option(
          "--domain", domain,
          "Box of the complex: minimum and maximum coordinates like -1,-1,-1,1,1,1, in the plane "
          "-1,-1,1,1. A final ,grow, or grow alone for the default box, enlarges the box when the "
          "interface comes near its boundary. mesh makes the tetrahedra of the INPUT the domain")
      ->excludes(resume);
  add_value(command, "--edge", start.edge, positive,
            "Target length of interface edges for inequalities and images (default: 1/40 of the "
            "longest side of the domain; 2.5 voxels or pixels)")
      ->excludes(resume);
  add_value(command, "--edge-per-thickness", start.thin_parts.edge_per_thickness, not_negative("3"),
            "Split interface edges that are longer than this number of thicknesses of the part or "
            "the gap at them (default: 3; 0, which turns this off, with --triangles and for "
            "rotations)")
      ->excludes(resume);
  command
      .add_option(
          "--most-new-facets", start.thin_parts.most_new_facets,
          "Largest number of interface triangles, in the plane segments, that thin parts add")
      ->excludes(resume)
      ->capture_default_str();
  add_labels_option(command, start.labels)->excludes(resume);
  command
      .add_option("--threshold", start.thresholds,
                  "Labels of a gray image: the number of thresholds that a value reaches, like "
                  "100 or 80,160; otsu or otsu:2 chooses one threshold or two")
      ->excludes(resume);
  CLI::Option* repairs =
      command
          .add_flag(
              "--repair", start.repairs,
              "Repair surfaces that do not bound a solid: merge points, close T-junctions, fill "
              "holes, unite intersecting components or, if necessary, wrap the surface")
          ->excludes(resume);
  add_value(command, "--largest-hole", start.largest_hole, Length_range{positive},
            "Fill holes whose boundary is at most this long, like 2.5; 20e means 20 mean edges of "
            "the surface (default: 1.6 diagonals of the bounding box of the component)")
      ->needs(repairs)
      ->excludes(resume);
}

void complete_start(const std::string& domain, const Default_start& defaults, Start_check* check,
                    Run_options& run) {
  const bool is_new = run.resume.empty(), has_input = !run.start.inputs.empty();
  if (is_new && !has_input)
    run.start.figure = defaults.figure;
  const bool is_planar = is_new && dimension_of(run.start) == 2;
  if (run.given.count("--domain") > 0)
    read_domain(domain, is_planar, run);
  require_inputs(run, defaults, is_planar);
  if (check != nullptr)
    check(run, is_planar);
  double& edge_per_thickness = run.start.thin_parts.edge_per_thickness;
  if (run.given.count("--edge-per-thickness") == 0 &&
      (run.given.count("--triangles") > 0 || is_rigid(run.step.motion)))
    edge_per_thickness = 0; // the triangles of the input or those that are asked for
  if (edge_per_thickness > 0 && edge_per_thickness < 1)
    throw Usage_error("--edge-per-thickness is less than 1; choose 1 or more, or 0");
  if (!is_new)
    return;
  require_dimension(run, is_planar);
  require_kind(run, defaults, is_planar);
  if (!is_planar && (defaults.fits_inputs || !has_input))
    run.start.ball = defaults.ball;
  if (!run.domain)
    run.domain = is_planar ? defaults.domain_in_plane : defaults.domain_in_space;
}

CLI::Option* add_labels_option(CLI::App& command, std::string& labels) {
  return command.add_option(
      "--labels", labels,
      "Name of the cell array of a .vtu file with the labels; 'none' gives label 1 to all cells, "
      "and reads named parts of a surface as one (default: label, medit:ref, gmsh:physical or "
      "MaterialIDs)");
}

void add_threshold_option(CLI::App& command, std::string& thresholds) {
  command.add_option("--threshold", thresholds,
                     "Labels of a gray image: thresholds like 100 or 80,160, or otsu, or otsu:2");
}

void require_file_with_arrays(const std::string& path, const std::string& labels) {
  const std::string file = with_user_names(path), format = extension(file);
  const bool has_parts = labels == "none" && (format == "stl" || format == "obj");
  if (!labels.empty() && format != "vtu" && !is_foreign(file) && !has_parts)
    throw Usage_error("--labels applies only to .vtu files and grids of other programs, and none "
                      "to .stl and .obj files; leave it out");
}

} // namespace dsc

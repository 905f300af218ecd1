// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_commands.h"

#include "continue_steps.h"
#include "errors.h"
#include "files.h"
#include "inequalities.h"
#include "option_values.h"
#include "velocity_expressions.h"

#include <algorithm>
#include <array>
#include <climits>
#include <optional>
#include <thread>

namespace dsc {
namespace {

// Where these flows are usually started.
const Ball ball_of_enright = {{.35, .35, .35}, .15};
const Ball ball_of_vortex = {{.5, .75, .5}, .15};
constexpr std::array<double, 6> unit_cube = {0, 0, 0, 1, 1, 1};

constexpr std::array<double, 6> unit_square = {0, 0, 0, 1, 1, 0},
                                square_of_zalesak = {0, 0, 0, 100, 100, 0};

constexpr double default_dt = .01, default_dt_of_zalesak = 1;

constexpr int most_threads = 1024;

unsigned number_of_cores() { // 0 if unknown
  return std::clamp(std::thread::hardware_concurrency(), 1u, unsigned(most_threads));
}

} // namespace

CLI::Option* add_labels_option(CLI::App& command, std::string& labels) {
  return command.add_option(
      "--labels", labels,
      "Name of the cell array of a .vtu file that holds the labels, or 'none' for label 1 "
      "everywhere; label, medit:ref, gmsh:physical or MaterialIDs if not given");
}

void require_file_with_arrays(const std::string& path, const std::string& labels) {
  if (!labels.empty() && extension(path) != "vtu")
    throw Usage_error("--labels has a meaning for .vtu files only; leave it out");
}

Run_commands::Run_commands(CLI::App& app) {
  m_options.threads = number_of_cores();
  m_rotate = add_command(app, "rotate", "Turn the interface about the domain's centre");
  m_rotate->add_option("--axis", m_axis,
                       "Direction of the axis, like 0,0,1; required for a new run in space");
  m_rotate->add_option("--angle", m_angle, "Degrees per step; required for a new run");

  m_offset = add_command(app, "offset", "Move the interface along its normals");
  m_offset->add_option("--distance", m_distance,
                       "Distance per step, positive outwards; 0.25e is a quarter of the mean "
                       "interface edge of the input; required for a new run");
  m_offset->add_flag("--move-faces", m_moves_faces,
                     "Move flat faces as a whole, so that edges become round or stay sharp");

  m_enright = add_command(app, "enright",
                          "Deform surfaces in the unit cube, or a ball if there is no INPUT, with "
                          "the flow of LeVeque and Enright");
  m_vortex = add_command(app, "vortex",
                         "Deform surfaces in the unit cube, or a ball if there is no INPUT, with a "
                         "single vortex about the z direction; in the plane, curves in the unit "
                         "square or, with --plane, a disk");
  m_vortex->add_flag("--plane", m_is_planar, "Without INPUT, deform a disk in the unit square");
  for (CLI::App* command : {m_enright, m_vortex}) {
    add_flow_options(*command);
    command->add_flag("--fit", m_fits, "Scale and move the surfaces into that ball");
  }

  m_advect = add_command(app, "advect", "Move the interface with any velocities");
  m_advect->add_option("--velocity", m_expressions,
                       "Three expressions in x, y, z and t like '-y,x,sin(pi*t)', in the "
                       "coordinates of the input, in the plane two; required for a new run");
  add_flow_options(*m_advect);

  m_mean_curvature = add_command(app, "mean-curvature", "Move the interface by its mean curvature");
  m_mean_curvature->add_option("--dt", m_dt,
                               "Time per step, in squares of the input's unit of length; the "
                               "square of its mean interface edge if not given");
  m_mean_curvature->add_flag("--keep-volumes", m_keeps_volumes,
                             "Keep the volume of each label but 0");
  add_tolerance_option(*m_mean_curvature);

  m_zalesak = add_command(app, "zalesak",
                          "Turn curves, or a slotted disk if there is no INPUT, about (50, 50) in "
                          "the square up to (100, 100), once in 628 units of time");
  m_zalesak->add_option("--dt", m_dt, "Time per step; 1 if not given");
}

CLI::App* Run_commands::add_command(CLI::App& app, const std::string& name,
                                    const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  CLI::Option* inputs = command->add_option(
      "INPUT", m_options.start.inputs,
      "Closed surfaces (.off, .obj, .ply, .stl), or in the plane polygons (.wkt), or inequalities "
      "like 'x^2+y^2+z^2<1' in the domain; they get the labels 1, 2 and so on. Or labelled "
      "tetrahedra (.mesh, .vtu), or an image of labels (.inr, .inr.gz), in the plane (.pgm, .png) "
      "or segments (.poly)");
  CLI::Option* resume = command->add_option("--resume", m_options.resume,
                                            "Continue the run of this checkpoint instead of an "
                                            "INPUT; options of its steps that are not given stay");
  resume->excludes(inputs);
  command->add_option("--steps", m_options.steps, "Number of steps to do in this run")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  command
      ->add_option("--triangles", m_options.start.triangles,
                   "Decimate or refine the surfaces to about so many triangles in total")
      ->check(CLI::Range(4, INT_MAX))
      ->excludes(resume);
  command
      ->add_option("--segments", m_options.start.segments,
                   "Divide curves in the plane into about so many segments in total, or more")
      ->check(CLI::Range(4, INT_MAX))
      ->excludes(resume);
  command
      ->add_option(
          "--domain", m_domain,
          "Box around all, by its least and its largest coordinates like -1,-1,-1,1,1,1, "
          "in the plane -1,-1,1,1; with ,grow behind it, or grow alone for the default box, "
          "it gets larger where the interface comes near its boundary")
      ->excludes(resume);
  command
      ->add_option("--edge", m_edge,
                   "About how long interface edges are to be, of inequalities and images; a "
                   "fortieth of the domain, or 2.5 voxels or pixels, if not given")
      ->excludes(resume);
  add_labels_option(*command, m_options.start.labels)->excludes(resume);
  CLI::Option* repairs =
      command
          ->add_flag("--repair", m_options.start.repairs,
                     "Make surfaces bound solids that do not: merge points, close T-junctions, "
                     "fill holes, unite parts that cross or, where that is not enough, wrap them")
          ->excludes(resume);
  command
      ->add_option("--largest-hole", m_largest_hole,
                   "Fill holes with borders up to this length, like 2.5 or, in mean edges of the "
                   "surface, 20e; 1.6 diagonals of the box around the part if not given")
      ->needs(repairs)
      ->excludes(resume);
  CLI::Option* improves =
      command->add_flag("--improve-interface", m_options.step.improves_interface,
                        "Improve the triangles of the interface before each step");
  command
      ->add_option("--aggressiveness", m_aggressiveness,
                   "How much that may smooth the interface, from 0 for not at all to less than 1; "
                   "0.025 if not given")
      ->needs(improves);
  command
      ->add_option("--threads", m_options.threads,
                   "Number of threads, all cores if not given; the result is the same")
      ->check(CLI::Range(1, most_threads));
  CLI::Option* output =
      command->add_option("--output", m_options.output,
                          "Folder for ParaView files and a checkpoint, created if need be");
  command
      ->add_option("--every", m_options.every,
                   "Write every so many steps; the last is always written")
      ->check(CLI::Range(1, INT_MAX))
      ->needs(output)
      ->capture_default_str();
  command
      ->add_option("--subdivide", m_options.subdivisions,
                   "Write a smooth surface (.ply) of each of these steps, too, in space: of four "
                   "triangles for each so many times, by Loop's scheme")
      ->check(CLI::Range(1, most_subdivisions))
      ->needs(output);
  command->add_option("--picture", m_options.picture,
                      "Picture of the interface in the end, in space (.png)");
  command->add_option("--report", m_options.report, "JSON file with what happened in each step");
  command->add_flag("--quiet", m_options.quiet,
                    "Print nothing but errors and where an interrupted run continues");
  return command;
}

void Run_commands::add_flow_options(CLI::App& command) {
  command.add_option("--period", m_period,
                     "Multiply velocities by cos(pi t / PERIOD), so that all is back after it");
  command.add_option("--dt", m_dt,
                     "Time per step; 0.01 if not given. The distance to the start is reported "
                     "where a step ends with a period");
  command.add_option("--scheme", m_scheme, "How velocities are integrated")
      ->check(CLI::IsMember(&integration_schemes()))
      ->capture_default_str();
  add_tolerance_option(command);
}

void Run_commands::add_tolerance_option(CLI::App& command) {
  command.add_option("--tolerance", m_tolerance,
                     "How far edges may lie from the smooth interface where it gets too coarse for "
                     "its curvature, in mean edges of the input; 0.04 in space and 0.005 in the "
                     "plane if not given; with 0, the interface is not "
                     "adapted to its curvature");
}

std::optional<double> Run_commands::tolerance(const std::set<std::string>& given) const {
  return given.count("--tolerance") > 0 ? std::make_optional(parse_tolerance(m_tolerance))
                                        : std::nullopt;
}

Advection Run_commands::advection(Advection::Field field, const std::set<std::string>& given,
                                  double default_period) const {
  return {field,
          m_expressions,
          given.count("--period") > 0 ? parse_positive(m_period, "--period") : default_period,
          given.count("--dt") > 0 ? parse_positive(m_dt, "--dt") : default_dt,
          integration_schemes().at(m_scheme),
          tolerance(given)};
}

/// What is not given is as by default or, where there is no default, of no meaning.
Motion Run_commands::motion(const std::set<std::string>& given) const {
  if (*m_rotate)
    return Rotation{given.count("--axis") > 0 ? parse_axis(m_axis) : std::array<double, 3>(),
                    given.count("--angle") > 0 ? parse_angle(m_angle) : 0};
  if (*m_offset)
    return Offset{given.count("--distance") > 0 ? parse_distance(m_distance) : Distance(),
                  m_moves_faces};
  if (*m_enright)
    return advection(Advection::Field::enright, given, 1);
  if (*m_vortex)
    return advection(Advection::Field::vortex, given, 8);
  if (*m_advect) {
    if (given.count("--velocity") > 0 && m_options.resume.empty())
      const Velocity_expressions check(m_expressions, dimension_of(m_options.start));
    return advection(Advection::Field::expressions, given, 0);
  }
  if (*m_zalesak)
    return Zalesak{given.count("--dt") > 0 ? parse_positive(m_dt, "--dt") : default_dt_of_zalesak};
  return Curvature_flow{given.count("--dt") > 0 ? parse_positive(m_dt, "--dt") : 0, m_keeps_volumes,
                        tolerance(given)};
}

/// What has a meaning in one dimension only is refused in the other.
void Run_commands::require_dimension(const Run_options& options, bool is_planar) const {
  const auto is_given = [&](const char* name) { return options.given.count(name) > 0; };
  if (is_planar && *m_enright)
    throw Usage_error("dsc enright deforms surfaces; in the plane, use dsc vortex");
  if (!is_planar && *m_zalesak)
    throw Usage_error("dsc zalesak turns curves in the plane; for surfaces, use dsc rotate");
  for (const char* name :
       {"--axis", "--move-faces", "--fit", "--triangles", "--repair", "--largest-hole"})
    if (is_planar && is_given(name))
      throw Usage_error(std::string(name) + " has no meaning in the plane; leave it out");
  for (const char* name : {"--segments", "--plane"})
    if (!is_planar && is_given(name))
      throw Usage_error(std::string(name) + " has a meaning in the plane only; leave it out");
  const std::string format = options.start.inputs.empty() ? "" : extension(options.start.inputs[0]);
  if ((format == "pgm" || format == "png") && is_given("--segments"))
    throw Usage_error("--segments has no effect on an image of pixels; leave it out");
  if (!is_planar && *m_rotate && !is_given("--axis"))
    throw Usage_error("--axis is required; see dsc rotate --help");
}

/// What has a meaning for some kinds of inputs only is refused for the others.
void Run_commands::require_kind(const Run_options& options, bool is_planar) const {
  const Input_kind kind = input_kind(options.start);
  const auto is_given = [&](const char* name) { return options.given.count(name) > 0; };
  const std::string format =
      options.start.inputs.empty() ? "" : extension(options.start.inputs.front());
  const bool has_edge = kind == Input_kind::inequalities || kind == Input_kind::image ||
                        format == "pgm" || format == "png";
  if (is_given("--edge") && !has_edge)
    throw Usage_error("--edge has a meaning for inequalities and images only; leave it "
                      "out");
  if (is_given("--labels"))
    require_file_with_arrays(options.start.inputs.empty() ? "" : options.start.inputs.front(),
                             options.start.labels);
  if (is_planar || kind == Input_kind::surfaces) {
    for (const std::string& input : options.start.inputs)
      if (input_kind(input) != Input_kind::surfaces)
        throw Usage_error(input + " cannot be mixed with other kinds of INPUT");
    return;
  }
  for (const char* name : {"--triangles", "--fit", "--repair", "--largest-hole"})
    if (is_given(name))
      throw Usage_error(std::string(name) + " has a meaning for surfaces only; leave it out");
  if (kind == Input_kind::inequalities) {
    for (const std::string& input : options.start.inputs)
      if (input_kind(input) != kind)
        throw Usage_error(input + " is no inequality and cannot be mixed with them");
    const Inequalities check(options.start.inputs);
    if (!options.domain && !*m_enright && !*m_vortex)
      throw Usage_error("inequalities need a box to hold in; give its least and its largest "
                        "coordinates by --domain");
  } else if (options.start.inputs.size() > 1)
    throw Usage_error("there is more than one INPUT, but tetrahedra and images hold all labels "
                      "themselves; give a single one");
}

Run_options Run_commands::options() const {
  Run_options options = m_options;
  for (const CLI::App* command :
       {m_rotate, m_offset, m_enright, m_vortex, m_advect, m_mean_curvature, m_zalesak})
    for (const CLI::Option* option : command->get_options())
      if (option->count() > 0)
        options.given.insert(option->get_name());
  const bool is_new = options.resume.empty(), has_input = !options.start.inputs.empty();
  if (is_new && !has_input && *m_zalesak)
    options.start.figure = Figure::slotted_disk;
  if (is_new && !has_input && *m_vortex && m_is_planar)
    options.start.figure = Figure::disk;
  const bool is_planar = is_new && dimension_of(options.start) == 2;
  options.step.motion = motion(options.given);
  if (options.given.count("--domain") > 0) {
    std::string domain = m_domain;
    options.step.grows_domain = take_growth(domain);
    if (!domain.empty() || !options.step.grows_domain)
      options.domain = parse_domain(domain, is_planar ? 2 : 3);
  }
  if (options.given.count("--aggressiveness") > 0)
    options.step.aggressiveness = parse_aggressiveness(m_aggressiveness);
  if (is_new) {
    require_options(options.step.motion, options.given);
    require_effect_of_options(options.step, options.given);
  }

  const bool has_ball = (*m_enright || *m_vortex) && !is_planar;
  if (is_new && !has_input && !has_ball && !is_planar)
    throw Usage_error("there is no INPUT; name at least one surface, or a checkpoint by --resume");
  if (!has_input && m_fits)
    throw Usage_error("--fit has nothing to fit; name at least one INPUT");
  if (m_is_planar && (has_input || !is_new))
    throw Usage_error("--plane has no effect with an INPUT or --resume; leave it out");
  if (!has_input && options.start.repairs)
    throw Usage_error("--repair has nothing to repair; name at least one INPUT");
  for (const std::string& input : options.start.inputs)
    if (is_planar)
      require_extension(input, {"wkt", "poly", "pgm", "png"});
    else if (input_kind(options.start) != Input_kind::inequalities)
      require_extension(input, {"off", "obj", "ply", "stl", "mesh", "vtu", "inr", "gz", "wkt",
                                "poly", "pgm", "png"});
  if (is_new) {
    require_dimension(options, is_planar);
    require_kind(options, is_planar);
  }
  if (options.given.count("--largest-hole") > 0)
    options.start.largest_hole = parse_length(m_largest_hole, "--largest-hole");
  if (options.given.count("--edge") > 0)
    options.start.edge = parse_positive(m_edge, "--edge");
  if (is_new && has_ball) {
    if (m_fits || !has_input)
      options.start.ball = *m_enright ? ball_of_enright : ball_of_vortex;
    if (!options.domain)
      options.domain = unit_cube;
  }
  if (is_planar && !options.domain && (*m_vortex || *m_zalesak))
    options.domain = *m_vortex ? unit_square : square_of_zalesak;
  return options;
}

} // namespace dsc

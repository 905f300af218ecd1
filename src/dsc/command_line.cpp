// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "errors.h"
#include "files.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <initializer_list>
#include <iostream>
#include <string>

namespace dsc {
namespace {

/// The number that `text` starts with; moves `text` behind it.
double take_number(std::string& text, const std::string& option) {
  if (!text.empty() && text[0] == '+')
    text.erase(0, 1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || !std::isfinite(number))
    throw Usage_error(option + " needs a finite number, not '" + text +
                      "'; write it like 1, -0.5 or 2e-3");
  text.erase(0, rest - text.data());
  return number;
}

void require_end(const std::string& text, const std::string& option, const std::string& form) {
  if (!text.empty())
    throw Usage_error(option + " does not end before '" + text + "'; write it like " + form);
}

std::array<double, 3> parse_axis(std::string text) {
  const std::string option = "--axis", form = "0,0,1";
  std::array<double, 3> axis;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) {
      if (text.empty() || text[0] != ',')
        throw Usage_error("--axis needs three numbers; write it like " + form);
      text.erase(0, 1);
    }
    axis[i] = take_number(text, option);
  }
  require_end(text, option, form);
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (!(length > 0) || !std::isfinite(length))
    throw Usage_error("--axis has no direction; write one of a finite length above zero like " +
                      form);
  return axis;
}

double parse_angle(std::string text) {
  const double angle = take_number(text, "--angle");
  require_end(text, "--angle", "7.2");
  return angle;
}

double parse_threshold(std::string text) {
  const std::string option = "--threshold";
  const double threshold = take_number(text, option);
  require_end(text, option, "0.4");
  if (!(0 < threshold && threshold <= 1))
    throw Usage_error("--threshold is not a quality; choose one above 0 and up to 1");
  return threshold;
}

Offset parse_distance(std::string text) {
  Offset offset;
  offset.distance = take_number(text, "--distance");
  offset.in_mean_edges = text == "e";
  if (offset.in_mean_edges)
    text.clear();
  require_end(text, "--distance", "0.1 or 0.25e");
  return offset;
}

void require_extension(const std::string& path, const std::initializer_list<const char*>& known) {
  const std::string found = extension(path);
  if (std::find(known.begin(), known.end(), found) != known.end())
    return;
  std::string list;
  for (const char* name : known)
    list += std::string(list.empty() ? "." : ", .") + name;
  throw Usage_error("the extension of '" + path + "' is unknown; use one of " + list);
}

void add_run_options(CLI::App& command, Run_options& options) {
  CLI::Option* inputs = command.add_option(
      "INPUT", options.inputs,
      "Closed surfaces (.off, .obj, .ply, .stl); they get the labels 1, 2 and so on");
  CLI::Option* resume = command.add_option("--resume", options.resume,
                                           "Continue from this checkpoint instead of an INPUT");
  resume->excludes(inputs);
  command.add_option("--steps", options.steps, "Number of steps to do in this run")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  command
      .add_option("--triangles", options.triangles,
                  "Decimate or refine the surfaces to about so many triangles in total")
      ->check(CLI::Range(4, INT_MAX))
      ->excludes(resume);
  command.add_option("--threads", options.threads, "Number of threads; the result is the same")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  CLI::Option* output = command.add_option(
      "--output", options.output, "Folder for ParaView files and a checkpoint, created if need be");
  command
      .add_option("--every", options.every, "Write every so many steps; the last is always written")
      ->check(CLI::Range(1, INT_MAX))
      ->needs(output)
      ->capture_default_str();
  command.add_option("--report", options.report, "JSON file with what happened in each step");
  command.add_flag("--quiet", options.quiet, "Print nothing but errors");
}

void check_run_options(const Run_options& options) {
  if (options.inputs.empty() && options.resume.empty())
    throw Usage_error("there is no INPUT; name at least one surface, or a checkpoint by --resume");
  for (const std::string& input : options.inputs)
    require_extension(input, {"off", "obj", "ply", "stl"});
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

} // namespace

std::optional<Options> parse_command_line(int argc, char** argv) {
  CLI::App app("Deformable simplicial complexes: moving interfaces with topology changes", "dsc");
  app.require_subcommand(1);

  Info_options info_options;
  CLI::App* info = app.add_subcommand("info", "Print what a file holds, in numbers");
  info->add_option(
          "FILE", info_options.file,
          "A surface (.off, .obj, .ply, .stl), a checkpoint (.dsc) or a mesh (.mesh, .vtu)")
      ->required();

  Run_options run_options;
  std::string axis, angle, distance;
  CLI::App* rotate = app.add_subcommand("rotate", "Turn the interface about the domain's centre");
  rotate->add_option("--axis", axis, "Direction of the axis, like 0,0,1")->required();
  rotate->add_option("--angle", angle, "Degrees per step")->required();
  add_run_options(*rotate, run_options);
  CLI::App* offset = app.add_subcommand("offset", "Move the interface along its normals");
  offset
      ->add_option("--distance", distance,
                   "Distance per step, positive outwards; 0.25e is a quarter of the mean "
                   "interface edge of the input")
      ->required();
  add_run_options(*offset, run_options);

  Convert_options convert_options;
  CLI::App* convert = app.add_subcommand("convert", "Write a checkpoint in another format");
  convert->add_option("CHECKPOINT", convert_options.checkpoint, "File to read")->required();
  convert
      ->add_option("OUT", convert_options.output,
                   "Interface (.off, .obj, .ply, .stl) or tetrahedra (.vtu, .mesh)")
      ->required();
  convert->add_flag("--quiet", convert_options.quiet, "Print nothing but errors");

  Improve_options improve_options;
  std::string threshold;
  CLI::App* improve = app.add_subcommand(
      "improve", "Improve the tetrahedra between the interface and the boundary");
  improve->add_option("INPUT", improve_options.input, "Labelled tetrahedra (.mesh, .vtu)")
      ->required();
  improve
      ->add_option("-o,--output", improve_options.output,
                   "File for the improved tetrahedra (.mesh, .vtu); may be INPUT")
      ->required();
  improve->add_flag("--aggressive", improve_options.aggressive,
                    "Take minutes instead of seconds for better tetrahedra");
  improve->add_option("--threshold", threshold,
                      "Improve tetrahedra of a lower quality only: the least sine of a dihedral "
                      "angle, obtuse ones times 0.7, in units of the regular tetrahedron");
  improve->add_option("--report", improve_options.report,
                      "JSON file with the state before and after");
  improve->add_flag("--quiet", improve_options.quiet, "Print nothing but errors");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    std::string command = "dsc";
    for (const CLI::App* chosen : app.get_subcommands())
      command += " " + chosen->get_name();
    throw Usage_error(one_line(error.what()) + "; see " + command + " --help");
  }

  if (*info) {
    require_extension(info_options.file, {"off", "obj", "ply", "stl", "dsc", "mesh", "vtu"});
    return info_options;
  }
  if (*convert) {
    require_extension(convert_options.output, {"off", "obj", "ply", "stl", "vtu", "mesh"});
    return convert_options;
  }
  if (*improve) {
    require_extension(improve_options.input, {"mesh", "vtu"});
    require_extension(improve_options.output, {"mesh", "vtu"});
    if (improve->count("--threshold") > 0)
      improve_options.threshold = parse_threshold(threshold);
    return improve_options;
  }
  if (*rotate)
    run_options.motion = Rotation{parse_axis(axis), parse_angle(angle)};
  else
    run_options.motion = parse_distance(distance);
  check_run_options(run_options);
  return run_options;
}

} // namespace dsc

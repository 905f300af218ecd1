// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "errors.h"
#include "option_values.h"
#include "run_commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <string>

namespace dsc {
namespace {

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
          "A surface (.off, .obj, .ply, .stl), a figure in the plane (.wkt, .poly, .pgm), a "
          "checkpoint (.dsc) or a mesh (.mesh, .vtu)")
      ->required();

  Run_commands run_commands(app);

  Convert_options convert_options;
  CLI::App* convert = app.add_subcommand("convert", "Write a checkpoint in another format");
  convert->add_option("CHECKPOINT", convert_options.checkpoint, "File to read")->required();
  convert
      ->add_option(
          "OUT", convert_options.output,
          "Interface (.off, .obj, .ply, .stl) or tetrahedra (.vtu, .mesh); in the plane regions "
          "(.wkt, .poly), a picture (.svg) or triangles (.vtu)")
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
    require_extension(info_options.file,
                      {"off", "obj", "ply", "stl", "wkt", "poly", "pgm", "dsc", "mesh", "vtu"});
    return info_options;
  }
  if (*convert) {
    require_extension(convert_options.output,
                      {"off", "obj", "ply", "stl", "vtu", "mesh", "wkt", "poly", "svg"});
    return convert_options;
  }
  if (*improve) {
    require_extension(improve_options.input, {"mesh", "vtu"});
    require_extension(improve_options.output, {"mesh", "vtu"});
    if (improve->count("--threshold") > 0)
      improve_options.threshold = parse_threshold(threshold);
    return improve_options;
  }
  return run_commands.options();
}

} // namespace dsc

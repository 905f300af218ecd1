// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "errors.h"
#include "files.h"
#include "nearest_name.h"
#include "option_values.h"
#include "run_commands.h"
#include "surface_expressions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <climits>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace dsc {
namespace {

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void require_surface_to_subdivide(const std::string& path) {
  const std::string format = extension(path);
  if (format != "off" && format != "obj" && format != "ply" && format != "stl")
    throw Usage_error("--subdivide has a meaning for surfaces only (.off, .obj, .ply, .stl); leave "
                      "it out, or choose one of these for OUT");
}

/// The commands, or with `-` in front the options, that an app knows.
std::vector<std::string> known_names(const CLI::App& app, bool are_options) {
  std::vector<std::string> result;
  if (are_options)
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames())
        result.push_back("--" + name);
  else
    for (const CLI::App* command : app.get_subcommands(nullptr))
      result.push_back(command->get_name());
  return result;
}

/// The nearest name to the first command or option that is not known; empty if all are known, or no
/// name is near.
std::string advice_on_arguments(const CLI::App& app, int argc, char** argv) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('='));
    if (argument.rfind("-", 0) == 0 && argument.rfind("--", 0) != 0 &&
        argument.find_first_of("<>") != std::string::npos)
      return "; write an inequality that begins with '-' in parentheses, like '(-x)<1'";
    const bool is_option = name.rfind("--", 0) == 0 && name.size() > 2;
    if (!is_option && (i > 1 || !chosen.empty()))
      continue;
    const std::vector<std::string> known = known_names(command, is_option);
    if (std::find(known.begin(), known.end(), name) != known.end())
      continue;
    const std::string nearest = nearest_name(name, known);
    return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
  }
  return "";
}

/// A ball may be all on a surface that does not repeat itself.
void require_periods(const Cut_locus_options& options, bool are_given) {
  if (options.surface == "torus")
    return;
  const bool is_ellipsoid = options.surface == "ellipsoid";
  if (is_ellipsoid && !are_given)
    return;
  if (is_ellipsoid || Surface_expressions(options.surface).is_of_sphere()) {
    if (are_given)
      throw Usage_error("--periods has a meaning for a surface in u and v only; leave it out");
  } else if (options.radius == 0 &&
             !Surface_expressions(options.surface).repeats_after(options.periods))
    throw Usage_error("the surface '" + options.surface +
                      "' does not repeat itself after the periods; choose others by --periods");
}

/// Scenes are named or printed without anything else.
void require_alone(const CLI::App& command, const std::vector<std::string>& names) {
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 &&
        std::find(names.begin(), names.end(), option->get_name()) == names.end())
      throw Usage_error(option->get_name() + " has no effect with " + names.front() +
                        "; leave it out");
}

} // namespace

std::optional<Options> parse_command_line(int argc, char** argv) {
  CLI::App app("Deformable simplicial complexes: moving interfaces with topology changes", "dsc");
  app.require_subcommand(1);

  Info_options info_options;
  CLI::App* info = app.add_subcommand("info", "Print what a file holds, in numbers");
  info->add_option(
          "FILE", info_options.file,
          "A surface (.off, .obj, .ply, .stl), a figure in the plane (.wkt, .poly, .pgm, .png), a "
          "checkpoint (.dsc) or a mesh (.mesh, .vtu)")
      ->required();

  add_labels_option(*info, info_options.labels);

  Run_commands run_commands(app);

  Convert_options convert_options;
  CLI::App* convert = app.add_subcommand("convert", "Write a checkpoint in another format");
  convert->add_option("CHECKPOINT", convert_options.checkpoint, "File to read")->required();
  convert
      ->add_option("OUT", convert_options.output,
                   "Interface (.off, .obj, .ply, .stl), its picture (.png) or tetrahedra (.vtu, "
                   ".mesh); in the "
                   "plane regions "
                   "(.wkt, .poly), a picture (.svg) or triangles (.vtu)")
      ->required();
  convert
      ->add_option(
          "--subdivide", convert_options.subdivisions,
          "Divide each triangle of the interface into four so many times, by Loop's scheme, "
          "which makes it smooth")
      ->check(CLI::Range(1, most_subdivisions));
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
  add_labels_option(*improve, improve_options.labels);
  improve->add_flag("--aggressive", improve_options.aggressive,
                    "Take minutes instead of seconds for better tetrahedra");
  improve->add_option("--threshold", threshold,
                      "Improve tetrahedra of a lower quality only: the least sine of a dihedral "
                      "angle, obtuse ones times 0.7, in units of the regular tetrahedron");
  improve->add_option("--report", improve_options.report,
                      "JSON file with the state before and after");
  improve->add_flag("--quiet", improve_options.quiet, "Print nothing but errors");

  Cut_locus_options cut_locus_options;
  std::string point, periods = "6.283185307179586,6.283185307179586", spacing, step, radius;
  CLI::App* cut_locus = app.add_subcommand(
      "cut-locus", "Find where the shortest ways end that begin in a point of a surface");
  cut_locus
      ->add_option(
          "--surface", cut_locus_options.surface,
          "'torus', of the radii 2 and 1, 'ellipsoid', of the half axes 1, 0.8 and 0.6, or the "
          "three coordinates as expressions: in u and v, as of a torus, like "
          "'(2+cos(v))*cos(u),(2+cos(v))*sin(u),2*sin(v)', or in x, y and z, those of the unit "
          "sphere, like 'x,y,z*(1+0.2*x)'")
      ->capture_default_str();
  cut_locus
      ->add_option("--point", point,
                   "u and v of the point, like 0,0.3; its direction, like 1,0.5,0, for a "
                   "surface in x, y and z")
      ->required();
  cut_locus->add_option("--periods", periods,
                        "after which a surface in u and v repeats itself; 2 pi each if not given");
  cut_locus->add_option(
      "--spacing", spacing,
      "Length of edges in u and v; a fortieth of a period if not given; 0.1 for a "
      "surface in x, y and z, whose chart is 8 wide");
  cut_locus->add_option("--radius", radius,
                        "Draw the ball of this radius instead, as seen in u and v");
  cut_locus->add_option("--step", step,
                        "By how much the front of all ways advances at once; half "
                        "the spacing, as long as that is on the surface, if not given");
  cut_locus->add_option(
      "-o,--output", cut_locus_options.output,
      "Picture in u and v, or of what is opposite to the point of a surface in x, y and "
      "z (.svg); of a ball its triangles, too (.vtu)");
  cut_locus->add_option("--report", cut_locus_options.report,
                        "JSON file with points, distances and arcs");
  cut_locus->add_flag("--quiet", cut_locus_options.quiet, "Print nothing but errors");

  Reconstruct_options reconstruct_options;
  std::string tolerance = "0.03";
  CLI::App* reconstruct =
      app.add_subcommand("reconstruct", "Find the solid whose surface points sample");
  reconstruct
      ->add_option("POINTS", reconstruct_options.input,
                   "Points, with or without normals (.xyz, .pwn, .ply, .off)")
      ->required();
  reconstruct
      ->add_option("-o", reconstruct_options.output,
                   "Surface (.off, .obj, .ply, .stl) or tetrahedra (.vtu, .mesh)")
      ->required();
  reconstruct
      ->add_option("--tolerance", tolerance,
                   "How far triangles may be from their points, in mean distances of a point from "
                   "its neighbors")
      ->capture_default_str();
  reconstruct->add_flag("--open", reconstruct_options.keeps_open,
                        "Accept points of an open sheet, and write the triangles that have points");
  reconstruct->add_option("--steps", reconstruct_options.steps, "Number of steps at the most")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  reconstruct
      ->add_option("--threads", reconstruct_options.threads,
                   "Number of threads; the result is the same")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  reconstruct->add_option("--output", reconstruct_options.folder,
                          "Folder for the steps, to be shown with ParaView");
  reconstruct->add_option("--report", reconstruct_options.report,
                          "JSON file with distances, parts, and what fits nothing");
  reconstruct->add_option("--picture", reconstruct_options.picture,
                          "Picture of the surface (.png)");
  reconstruct->add_flag("--quiet", reconstruct_options.quiet, "Print nothing but errors");

  Fluid_options fluid_options;
  std::string end;
  fluid_options.threads = std::max(1U, std::thread::hardware_concurrency());
  CLI::App* fluid = app.add_subcommand("fluid", "Compute the flow of liquids with free surfaces");
  fluid->add_option("SCENE", fluid_options.scene, "Scene (.json), or the name of one: see --list");
  fluid->add_flag("--list", fluid_options.lists, "Name the scenes that the program has");
  fluid->add_flag("--print", fluid_options.prints, "Print the scene, to be edited");
  fluid->add_option("--data", fluid_options.data, "Folder of the files that the scene names");
  fluid->add_option("--end", end, "Time of the end; that of the scene if not given");
  fluid->add_option("--steps", fluid_options.steps, "Number of steps at the most")
      ->check(CLI::Range(1, INT_MAX));
  fluid
      ->add_option("--threads", fluid_options.threads,
                   "Number of threads (default: all cores); the result is the same")
      ->check(CLI::Range(1, 1024));
  CLI::Option* fluid_output =
      fluid->add_option("--output", fluid_options.output,
                        "Folder for the steps, to be shown with ParaView, and the checkpoint");
  fluid
      ->add_option("--subdivide", fluid_options.subdivisions,
                   "Write a smooth surface (.ply) of each of these steps, too: of four triangles "
                   "for each so many times, by Loop's scheme")
      ->check(CLI::Range(1, most_subdivisions))
      ->needs(fluid_output);
  fluid->add_option("--every", fluid_options.every, "Write each of so many steps")
      ->check(CLI::Range(1, INT_MAX))
      ->needs(fluid_output)
      ->capture_default_str();
  fluid->add_option("--resume", fluid_options.resume, "Go on from a checkpoint, to the same bits");
  fluid->add_option("--report", fluid_options.report,
                    "JSON file with energies, momenta, volumes and contacts of each step");
  fluid->add_option("--picture", fluid_options.picture, "Picture of the liquids in the end (.png)");
  fluid->add_flag("--quiet", fluid_options.quiet, "Print nothing but errors");

  if (argc < 2) {
    std::cout << app.help();
    return std::nullopt;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    std::string command = "dsc";
    for (const CLI::App* chosen : app.get_subcommands())
      command += " " + chosen->get_name();
    throw Usage_error(one_line(error.what()) + advice_on_arguments(app, argc, argv) + "; see " +
                      command + " --help");
  }

  if (*info) {
    require_extension(info_options.file, {"off", "obj", "ply", "stl", "wkt", "poly", "pgm", "png",
                                          "dsc", "mesh", "vtu"});
    require_file_with_arrays(info_options.file, info_options.labels);
    return info_options;
  }
  if (*convert) {
    require_extension(convert_options.output,
                      {"off", "obj", "ply", "stl", "vtu", "mesh", "wkt", "poly", "svg", "png"});
    if (convert_options.subdivisions > 0)
      require_surface_to_subdivide(convert_options.output);
    return convert_options;
  }
  if (*improve) {
    require_extension(improve_options.input, {"mesh", "vtu"});
    require_extension(improve_options.output, {"mesh", "vtu"});
    require_file_with_arrays(improve_options.input, improve_options.labels);
    if (improve->count("--threshold") > 0)
      improve_options.threshold = parse_threshold(threshold);
    return improve_options;
  }
  if (*cut_locus) {
    cut_locus_options.point = parse_point(point);
    cut_locus_options.periods = parse_pair(periods, "--periods");
    if (cut_locus->count("--spacing") > 0)
      cut_locus_options.spacing = parse_positive(spacing, "--spacing");
    if (cut_locus->count("--step") > 0)
      cut_locus_options.step = parse_positive(step, "--step");
    if (cut_locus->count("--radius") > 0)
      cut_locus_options.radius = parse_positive(radius, "--radius");
    require_periods(cut_locus_options, cut_locus->count("--periods") > 0);
    if (!cut_locus_options.output.empty() && cut_locus_options.radius > 0)
      require_extension(cut_locus_options.output, {"svg", "vtu"});
    else if (!cut_locus_options.output.empty())
      require_extension(cut_locus_options.output, {"svg"});
    return cut_locus_options;
  }
  if (*reconstruct) {
    require_extension(reconstruct_options.input, {"xyz", "pwn", "ply", "off"});
    require_extension(reconstruct_options.output, {"off", "obj", "ply", "stl", "vtu", "mesh"});
    if (!reconstruct_options.picture.empty())
      require_extension(reconstruct_options.picture, {"png"});
    if (reconstruct_options.keeps_open) {
      require_extension(reconstruct_options.output, {"off", "obj", "ply", "stl"});
      if (!reconstruct_options.picture.empty())
        throw Usage_error("--picture draws closed surfaces only; leave it out, or --open");
    }
    reconstruct_options.tolerance = parse_positive(tolerance, "--tolerance");
    return reconstruct_options;
  }
  if (*fluid) {
    if (fluid_options.lists)
      require_alone(*fluid, {"--list"});
    if (fluid_options.prints)
      require_alone(*fluid, {"--print", "SCENE"});
    if (!fluid_options.picture.empty())
      require_extension(fluid_options.picture, {"png"});
    if (fluid->count("--end") > 0)
      fluid_options.end = parse_positive(end, "--end");
    if (!fluid_options.lists && fluid_options.scene.empty() == fluid_options.resume.empty())
      throw Usage_error("dsc fluid needs a SCENE or --resume, and not both; dsc fluid --list names "
                        "scenes");
    if (fluid_options.prints && fluid_options.scene.empty())
      throw Usage_error("dsc fluid --print needs a SCENE");
    return fluid_options;
  }
  return run_commands.options();
}

} // namespace dsc

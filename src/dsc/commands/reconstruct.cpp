// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/translations.h"
#include "motions/tracked_complex_3.h"
#include "output/progress_line.h"
#include "output/report_json.h"
#include "output/step_folder.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_sheet_3.h>

#include <CGAL/Mesh_files/point_set_3.h>
#include <CGAL/Solid_reconstruction_3/compiled_3.h>

#include <climits>

namespace dsc {
namespace {

namespace parameters = CGAL::parameters;
using CGAL::IO::Point_and_normal_3;
using Complex = Tracked_complex_3::Complex;
using Reconstruction_report = DSC::Reconstruction_report_3<Complex>;

/// Options of the command `reconstruct`.
struct Reconstruct_options
{
  std::string input;      ///< point file
  std::string output;     ///< file of a surface or of tetrahedra
  double tolerance = .03; ///< in units of the point spacing
  bool is_open = false;   ///< whether the points sample an open sheet
  unsigned steps = 80;    ///< maximum number
  unsigned threads = default_number_of_threads();
  std::string folder;  ///< output folder of the steps; empty for none
  std::string report;  ///< file; empty for none
  std::string picture; ///< file; empty for none
  bool quiet = false;
};

Json json_of(const Reconstruction_report& report, const Complex& complex) {
  Json facets = Json::array();
  for (const auto& f : report.facets_without_points) {
    Json facet = Json::array();
    for (const auto v : complex.facet_vertices(f)) {
      const auto p = complex.user_position(v);
      facet.push_back({p.x(), p.y(), p.z()});
    }
    facets.push_back(facet);
  }
  Json doubtful_places = Json::array();
  for (const auto& p : report.doubtful_places)
    doubtful_places.push_back({p.x(), p.y(), p.z()});
  return {{"points", report.number_of_points},
          {"duplicates", report.number_of_duplicates},
          {"outliers", report.number_of_outliers},
          {"spacing", report.spacing},
          {"noise", report.noise},
          {"steps", report.number_of_steps},
          {"is_complete", report.is_complete},
          {"split", report.changes.split},
          {"collapsed", report.changes.collapsed},
          {"flipped", report.changes.flipped},
          {"smoothed", report.changes.smoothed},
          {"inserted", report.changes.inserted},
          {"relabeled", report.relabeled},
          {"topology_changes", report.topology_changes},
          {"held_back", report.held_back},
          {"root_mean_square", report.root_mean_square},
          {"maximum_distance", report.maximum_distance},
          {"unfit_points", report.unfit_points},
          {"doubtful_places", doubtful_places},
          {"facets_without_points", facets}};
}

/// Removes points that are not finite: organized clouds contain one for each ray without a point.
void leave_out_points(std::vector<Point_and_normal_3>& points, Unused_content& unused) {
  const auto end = std::remove_if(points.begin(), points.end(), [](const auto& p) {
    return !(std::isfinite(p.first.x()) && std::isfinite(p.first.y()) &&
             std::isfinite(p.first.z()));
  });
  const auto number = std::size_t(points.end() - end);
  unused.add(noun(number, "point that is not finite", "points that are not finite"), number);
  points.erase(end, points.end());
}

std::size_t number_of_normals(const std::vector<Point_and_normal_3>& points) {
  return std::size_t(std::count_if(points.begin(), points.end(),
                                   [](const auto& p) { return p.second != CGAL::NULL_VECTOR; }));
}

/// Prints a warning if parts of the surface are not sampled by points.
void warn_of_openness(const Reconstruction_report& report, std::size_t triangles) {
  static constexpr double many = .1; // of the triangles
  const std::size_t n = report.facets_without_points.size();
  if (double(n) > many * double(triangles))
    std::fprintf(
        stderr,
        "dsc: %zu of %zu triangles have no points: if the points sample an open surface, use "
        "--open\n",
        n, triangles);
}

/// Prints why the result is not complete. Returns the exit code.
int tell_completeness(const Reconstruction_report& report) {
  if (report.is_complete)
    return 0;
  if (report.doubtful_places.empty()) {
    std::fprintf(stderr,
                 "dsc: not complete: the surface still moves after %zu %s; use more --steps\n",
                 report.number_of_steps, noun(report.number_of_steps, "step", "steps"));
    return 1;
  }
  const auto& p = report.doubtful_places.front();
  std::fprintf(stderr,
               "dsc: not complete: the surface contradicts the points at %zu %s, such as (%.6g, "
               "%.6g, %.6g): a tunnel or component is missing or extra; add points there\n",
               report.doubtful_places.size(),
               noun(report.doubtful_places.size(), "place", "places"), p.x(), p.y(), p.z());
  return 1;
}

void print_summary(const Reconstruction_report& report, std::size_t normals,
                   const Statistics& statistics, double seconds) {
  const Label_statistics& solid = statistics.labels.back();
  std::printf(
      "dsc: %zu points, %zu %s, %zu %s used, %zu triangles, %zu %s, Euler characteristic %d; "
      "distances of points: root mean square %.3g, maximum %.3g (spacing %.3g); %zu unfit %s, %zu "
      "%s without points; %.3g s\n",
      report.number_of_points, report.number_of_outliers,
      noun(report.number_of_outliers, "outlier", "outliers"), normals,
      noun(normals, "normal", "normals"), statistics.interface_facets, solid.components,
      noun(solid.components, "component", "components"), solid.euler_characteristic,
      report.root_mean_square, report.maximum_distance, report.spacing, report.unfit_points.size(),
      noun(report.unfit_points.size(), "point", "points"), report.facets_without_points.size(),
      noun(report.facets_without_points.size(), "triangle", "triangles"), seconds);
}

void write_report(const Reconstruct_options& options, const Reconstruction_report& report,
                  const Tracked_complex_3& tracked, std::size_t normals, double seconds) {
  Json json = {{"input", options.input}, {"seconds", seconds}};
  json.update(json_of(report, tracked.complex));
  json["normals"] = normals;
  json["state"] = statistics_json(tracked.statistics());
  write_json(options.report, json);
}

using DSC::Reconstructed_sheet_3;
using DSC::Sheet_report_3;

void write_sheet(const std::string& path, const Reconstructed_sheet_3& sheet) {
  DSC::Interface_surface_3<Tracked_complex_3::Complex> surface;
  for (const auto& p : sheet.points)
    surface.points.emplace_back(p.x(), p.y(), p.z());
  surface.triangles = sheet.triangles;
  CGAL::IO::write_interface(path, surface);
}

void write_report(const Reconstruct_options& options, const Sheet_report_3& report,
                  const Reconstructed_sheet_3& sheet, double seconds) {
  Json doubtful_places = Json::array();
  for (const auto& p : report.doubtful_places)
    doubtful_places.push_back({p.x(), p.y(), p.z()});
  write_json(options.report, {{"input", options.input},
                              {"seconds", seconds},
                              {"points", report.number_of_points},
                              {"duplicates", report.number_of_duplicates},
                              {"outliers", report.number_of_outliers},
                              {"spacing", report.spacing},
                              {"noise", report.noise},
                              {"triangles", sheet.triangles.size()},
                              {"components", report.number_of_components},
                              {"euler_characteristic", report.euler_characteristic},
                              {"boundaries", report.number_of_boundaries},
                              {"boundary_length", report.boundary_length},
                              {"is_orientable", report.is_orientable},
                              {"is_complete", report.is_complete},
                              {"root_mean_square", report.root_mean_square},
                              {"maximum_distance", report.maximum_distance},
                              {"unfit_points", report.unfit_points},
                              {"doubtful_places", doubtful_places}});
}

void print_summary(const Sheet_report_3& report, const Reconstructed_sheet_3& sheet,
                   double seconds) {
  std::printf("dsc: %zu points, %zu %s, %zu triangles, %zu %s, Euler characteristic %d, %zu %s of "
              "length %.4g%s; distances of points: root mean square %.3g, maximum %.3g (spacing "
              "%.3g, noise %.3g); %.3g s\n",
              report.number_of_points, report.number_of_outliers,
              noun(report.number_of_outliers, "outlier", "outliers"), sheet.triangles.size(),
              report.number_of_components,
              noun(report.number_of_components, "component", "components"),
              report.euler_characteristic, report.number_of_boundaries,
              noun(report.number_of_boundaries, "boundary", "boundaries"), report.boundary_length,
              report.is_orientable ? "" : ", one-sided", report.root_mean_square,
              report.maximum_distance, report.spacing, report.noise, seconds);
}

/// Prints where the sheet is not complete. Returns the exit code.
int tell_completeness(const Sheet_report_3& report, const std::vector<Point_and_normal_3>& points) {
  if (!report.unfit_points.empty()) {
    const auto& p = points[report.unfit_points.front()].first;
    std::fprintf(stderr,
                 "dsc: not complete: %zu %s farther than %.3g from the sheet, such as (%.6g, %.6g, "
                 "%.6g)\n",
                 report.unfit_points.size(),
                 noun(report.unfit_points.size(), "point is", "points are"),
                 report.largest_distance(), p.x(), p.y(), p.z());
  }
  if (!report.doubtful_places.empty()) {
    const auto& p = report.doubtful_places.front();
    std::fprintf(stderr,
                 "dsc: not complete: the sheet contradicts the points at %zu %s, such as (%.6g, "
                 "%.6g, %.6g): triangles are missing or extra; add points there\n",
                 report.doubtful_places.size(),
                 noun(report.doubtful_places.size(), "place", "places"), p.x(), p.y(), p.z());
  }
  return report.is_complete ? 0 : 1;
}

/// Reconstructs an open sheet from points, and writes it. Returns the exit code.
int reconstruct_open_sheet(const Reconstruct_options& options,
                           const std::vector<Point_and_normal_3>& points) {
  const auto begin = Clock::now();
  Sheet_report_3 report;
  const Reconstructed_sheet_3 sheet = DSC::reconstruct_sheet_3(
      points, parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal_3>())
                  .number_of_threads(options.threads)
                  .report(std::ref(report)));
  write_sheet(options.output, sheet);
  const double seconds = seconds_since(begin);
  if (!options.report.empty())
    write_report(options, report, sheet, seconds);
  if (!options.quiet)
    print_summary(report, sheet, seconds);
  return tell_completeness(report, points);
}

int reconstruct(const Reconstruct_options& options) {
  if (options.quiet)
    keep_silent_about_unused();
  // An interrupt ends the command before anything is written: the result is complete or missing.
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  // Fails before the computation starts if an output file cannot be written.
  require_place("-o", options.output, {options.input});
  require_place("--report", options.report, {options.input, options.output});
  require_place("--picture", options.picture, {options.input, options.output, options.report});
  std::optional<Step_folder> folder;
  if (!options.folder.empty())
    folder.emplace(options.folder);

  Unused_content unused;
  const std::string input = native_file(options.input);
  if (!has_format(input, Use::read, content::points, 0))
    throw Input_error(options.input + " contains no points; name a file with points");
  std::vector<Point_and_normal_3> points = CGAL::IO::read_point_set(input, &unused);
  leave_out_points(points, unused);
  const std::size_t normals = number_of_normals(points);
  if (options.is_open)
    unused.add(noun(normals, "normal", "normals"), normals);
  print_unused(options.input, unused);
  if (options.is_open)
    return reconstruct_open_sheet(options, points);
  const auto begin = Clock::now();
  Progress_line progress(options.steps, options.quiet);
  const auto observe = [&](const Complex& complex, std::size_t step) {
    if (folder)
      folder->write(complex, step, double(step));
    progress.show(unsigned(step));
    return true;
  };
  Reconstruction_report report;
  Tracked_complex_3 tracked(DSC::reconstruct_point_set_3<Complex>(
      points, parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal_3>())
                  .normal_map(CGAL::Second_of_pair_property_map<Point_and_normal_3>())
                  .fit_tolerance(options.tolerance)
                  .number_of_iterations(options.steps)
                  .number_of_threads(options.threads)
                  .observer(observe)
                  .report(std::ref(report))));
  progress.clear();
  if (folder)
    folder->require();
  interruptible.reset();

  tracked.write(options.output);
  if (!options.picture.empty())
    tracked.write(options.picture);
  const double seconds = seconds_since(begin);
  const Statistics statistics = tracked.statistics();
  if (!options.report.empty())
    write_report(options, report, tracked, normals, seconds);
  if (!options.quiet) {
    warn_of_openness(report, statistics.interface_facets);
    print_summary(report, normals, statistics, seconds);
  }
  return tell_completeness(report);
}

int execute(const Reconstruct_options& options) {
  try {
    return reconstruct(options);
  } catch (const DSC::Invalid_points_error& error) {
    throw Input_error(options.input + ": " + error.what());
  }
}

void check(const Reconstruct_options& options) {
  require_format(options.input, Use::read, content::points, content::points);
  require_format(options.output, Use::write,
                 options.is_open ? content::surface : content::surface | content::tetrahedra);
  if (!options.picture.empty())
    require_format(options.picture, Use::write, content::picture);
}

} // namespace

void add_reconstruct(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Reconstruct_options>();
  CLI::App* command = app.add_subcommand("reconstruct", description_of_reconstruct);
  add_input(*command, "POINTS", options->input,
            "Points, with or without normals (" +
                formats_with(Use::read, content::points, content::points) +
                "); - for standard input")
      ->required();
  add_output(*command, "-o", options->output,
             "Surface (" + formats_with(Use::write, content::surface) + ") or tetrahedra (" +
                 formats_with(Use::write, content::tetrahedra) + "); - for standard output")
      ->required();
  add_value(*command, "--tolerance", options->tolerance, positive,
            "Tolerance of triangles to their points, in mean distances of a point from its "
            "neighbors")
      ->default_str("0.03");
  CLI::Option* open = command->add_flag(
      "--open", options->is_open,
      "Reconstruct an open sheet, such as a terrain; its boundaries and holes stay open");
  command->add_option("--steps", options->steps, "Maximum number of steps")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  add_threads_option(*command, options->threads);
  command->add_option("--output", options->folder,
                      "Folder for ParaView files of all steps; created if necessary");
  add_output(*command, "--report", options->report,
             "JSON file with distances, components, and points and triangles that do not fit",
             "json");
  add_output(*command, "--picture", options->picture, "Picture of the surface (.png)", "png");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  for (const char* name : {"--tolerance", "--steps", "--output", "--picture"})
    open->excludes(command->get_option(name));
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

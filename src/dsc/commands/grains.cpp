// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Grain_run.h"
#include "commands/commands.h"
#include "input/files.h"
#include "input/formats.h"
#include "output/report_json.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <CGAL/Mesh_files/Svg_canvas.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>

namespace dsc {
namespace {

struct Grains_options
{
  Grain_run run;
  std::string energy = "isotropic"; ///< name, or a file
  std::string report, plot;         ///< files; empty for none
  bool quiet = false;
};

Json parameters(const Grain_run& run) {
  Json result = to_json(run);
  result["command"] = "grains";
  result["until"] = run.until;
  return result;
}

Json json_of(const Grain_state& state) {
  return {{"step", state.step},
          {"time", state.time},
          {"grains", state.grains},
          {"energy", state.energy},
          {"cells", state.cells},
          {"removed", state.removed},
          {"unfinished", state.unfinished}};
}

Json json_of(const DSC::Grain_statistics& grain, int dimension) {
  Json result = {{"label", grain.label},
                 {dimension == 2 ? "area" : "volume", grain.measure},
                 {dimension == 2 ? "perimeter" : "area", grain.boundary},
                 {"neighbors", grain.neighbors}};
  if (dimension == 2)
    result["sides"] = grain.corners;
  else {
    result["mean_width"] = grain.mean_width;
    result["triple_lines"] = grain.triple_lines;
  }
  return result;
}

/// The distribution of a quantity.
struct Histogram
{
  std::string quantity;        ///< its name and unit, below the axis
  std::vector<double> values;  ///< of the quantity
  std::vector<double> weights; ///< of the values; 1 for all if empty
  double low = 0, high = 1;    ///< range of the axis; other values count in the outer bins
  std::size_t bins = 20;
  bool is_integer = false; ///< whether each bin is an integer, which names it

  /// Returns the density in each bin: the integral over the axis is 1; 0 without values.
  std::vector<double> densities() const {
    std::vector<double> result(bins, 0.);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double place = (values[i] - low) / (high - low) * double(bins),
                   weight = weights.empty() ? 1 : weights[i];
      result[std::size_t(std::clamp(place, 0., double(bins - 1)))] += weight;
      sum += weight;
    }
    for (double& density : result)
      density *= sum > 0 ? double(bins) / (sum * (high - low)) : 0;
    return result;
  }
};

using Point = CGAL::Epick::Point_2;

/// Lengths of a diagram, in pixels.
constexpr double width = 320, height = 200, margin = 50;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

/// Draws a histogram whose axis begins at (left, margin).
void draw(const Histogram& histogram, double left, DSC::Svg_canvas& canvas, DSC::Svg_layer& bars,
          DSC::Svg_layer& axes) {
  const std::vector<double> densities = histogram.densities();
  const double most = (std::max)(*std::max_element(densities.begin(), densities.end()), 1e-300),
               bar = width / double(densities.size());
  for (std::size_t i = 0; i < densities.size(); ++i) {
    const double x = left + double(i) * bar, top = margin + height * densities[i] / most;
    canvas.add(std::array<Point, 4>{Point(x, margin), Point(x + bar, margin), Point(x + bar, top),
                                    Point(x, top)},
               bars);
  }
  canvas.add(std::array<Point, 2>{Point(left, margin), Point(left + width, margin)}, axes);
  const auto tick = [&](double value) {
    const double place = (value - histogram.low) / (histogram.high - histogram.low);
    canvas.add_text(Point(left + width * place, margin - 16), "middle", number(value));
  };
  static constexpr int ticks = 4;
  for (int i = 0; i <= ticks && !histogram.is_integer; ++i)
    tick(histogram.low + (histogram.high - histogram.low) * i / ticks);
  // Every second integer, so that the names do not overlap.
  for (std::size_t i = 0; i < densities.size() && histogram.is_integer; i += 2)
    tick(histogram.low + .5 + double(i));
  canvas.add_text(Point(left + width / 2, margin - 36), "middle", histogram.quantity);
  canvas.add_text(Point(left - 4, margin + height - 5), "end", number(most));
}

/// Draws histograms next to each other (.svg).
/// \throws std::runtime_error if the file cannot be written
void write_histograms(const std::string& path, const std::vector<Histogram>& histograms) {
  const CGAL::Bbox_2 box(0, 0, double(histograms.size()) * (width + margin) + margin / 2,
                         height + 1.5 * margin);
  DSC::Svg_canvas canvas(box, box, box.xmax(), {0, 0});
  DSC::Svg_layer bars = {"bars", "#4d85bd", "#ffffff", 1}, axes = {"axes", "none", "#000000", 1};
  for (std::size_t i = 0; i < histograms.size(); ++i)
    draw(histograms[i], margin + double(i) * (width + margin), canvas, bars, axes);
  canvas.write(path, {bars, axes});
}

/// Draws the distributions of sizes, of neighbors and of misorientations.
void plot(const std::string& path, const Grain_result& result, int dimension) {
  static constexpr double largest_size = 3;              // diameters of a mean grain
  static constexpr double largest_angles[] = {45, 62.8}; // misorientations of cubic crystals
  Histogram sizes, neighbors, misorientations;
  double sum = 0;
  for (const auto& grain : result.grains)
    sum += grain.measure;
  std::size_t most = 1;
  for (const auto& grain : result.grains) {
    sizes.values.push_back(
        std::pow(grain.measure * double(result.grains.size()) / sum, 1. / dimension));
    neighbors.values.push_back(double(grain.neighbors));
    most = (std::max)(most, grain.neighbors);
  }
  sizes.quantity = "diameter of a grain / diameter of a mean grain";
  sizes.high = largest_size;
  neighbors.quantity = "neighbors of a grain";
  neighbors.low = -.5;
  neighbors.high = double(most) + .5;
  neighbors.bins = most + 1;
  neighbors.is_integer = true;
  misorientations.quantity = dimension == 2 ? "misorientation, weighted by length (degrees)"
                                            : "misorientation, weighted by area (degrees)";
  misorientations.high = largest_angles[dimension - 2];
  misorientations.values = result.misorientations;
  misorientations.weights = result.areas;
  write_histograms(path, {sizes, neighbors, misorientations});
}

int execute(const Grains_options& options) {
  const Grain_run& run = options.run;
  require_place("--picture", run.picture, {options.energy, run.resume});
  require_place("--report", options.report, {run.picture, options.energy, run.resume});
  require_place("--plot", options.plot, {run.picture, options.report, options.energy, run.resume});
  Json states = Json::array();
  Grain_state last;
  const Interruptible interruptible(options.quiet);
  const Grain_result result = grow_grains(run, [&](const Grain_state& state) {
    last = state;
    states.push_back(json_of(state));
  });
  if (!options.report.empty()) {
    Json json = {{"parameters", parameters(run)}, {"steps", states}};
    if (result.slope != 0)
      json["law"] = {{"slope", result.slope}, {"correlation", result.correlation}};
    for (const auto& [sides, rate] : result.rates)
      json["law"]["rates"].push_back(
          {{"sides", sides}, {"rate", rate.sum / double(rate.number)}, {"number", rate.number}});
    for (const auto& grain : result.grains)
      json["grains"].push_back(json_of(grain, run.dimension));
    for (std::size_t k = 0; k < result.areas.size(); ++k)
      json["boundaries"].push_back(
          {{"misorientation", result.misorientations[k]}, {"measure", result.areas[k]}});
    write_json(options.report, json);
  }
  if (!options.plot.empty())
    plot(options.plot, result, run.dimension);
  if (options.quiet)
    return 0;
  std::printf("dsc: %zu of %zu grains are left after %u %s, at the time %.6g\n", last.grains,
              run.number, last.step, noun(last.step, "step", "steps"), last.time);
  if (result.slope != 0)
    std::printf("dsc: they grow at %.4f of the rate of %s, correlation %.4f\n", result.slope,
                run.dimension == 2 ? "von Neumann and Mullins" : "MacPherson and Srolovitz",
                result.correlation);
  return 0;
}

/// Reads the energy: a name or a table.
void read_energy(const std::string& text, bool given_largest_angle, Grain_energy& energy) {
  if (given_largest_angle && text != "read-shockley")
    throw Usage_error("--largest-angle applies only to --energy read-shockley; leave it out");
  if (text == "isotropic")
    return;
  if (text == "read-shockley") {
    energy.kind = Grain_energy::Kind::read_shockley;
    return;
  }
  if (extension(text).empty())
    throw Usage_error("--energy expects isotropic, read-shockley, or a file with a table such as "
                      "energy.txt; the value was '" +
                      text + "'");
  energy.kind = Grain_energy::Kind::table;
  energy.table = read_angle_table(text);
}

/// Reads the energy or the grains of a checkpoint, and checks the names of pictures.
/// \throws Usage_error
void complete(Grains_options& options, bool given_largest_angle) {
  Grain_run& run = options.run;
  if (run.resume.empty())
    read_energy(options.energy, given_largest_angle, run.energy);
  else
    read_grains(run.resume, run);
  if (!options.plot.empty())
    require_format(options.plot, Use::write, content::drawing);
  if (run.picture.empty())
    return;
  require_format(run.picture, Use::write, content::drawing);
  if (run.dimension == 3)
    throw Usage_error("--picture applies only to --dimension 2; use --output");
}

/// Returns a function that reads a positive number in a range.
/// \param complaint about other numbers; follows the name of the option
auto between(double least, double greatest, const char* complaint) {
  return [=](const std::string& text, const std::string& option) {
    const double result = positive(text, option);
    if (!(least <= result && result <= greatest))
      throw Usage_error(option + complaint);
    return result;
  };
}

} // namespace

void add_grains(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Grains_options>();
  Grain_run& run = options->run;
  CLI::App* command = app.add_subcommand("grains", description_of_grains);
  CLI::Option* resume = add_input(*command, "--resume", run.resume,
                                  "Checkpoint to continue; results equal those of an "
                                  "uninterrupted run. Needs another --output");
  command->add_option("--number", run.number, "Number of grains at the beginning")
      ->check(CLI::Range(std::size_t(2), std::size_t(1000000)))
      ->capture_default_str();
  command->add_option("--dimension", run.dimension, "2 or 3")
      ->check(CLI::Range(2, 3))
      ->capture_default_str();
  const auto is_torus = [](const std::string& text, const std::string&) { return text == "torus"; };
  add_value(*command, "--domain", run.is_periodic, is_torus,
            "torus, which is periodic, or box, where grain boundaries end at right angles; of "
            "size 1")
      ->check(CLI::IsMember({"torus", "box"}))
      ->default_str("torus");
  command
      ->add_option("--energy", options->energy,
                   "Energy of grain boundaries: isotropic, read-shockley (by the misorientation of "
                   "two cubic crystals with random orientations), or a file with lines of an angle "
                   "in degrees, a tension and a mobility")
      ->capture_default_str();
  add_value(*command, "--largest-angle", run.energy.largest_angle, positive,
            "Angle in degrees below which the energy read-shockley depends on the "
            "misorientation")
      ->default_str("15");
  CLI::Option* particles =
      command
          ->add_option("--particles", run.particles,
                       "Number of round particles that stay in place and pin grain boundaries")
          ->check(CLI::Range(std::size_t(0), std::size_t(10000)))
          ->capture_default_str();
  add_value(*command, "--particle-radius", run.particle_radius,
            between(.05, 10, " is out of range; use .05 to 10"),
            "Radius of particles, in diameters of a grain at the beginning")
      ->needs(particles)
      ->default_str(".2");
  add_value(*command, "--until", run.until,
            between(0, std::nextafter(1., 0.), " must be less than 1; write it like 0.5"),
            "End when this fraction of the grains is left")
      ->default_str(".5");
  command->add_option("--steps", run.steps, "Maximum number of steps (default: no bound)")
      ->check(CLI::Range(1u, 2147483647u));
  add_value(*command, "--edges", run.edges, between(3, 1000, " is out of range; use 3 to 1000"),
            "Edges of the interface in the diameter of a grain")
      ->default_str("10");
  add_value(*command, "--step", run.step,
            between(0, 10, " is out of range; use more than 0 and at most 10"),
            "Time step, in squares of the length of an edge")
      ->default_str(".1");
  command->add_option("--seed", run.seed, "Number of the random sequence")->capture_default_str();
  add_threads_option(*command, run.threads);
  CLI::Option* output = command->add_option(
      "--output", run.output, "Folder for ParaView files and a checkpoint; created if necessary");
  command->add_option("--every", run.every, "Write every N-th step")
      ->check(CLI::Range(1u, 2147483647u))
      ->needs(output)
      ->capture_default_str();
  add_output(*command, "--picture", run.picture, "Picture at the end (.svg), in the plane", "svg");
  add_output(*command, "--plot", options->plot,
             "Distributions of sizes, neighbors and misorientations at the end (.svg)", "svg");
  add_output(*command, "--report", options->report,
             "JSON file with all steps, and with sizes and neighbors of grains at the end", "json");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  for (const char* name : {"--number", "--dimension", "--domain", "--energy", "--largest-angle",
                           "--particles", "--particle-radius", "--edges", "--step", "--seed"})
    resume->excludes(command->get_option(name));
  command->callback([command, options, &exit_code] {
    complete(*options, command->count("--largest-angle") > 0);
    exit_code = execute(*options);
  });
}

} // namespace dsc

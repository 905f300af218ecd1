// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/translations.h"
#include "input/voxel_images.h"
#include "motions/mesh_at_rest.h"
#include "motions/run_position.h"
#include "motions/tracked_complex_2.h"
#include "motions/tracked_complex_3.h"
#include "output/label_titles.h"
#include "output/picture.h"
#include "output/report_json.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <CGAL/Complex_construction/sample_labels.h>
#include <CGAL/Image_segmentation/compiled_2.h>
#include <CGAL/Image_segmentation/compiled_3.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace dsc {
namespace {

using DSC::Segmentation_report;

struct Segment_options
{
  std::string input, mask, start;
  std::vector<std::string> outputs;
  std::string mesh, report, picture; ///< files; empty for none
  unsigned phases = 0;               ///< 0 if not given
  std::vector<double> intensities;
  std::optional<double> noise, smoothing, longest_edge, shortest_edge;
  std::vector<std::string> connected; ///< labels by number or name, in lists
  bool keeps_topology = false, has_channels = false, quiet = false;
  unsigned threads = default_number_of_threads();
};

template <int d> using Tracked = std::conditional_t<d == 2, Tracked_complex_2, Tracked_complex_3>;

/// Returns the options of the library.
template <int d>
DSC::Segmentation_options<d> options_of(const Segment_options& options, std::size_t channels,
                                        const Label_names& names) {
  DSC::Segmentation_options<d> result;
  if (options.phases > 0)
    result.phases = options.phases;
  if (!options.intensities.empty()) {
    if (channels != 1)
      throw Usage_error("--intensities applies to an image with one channel; use --phases");
    for (const double x : options.intensities)
      result.intensities.push_back({x});
    if (options.phases > 0 && options.phases != result.intensities.size())
      throw Usage_error("--phases and the number of --intensities differ; leave out --phases");
  }
  if (options.noise)
    result.noise.assign(channels, *options.noise);
  result.smoothing = options.smoothing;
  result.longest_edge = options.longest_edge.value_or(result.longest_edge);
  result.shortest_edge = options.shortest_edge.value_or(result.shortest_edge);
  result.keeps_topology = options.keeps_topology;
  result.connected = labels_of("--connected", options.connected, names);
  result.number_of_threads = options.threads;
  try {
    result.check();
  } catch (const DSC::Error& error) {
    throw Usage_error(error.what());
  }
  return result;
}

bool is_label_image(const std::string& path) {
  return has_format(path, Use::write, 0, content::voxels | content::pixels);
}

/// Draws the image with the boundaries of phases; in space, the boundaries alone.
void draw(const std::string& path, const Tracked_complex_3& tracked, const DSC::Gray_image<3>&) {
  tracked.write(path);
}

/// Returns the gray value of each pixel between 0 and 1, without the darkest and the brightest
/// ones.
std::vector<double> gray_values(const DSC::Gray_image<2>& image) {
  static constexpr double tail = .005; // part of the pixels that are black, and white
  std::vector<double> result(image.channels.front().size(), 0.), sorted;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (image.has_value(i)) {
      for (const auto& channel : image.channels)
        result[i] += double(channel[i]) / double(image.channels.size());
      sorted.push_back(result[i]);
    }
  std::sort(sorted.begin(), sorted.end());
  const auto skipped = std::size_t(tail * double(sorted.size()));
  const double low = sorted[skipped], high = sorted[sorted.size() - 1 - skipped];
  for (double& value : result)
    value = high > low ? std::clamp((value - low) / (high - low), 0., 1.) : .5;
  return result;
}

void draw(const std::string& path, const Tracked_complex_2& tracked,
          const DSC::Gray_image<2>& image) {
  static constexpr double dark = .15, light = .95; // gray values, so that lines are visible
  static constexpr Picture_color without_value = {1, 1, 1};
  static constexpr std::size_t most = 800; // squares along a side of the picture
  const auto& grid = image.grid;
  const std::size_t step = (std::max)(grid.size[0], grid.size[1]) / most + 1; // pixels of a square
  const std::vector<double> values = gray_values(image);
  Picture picture;
  for (std::size_t y = 0; y < grid.size[1]; y += step) {
    DSC::Progress_scope::check();
    for (std::size_t x = 0; x < grid.size[0]; x += step) {
      Picture_polygon square;
      for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        square.corners.push_back(
            {grid.origin[0] + (double((std::min)(x + std::size_t(i) * step, grid.size[0])) - .5) *
                                  grid.spacing[0],
             grid.origin[1] + (double((std::min)(y + std::size_t(j) * step, grid.size[1])) - .5) *
                                  grid.spacing[1]});
      const std::size_t pixel = y * grid.size[0] + x;
      if (image.has_value(pixel))
        square.color.fill(dark + values[pixel] * (light - dark));
      else
        square.color = without_value;
      picture.polygons.push_back(std::move(square));
    }
  }
  static constexpr double saturation = .9, lightness = .5; // of lines on gray pixels
  const auto& complex = tracked.complex;
  const auto point = [&](auto v) -> Picture_point {
    const auto p = complex.user_position(v);
    return {p.x(), p.y()};
  };
  for (const auto& facet : complex.interface_facets()) {
    const auto ends = complex.facet_vertices(facet);
    picture.lines.push_back(
        {{point(ends[0]), point(ends[1])},
         color_of_label(facet.first->subdomain_index(), saturation, lightness)});
  }
  write_picture(path, picture);
}

/// Improves the cells for simulations and writes them.
void write_improved(Tracked_complex_2& tracked, unsigned threads, const std::string& path) {
  DSC::Mesh_improvement_options<Tracked_complex_2::Complex> improvement;
  improvement.number_of_threads = threads;
  DSC::improve_mesh(tracked.complex, improvement);
  tracked.write(path);
}

void write_improved(const Tracked_complex_3& tracked, unsigned threads, const std::string& path) {
  Improvement_options improvement;
  improvement.threads = threads;
  Mesh_content content;
  Mesh_at_rest mesh(tracked.complex.state(), tracked.label_names);
  mesh.improve(improvement, content);
  mesh.write(path, content);
}

template <int d>
Json json_of(const Segmentation_report& report, const Segment_options& options,
             const Tracked<d>& tracked, const DSC::Gray_image<d>& image) {
  const double side = image.side(), pixel = std::pow(side, d);
  Json json = {{"parameters",
                {{"command", "segment"},
                 {"input", options.input},
                 {"smoothing", report.smoothing},
                 {"noise", report.noise}}}};
  for (const auto& phase : report.phases)
    json["phases"].push_back(label_json(phase.label, tracked.label_names,
                                        {{"intensities", phase.intensities},
                                         {d == 2 ? "area" : "volume", phase.measure * pixel},
                                         {"pixels", phase.measure},
                                         {"components", phase.components}}));
  json["boundaries"] = Json::array();
  for (const auto& boundary : report.boundaries)
    json["boundaries"].push_back(
        {{"labels", {boundary.a, boundary.b}},
         {d == 2 ? "length" : "area", boundary.measure * std::pow(side, d - 1)},
         {"uncertainty", boundary.uncertainty * side}});
  json["energies"] = report.energies;
  json["residual"] = report.residual;
  json["converged"] = report.has_converged;
  json["statistics"] = statistics_json(tracked.statistics());
  return json;
}

template <int d>
void print(const Segmentation_report& report, std::size_t cells, const Label_names& names) {
  std::printf("dsc: %zu phases, %zu %s%s\n", report.phases.size(), cells,
              d == 2 ? "triangles" : "tetrahedra", report.has_converged ? "" : "; not converged");
  for (const auto& phase : report.phases) {
    std::printf("dsc: label %s: intensity", label_title(phase.label, names).c_str());
    for (const double x : phase.intensities)
      std::printf(" %.4g", x);
    if (phase.components == 0)
      std::printf(", vanished\n");
    else
      std::printf(", %.6g pixels in %zu %s\n", phase.measure, phase.components,
                  noun(phase.components, "component", "components"));
  }
}

/// \param voxels the grid of the image in space; of a planar image, a single layer
template <int d>
int segment(const Segment_options& options, const DSC::Gray_image<d>& image,
            const DSC::Sampling_grid<3>& voxels) {
  using Complex = typename Tracked<d>::Complex;
  Tracked<d> tracked;
  if (!options.start.empty()) {
    std::string metadata;
    const auto start = track_checkpoint(options.start, metadata);
    auto* const complex = dynamic_cast<Tracked<d>*>(start.get());
    if (complex == nullptr)
      throw Input_error(options.start + " and " + options.input +
                        " differ in dimension; use a complex of the same dimension");
    tracked.complex = std::move(complex->complex);
    tracked.label_names = std::move(complex->label_names);
  }
  const auto library_options = options_of<d>(options, image.channels.size(), tracked.label_names);
  Segmentation_report report;
  if (options.start.empty()) {
    auto result = DSC::segment_image<Complex>(image, library_options);
    tracked.complex = std::move(result.first);
    report = std::move(result.second);
  } else {
    try {
      report = DSC::segment_image(tracked.complex, image, library_options);
    } catch (const DSC::Error& error) {
      throw Input_error(options.start + ": " + error.what());
    }
  }
  for (const std::string& output : options.outputs)
    if (is_label_image(output)) {
      tell_lost_names(output, tracked.label_names);
      write_label_image(output, voxels, DSC::sample_labels(tracked.complex, image.grid),
                        is_foreign(options.input) ? options.input : "");
    } else if (extension(output) == "dsc")
      tracked.write_checkpoint(output, to_metadata(tracked.label_names));
    else
      tracked.write(output);
  if (!options.picture.empty())
    draw(options.picture, tracked, image);
  if (!options.report.empty())
    write_json(options.report, json_of<d>(report, options, tracked, image));
  if (!options.quiet)
    print<d>(report, tracked.complex.number_of_cells(), tracked.label_names);
  if (!options.mesh.empty())
    write_improved(tracked, options.threads, options.mesh);
  return 0;
}

/// Checks the names of the files before the computation.
/// \throws Usage_error if a format does not fit the dimension
void check_files(const Segment_options& options, bool is_planar) {
  std::vector<std::string> others = {options.input, options.mask, options.start};
  const auto check = [&](const std::string& option, const std::string& path) {
    require_place(option, path, others);
    others.push_back(path);
  };
  for (const std::string& output : options.outputs) {
    if (is_label_image(output))
      require_program("dsc-files", output);
    require_format(output, Use::write,
                   content::complex |
                       (is_planar ? content::regions : content::tetrahedra | content::surface),
                   is_planar ? content::pixels : content::voxels);
    check("--output", output);
  }
  if (!options.mesh.empty()) {
    require_format(options.mesh, Use::write, is_planar ? content::triangles : content::tetrahedra);
    check("--mesh", options.mesh);
  }
  if (!options.picture.empty())
    require_format(options.picture, Use::write, content::picture);
  check("--picture", options.picture);
  check("--report", options.report);
}

/// Leaves out the pixels for which a mask is 0.
void apply_mask(Read_image& image, const std::string& path) {
  const Read_image mask = read_gray_image(path, false);
  if (mask.image.grid.size != image.image.grid.size)
    throw Input_error(path + " has another size than the image; give a mask with the same pixels");
  image.image.mask.resize(mask.image.channels.front().size(), 1);
  for (std::size_t i = 0; i < image.image.mask.size(); ++i)
    if (mask.image.channels.front()[i] == 0 || !mask.image.has_value(i))
      image.image.mask[i] = 0;
}

int execute(const Segment_options& options) {
  const Interruptible interruptible(options.quiet);
  Read_image image = read_gray_image(options.input, options.has_channels);
  check_files(options, image.is_planar());
  if (image.number_without_values > 0 && !options.quiet)
    std::fprintf(stderr, "dsc: %s: %zu %s not used, because the value is not a number\n",
                 options.input.c_str(), image.number_without_values,
                 noun(image.number_without_values, "pixel is", "pixels are"));
  if (!options.mask.empty())
    apply_mask(image, options.mask);
  try {
    image.image.check();
  } catch (const DSC::Error& error) {
    throw Input_error(options.input + ": " + error.what());
  }
  const DSC::Sampling_grid<3> voxels = image.image.grid;
  if (image.is_planar())
    return segment<2>(options, layer_of(std::move(image)), voxels);
  return segment<3>(options, image.image, voxels);
}

} // namespace

void add_segment(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Segment_options>();
  CLI::App* command = app.add_subcommand("segment", description_of_segment);
  add_input(*command, "image", options->input,
            "Image of pixels or voxels, gray or with colors; - for standard input")
      ->required();
  add_output(*command, "-o,--output", options->outputs,
             "File: labels of pixels (" + formats_with(Use::write, 0, content::pixels) +
                 "), cells (" + formats_with(Use::write, content::tetrahedra) + "), boundaries (" +
                 formats_with(Use::write, content::surface) + "; in the plane " +
                 formats_with(Use::write, content::regions) +
                 "), a complex (.dsc); can be repeated; - for "
                 "standard output")
      ->take_all();
  command->add_option("--phases", options->phases, "Number of phases (default: 2)")
      ->check(CLI::Range(2u, 64u));
  add_value(*command, "--intensities", options->intensities, parse_list,
            "Intensities of the phases, like 20,90,200, instead of --phases");
  add_value(*command, "--smoothing", options->smoothing, positive,
            "Energy of boundaries, in squares of the noise and sides of pixels (default: "
            "by the smallest contrast)");
  add_value(*command, "--noise", options->noise, positive,
            "Standard deviation of the noise (default: estimated)");
  add_input(*command, "--mask", options->mask, "Mask image; pixels with the value 0 are ignored");
  command->add_flag("--color", options->has_channels, "Use the channels of a color image");
  add_value(*command, "--longest-edge", options->longest_edge, positive,
            "Edges at the beginning, in pixels (default: 5, in space 10)");
  add_value(*command, "--shortest-edge", options->shortest_edge, positive,
            "Edges of boundaries at the end, in pixels (default: 2.5, in space 3)");
  add_input(*command, "--start", options->start,
            "Complex (.dsc) to begin with; its labels are indices of phases");
  command->add_flag("--keep-topology", options->keeps_topology,
                    "Keep the topology of --start, or of the labels of the first mesh");
  command
      ->add_option("--connected", options->connected,
                   "Labels of which only the largest component stays, like 1,2 or names of --start")
      ->allow_extra_args(false);
  add_output(*command, "--mesh", options->mesh,
             "File (" + formats_with(Use::write, content::tetrahedra) +
                 ") of cells that are improved for simulations");
  add_output(*command, "--picture", options->picture,
             "Picture (.png) of the image with boundaries; in space, of the boundaries", "png");
  add_output(*command, "--report", options->report,
             "JSON file with phases, boundaries, energies and statistics", "json");
  add_threads_option(*command, options->threads);
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([options, &exit_code] { exit_code = execute(*options); });
}

} // namespace dsc

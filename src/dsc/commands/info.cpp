// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/start_options.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/labeled_tetrahedra.h"
#include "input/translations.h"
#include "input/voxel_images.h"
#include "motions/mesh_at_rest.h"
#include "motions/run_position.h"
#include "motions/tracked_complex.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/standard_streams.h"

#include <iostream>

namespace dsc {
namespace {

struct Info_options
{
  std::string file;
  std::string labels, thresholds; ///< as in `Run_start`
};

void print(const Statistics& statistics) {
  const bool is_planar = statistics.dimension == 2;
  const char* const cells = is_planar ? "triangles" : "tetrahedra";
  const auto line = [](std::string name, const auto& value) -> std::ostream& {
    name.resize(21, ' ');
    return std::cout << name << value;
  };
  line("vertices", statistics.vertices) << '\n';
  line(cells, statistics.cells) << '\n';
  line(is_planar ? "interface segments" : "interface triangles", statistics.interface_facets)
      << '\n';
  for (const Label_statistics& label : statistics.labels)
    std::cout << "label " << label.label
              << (label.name.empty() ? "" : " '" + printed_line(label.name) + "'") << ": "
              << label.cells << ' ' << cells << ", " << (is_planar ? "area " : "volume ")
              << label.volume << ", interface " << (is_planar ? "length " : "area ") << label.area
              << ", components " << label.components << ", Euler characteristic "
              << label.euler_characteristic << '\n';
  line(is_planar ? "angles" : "dihedral angles", statistics.min_angle)
      << " to " << statistics.max_angle << " degrees, " << 100 * statistics.angles_outside_6_171
      << " % outside 6 to 171\n";
  line("smallest quality", statistics.min_quality) << '\n';
}

void print(const Surface_statistics& statistics) {
  std::cout << "vertices              " << statistics.vertices << '\n'
            << "triangles             " << statistics.triangles << '\n'
            << "components            " << statistics.components << '\n'
            << "Euler characteristic  " << statistics.euler_characteristic << '\n'
            << "area                  " << statistics.area << '\n';
  if (statistics.boundary_edges == 0)
    std::cout << "volume                " << statistics.volume << '\n';
  else
    std::cout << "boundary edges        " << statistics.boundary_edges << " (not closed)\n";
  std::cout << "angles                " << statistics.min_angle << " to " << statistics.max_angle
            << " degrees\n";
  for (const auto& [name, triangles] : statistics.parts)
    if (!name.empty() || statistics.parts.size() > 1)
      std::cout << "part '" << printed_line(name) << "': " << triangles
                << noun(triangles, " triangle\n", " triangles\n");
}

void print(const Image_statistics& statistics) {
  const auto line = [](const char* name, const auto& numbers) {
    std::cout << name << numbers[0] << " x " << numbers[1] << " x " << numbers[2] << '\n';
  };
  line("voxels                ", statistics.grid.size);
  line("size of a voxel       ", statistics.grid.spacing);
  std::cout << "first voxel           " << statistics.grid.origin[0] << ' '
            << statistics.grid.origin[1] << ' ' << statistics.grid.origin[2] << '\n';
  for (const auto& [label, voxels] : statistics.voxels)
    std::cout << "label " << label << ": " << voxels << noun(voxels, " voxel", " voxels") << '\n';
}

int execute(const Info_options& options) {
  const Interruptible interruptible(false);
  const std::string file = native_file(options.file, options.labels, options.thresholds),
                    format = extension(file);
  Run_start start;
  start.inputs = {file};
  if (format == "dsc") {
    std::string metadata;
    const auto complex = track_checkpoint(file, metadata);
    if (const std::optional<Saved_run> run = from_metadata(metadata))
      std::cout << "step                 " << run->position.step << ", time " << run->position.time
                << '\n';
    print(complex->statistics());
  } else if (input_kind(start) == Input_kind::tetrahedra) {
    Labeled_tetrahedra mesh = read_tetrahedra(file, options.labels);
    print(Mesh_at_rest(file, mesh).statistics());
  } else if (input_kind(start) == Input_kind::image) {
    print(image_statistics(file));
  } else if (dimension_of(start) == 2) {
    print(track_figure(start, std::nullopt)->statistics());
  } else {
    if (!has_format(file, Use::read, content::surface, 0))
      throw Input_error(options.file + " contains points; dsc reconstruct reads them");
    print(surface_statistics(file));
  }
  return 0;
}

void check(const Info_options& options) {
  require_format(options.file, Use::read, content::starts | content::complex | content::points,
                 content::all);
  require_file_with_arrays(options.file, options.labels);
}

} // namespace

void add_info(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Info_options>();
  CLI::App* command = app.add_subcommand("info", description_of_info);
  add_input(*command, "FILE", options->file,
            "Checkpoint (.dsc), or a file that other commands read (" +
                formats_with(Use::read, content::starts, content::all) + "); - for standard input")
      ->required();
  add_labels_option(*command, options->labels);
  add_threshold_option(*command, options->thresholds);
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/labels_option.h"
#include "files.h"
#include "interrupt.h"
#include "labelled_tetrahedra.h"
#include "option_values.h"
#include "run_position.h"
#include "tracked_complex_3.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace dsc {
namespace {

struct Info_options
{
  std::string file;
  std::string labels; ///< as in `Run_start`
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
    std::cout << "label " << label.label << ": " << label.cells << ' ' << cells << ", "
              << (is_planar ? "area " : "volume ") << label.volume << ", interface "
              << (is_planar ? "length " : "area ") << label.area << ", components "
              << label.components << ", Euler characteristic " << label.euler_characteristic
              << '\n';
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
}

int execute(const Info_options& options) {
  const Interruptible interruptible(false);
  const std::string format = extension(options.file);
  Run_start start;
  start.inputs = {options.file};
  if (format == "dsc") {
    std::string metadata;
    const auto complex = track_checkpoint(options.file, metadata);
    if (const std::optional<Saved_run> run = from_metadata(metadata))
      std::cout << "step                 " << run->position.step << ", time " << run->position.time
                << '\n';
    print(complex->statistics());
  } else if (format == "mesh" || format == "vtu") {
    const Labelled_tetrahedra mesh = read_tetrahedra(options.file, options.labels);
    print(Tracked_complex_3::from_mesh(options.file, mesh)->statistics());
  } else if (dimension_of(start) == 2) {
    print(track_figure(start, std::nullopt)->statistics());
  } else {
    print(surface_statistics(options.file));
  }
  return 0;
}

void check(const Info_options& options) {
  require_extension(options.file, {"off", "obj", "ply", "stl", "wkt", "poly", "pgm", "png", "dsc",
                                   "mesh", "vtu"});
  require_file_with_arrays(options.file, options.labels);
}

} // namespace

void add_info(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Info_options>();
  CLI::App* command = app.add_subcommand("info", description_of_info);
  command
      ->add_option(
          "FILE", options->file,
          "Surface (.off, .obj, .ply, .stl), planar curves or image (.wkt, .poly, .pgm, .png), "
          "checkpoint (.dsc) or mesh (.mesh, .vtu)")
      ->required();
  add_labels_option(*command, options->labels);
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

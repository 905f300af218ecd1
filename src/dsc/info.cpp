// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "files.h"
#include "run_position.h"
#include "tracked_complex.h"

#include <iostream>
#include <optional>

namespace dsc {
namespace {

void print(const Statistics& statistics) {
  std::cout << "vertices             " << statistics.vertices << '\n'
            << "tetrahedra           " << statistics.tetrahedra << '\n'
            << "interface triangles  " << statistics.interface_triangles << '\n';
  for (const Label_statistics& label : statistics.labels)
    std::cout << "label " << label.label << ": " << label.tetrahedra << " tetrahedra, volume "
              << label.volume << ", interface area " << label.area << ", components "
              << label.components << ", Euler characteristic " << label.euler_characteristic
              << '\n';
  std::cout << "dihedral angles      " << statistics.min_dihedral << " to "
            << statistics.max_dihedral << " degrees, " << 100 * statistics.dihedrals_outside_6_171
            << " % outside 6 to 171\n"
            << "smallest quality     " << statistics.min_quality << '\n';
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

} // namespace

int execute(const Info_options& options) {
  const std::string format = extension(options.file);
  if (format == "mesh" || format == "vtu")
    print(Tracked_complex::from_mesh(options.file).statistics());
  else if (format == "dsc") {
    std::string metadata;
    const Tracked_complex complex = Tracked_complex::from_checkpoint(options.file, metadata);
    if (const std::optional<Saved_run> run = from_metadata(metadata))
      std::cout << "step                 " << run->position.step << ", time " << run->position.time
                << '\n';
    print(complex.statistics());
  } else
    print(surface_statistics(options.file));
  return 0;
}

} // namespace dsc

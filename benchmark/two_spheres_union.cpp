// Offsets two spheres until they overlap, and prints rows of a table: the volume of the result and
// the exact volume of the union.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/number_utils.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;
using CGAL::Deformable_simplicial_complexes::Forbid_topology_changes;

constexpr double start_radius = .2, half_distance = .25;

// Returns the volume of two overlapping spheres of this radius, by the formula for two caps.
double exact_volume(double r) {
  const double d = 2 * half_distance, spheres = 8 * CGAL_PI * r * r * r / 3;
  return r <= half_distance ? spheres
                            : spheres - CGAL_PI * (4 * r + d) * (2 * r - d) * (2 * r - d) / 12;
}

Surface spheres(std::size_t n) {
  Surface surface;
  for (double x : {-half_distance, half_distance})
    append_sphere(surface, Kernel::Vector_3(x / start_radius, 0, 0), n);
  for (auto& p : surface.points)
    p = CGAL::ORIGIN + start_radius * (p - CGAL::ORIGIN);
  return surface;
}

// Steps of a quarter of a mean edge; the last step before each radius is shorter.
int measure(std::size_t n, bool forbid, bool moves_faces) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{spheres(n)}, CGAL::Tetgen_tetrahedralizer_3());
  const std::size_t triangles = complex.interface_facets().size();
  const double step = complex.mean_interface_edge() / 4;
  const double volume_at_start = complex.volume(1) / exact_volume(start_radius);
  double r = start_radius;
  std::size_t merged = 0, unfinished = 0;
  const double begin = processor_seconds();
  for (double target : {.3, .35, .4}) {
    while (r < target) {
      const double dt = (std::min)(step, target - r);
      const auto report =
          forbid        ? DSC::advect_interface(complex, DSC::Normal_offset{1}, r, dt,
                                                parameters::topology_control(Forbid_topology_changes()))
          : moves_faces ? DSC::advect_interface(complex, DSC::Face_offset_3(1), r, dt)
                        : DSC::advect_interface(complex, DSC::Normal_offset{1}, r, dt);
      r = r + dt < target ? r + dt : target;
      unfinished = report.unfinished.size();
      for (const auto& event : report.events) {
        std::cerr << "r = " << r << ", label " << event.label << ": " << event.before.size()
                  << " -> " << event.after.size() << " at " << event.where << '\n';
        merged += event.label == 1 && event.kind == DSC::Component_event::Kind::merged;
      }
    }
    std::cout.precision(4);
    std::cout << "| " << triangles << " | " << (moves_faces ? "faces" : "vertices") << " | "
              << (forbid ? "forbidden" : "allowed") << " | " << r << " | "
              << complex.number_of_components(1) << " | " << complex.euler_characteristic(1)
              << " | " << complex.volume(1) << " | " << exact_volume(r) << " | "
              << 100 * (complex.volume(1) / exact_volume(r) - 1) << " | "
              << 100 * (volume_at_start - 1) << " | " << unfinished << " | " << merged << " | "
              << processor_seconds() - begin << " |" << std::endl;
  }
  return check(complex) ? 0 : 1;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Offsets two spheres into each other.");
  std::size_t n = 9;
  bool forbid = false, moves_faces = false;
  app.add_option("-n", n, "20 n^2 triangles a sphere");
  app.add_flag("--forbid", forbid, "changes of topology");
  app.add_flag("--faces", moves_faces, "offset faces, not vertices");
  CLI11_PARSE(app, argc, argv);
  return dsc_benchmark::measure(n, forbid, moves_faces);
}

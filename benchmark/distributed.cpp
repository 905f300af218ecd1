// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves surfaces on several processes, and prints a row of a table for each step: cells, wall-clock
// time, rounds, and what the process with the most messages sent. The last row has the memory. Or
// compares the results with those of one rank without patches.

#include "inputs.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Distributed_complexes/Mpi_communicator.h>
#include <CGAL/Distributed_complexes/advect_distributed_interface.h>
#include <CGAL/Distributed_complexes/refine_distributed_complex_3.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_flows/velocity_fields_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#ifdef DSC_WITH_SCOTCH
#include <CGAL/Distributed_complexes/Scotch_partitioner.h>
#endif

#include <CLI/CLI.hpp>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace dsc_benchmark {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Distributed = DSC::Distributed_complex<Complex>;
using Point = Complex::Point_3;
using Vector = Complex::Vector_3;
using Operation = DSC::Communicator::Operation;

/// Returns a number of /proc/self/status in MB; 0 if it is unknown.
double megabytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name + ":") {
      double kilobytes = 0;
      status >> kilobytes;
      return kilobytes / 1024;
    }
  return 0;
}

struct Options
{
  std::string motion = "offset";
  std::size_t n = 16;
  int refinements = 0, steps = 3;
  bool compares = false;
};

/// A field without divergence and with strong shear.
Vector abuse(const Point& p, double t) {
  return {std::sin(7 * p.y() + t) + .5 * std::cos(11 * p.z()), std::sin(9 * p.z() - t),
          std::cos(8 * p.x() + 3 * p.y())};
}

/// Does a step of about a quarter of an edge. Returns the report.
template <class Dsc> auto step(Dsc& dsc, const Options& options, int i) {
  const double edge = dsc.mean_interface_edge(), dt = .25 * edge;
  if (options.motion == "rotate")
    return advect_interface(dsc, DSC::Rigid_rotation_3(Point(0, 0, 0), Vector(0, 0, 1), dt), 0, 1);
  if (options.motion == "enright")
    return advect_interface(dsc, DSC::Enright_velocity_3(3), dt * i, dt);
  if (options.motion == "abuse")
    return advect_interface(dsc, abuse, dt * i, dt);
  return advect_interface(dsc, DSC::Normal_offset{dt}, 0, 1);
}

/// Returns the surface of a motion.
Surface start(const Options& options) {
  Surface surface;
  if (options.motion == "spheres") {
    for (double x : {-1.3, 1.3})
      append_sphere(surface, Kernel::Vector_3(x, 0, 0), options.n);
    return surface;
  }
  surface = sphere(options.motion == "enright" ? .15 : 1, options.n);
  if (options.motion == "enright")
    for (auto& p : surface.points)
      p = p + Kernel::Vector_3(.35, .35, .35);
  return surface;
}

/// Returns the complex at the start of a motion.
Complex start_complex(const Options& options) {
  DSC::Construction_options<3> construction;
  if (options.motion == "enright")
    construction.enclosing_box = CGAL::Bbox_3(0, 0, 0, 1, 1, 1);
  return DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{start(options)}, CGAL::Tetgen_tetrahedralizer_3(), construction);
}

/// The results of all steps of a run: the vertices that did not arrive, the worst quality of a cell
/// after a step, and the volume of the label 1 at the end.
struct Results
{
  std::size_t unfinished = 0;
  double quality = 1, volume = 0, seconds = 0;

  void print(const char* mode) const {
    std::printf("| %s | %zu | %.4f | %.8f | %.2f |\n", mode, unfinished, quality, volume, seconds);
  }
};

double worst_quality(const Complex& complex) {
  double result = 1;
  for (const auto c : complex.finite_cells())
    result = (std::min)(result, c->quality());
  return result;
}

/// Compares the results of several ranks with those of one rank without patches.
void compare(const Options& options) {
  DSC::Mpi_communicator communicator;
  Distributed dsc(communicator);
  Complex complex;
  const bool prints = communicator.rank() == 0;
  if (prints)
    complex = start_complex(options);
  dsc.distribute(complex);
  Results distributed;
  for (int i = 0; i < options.steps; ++i) {
    const double begin = MPI_Wtime();
    const auto report = step(dsc, options, i);
    distributed.seconds += MPI_Wtime() - begin;
    distributed.unfinished += std::size_t(report.unfinished);
    const Complex whole = dsc.gather();
    if (prints) {
      distributed.quality = (std::min)(distributed.quality, worst_quality(whole));
      distributed.volume = whole.volume(1);
    }
  }
  if (!prints)
    return;
  Results alone;
  const double before = complex.volume(1);
  for (int i = 0; i < options.steps; ++i) {
    const double begin = MPI_Wtime();
    alone.unfinished += step(complex, options, i).unfinished.size();
    alone.seconds += MPI_Wtime() - begin;
    alone.quality = (std::min)(alone.quality, worst_quality(complex));
    alone.volume = complex.volume(1);
  }
  std::printf("%s, %d steps, volume %.8f at the beginning\n\n| mode | unfinished | worst quality | "
              "volume | s |\n|---|---|---|---|---|\n",
              options.motion.c_str(), options.steps, before);
  alone.print("one rank, deform_interface()");
  distributed.print(("patches, ranks: " + std::to_string(communicator.size())).c_str());
}

void run(const Options& options) {
  DSC::Mpi_communicator communicator;
  Distributed dsc(communicator);
  Complex coarse;
  if (communicator.rank() == 0)
    coarse = start_complex(options);
  dsc.distribute(coarse);
  coarse.clear();
  for (int i = 0; i < options.refinements; ++i)
    refine_3(dsc);
  const auto divide = [&] {
#ifdef DSC_WITH_SCOTCH
    dsc.rebalance(DSC::Scotch_partitioner());
#else
    dsc.rebalance();
#endif
  };
  const auto most = [&](std::uint64_t number) {
    return communicator.reduced(Operation::maximum, std::int64_t(number));
  };
  const bool prints = communicator.rank() == 0;
  if (prints)
    std::printf("| step | tetrahedra | s | passes | rounds | patches | exchanges | reductions | "
                "messages | MB sent | checksum |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 0; i < options.steps; ++i) {
    divide();
    const auto before = communicator.traffic();
    const double begin = MPI_Wtime();
    const auto report = step(dsc, options, i);
    const double seconds = MPI_Wtime() - begin;
    const auto after = communicator.traffic();
    const std::int64_t messages = most(after.messages - before.messages);
    const double megabytes_sent = double(most(after.bytes - before.bytes)) / 1e6;
    const auto cells = dsc.number_of_cells();
    const auto checksum = dsc.checksum();
    if (prints)
      std::printf("| %d | %llu | %.2f | %u | %lld | %lld | %llu | %llu | %lld | %.3f | %016llx |\n",
                  i + 1, static_cast<unsigned long long>(cells), seconds, report.passes,
                  static_cast<long long>(report.rounds), static_cast<long long>(report.patches),
                  static_cast<unsigned long long>(after.exchanges - before.exchanges),
                  static_cast<unsigned long long>(after.reductions - before.reductions),
                  static_cast<long long>(messages), megabytes_sent,
                  static_cast<unsigned long long>(checksum));
  }
  const std::int64_t own = most(dsc.number_of_own_cells()), held = most(dsc.number_of_held_cells()),
                     bytes = most(dsc.memory()),
                     peak = most(std::uint64_t(megabytes("VmHWM") * 1e6));
  if (prints)
    std::printf("\nprocess with the most: %lld own tetrahedra, %lld held, %.0f MB of the complex, "
                "%.0f MB peak of the process\n",
                static_cast<long long>(own), static_cast<long long>(held), double(bytes) / 1e6,
                double(peak) / 1e6);
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  CLI::App app("Moves surfaces on several processes");
  dsc_benchmark::Options options;
  app.add_option("--motion", options.motion, "offset, rotate, enright, spheres or abuse")
      ->check(CLI::IsMember({"offset", "rotate", "enright", "spheres", "abuse"}));
  app.add_option("--n", options.n, "The sphere has 20 n^2 triangles before it is refined");
  app.add_option("--refinements", options.refinements, "Each gives eight times as many tetrahedra");
  app.add_option("--steps", options.steps, "Number of steps");
  app.add_flag("--compare", options.compares, "Compare with one rank without patches");
  CLI11_PARSE(app, argc, argv);
  if (options.compares)
    dsc_benchmark::compare(options);
  else
    dsc_benchmark::run(options);
  MPI_Finalize();
}

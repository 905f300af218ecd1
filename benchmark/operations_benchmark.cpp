// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the operations of motion and improvement on the complex of a surface. Proposals are made
// for all cells or vertices in turn; `accepted` is the fraction of the proposals that can be
// committed.
// Usage: operations_benchmark MESH [options of Google Benchmark]

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Harmonic_extension.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

using Cell_handle = Complex::Cell_handle;
using Vertex_handle = Complex::Vertex_handle;
using Star = std::vector<Cell_handle>;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;
namespace parameters = CGAL::parameters;

// Measures `operation(i)` for i = 0, ..., n - 1 in turn, and counts how often it returned true.
template <class Operation>
void add_benchmark(const std::string& name, std::size_t n, Operation operation) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) mutable {
    std::size_t i = 0, accepted = 0;
    for ([[maybe_unused]] auto _ : state) {
      accepted += operation(i);
      i = i + 1 == n ? 0 : i + 1;
    }
    state.counters["accepted"] =
        benchmark::Counter(double(accepted), benchmark::Counter::kAvgIterations);
  });
}

void add_proposals_for_cells(const Complex& complex) {
  const Star cells = complex.cells();
  const auto add = [&](const std::string& name, auto propose) {
    add_benchmark(name, cells.size(),
                  [cells, propose, cavity = Complex::Cavity(complex)](std::size_t i) mutable {
                    return propose(cells[i], i, cavity);
                  });
  };
  const auto add_for_edges = [&](const std::string& name, auto propose) {
    static constexpr std::array<std::array<int, 2>, 6> edges = {
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    add(name, [propose](Cell_handle c, std::size_t i, Complex::Cavity& cavity) {
      return propose(c, edges[i % 6][0], edges[i % 6][1], cavity);
    });
  };
  add_for_edges("propose_edge_removal", [&](Cell_handle c, int i, int j, auto& cavity) {
    return DSC::propose_edge_removal(complex, c, i, j, cavity);
  });
  add_for_edges("propose_interface_edge_flip", [&](Cell_handle c, int i, int j, auto& cavity) {
    return DSC::propose_interface_edge_flip(complex, c, i, j, cavity);
  });
  add_for_edges("propose_edge_collapse", [&](Cell_handle c, int i, int j, auto& cavity) {
    return DSC::propose_edge_collapse(complex, c, i, j, .1, cavity);
  });
  add_for_edges("propose_edge_split", [&](Cell_handle c, int i, int j, auto& cavity) {
    return DSC::propose_edge_split(complex, c, i, j, .5, cavity);
  });
  add("propose_multi_face_removal", [&](Cell_handle c, std::size_t i, auto& cavity) {
    return DSC::propose_multi_face_removal(complex, c, int(i % 4), cavity);
  });
  // With a threshold of 1, each cell is examined.
  add("propose_relabeling", [&](Cell_handle c, std::size_t, auto&) {
    Complex::Label label = c->subdomain_index();
    return DSC::propose_relabeling(complex, c, 1., label);
  });
}

void add_stars_and_motion(Complex& complex) {
  std::vector<Vertex_handle> free, moving;
  for (const Vertex_handle v : complex.vertices())
    if (!complex.is_boundary(v)) {
      moving.push_back(v);
      if (!v->is_interface())
        free.push_back(v);
    }

  add_benchmark("star", moving.size(), [&complex, moving, star = Star()](std::size_t i) mutable {
    complex.star(moving[i], star);
    return true;
  });
  add_benchmark("star and propose_smart_laplacian", free.size(),
                [&complex, free, star = Star()](std::size_t i) mutable {
                  complex.star(free[i], star);
                  Complex::Point_3 target;
                  return DSC::propose_smart_laplacian(complex, free[i], star, target);
                });
  add_benchmark("star and propose_optimal_position", free.size(),
                [&complex, free, star = Star()](std::size_t i) mutable {
                  complex.star(free[i], star);
                  Complex::Point_3 target;
                  return DSC::propose_optimal_position(complex, free[i], star, target);
                });
  const Vector step = complex.mean_interface_edge() * Vector(.01, .02, .03);
  add_benchmark(
      "move_vertex, there and back", moving.size(), [&complex, moving, step](std::size_t i) {
        const Complex::Point_3 p = moving[i]->point();
        const Point q = complex.position(moving[i]) + step;
        return complex.move_vertex(moving[i], q) == 1 && complex.move_vertex(moving[i], p) == 1;
      });
}

void add_passes(const Complex& complex) {
  benchmark::RegisterBenchmark("sweep: exact orientation and quality of all cells",
                               [&complex, cells = complex.cells()](benchmark::State& state) {
                                 for ([[maybe_unused]] auto _ : state)
                                   benchmark::DoNotOptimize(sweep(complex, cells));
                                 state.counters["cells"] = double(cells.size());
                               })
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(
      "harmonic extension of a rotation to all free vertices",
      [&complex](benchmark::State& state) {
        std::vector<Vertex_handle> free;
        for (const Vertex_handle v : complex.vertices())
          if (!v->is_interface() && !complex.is_boundary(v))
            free.push_back(v);
        const auto displacement_of = [&](Vertex_handle v) {
          const Point p = complex.position(v);
          return v->is_interface() ? 2 * degree * Vector(-p.y(), p.x(), 0) : Vector(0, 0, 0);
        };
        const DSC::For_each_index for_each_index;
        std::vector<std::uint32_t> numbers(free.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        for ([[maybe_unused]] auto _ : state) {
          const internal::Moving_region<Complex> region(complex, free, for_each_index);
          const auto displacement = [&](std::size_t v) {
            return displacement_of(region.vertices()[v]);
          };
          benchmark::DoNotOptimize(
              internal::Harmonic_extension<Complex>(region, numbers, displacement, for_each_index)
                  .solve());
        }
        state.counters["vertices"] = double(free.size());
      })
      ->Unit(benchmark::kMillisecond);
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  namespace parameters = dsc_benchmark::parameters;
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::cerr << "Usage: operations_benchmark MESH [options of Google Benchmark]\n";
    return EXIT_FAILURE;
  }
  try {
    auto complex = DSC::make_deformable_simplicial_complex_3<dsc_benchmark::Complex>(
        {dsc_benchmark::read_input(argv[1], 0)}, CGAL::Tetgen_tetrahedralizer_3(),
        parameters::normalize(true));
    complex.sort_storage();
    dsc_benchmark::add_passes(complex);
    dsc_benchmark::add_stars_and_motion(complex);
    dsc_benchmark::add_proposals_for_cells(complex);
    benchmark::RunSpecifiedBenchmarks();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "operations_benchmark: " << argv[1] << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

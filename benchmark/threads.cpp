// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the same work with several numbers of threads in turn. Prints a row of a table: the
// wall-clock times, the parallel share that they imply, speedups predicted from it, and whether all
// results are bitwise equal.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

using Work = std::function<void(Complex&, unsigned number_of_threads)>;

/// A number of steps of a flow.
template <class Flow> Work steps_of(const Flow& flow, int number, double dt) {
  return [=](Complex& complex, unsigned number_of_threads) {
    for (int i = 0; i < number; ++i)
      DSC::advect_interface(complex, flow, i * dt, dt,
                            parameters::number_of_threads(number_of_threads));
  };
}

/// Operations on a complex by their names.
std::map<std::string, Work> works(const Complex& complex) {
  static constexpr int number_of_steps = 10;
  const double edge = complex.mean_interface_edge();
  return {{"rotation", steps_of(DSC::Rigid_rotation_3(centre(bounding_box(complex)),
                                                      Vector(0, 0, 1), 2 * degree),
                                number_of_steps, 1)},
          {"offset", steps_of(DSC::Normal_offset{edge / 4}, number_of_steps, 1)},
          {"mean_curvature", steps_of(DSC::Mean_curvature_flow(), number_of_steps, edge * edge)}};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The parallel share of a work by Amdahl's law, from its times with one thread and with several.
double parallel_share(double one, double several, unsigned number_of_threads) {
  return (1 - several / one) / (1 - 1. / number_of_threads);
}

/// A speedup predicted by Amdahl's law, without limits by memory.
double predicted_speedup(double share, unsigned number_of_threads) {
  return 1 / (1 - share + share / number_of_threads);
}

int run(const std::string& name, const std::string& input, std::size_t triangles,
        const std::vector<unsigned>& threads, int repetitions) {
  Complex initial = DSC::make_deformable_simplicial_complex_3<Complex>(
      {read_input(input, triangles)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::normalize(true));
  initial.sort_storage();
  const Work work = works(initial).at(name);

  std::vector<std::vector<double>> seconds(threads.size()), busy(threads.size());
  bool is_same = true;
  Complex::State expected;
  for (int repetition = 0; repetition < repetitions; ++repetition)
    for (std::size_t k = 0; k < threads.size(); ++k) {
      Complex complex = initial;
      const auto start = std::chrono::steady_clock::now();
      const std::clock_t processor_start = std::clock();
      work(complex, threads[k]);
      const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
      seconds[k].push_back(duration.count());
      busy[k].push_back(double(std::clock() - processor_start) / CLOCKS_PER_SEC /
                        (threads[k] * duration.count()));
      if (repetition == 0 && k == 0)
        expected = complex.state();
      else
        is_same = is_same && complex.state() == expected;
    }

  std::cout.precision(3);
  std::cout << "| " << name << " | " << std::filesystem::path(input).stem().string() << " | "
            << initial.number_of_cells() << " | ";
  const double first = median(seconds[0]);
  std::cout << first << " | ";
  for (std::size_t k = 1; k < threads.size(); ++k)
    std::cout << median(seconds[k]) << " | " << first / median(seconds[k]) << " | "
              << 100 * median(busy[k]) << " % | ";
  if (threads.size() > 1 && threads[0] == 1 && threads[1] > 1) {
    const double share = parallel_share(first, median(seconds[1]), threads[1]);
    if (share > 0 && share <= 1) {
      std::cout << 100 * share << " % |";
      for (unsigned number : {4, 8, 16})
        std::cout << ' ' << predicted_speedup(share, number);
      std::cout << " | ";
    } else {
      std::cout << "– | – | "; // other work has disturbed the measurement
    }
  }
  std::cout << (is_same ? "same" : "different") << " |" << std::endl;
  return is_same ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Does the same work with several numbers of threads, in turns.");
  std::string work, input;
  std::size_t triangles = 0;
  std::vector<unsigned> threads = {1, 2};
  int repetitions = 5;
  app.add_option("work", work)
      ->required()
      ->check(CLI::IsMember({"rotation", "offset", "mean_curvature"}));
  app.add_option("mesh", input, "a file, sphere, or two_spheres")->required();
  app.add_option("--triangles", triangles, "to which a finer surface is decimated");
  app.add_option("--threads", threads, "their numbers");
  app.add_option("--repetitions", repetitions, "of which the median is taken");
  CLI11_PARSE(app, argc, argv);
  try {
    return dsc_benchmark::run(work, input, triangles, threads, repetitions);
  } catch (const std::exception& error) {
    std::cerr << "threads: " << input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

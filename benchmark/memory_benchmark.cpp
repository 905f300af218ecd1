// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the bytes per tetrahedron of a new complex. The bytes of cells and vertices are computed
// from the capacities of their containers. The total is the memory that the destruction of the
// complex releases. Prints a row of a table, without the table head. Needs the GNU C library on
// Linux.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include <malloc.h>
#include <unistd.h>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

double heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd); // in the heap and in separate mappings
}

double resident_bytes() {
  malloc_trim(0);
  std::size_t pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident_pages;
  return double(resident_pages) * double(sysconf(_SC_PAGESIZE));
}

template <class Container> double container_bytes(const Container& container) {
  return double(container.capacity()) * sizeof(typename Container::value_type);
}

void run(const std::string& input, std::size_t triangles, const std::string& json_path) {
  auto complex = std::make_unique<Complex>(DSC::make_deformable_simplicial_complex_3<Complex>(
      {read_input(input, triangles)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::normalize(true)));
  const std::size_t tetrahedra = complex->number_of_cells();
  const double cells = container_bytes(complex->triangulation().tds().cells());
  const double vertices = container_bytes(complex->triangulation().tds().vertices());

  double heap = heap_bytes(), resident = resident_bytes();
  complex.reset();
  heap -= heap_bytes();
  resident -= resident_bytes();

  const auto per_tetrahedron = [&](double bytes) { return bytes / double(tetrahedra); };
  const nlohmann::ordered_json result = {{"input", std::filesystem::path(input).stem().string()},
                                         {"tetrahedra", tetrahedra},
                                         {"cells", per_tetrahedron(cells)},
                                         {"vertices", per_tetrahedron(vertices)},
                                         {"other", per_tetrahedron(heap - cells - vertices)},
                                         {"all", per_tetrahedron(heap)},
                                         {"resident", per_tetrahedron(resident)}};
  std::cout.precision(4);
  for (const auto& [key, value] : result.items())
    if (value.is_number_float())
      std::cout << "| " << value.get<double>() << ' ';
    else
      std::cout << "| " << (value.is_string() ? value.get<std::string>() : value.dump()) << ' ';
  std::cout << '|' << std::endl;
  if (!json_path.empty())
    std::ofstream(json_path) << result.dump(2) << '\n';
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Counts the bytes per tetrahedron of a complex.");
  std::string input, json_path;
  std::size_t triangles = 0;
  app.add_option("mesh", input, "a file, sphere, or two_spheres")->required();
  app.add_option("--triangles", triangles, "to which a finer surface is decimated");
  app.add_option("--json", json_path, "a file for the numbers");
  CLI11_PARSE(app, argc, argv);
  try {
    dsc_benchmark::run(input, triangles, json_path);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "memory_benchmark: " << input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

// Measures improve_mesh() on the tetrahedra that TetGen generates for a surface in a box, and
// prints a row of a table.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

using Complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default, DSC::Biased_minimum_sine_3>;

// The dihedral angles of all cells, and of the free cells. The fixed interface determines angles of
// cells with two facets on it, and of cells with a facet whose smallest angle is below a bound. The
// cells around a nearly degenerate facet cannot be improved either.
struct Statistics
{
  Angles all, free;
  std::size_t dictated = 0, cramped = 0;
  std::size_t poor = 0; // free cells with an angle outside 25 to 145 degrees

  void add_free(const std::array<double, 6>& angles) {
    free.add(angles);
    const auto extremes = std::minmax_element(angles.begin(), angles.end());
    poor += *extremes.first < 25 || *extremes.second > 145;
  }
};

double smallest_angle(const Complex& complex, const Complex::Facet& f) {
  const auto v = complex.facet_vertices(f);
  double smallest = 180;
  for (int i = 0; i < 3; ++i) {
    const Point p = complex.position(v[i]);
    const Vector a = complex.position(v[(i + 1) % 3]) - p, b = complex.position(v[(i + 2) % 3]) - p;
    smallest = (std::min)(smallest,
                          std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b) /
                              degree);
  }
  return smallest;
}

// Returns the vertices of interface facets with an angle below a bound in degrees.
std::set<Complex::Vertex_handle> corners_of_segments(const Complex& complex, double bound) {
  std::set<Complex::Vertex_handle> result;
  for (const auto& f : complex.interface_facets())
    if (smallest_angle(complex, f) < bound)
      for (const auto v : complex.facet_vertices(f))
        result.insert(v);
  return result;
}

Statistics statistics(const Complex& complex, double sharp) {
  static constexpr double segment = 3; // degrees
  const auto corners = corners_of_segments(complex, segment);
  Statistics result;
  for (const Complex::Cell_handle c : complex.triangulation().finite_cell_handles()) {
    int fixed = 0;
    bool is_sharp = false, is_cramped = false;
    for (int i = 0; i < 4; ++i) {
      is_cramped = is_cramped || corners.count(c->vertex(i)) > 0;
      if (complex.is_interface(std::make_pair(c, i))) {
        ++fixed;
        is_sharp = is_sharp || smallest_angle(complex, std::make_pair(c, i)) < sharp;
      }
    }
    const auto angles = dihedral_angles(complex, c);
    result.all.add(angles);
    if (fixed > 1 || is_sharp)
      ++result.dictated;
    else if (is_cramped)
      ++result.cramped;
    else
      result.add_free(angles);
  }
  return result;
}

using Interface = std::vector<std::array<std::array<double, 3>, 3>>;

// As bitwise coordinates.
Interface interface_of(const Complex& complex) {
  Interface result;
  for (const auto& f : complex.interface_facets()) {
    std::array<std::array<double, 3>, 3> triangle;
    const auto v = complex.facet_vertices(f);
    for (int i = 0; i < 3; ++i) {
      const Point p = complex.position(v[i]);
      triangle[i] = {p.x(), p.y(), p.z()};
    }
    std::sort(triangle.begin(), triangle.end());
    result.push_back(triangle);
  }
  std::sort(result.begin(), result.end());
  return result;
}

void print_angles(const Angles& angles) {
  std::cout << angles.minimum << " – " << angles.maximum << " | ";
}

int measure(const std::string& input, std::size_t triangles, bool aggressive, double sharp,
            unsigned number_of_threads) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{read_input(input, triangles)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::normalize(true).improve(false));
  const Interface before = interface_of(complex);
  const Statistics start = statistics(complex, sharp);
  const std::size_t tetrahedra = complex.number_of_cells();

  const auto begin = std::chrono::steady_clock::now();
  DSC::improve_mesh(complex,
                    parameters::aggressive(aggressive).number_of_threads(number_of_threads));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  const Statistics end = statistics(complex, sharp);
  std::cout.precision(4);
  std::cout << "| " << input.substr(input.find_last_of('/') + 1) << " | "
            << (aggressive ? "aggressive" : "default") << " | " << tetrahedra << " | "
            << complex.number_of_cells() << " | ";
  print_angles(start.all);
  print_angles(end.all);
  print_angles(end.free);
  std::cout << end.poor << " | " << end.dictated << " | " << end.cramped << " | " << seconds
            << " | " << double(tetrahedra) / seconds << " |\n";
  return check(complex) && interface_of(complex) == before ? 0 : 1;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Measures the improvement of a mesh at rest.");
  std::string input;
  std::size_t triangles = 0;
  bool aggressive = false;
  double sharp = 15;
  unsigned number_of_threads = 1;
  app.add_option("input", input, "a closed surface")->required();
  app.add_option("--triangles", triangles, "decimate it first");
  app.add_flag("--aggressive", aggressive, "take more time");
  app.add_option("--sharp", sharp,
                 "angles of the surface below this dictate those around, degrees");
  app.add_option("--threads", number_of_threads, "number of threads")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  return dsc_benchmark::measure(input, triangles, aggressive, sharp, number_of_threads);
}

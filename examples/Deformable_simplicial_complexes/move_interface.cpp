// Moves two cubes until they merge, and prints the changes of topology that a visitor receives.
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Kernel::Point_3;

// Counts relabeled cells, and prints events.
struct Printer : DSC::Deformation_visitor<Complex>
{
  void after_relabel(Complex::Cell_handle /*cell*/, int /*before*/) override { ++relabeled; }
  void after_topology_event(const DSC::Topology_event<Complex>& event) override {
    std::cout << "label " << event.label << ": " << event.before.size() << " -> "
              << event.after.size() << " components" << std::endl;
  }
  int relabeled = 0;
};

int main() {
  // The box [-1,1]^3 in n^3 cubes, each of six tetrahedra around a diagonal
  const std::size_t n = 8;
  using Indices = std::array<std::size_t, 3>;
  const auto index = [=](const Indices& i) { return (i[2] * (n + 1) + i[1]) * (n + 1) + i[0]; };
  std::vector<Point> points;
  for (std::size_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    points.emplace_back(2. * double(i % (n + 1)) / n - 1,
                        2. * double(i / (n + 1) % (n + 1)) / n - 1,
                        2. * double(i / (n + 1) / (n + 1)) / n - 1);
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  for (std::size_t i = 0; i < n * n * n; ++i) {
    Indices axes = {0, 1, 2};
    do {
      Indices corner = {i % n, i / n % n, i / n / n};
      std::array<std::size_t, 4> t = {index(corner)};
      for (std::size_t k = 0; k < 3; ++k) {
        ++corner[axes[k]];
        t[k + 1] = index(corner);
      }
      if (CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) < 0)
        std::swap(t[2], t[3]);
      tetrahedra.push_back(t);
      // Label 1 in two cubes of side length 1/2
      const Point p = CGAL::centroid(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
      labels.push_back(
          (std::max)({std::abs(std::abs(p.x()) - .5), std::abs(p.y()), std::abs(p.z())}) < .25);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  Complex complex;
  complex.assign(points, tetrahedra, labels);

  // Each step moves both cubes towards each other by a fifth of an edge length.
  Printer printer;
  for (int step = 0; step < 6; ++step) {
    const auto report = DSC::deform_interface(
        complex,
        [](Complex::Vertex_handle v) {
          const Point& p = v->point();
          return p + Kernel::Vector_3(p.x() < 0 ? .05 : -.05, 0, 0);
        },
        CGAL::parameters::visitor(std::ref(printer)));
    std::cout << "step " << step << ": volume " << complex.volume(1) << ", "
              << report.unfinished.size() << " vertices did not arrive" << std::endl;
  }
  std::cout << printer.relabeled << " cells relabeled, " << complex.number_of_components(1)
            << " component(s)" << std::endl;
  return complex.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Shrinks a square in the plane, while a visitor bounds the number of passes.
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

// Ends a deformation after three passes.
struct Three_passes : DSC::Deformation_visitor<Complex>
{
  bool go_further(unsigned pass) override { return pass <= 3; }
};

int main() {
  // The square [-1,1]^2 in n^2 squares of two triangles; label 1 in the square [-1/2,1/2]^2
  const std::size_t n = 16;
  std::vector<Point> points;
  for (std::size_t i = 0; i < (n + 1) * (n + 1); ++i)
    points.emplace_back(2. * double(i % (n + 1)) / n - 1, 2. * double(i / (n + 1)) / n - 1);
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  for (std::size_t i = 0; i < n * n; ++i) {
    const std::size_t a = i / n * (n + 1) + i % n, b = a + 1, c = a + n + 1, d = c + 1;
    triangles.push_back({a, b, d});
    triangles.push_back({a, d, c});
    const Point p = CGAL::midpoint(points[a], points[d]);
    labels.insert(labels.end(), 2, std::abs(p.x()) < .5 && std::abs(p.y()) < .5);
  }
  Complex complex;
  complex.assign(points, triangles, labels);

  for (int step = 0; step < 40 && complex.area(1) > 0; ++step) {
    const auto report = DSC::deform_interface(
        complex,
        [](Complex::Vertex_handle v) { return CGAL::ORIGIN + .9 * (v->point() - CGAL::ORIGIN); },
        CGAL::parameters::visitor(Three_passes()));
    if (step % 5 == 0)
      std::cout << "step " << step << ": area " << complex.area(1) << ", length "
                << complex.length(1) << ", " << report.collapsed << " collapses" << std::endl;
  }
  std::cout << complex.number_of_cells(1) << " triangles of label 1 are left" << std::endl;
  return complex.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}

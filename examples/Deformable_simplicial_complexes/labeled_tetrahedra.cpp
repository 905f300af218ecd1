// Builds a complex of four labels from labeled tetrahedra, and measures volumes, interfaces and
// triple lines.
#include <CGAL/Deformable_simplicial_complex_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Indices = std::array<std::size_t, 3>;

// Label 0 below; above, label 1 on one side and the labels 2 and 3 on the other side
int label_at(const Point& p) { return p.z() < 0 ? 0 : p.x() < 0 ? 1 : p.y() < 0 ? 2 : 3; }

int main() {
  // The box [-1,1]^3 in n^3 cubes, each of six tetrahedra around a diagonal
  const std::size_t n = 4;
  const auto index = [=](const Indices& i) { return (i[2] * (n + 1) + i[1]) * (n + 1) + i[0]; };
  std::vector<Point> points;
  for (std::size_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
    const std::size_t x = i % (n + 1), y = i / (n + 1) % (n + 1), z = i / (n + 1) / (n + 1);
    points.emplace_back(2. * x / n - 1, 2. * y / n - 1, 2. * z / n - 1);
  }
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  for (std::size_t i = 0; i < n * n * n; ++i) {
    Indices axes = {0, 1, 2};
    do { // walk from the lowest corner of the cube to the highest one along the axes in this order
      Indices corner = {i % n, i / n % n, i / n / n};
      std::array<std::size_t, 4> t = {index(corner)};
      for (std::size_t k = 0; k < 3; ++k) {
        ++corner[axes[k]];
        t[k + 1] = index(corner);
      }
      if (CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) < 0)
        std::swap(t[2], t[3]);
      tetrahedra.push_back(t);
      labels.push_back(
          label_at(CGAL::centroid(points[t[0]], points[t[1]], points[t[2]], points[t[3]])));
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  Complex complex;
  complex.assign(points, tetrahedra, labels);

  for (const int a : complex.labels()) {
    std::cout << "label " << a << ": volume " << complex.volume(a) << ", "
              << complex.number_of_components(a) << " component(s)\n";
    for (const int b : complex.labels())
      if (a < b)
        std::cout << "  interface with label " << b << ": " << complex.interface_facets(a, b).size()
                  << " facets, area " << complex.area(a, b) << '\n';
  }

  // The triple lines: edges where three labels meet
  double length = 0;
  const Complex::Triangulation& triangulation = complex.triangulation();
  for (const Complex::Edge& e : triangulation.finite_edges()) {
    std::set<int> around;
    auto c = triangulation.incident_cells(e), done = c;
    do
      if (!triangulation.is_infinite(c))
        around.insert(complex.label(c));
    while (++c != done);
    if (around.size() == 3)
      length += std::sqrt(triangulation.segment(e).squared_length());
  }
  std::cout << "triple lines of length " << length << std::endl;
  return EXIT_SUCCESS;
}

#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_TORUS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_TORUS_H

#include "test.h"

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>

namespace torus {

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<2>;
using Complex = CGAL::Deformable_simplicial_complex_2<CGAL::Epick, CGAL::Default, Domain>;
using Point = Complex::Point_2;

// n times n squares of two triangles each, with the labels of their barycenters.
template <class Label>
Complex grid(std::size_t n, const Label& label, const std::array<double, 2>& periods = {1, 1}) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  const double dx = periods[0] / double(n), dy = periods[1] / double(n);
  const auto index = [n](std::size_t i, std::size_t j) { return i % n * n + j % n; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      points.emplace_back(double(i) * dx, double(j) * dy);
      triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      labels.push_back(label(Point((double(i) + 2. / 3) * dx, (double(j) + 1. / 3) * dy)));
      triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
      labels.push_back(label(Point((double(i) + 1. / 3) * dx, (double(j) + 2. / 3) * dy)));
    }
  Complex complex((Domain(periods)));
  complex.assign(points, triangles, labels);
  return complex;
}

} // namespace torus

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_TORUS_H

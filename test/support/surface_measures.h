#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SURFACE_MEASURES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SURFACE_MEASURES_H

#include "small_meshes.h"
#include "test.h"

// Functions for the tests of files and of extraction.
namespace surface_measures {

using small_meshes::Complex;

// Returns a complex whose user coordinates reveal a loss of digits.
template <class Label> Complex complex_with_long_coordinates(Label label) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(4, label));
  dsc.set_normalization({Complex::Vector_3(0.1, -100, 1e-7), 1. / 3});
  return dsc;
}

struct Measures
{
  double area = 0;
  double volume = 0; // the volume behind the triangles if they are closed
  long euler_characteristic = 0;
};

template <class Points, class Triangles>
Measures measures(const Points& points, const Triangles& triangles) {
  Measures result;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& t : triangles) {
    const auto p = points[t[0]] - CGAL::ORIGIN, q = points[t[1]] - CGAL::ORIGIN,
               r = points[t[2]] - CGAL::ORIGIN;
    result.area += std::sqrt(CGAL::cross_product(q - p, r - p).squared_length()) / 2;
    result.volume += CGAL::cross_product(p, q) * r / 6;
    for (int i = 0; i < 3; ++i)
      ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  }
  result.euler_characteristic = long(points.size()) - long(edges.size()) + long(triangles.size());
  return result;
}

template <class Surface> Measures measures(const Surface& surface) {
  return measures(surface.points, surface.triangles);
}

constexpr double tolerance = 1e-12;

} // namespace surface_measures

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SURFACE_MEASURES_H

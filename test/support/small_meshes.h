#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SMALL_MESHES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SMALL_MESHES_H

#include <CGAL/Deformable_simplicial_complex_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Small labeled meshes whose measures are known, and complexes of these meshes.
namespace small_meshes {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Position = Complex::Point_3;
using Vector = Complex::Vector_3;
using Vertex_handle = Complex::Vertex_handle;
using Cell_handle = Complex::Cell_handle;

struct Labeled_mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
};

// Labels by the barycenter of a tetrahedron. Planar interfaces lie on facets of `grid(n)` if their
// planes are grid planes 2i/n - 1.

// one label everywhere: no interface
inline int uniform(const Point&) { return 0; }

// the cube [-1/2,1/2]^3 has label 1; n must be a multiple of 4
inline int cube(const Point& p) {
  return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < 0.5 ? 1 : 0;
}

// the box [-1/2,1/2]^3 cut at x = 0 into label 1 (left) and label 2; n must be a multiple of 4
inline int two_boxes(const Point& p) { return cube(p) == 0 ? 0 : p.x() < 0 ? 1 : 2; }

// the quadrants of the xy-plane have the labels 0 to 3; n must be even
inline int four_phases(const Point& p) { return (p.x() < 0 ? 0 : 1) + (p.y() < 0 ? 0 : 2); }

// a ball of radius 0.6 about the origin has label 1
inline int ball(const Point& p) { return (p - CGAL::ORIGIN).squared_length() < 0.36; }

// the octants of a ball of radius 0.8 have the labels 0 to 7, and around them is 0; n must be even
inline int eight_phases(const Point& p) {
  const bool is_inside = (p - CGAL::ORIGIN).squared_length() < 0.64;
  return is_inside ? four_phases(p) + (p.z() < 0 ? 0 : 4) : 0;
}

// two disjoint balls of radius 0.3, both with label 1
inline int two_balls(const Point& p) {
  const double x = std::abs(p.x()) - 0.5;
  return x * x + p.y() * p.y() + p.z() * p.z() < 0.09;
}

// The box [-1,1]^3 split into n^3 cubes of six tetrahedra each. Each tetrahedron follows one path
// along the axes from the lowest to the highest corner (Kuhn). The tetrahedra are conforming and
// positively oriented.
template <class Label> Labeled_mesh grid(std::size_t n, Label label) {
  Labeled_mesh mesh;
  const auto coordinate = [n](std::size_t i) { return 2. * double(i) / double(n) - 1.; };
  const auto index = [n](const std::array<std::size_t, 3>& corner) {
    return (corner[2] * (n + 1) + corner[1]) * (n + 1) + corner[0];
  };
  for (std::size_t z = 0; z <= n; ++z)
    for (std::size_t y = 0; y <= n; ++y)
      for (std::size_t x = 0; x <= n; ++x)
        mesh.points.emplace_back(coordinate(x), coordinate(y), coordinate(z));

  const auto add_cube = [&](const std::array<std::size_t, 3>& lowest) {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    do {
      std::array<std::size_t, 4> tetrahedron;
      std::array<std::size_t, 3> corner = lowest;
      tetrahedron[0] = index(corner);
      for (std::size_t step = 0; step < 3; ++step) {
        ++corner[axes[step]];
        tetrahedron[step + 1] = index(corner);
      }
      const bool is_odd_permutation = (axes[0] + 1) % 3 != axes[1];
      if (is_odd_permutation)
        std::swap(tetrahedron[1], tetrahedron[2]);
      mesh.tetrahedra.push_back(tetrahedron);
      mesh.labels.push_back(
          label(CGAL::centroid(mesh.points[tetrahedron[0]], mesh.points[tetrahedron[1]],
                               mesh.points[tetrahedron[2]], mesh.points[tetrahedron[3]])));
    } while (std::next_permutation(axes.begin(), axes.end()));
  };
  for (std::size_t z = 0; z < n; ++z)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x)
        add_cube({x, y, z});
  return mesh;
}

inline Complex make_complex(const Labeled_mesh& mesh) {
  Complex dsc;
  dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  return dsc;
}

} // namespace small_meshes

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SMALL_MESHES_H

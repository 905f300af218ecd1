#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SMALL_SURFACES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SMALL_SURFACES_H

#include "small_meshes.h"
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>

// Small closed surfaces whose volumes are known.
namespace small_surfaces {

using small_meshes::Complex;
using small_meshes::Point;
using Surface = DSC::Labeled_surface_3<Point>;
using Surfaces = std::vector<Surface>;

// A box between two corners, of twelve triangles. The index of a corner has one bit per axis.
inline Surface box(const std::array<double, 3>& low, const std::array<double, 3>& high,
                   int label = 1) {
  Surface s;
  for (int corner = 0; corner < 8; ++corner) {
    const auto x = [&](int axis) { return (corner >> axis & 1 ? high : low)[axis]; };
    s.points.emplace_back(x(0), x(1), x(2));
  }
  s.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  s.label = label;
  return s;
}

inline Surface octahedron(double radius = 1, int label = 1) {
  const double r = radius;
  return {{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
          label};
}

// Appends the triangles of another surface. The surfaces share no points.
inline void append(Surface& surface, const Surface& other) {
  const std::size_t n = surface.points.size();
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    surface.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
}

} // namespace small_surfaces

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SMALL_SURFACES_H

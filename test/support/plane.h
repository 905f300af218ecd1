#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_PLANE_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_PLANE_H

#include "test.h"

#include <CGAL/Deformable_simplicial_complex_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace plane {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;

struct Disk
{
  double x, y, radius;
  int label;
};

// Disks with n vertices on each circle in the square [-size, size]^2, triangulated by CGAL with a
// grid of surrounding points.
inline Complex disks_in_a_square(const std::vector<Disk>& disks, int n, double size, int grid) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Tds =
      CGAL::Triangulation_data_structure_2<Vertex_base,
                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds> cdt;
  constexpr double pi = 3.14159265358979323846;
  for (const Disk& disk : disks) {
    std::vector<Point> circle;
    for (int i = 0; i < n; ++i)
      circle.emplace_back(disk.x + disk.radius * std::cos(2 * pi * i / n),
                          disk.y + disk.radius * std::sin(2 * pi * i / n));
    cdt.insert_constraint(circle.begin(), circle.end(), true);
  }
  for (int i = 0; i <= grid; ++i)
    for (int j = 0; j <= grid; ++j) {
      const double x = size * (2. * i / grid - 1), y = size * (2. * j / grid - 1);
      bool is_near = false;
      for (const Disk& disk : disks)
        is_near =
            is_near || std::abs(std::hypot(x - disk.x, y - disk.y) - disk.radius) < size / grid;
      if (!is_near)
        cdt.insert(Point(x, y));
    }
  std::vector<Point> points;
  for (auto v : cdt.finite_vertex_handles()) {
    v->info() = points.size();
    points.push_back(v->point());
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  for (auto f : cdt.finite_face_handles()) {
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    const Point p = CGAL::centroid(cdt.triangle(f));
    labels.push_back(0);
    for (const Disk& disk : disks)
      if (std::hypot(p.x() - disk.x, p.y() - disk.y) < disk.radius)
        labels.back() = disk.label;
  }
  Complex complex;
  complex.assign(points, triangles, labels);
  return complex;
}

} // namespace plane

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_PLANE_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_MEASURES_H
#define DSC_BENCHMARK_MEASURES_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <time.h>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vector = Complex::Vector_3;

constexpr double degree = CGAL_PI / 180;

/// Returns the processor time of the program; it does not depend on other processes.
inline double processor_seconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Returns whether a complex is valid; prints the reasons to `std::cerr` if it is not.
template <class Complex> bool check(const Complex& complex) {
  return complex.is_valid() || complex.is_valid(true);
}

inline CGAL::Bbox_3 bounding_box(const Complex& complex) {
  CGAL::Bbox_3 box;
  for (const Complex::Vertex_handle v : complex.vertices())
    box += complex.position(v).bbox();
  return box;
}

inline Point centre(const CGAL::Bbox_3& box) {
  return CGAL::midpoint(Point(box.xmin(), box.ymin(), box.zmin()),
                        Point(box.xmax(), box.ymax(), box.zmax()));
}

/// Returns the sum of the exact orientations and the volume-length ratios of all cells.
inline double sweep(const Complex& complex, const std::vector<Complex::Cell_handle>& cells) {
  const auto orientation = complex.geom_traits().orientation_3_object();
  const DSC::Volume_length_ratio_3 ratio;
  double sum = 0;
  for (const Complex::Cell_handle c : cells) {
    const auto v = [c](int i) { return c->vertex(i); };
    sum += orientation(v(0)->point(), v(1)->point(), v(2)->point(), v(3)->point()) +
           ratio(complex.position(v(0)), complex.position(v(1)), complex.position(v(2)),
                 complex.position(v(3)));
  }
  return sum;
}

/// Returns the processor time of a sweep over all finite tetrahedra: the median of several sweeps.
/// It is the unit of the costs of motions. Call it for a complex with sorted storage, immediately
/// before the measurement, because the speed of machines varies.
inline double sweep_seconds(const Complex& complex,
                            const std::vector<Complex::Cell_handle>& cells) {
  std::array<double, 5> seconds;
  [[maybe_unused]] volatile double sum; // prevents the optimization of sweeps
  for (double& s : seconds) {
    const double start = processor_seconds();
    sum = sweep(complex, cells);
    s = processor_seconds() - start;
  }
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  return seconds[seconds.size() / 2];
}

/// Returns the six dihedral angles of a cell, in degrees.
template <class Complex>
std::array<double, 6> dihedral_angles(const Complex& complex, typename Complex::Cell_handle c) {
  const auto p = [&](int i) { return complex.position(c->vertex(i)); };
  const auto normals = CGAL::Deformable_simplicial_complexes::internal::Tetrahedron_frame<Point>(
                           p(0), p(1), p(2), p(3))
                           .area_vectors();
  std::array<double, 6> result;
  double* angle = result.data();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double sine = std::sqrt(CGAL::cross_product(normals[i], normals[j]).squared_length());
      *angle++ = std::atan2(sine, -(normals[i] * normals[j])) / degree;
    }
  return result;
}

/// Dihedral angles of some cells.
struct Angles
{
  double minimum = 180, maximum = 0;
  std::size_t number = 0, outside_6_171 = 0;

  void add(const std::array<double, 6>& angles) {
    for (double angle : angles) {
      minimum = (std::min)(minimum, angle);
      maximum = (std::max)(maximum, angle);
      ++number;
      outside_6_171 += angle < 6 || angle > 171;
    }
  }

  double fraction_outside_6_171() const { return double(outside_6_171) / double(number); }
};

/// Returns the dihedral angles of all finite cells.
template <class Complex> Angles dihedral_angles(const Complex& complex) {
  Angles angles;
  for (const auto c : complex.triangulation().finite_cell_handles())
    angles.add(dihedral_angles(complex, c));
  return angles;
}

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_MEASURES_H

// Stretches a disk to a thread in a single vortex and back, and prints its length, the change of
// its area, and the area by which it differs from the disk at the end.
// Usage: single_vortex [PERIOD [SEGMENTS [DT]]]
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/velocity_fields_2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_2<>;
namespace parameters = CGAL::parameters;

const double pi = std::acos(-1.), radius = .15;
const Complex::Point_2 center(.5, .75);

double length(const Complex& dsc) {
  double sum = 0;
  for (const auto& segment : dsc.interface_facets())
    sum += dsc.measure(segment);
  return sum;
}

// Returns the area between the interface and the circle, as seen from the center.
double symmetric_difference(const Complex& dsc) {
  static constexpr int parts = 20; // of each segment
  double sum = 0;
  for (const auto& segment : dsc.interface_facets()) {
    const auto ends = dsc.facet_vertices(segment);
    const auto p = dsc.position(ends[0]) - center, q = dsc.position(ends[1]) - center;
    for (int i = 0; i < parts; ++i) {
      const auto a = p + double(i) / parts * (q - p), b = p + (i + 1.) / parts * (q - p);
      const double angle = std::atan2(CGAL::determinant(a, b), a * b);
      sum += std::abs(a * b - radius * radius) / 2 * std::abs(angle);
    }
  }
  return sum;
}

int main(int argc, char** argv) {
  const double period = argc > 1 ? std::atof(argv[1]) : 1, dt = argc > 3 ? std::atof(argv[3]) : .01;
  const int segments = argc > 2 ? std::atoi(argv[2]) : 100, steps = int(std::lround(period / dt));

  // A polygon with the area of the disk
  const double step = 2 * pi / segments, r = radius * std::sqrt(step / std::sin(step));
  std::vector<Complex::Point_2> polygon;
  for (int i = 0; i < segments; ++i)
    polygon.emplace_back(center.x() + r * std::cos(i * step), center.y() + r * std::sin(i * step));
  DSC::Labeled_curve_2<Complex::Point_2> disk;
  disk.add_polyline(polygon);
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      {disk}, parameters::enclosing_box(CGAL::Bbox_2(0, 0, 1, 1)));

  const double area = dsc.area(1), first_length = length(dsc);
  double worst = 0;
  for (int i = 0; i < steps; ++i) {
    DSC::advect_adaptively(dsc, DSC::Single_vortex_velocity_2(period), i * dt, dt);
    worst = (std::max)(worst, std::abs(dsc.area(1) / area - 1));
    if (2 * (i + 1) == steps)
      std::cout << "halfway " << length(dsc) / first_length << " times as long, in "
                << dsc.interface_facets().size() << " segments\n";
  }
  std::cout << "area within " << 100 * worst << " %; " << symmetric_difference(dsc)
            << " of the disk is not where it was\n";
  return dsc.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}

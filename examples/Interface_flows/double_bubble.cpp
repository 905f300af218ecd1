// Builds two soap bubbles with a common wall from labeled patches, and rotates them.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Patch = DSC::Labeled_patch_3<Point>;

constexpr std::size_t around = 48; // points of the circle where the walls meet

// Returns rings of triangles about the x axis, from the circle of radius sqrt(3)/2 at x = 0 to a
// point on the axis.
template <class Profile> Patch patch(std::size_t rings, const Profile& profile) {
  Patch result;
  for (std::size_t i = 0; i < rings; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const auto [x, radius] = profile(double(i) / double(rings));
      const double angle = 2 * CGAL_PI * double(j) / around;
      result.points.emplace_back(x, radius * std::cos(angle), radius * std::sin(angle));
    }
  const auto [tip, zero] = profile(1);
  result.points.emplace_back(tip, 0, 0);
  const auto index = [rings](std::size_t i, std::size_t j) {
    return i < rings ? i * around + j % around : rings * around;
  };
  for (std::size_t i = 0; i < rings; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      result.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j)});
      if (i + 1 < rings)
        result.triangles.push_back({index(i, j + 1), index(i + 1, j + 1), index(i + 1, j)});
    }
  return result;
}

// Counts the edges where three labels meet.
std::size_t length_of_triple_line(const Complex& complex) {
  const auto& triangulation = complex.triangulation();
  std::size_t edges = 0;
  for (const auto& edge : triangulation.finite_edges()) {
    std::set<Complex::Label> labels;
    auto cell = triangulation.incident_cells(edge), first = cell;
    do {
      if (!triangulation.is_infinite(cell))
        labels.insert(cell->subdomain_index());
    } while (++cell != first);
    edges += labels.size() > 2;
  }
  return edges;
}

int main() {
  // Two soap bubbles of radius 1 about (-1/2, 0, 0) and (1/2, 0, 0) with a planar wall between them
  struct Place
  {
    double x, radius;
  };
  const double radius = std::sqrt(.75);
  const auto cap = [radius](double side) {
    return [=](double t) {
      const double angle = (1 - t) * 2 * CGAL_PI / 3;
      return t == 0 ? Place{0, radius} : Place{side * (.5 + std::cos(angle)), std::sin(angle)};
    };
  };
  Patch left = patch(16, cap(-1)), right = patch(16, cap(1)), wall = patch(7, [radius](double t) {
                                                                return Place{0, (1 - t) * radius};
                                                              });
  // Seen from the front side, the corners of a triangle are in counterclockwise order.
  right.label_behind = 2;
  right.label_in_front = 0;
  left.label_behind = 0;
  left.label_in_front = 1;
  wall.label_behind = 1;
  wall.label_in_front = 2;

  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Patch>{left, right, wall}, CGAL::Tetgen_tetrahedralizer_3());
  const double exact = 4 * CGAL_PI / 3 - CGAL_PI * .25 * 2.5 / 3; // ball without a cap
  std::cout << "volumes " << complex.volume(1) << " and " << complex.volume(2) << ", of round ones "
            << exact << "; " << length_of_triple_line(complex) << " edges between three labels\n";

  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, CGAL_PI / 2);
  for (int step = 0; step < 5; ++step)
    DSC::advect_interface(complex, rotation, .2 * step, .2);
  std::cout << "after a quarter of a turn " << complex.volume(1) << " and " << complex.volume(2)
            << "; " << length_of_triple_line(complex) << " edges\n";
  CGAL::IO::write_VTU("double_bubble.vtu", complex);
  return length_of_triple_line(complex) == around ? EXIT_SUCCESS : EXIT_FAILURE;
}

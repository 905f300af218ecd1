// Defines a flow as a model of `InterfaceVelocity`: mean curvature flow of a sphere, compared with
// the exact radius.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vector = Complex::Vector_3;
using Mesh = CGAL::Surface_mesh<Complex::Point_3>;

// A model of `InterfaceVelocity`. The velocity of a vertex is the direction of steepest descent of
// the area: the mean curvature vector of the surface. Along junctions, all incident sheets
// contribute.
struct Area_decrease
{
  void operator()(const DSC::Interface_snapshot<Complex>& interface_,
                  const std::vector<Point>& positions, double /*t*/,
                  std::vector<Vector>& velocities) const {
    velocities.assign(positions.size(), Vector(0, 0, 0));
    std::vector<double> areas(positions.size(), 0.); // of the triangles around each vertex
    for (const auto& triangle : interface_.facets())
      for (int i = 0; i < 3; ++i) {
        const std::size_t v = triangle.vertices[i];
        const Point p = positions[v], q = positions[triangle.vertices[(i + 1) % 3]],
                    r = positions[triangle.vertices[(i + 2) % 3]];
        const Vector normal = CGAL::cross_product(q - p, r - p);
        const double twice_area = std::sqrt(normal.squared_length());
        if (twice_area == 0)
          continue;
        velocities[v] = velocities[v] - CGAL::cross_product(normal / twice_area, r - q) / 2;
        areas[v] += twice_area / 2;
      }
    for (std::size_t v = 0; v < velocities.size(); ++v)
      if (areas[v] > 0)
        velocities[v] = velocities[v] / (areas[v] / 3);
  }
};

int main() {
  Mesh surface;
  CGAL::make_icosahedron(surface, Complex::Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(surface, CGAL::parameters::number_of_iterations(2));
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      surface, CGAL::Tetgen_tetrahedralizer_3(), CGAL::parameters::normalize(true));

  // A sphere stays a sphere; the square of its radius decreases by 4 dt.
  const double h = complex.mean_interface_edge(), dt = .04 * h * h;
  for (int step = 0; step < 20; ++step) {
    const auto report = DSC::advect_interface(complex, Area_decrease(), step * dt, dt);
    if (step % 5 == 0)
      std::cout << "time " << (step + 1) * dt << ": volume " << complex.volume(1) << ", area "
                << complex.area(1) << ", vertices that fell short: " << report.unfinished.size()
                << std::endl;
  }
  return EXIT_SUCCESS;
}

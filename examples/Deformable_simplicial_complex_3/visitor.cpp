#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/interface_flows_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <vector>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Surface = CGAL::Labelled_surface_3<Complex::Point_3>;
using Vertex_handle = Complex::Vertex_handle;

// Keeps a number for each vertex while vertices come and go, and limits the number of passes. Handles
// are compared by the creation of their vertices, so that the order in the map is always the same.
struct Temperatures : public CGAL::Deformation_visitor_3
{
  std::map<Vertex_handle, double> temperature;
  unsigned splits = 0, collapses = 0, passes = 0;

  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) {
    temperature[v] = (temperature.at(a) + temperature.at(b)) / 2;
    ++splits;
  }

  void before_collapse(Vertex_handle removed, Vertex_handle /*kept*/) {
    temperature.erase(removed);
    ++collapses;
  }

  bool go_further(unsigned pass) {
    passes = pass;
    return pass <= 15;
  }
};

int main() {
  const std::vector<Surface> octahedron = {
      {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
       {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
       1}};
  Complex complex = CGAL::make_deformable_simplicial_complex_3<Complex>(
      octahedron, CGAL::Tetgen_tetrahedralizer_3());

  Temperatures visitor;
  for (const Vertex_handle v : complex.vertices())
    visitor.temperature[v] = complex.position(v).z();

  const CGAL::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, 1.);
  for (int step = 0; step < 20; ++step) {
    const auto report = CGAL::advect_interface(
        complex, rotation, .25 * step, .25,
        CGAL::Deformable_simplicial_complexes::parameters::visitor(std::ref(visitor)));
    if (!report.complete)
      std::cout << "step " << step << ": " << report.unfinished.size() << " vertices fell short\n";
  }

  std::cout << visitor.splits << " splits, " << visitor.collapses << " collapses; "
            << complex.number_of_vertices() << " vertices, " << visitor.temperature.size()
            << " temperatures" << std::endl;
  return visitor.temperature.size() == complex.number_of_vertices() ? EXIT_SUCCESS : EXIT_FAILURE;
}

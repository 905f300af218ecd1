// Keeps a temperature on the vertices by a visitor, while the flow creates and removes vertices.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vertex_handle = Complex::Vertex_handle;

// Stores a temperature for each vertex and follows creations and removals of vertices. Handles are
// ordered by the creation of their vertices, not by addresses, so the order in the map is
// deterministic.
struct Temperatures : public DSC::Deformation_visitor<Complex>
{
  explicit Temperatures(const Complex& complex) : complex(complex) {}

  const Complex& complex;
  std::map<Vertex_handle, double> temperature;
  unsigned splits = 0, insertions = 0, collapses = 0, relabeled_cells = 0;

  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) override {
    temperature[v] = (temperature.at(a) + temperature.at(b)) / 2;
    ++splits;
  }
  // Sets the mean of the neighbors with known temperatures; other neighbors may be new, too.
  void after_insertion(Vertex_handle v) override {
    std::vector<Vertex_handle> neighbors;
    complex.triangulation().finite_adjacent_vertices(v, std::back_inserter(neighbors));
    double sum = 0;
    unsigned known = 0;
    for (const Vertex_handle w : neighbors)
      if (const auto it = temperature.find(w); it != temperature.end()) {
        sum += it->second;
        ++known;
      }
    temperature[v] = known == 0 ? 0 : sum / known;
    ++insertions;
  }
  void before_collapse(Vertex_handle removed, Vertex_handle /*kept*/) override {
    temperature.erase(removed);
    ++collapses;
  }
  void after_relabel(Complex::Cell_handle /*cell*/, int /*before*/) override { ++relabeled_cells; }

  // Allows at most two passes; the next step moves vertices that do not arrive.
  bool go_further(unsigned pass) override { return pass <= 2; }
};

int main() {
  // One surface with two connected components; both enclose label 1
  CGAL::Surface_mesh<Point> spheres;
  CGAL::make_icosahedron(spheres, Point(-.7, 0, 0), .5);
  CGAL::make_icosahedron(spheres, Point(.7, 0, 0), .5);
  CGAL::Subdivision_method_3::Loop_subdivision(spheres, CGAL::parameters::number_of_iterations(2));
  Complex complex =
      DSC::make_deformable_simplicial_complex_3<Complex>(spheres, CGAL::Tetgen_tetrahedralizer_3());

  Temperatures visitor(complex);
  for (const Vertex_handle v : complex.vertices())
    visitor.temperature[v] = complex.position(v).x() < 0 ? 0 : 100;

  const double dt = .04; // the spheres touch at time 0.2
  for (int step = 0; step < 12; ++step) {
    const auto report = DSC::advect_interface(complex, DSC::Normal_offset{1.}, step * dt, dt,
                                              CGAL::parameters::visitor(std::ref(visitor)));
    if (!report.complete)
      std::cout << "step " << step << ": " << report.unfinished.size() << " vertices fell short\n";
  }

  std::cout << visitor.splits << " splits, " << visitor.insertions << " insertions, "
            << visitor.collapses << " collapses, " << visitor.relabeled_cells
            << " cells relabeled\n"
            << visitor.temperature.size() << " temperatures for " << complex.number_of_vertices()
            << " vertices" << std::endl;
  return visitor.temperature.size() == complex.number_of_vertices() ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Carries a temperature on the vertices and a density on the cells through a deformation and a mesh
// improvement.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <unordered_map>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vertex_handle = Complex::Vertex_handle;
using Cell_handle = Complex::Cell_handle;
namespace parameters = CGAL::parameters;

// A property map for vertices or cells that are created and removed. The keys are time stamps: no
// time stamp is used twice, whereas a new cell may get the handle of a removed cell.
template <class Handle> struct Values
{
  using key_type = Handle;
  using value_type = double;
  using reference = double;
  using category = boost::read_write_property_map_tag;

  friend double get(const Values& map, Handle h) { return map.values->at(h->time_stamp()); }
  friend void put(const Values& map, Handle h, double value) {
    (*map.values)[h->time_stamp()] = value;
  }

  std::unordered_map<std::size_t, double>* values;
};

double volume(Cell_handle c) {
  return CGAL::volume(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                      c->vertex(3)->point());
}

// Returns the integral of a density.
double mass(const Complex& complex, const Values<Cell_handle>& density) {
  double result = 0;
  for (const Cell_handle c : complex.cells())
    result += get(density, c) * volume(c);
  return result;
}

int main() {
  // One surface with two connected components; both enclose label 1
  CGAL::Surface_mesh<Point> spheres;
  CGAL::make_icosahedron(spheres, Point(-.7, 0, 0), .5);
  CGAL::make_icosahedron(spheres, Point(.7, 0, 0), .5);
  CGAL::Subdivision_method_3::Loop_subdivision(spheres, CGAL::parameters::number_of_iterations(2));
  Complex complex =
      DSC::make_deformable_simplicial_complex_3<Complex>(spheres, CGAL::Tetgen_tetrahedralizer_3());

  // A temperature at each vertex, and a density in each cell
  std::unordered_map<std::size_t, double> temperatures, densities;
  const Values<Vertex_handle> temperature = {&temperatures};
  const Values<Cell_handle> density = {&densities};
  for (const Vertex_handle v : complex.vertices())
    put(temperature, v, complex.position(v).x() < 0 ? 0 : 100);
  for (const Cell_handle c : complex.cells())
    put(density, c, complex.label(c) == 1 ? 5 : 1);

  const double before = mass(complex, density);
  {
    // From here to the end of the block, `density` stores masses.
    DSC::Carried_vertex_values vertex_values(complex, temperature);
    DSC::Carried_cell_averages cell_averages(complex, density);
    DSC::Deformation_visitor_pair visitor(vertex_values, cell_averages);
    const double dt = .04; // the spheres touch at time 0.2
    for (int step = 0; step < 6; ++step)
      DSC::advect_interface(complex, DSC::Normal_offset{1.}, step * dt, dt,
                            parameters::visitor(std::ref(visitor)));
    DSC::improve_mesh(complex, parameters::visitor(std::ref(visitor)));
  }
  const double after = mass(complex, density);

  double coldest = 100, warmest = 0;
  for (const Vertex_handle v : complex.vertices()) {
    coldest = (std::min)(coldest, get(temperature, v));
    warmest = (std::max)(warmest, get(temperature, v));
  }
  std::cout << "mass before: " << before << ", after: " << after << ", relative change "
            << (after - before) / before << '\n'
            << "temperatures from " << coldest << " to " << warmest << " at "
            << complex.number_of_vertices() << " vertices" << std::endl;
  return std::abs(after - before) <= 1e-12 * before ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Two balls grow until one touches the other. The complex has types of the user: a kernel, data in
// the vertices, a measure of quality, and a control of the topology.
#include <CGAL/Bbox_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/simplex_bases.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <functional>
#include <iostream>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Filtered_kernel<CGAL::Simple_cartesian<double>>;
using Point = Kernel::Point_3;

struct Temperature
{
  double value = 20;
};

using Vertex_base = CGAL::Deformable_simplicial_complex_vertex_base_3<
    Kernel, CGAL::Triangulation_vertex_base_with_info_3<Temperature, Kernel>>;
using Cell_base = CGAL::Deformable_simplicial_complex_cell_base_3<Kernel>;
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;

// The quality of a cell: a power of the volume by the sum of the squared edge lengths, 1 if the
// cell is regular. A model of TetrahedronQualityMeasure_3.
struct Mean_ratio
{
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    const double volume = CGAL::volume(p, q, r, s),
                 squares = CGAL::squared_distance(p, q) + CGAL::squared_distance(p, r) +
                           CGAL::squared_distance(p, s) + CGAL::squared_distance(q, r) +
                           CGAL::squared_distance(q, s) + CGAL::squared_distance(r, s);
    return std::copysign(12 * std::cbrt(9 * volume * volume) / squares, volume);
  }
};

using Complex = CGAL::Deformable_simplicial_complex_3<Kernel, Tds, Mean_ratio>;
using Vertex_handle = Complex::Vertex_handle;

// A new vertex gets the mean temperature of the ends of the edge that it divides.
struct Temperatures : public DSC::Deformation_visitor<Complex>
{
  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) override {
    v->info().value = (a->info().value + b->info().value) / 2;
    ++splits;
  }
  int splits = 0;
};

// Permits changes of topology in the lower half of the domain only. A model of TopologyControl.
struct Only_below
{
  bool operator()(const Complex& complex, Complex::Cell_handle cell, int /*label*/) const {
    return complex.position(cell->vertex(0)).z() < 0;
  }
};

int main() {
  const auto balls = [](const Point& p) {
    const auto is_near = [&](double z) {
      return CGAL::squared_distance(p, Point(0, 0, z)) < .3 * .3;
    };
    return is_near(.4) ? 1 : is_near(-.4) ? 2 : 0;
  };
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), .2, balls);
  for (const Vertex_handle v : complex.vertices())
    v->info().value = 20 + 10 * complex.position(v).z();

  Temperatures visitor;
  for (int step = 0; step < 4; ++step) {
    // Moves vertices away from the centers of the balls.
    const auto destination = [&](Vertex_handle v) {
      const Point p = complex.position(v), center(0, 0, p.z() < 0 ? -.4 : .4);
      return p + .1 * (p - center);
    };
    const auto report = DSC::deform_interface(
        complex, destination,
        CGAL::parameters::visitor(std::ref(visitor)).topology_control(Only_below()));
    double sum = 0;
    for (const Vertex_handle v : complex.vertices())
      sum += v->info().value;
    std::cout << complex.number_of_vertices() << " vertices, mean temperature "
              << sum / double(complex.number_of_vertices()) << ", " << report.unfinished.size()
              << " of the interface not at their destinations\n";
  }
  std::cout << visitor.splits << " splits; volumes " << complex.volume(1) << " and "
            << complex.volume(2) << '\n';
  return complex.is_valid() ? 0 : 1;
}

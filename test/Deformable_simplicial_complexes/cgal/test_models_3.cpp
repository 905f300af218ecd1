// The deformation accepts models of a user: of a quality measure, a topology control and a visitor.
#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdlib>
#include <functional>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Default_complex = CGAL::Deformable_simplicial_complex_3<>;

// The default quality measure without its gradient
struct Quality
{
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return DSC::Volume_length_ratio_3()(p, q, r, s);
  }
};
using Complex =
    CGAL::Deformable_simplicial_complex_3<Default_complex::Geom_traits, CGAL::Default, Quality>;

// A topology control that permits changes of small cells
struct Small_cells
{
  bool operator()(const Complex& complex, Complex::Cell_handle c, int /*label*/) {
    ++calls;
    return complex.measure(c) < .01;
  }
  int calls = 0;
};

// A visitor that counts relabeled cells and passes
struct Counter : DSC::Deformation_visitor<Complex>
{
  void after_relabel(Complex::Cell_handle, int) override { ++relabeled; }
  bool go_further(unsigned pass) override {
    passes += pass > 0;
    return true;
  }
  std::size_t relabeled = 0, passes = 0;
};

int main() {
  const small_meshes::Labeled_mesh mesh = small_meshes::grid(4, small_meshes::cube);
  Complex complex;
  complex.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  Small_cells control;
  Counter counter;
  std::size_t relabeled = 0, passes = 0;
  for (int step = 0; step < 12 && complex.number_of_cells(1) > 0; ++step) {
    const auto report = DSC::deform_interface(
        complex,
        [](Complex::Vertex_handle v) { return CGAL::ORIGIN + .8 * (v->point() - CGAL::ORIGIN); },
        CGAL::parameters::topology_control(std::ref(control)).visitor(std::ref(counter)));
    assert(complex.is_valid());
    relabeled += report.relabeled;
    passes += report.passes;
  }
  assert(counter.relabeled == relabeled && counter.passes >= passes && passes > 0);
  return EXIT_SUCCESS;
}

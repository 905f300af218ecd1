// Bad input throws an exception that names the simplices, and the complex stays unchanged.
#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Kernel::Point_3;

// Returns whether a function throws an exception of the type `Error`.
template <class Error, class Function> bool throws(const Function& function) {
  try {
    function();
  } catch (const Error&) {
    return true;
  }
  return false;
}

int main() {
  small_meshes::Labeled_mesh mesh = small_meshes::grid(4, small_meshes::cube);
  Complex complex;
  complex.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  const auto before = complex.state();

  // An inverted tetrahedron
  std::swap(mesh.tetrahedra[7][0], mesh.tetrahedra[7][1]);
  try {
    complex.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    assert(false);
  } catch (const DSC::Invalid_cells_error& error) {
    assert(error.tetrahedra() == std::vector<std::size_t>{7});
  }
  assert(complex.state() == before);

  // A destination that is no number
  const double nan = std::numeric_limits<double>::quiet_NaN();
  assert(throws<DSC::Invalid_destination_error>([&] {
    DSC::deform_interface(complex, [&](Complex::Vertex_handle) { return Point(nan, 0, 0); });
  }));
  assert(complex.state() == before);

  // A parameter out of its range
  assert(throws<DSC::Error>([&] {
    DSC::deform_interface(
        complex, [](Complex::Vertex_handle v) { return v->point(); },
        CGAL::parameters::quality_threshold(2));
  }));
  assert(complex.state() == before);

  // A visitor that throws: the exception reaches the caller, and the complex is valid.
  struct Visitor : DSC::Deformation_visitor<Complex>
  {
    bool go_further(unsigned /*pass*/) override { throw 1; }
  };
  assert(throws<int>([&] {
    DSC::deform_interface(
        complex, [](Complex::Vertex_handle v) { return v->point() + Kernel::Vector_3(.1, 0, 0); },
        CGAL::parameters::visitor(Visitor()));
  }));
  assert(complex.is_valid());

  // A proposal to a complex that has changed since
  Complex::Cavity first(complex), second(complex);
  const Complex::Cell_handle c = complex.cells()[100];
  const auto middle =
      complex.position(c->vertex(0)) + .5 * complex.displacement(c->vertex(0), c->vertex(1));
  assert(DSC::propose_edge_split(complex, c, 0, 1, middle, first));
  assert(DSC::propose_edge_split(complex, c, 0, 1, middle, second));
  complex.replace(first);
  const auto after = complex.state();
  assert(throws<DSC::Stale_proposal_error>([&] { complex.replace(second); }));
  assert(complex.state() == after && complex.is_valid());
  return EXIT_SUCCESS;
}

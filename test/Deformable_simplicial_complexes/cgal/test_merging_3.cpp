// Two cubes that approach each other merge, or stay apart if topology changes are forbidden.
#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Kernel::Point_3;

// Two cubes of side length 1/2 with centers at distance 1
int two_cubes(const Point& p) {
  return (std::max)({std::abs(std::abs(p.x()) - .5), std::abs(p.y()), std::abs(p.z())}) < .25;
}

// Moves both cubes towards each other, past the point where they touch. Returns the last report.
template <class NamedParameters>
DSC::Deformation_report<Complex> approach(Complex& complex, const NamedParameters& np) {
  DSC::Deformation_report<Complex> report;
  for (int step = 0; step < 6; ++step) {
    report.append(DSC::deform_interface(
        complex,
        [](Complex::Vertex_handle v) {
          return v->point() + Kernel::Vector_3(v->point().x() < 0 ? .05 : -.05, 0, 0);
        },
        np));
    assert(complex.is_valid());
  }
  return report;
}

int main() {
  const small_meshes::Labeled_mesh mesh = small_meshes::grid(8, two_cubes);
  Complex free, forbidden;
  free.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  forbidden.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  assert(free.number_of_components(1) == 2);

  const auto merged = approach(free, CGAL::parameters::maximum_number_of_passes(20));
  assert(free.number_of_components(1) == 1 && merged.relabeled > 0 && !merged.events.empty());
  for (const auto& change : merged.labels) {
    assert(change.after == free.number_of_components(change.label));
    assert(change.before + change.split + change.appeared ==
           change.after + change.merged + change.vanished);
  }

  const auto apart =
      approach(forbidden, CGAL::parameters::topology_control(DSC::Forbid_topology_changes()));
  assert(forbidden.number_of_components(1) == 2 && forbidden.number_of_components(0) == 1);
  assert(apart.events.empty() && !apart.complete && !apart.unfinished.empty());
  return EXIT_SUCCESS;
}

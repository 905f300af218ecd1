// Computes the cut locus of a point on a torus of revolution: the points where two or more shortest
// geodesics from the source end.
// Usage: cut_locus [SPACING [V [B [FILE.svg]]]]
// The source is the point (0, V) of the torus ((2 + cos v) cos u, (2 + cos v) sin u, B sin v).
#include <CGAL/Cut_loci_2/IO/cut_locus_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace DSC = CGAL::Deformable_simplicial_complexes;

struct Torus
{
  double b;

  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::cos;
    using std::sin;
    const T radius = 2. + cos(v);
    return {radius * cos(u), radius * sin(u), b * sin(v)};
  }
};

int main(int argc, char** argv) {
  const double period = 4 * std::acos(0.), spacing = argc > 1 ? std::atof(argv[1]) : .3,
               v = argc > 2 ? std::atof(argv[2]) : 0, b = argc > 3 ? std::atof(argv[3]) : 1;
  const DSC::Embedded_surface_2<Torus> metric(Torus{b});
  const CGAL::Deformable_simplicial_complexes::Torus_domain<2> domain({period, period});
  const DSC::Cut_locus_2 locus = DSC::cut_locus_2(metric, domain, {0, v}, spacing, spacing / 2);
  std::cout << locus.polylines.size() << " arcs; where they begin, meet or end:\n";
  for (const auto& vertex : locus.vertices)
    if (vertex.multiplicity != 2)
      std::cout << "  (" << vertex.point << "), at the distance " << vertex.distance << ", "
                << vertex.multiplicity << (vertex.multiplicity == 1 ? " arc\n" : " arcs\n");
  if (argc > 4)
    CGAL::IO::write_SVG(argv[4], locus, domain, {0, v});
}

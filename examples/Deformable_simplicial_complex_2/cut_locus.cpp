// The cut locus of a point of a torus of revolution: where two or more shortest ways from it end.
// Usage: cut_locus [SPACING [V [B [FILE.svg]]]]: of the point (0, V) of the torus
// ((2 + cos v) cos u, (2 + cos v) sin u, B sin v).
#include <CGAL/cut_locus_2.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

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

// The chart, with the cut locus and the point.
void write_svg(const char* path, const CGAL::Cut_locus_2& locus, double period, double v) {
  std::ofstream out(path);
  out << "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='600' viewBox='0 0 " << period
      << ' ' << period << "'>\n<rect width='100%' height='100%' fill='white'/>\n";
  for (const auto& polyline : locus.polylines)
    for (std::size_t k = 1; k < polyline.size(); ++k) {
      const auto &p = locus.vertices[polyline[k - 1]].point, &q = locus.vertices[polyline[k]].point;
      if (std::abs(p.x() - q.x()) < period / 2 && std::abs(p.y() - q.y()) < period / 2)
        out << "<line x1='" << p.x() << "' y1='" << period - p.y() << "' x2='" << q.x() << "' y2='"
            << period - q.y() << "' stroke='black' stroke-width='.02'/>\n";
    }
  out << "<circle cx='0' cy='" << period - v << "' r='.06' fill='red'/>\n</svg>\n";
}

int main(int argc, char** argv) {
  const double period = 4 * std::acos(0.), spacing = argc > 1 ? std::atof(argv[1]) : .3,
               v = argc > 2 ? std::atof(argv[2]) : 0, b = argc > 3 ? std::atof(argv[3]) : 1;
  const CGAL::Embedded_surface_2<Torus> metric(Torus{b});
  const CGAL::Deformable_simplicial_complexes::Torus_domain<2> domain({period, period});
  const CGAL::Cut_locus_2 locus = CGAL::cut_locus_2(metric, domain, {0, v}, spacing, spacing / 2);
  std::cout << locus.polylines.size() << " arcs; where they begin, meet or end:\n";
  for (const auto& vertex : locus.vertices)
    if (vertex.multiplicity != 2)
      std::cout << "  (" << vertex.point << "), at the distance " << vertex.distance << ", "
                << vertex.multiplicity << (vertex.multiplicity == 1 ? " arc\n" : " arcs\n");
  if (argc > 4)
    write_svg(argv[4], locus, period, v);
}

#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_MESH_HELPERS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_MESH_HELPERS_H

#include "small_meshes.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/enum.h>

// Functions that several tests use for complexes. They are templates because of other kernels and
// archetypes.
namespace mesh_helpers {

// Random numbers that are equal with all standard libraries.
class Random
{
public:
  explicit Random(unsigned seed) : m_engine(seed) {}

  double operator()(double minimum, double maximum) {
    return minimum + (maximum - minimum) * (double(m_engine()) / 4294967296.);
  }
  // in 0, ..., n - 1
  std::size_t below(std::size_t n) { return m_engine() % n; }

  template <class Complex> typename Complex::Vector_3 vector(double bound) {
    const double x = (*this)(-bound, bound), y = (*this)(-bound, bound);
    return {x, y, (*this)(-bound, bound)};
  }

private:
  std::mt19937 m_engine;
};

// Moves each vertex by a random vector, as far as its star permits.
template <class Complex> void jitter(Complex& dsc, double bound, unsigned seed) {
  Random random(seed);
  for (auto v : dsc.vertices())
    dsc.move_vertex(v, dsc.position(v) + random.vector<Complex>(bound));
}

// A grid of n^3 cubes whose vertices are displaced randomly by up to a fraction of the side length.
template <class Label>
small_meshes::Complex jittered_grid(std::size_t n, Label label, double part, unsigned seed) {
  auto dsc = small_meshes::make_complex(small_meshes::grid(n, label));
  jitter(dsc, part * 2. / double(n), seed);
  return dsc;
}

// A sphere of radius r about the origin, deformed from the cube of side length 1 in a grid of n^3
// cubes. n must be a multiple of 4, and r about .6. The sphere has 3 n^2 triangles.
inline small_meshes::Complex sphere(std::size_t n, double r) {
  auto dsc = small_meshes::make_complex(small_meshes::grid(n, small_meshes::cube));
  DSC::deform_interface(dsc, [&](small_meshes::Complex::Vertex_handle v) {
    const auto x = dsc.position(v) - CGAL::ORIGIN;
    return CGAL::ORIGIN + r / std::sqrt(x.squared_length()) * x;
  });
  return dsc;
}

template <class Complex> double minimum_quality(const Complex& dsc) {
  double minimum = std::numeric_limits<double>::infinity();
  for (auto c : dsc.triangulation().finite_cell_handles())
    minimum = (std::min)(minimum, c->quality());
  return minimum;
}

using Coordinates = std::array<double, 3>;

template <class Complex>
Coordinates coordinates(const Complex& dsc, typename Complex::Vertex_handle v) {
  const auto p = dsc.position(v);
  return {p.x(), p.y(), p.z()};
}

// Returns the interface as a sorted set of triangles, bitwise: corners and the two labels.
using Interface_triangle = std::pair<std::array<Coordinates, 3>, std::array<int, 2>>;

template <class Complex> std::vector<Interface_triangle> interface_triangles(const Complex& dsc) {
  std::vector<Interface_triangle> result;
  for (const auto& f : dsc.interface_facets()) {
    Interface_triangle t;
    const auto v = dsc.facet_vertices(f);
    for (int i = 0; i < 3; ++i)
      t.first[i] = coordinates(dsc, v[i]);
    std::sort(t.first.begin(), t.first.end());
    t.second = {f.first->subdomain_index(), f.first->neighbor(f.second)->subdomain_index()};
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Measures of cells before and after a motion, and qualities after it, as `set_points()` takes
// them.
struct Shapes
{
  std::vector<std::array<double, 2>> measures;
  std::vector<double> qualities;
};

// Returns the shapes of finite cells with vertices at given points.
template <class Complex>
Shapes shapes_with(const Complex& dsc, const std::vector<typename Complex::Cell_handle>& cells,
                   const std::vector<typename Complex::Vertex_handle>& vertices,
                   const std::vector<typename Complex::Point_3>& points) {
  const auto position_of = [&](auto v) {
    const auto i = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
    return i == std::ptrdiff_t(points.size()) ? v->point() : dsc.canonical(points[i]);
  };
  Shapes result;
  for (auto c : cells) {
    const auto corner = [&](int i) { return position_of(c->vertex(i)); };
    result.measures.push_back(
        {dsc.measure(c), dsc.domain().template apply<Complex>(Complex::Space::measure, corner)});
    result.qualities.push_back(dsc.quality(c, position_of));
  }
  return result;
}

// Returns whether all finite cells at v were positive with v at q, computed independently of the
// complex.
template <class Complex>
bool is_positive_with(const Complex& dsc, typename Complex::Vertex_handle v,
                      const typename Complex::Point_3& q) {
  std::vector<typename Complex::Cell_handle> star;
  dsc.triangulation().finite_incident_cells(v, std::back_inserter(star));
  for (auto c : star) {
    std::array<typename Complex::Point_3, 4> p;
    for (int i = 0; i < 4; ++i)
      p[i] = c->vertex(i) == v ? q : c->vertex(i)->point();
    if (CGAL::orientation(p[0], p[1], p[2], p[3]) != CGAL::POSITIVE)
      return false;
  }
  return true;
}

} // namespace mesh_helpers

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_MESH_HELPERS_H

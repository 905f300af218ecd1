// Moves two cubes until they merge. Shows their interface before and after, and the triangulation.
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/draw_triangulation_3.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace PMP = CGAL::Polygon_mesh_processing;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;

// The box [-1,1]^3 in n^3 cubes, each of six tetrahedra around a diagonal; label 1 in two cubes of
// side length 1/2
Complex complex_of_cubes(std::size_t n) {
  using Indices = std::array<std::size_t, 3>;
  const auto index = [n](const Indices& i) { return (i[2] * (n + 1) + i[1]) * (n + 1) + i[0]; };
  std::vector<Point> points;
  for (std::size_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    points.emplace_back(2. * double(i % (n + 1)) / n - 1,
                        2. * double(i / (n + 1) % (n + 1)) / n - 1,
                        2. * double(i / (n + 1) / (n + 1)) / n - 1);
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  for (std::size_t i = 0; i < n * n * n; ++i) {
    Indices axes = {0, 1, 2};
    do {
      Indices corner = {i % n, i / n % n, i / n / n};
      std::array<std::size_t, 4> t = {index(corner)};
      for (std::size_t k = 0; k < 3; ++k) {
        ++corner[axes[k]];
        t[k + 1] = index(corner);
      }
      if (CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) < 0)
        std::swap(t[2], t[3]);
      tetrahedra.push_back(t);
      const Point p = CGAL::centroid(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
      labels.push_back(
          (std::max)({std::abs(std::abs(p.x()) - .5), std::abs(p.y()), std::abs(p.z())}) < .25);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  Complex complex;
  complex.assign(points, tetrahedra, labels);
  return complex;
}

void draw_interface(const Complex& complex, const char* title) {
  std::vector<Point> points;
  std::map<Complex::Vertex_handle, std::size_t> index;
  for (const Complex::Vertex_handle v : complex.interface_vertices()) {
    index[v] = points.size();
    points.push_back(v->point());
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const Complex::Facet& facet : complex.interface_facets()) {
    const auto v = complex.facet_vertices(facet);
    triangles.push_back({index[v[0]], index[v[1]], index[v[2]]});
  }
  PMP::orient_polygon_soup(points, triangles);
  CGAL::Surface_mesh<Point> surface;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, surface);
  CGAL::draw(surface, title);
}

int main() {
  Complex complex = complex_of_cubes(16);
  draw_interface(complex, "Two cubes");
  // Each step moves both cubes towards each other by a fifth of an edge length.
  for (int step = 0; step < 12; ++step) {
    DSC::deform_interface(complex, [](Complex::Vertex_handle v) {
      const Point& p = v->point();
      return Point(p.x() + (p.x() < 0 ? .025 : -.025), p.y(), p.z());
    });
    std::cout << "step " << step + 1 << ": " << complex.number_of_components(1)
              << " components of label 1" << std::endl;
  }
  draw_interface(complex, "After twelve steps");
  CGAL::draw(complex.triangulation(), "The triangulation");
}

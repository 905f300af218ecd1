// Measures the interface of each label, and computes its normals, with Polygon Mesh Processing.
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/Interface_graph_3.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace PMP = CGAL::Polygon_mesh_processing;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vector = Complex::Geom_traits::Vector_3;
using Graph = DSC::Interface_graph_3<Complex>;

// Label 1 in the left half of a ball, label 2 in the right half, and label 0 around them
int label_at(const Point& p) {
  return (p - CGAL::ORIGIN).squared_length() > .5 ? 0 : p.x() < 0 ? 1 : 2;
}

int main() {
  // The box [-1,1]^3 in n^3 cubes, each of six tetrahedra around a diagonal
  const std::size_t n = 8;
  const auto index = [](const std::array<std::size_t, 3>& i) {
    return (i[2] * (n + 1) + i[1]) * (n + 1) + i[0];
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
    const std::size_t x = i % (n + 1), y = i / (n + 1) % (n + 1), z = i / (n + 1) / (n + 1);
    points.emplace_back(2. * x / n - 1, 2. * y / n - 1, 2. * z / n - 1);
  }
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  for (std::size_t i = 0; i < n * n * n; ++i) {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    do { // walk from the lowest corner of the cube to the highest one along the axes in this order
      std::array<std::size_t, 3> corner = {i % n, i / n % n, i / n / n};
      std::array<std::size_t, 4> t = {index(corner)};
      for (std::size_t k = 0; k < 3; ++k) {
        ++corner[axes[k]];
        t[k + 1] = index(corner);
      }
      if (CGAL::orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) < 0)
        std::swap(t[2], t[3]);
      tetrahedra.push_back(t);
      labels.push_back(
          label_at(CGAL::centroid(points[t[0]], points[t[1]], points[t[2]], points[t[3]])));
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  Complex complex;
  complex.assign(points, tetrahedra, labels);

  for (const int label : {1, 2}) {
    const Graph graph(complex, label); // valid until the complex changes
    std::cout << "label " << label << ": " << num_vertices(graph) << " vertices, "
              << num_faces(graph) << " faces, area " << PMP::area(graph);
    if (CGAL::is_closed(graph))
      std::cout << ", volume " << PMP::volume(graph);
    std::cout << '\n';

    // The normals point out of the label.
    const auto normals = get(CGAL::dynamic_vertex_property_t<Vector>(), graph);
    PMP::compute_vertex_normals(graph, normals);
    const auto points_of = get(CGAL::vertex_point, graph);
    const Graph::vertex_descriptor top =
        *std::max_element(vertices(graph).begin(), vertices(graph).end(), [&](auto v, auto w) {
          return get(points_of, v).z() < get(points_of, w).z();
        });
    std::cout << "  normal at the point " << get(points_of, top) << ": " << get(normals, top)
              << '\n';

    // A face is a facet of the complex. The cell on the other side tells the other label.
    double area = 0;
    for (const Graph::face_descriptor f : faces(graph)) {
      const Complex::Facet facet = graph.facet(f);
      if (complex.label(facet.first->neighbor(facet.second)) != 0)
        area += PMP::face_area(f, graph);
    }
    std::cout << "  area of the wall between the labels 1 and 2: " << area << '\n';
    if (std::abs(area - complex.area(1, 2)) > 1e-9)
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

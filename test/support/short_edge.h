#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SHORT_EDGE_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SHORT_EDGE_H

#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Mesh_support/Error.h>

// A mesh with an edge that is too short, for tests of functions that remove short edges.
namespace short_edge {

using namespace operation_helpers;
using Point = Complex::Point_3;

inline int half_space(const Point& p) { return p.x() < 0 ? 1 : 0; }

inline Vertex_handle vertex_at(const Complex& dsc, const Point& p) {
  for (Vertex_handle v : dsc.vertices())
    if (dsc.position(v) == p)
      return v;
  ADD_FAILURE() << "no vertex at " << p;
  return Vertex_handle();
}

// A grid of side length 1/2 in which the vertices at the origin and at (0, 1/2, 0) are close to
// each other.
struct Grid_with_short_edge
{
  template <class Label>
  explicit Grid_with_short_edge(Label label)
      : dsc(small_meshes::make_complex(small_meshes::grid(4, label))), v(vertex_at(dsc, {0, 0, 0})),
        w(vertex_at(dsc, {0, .5, 0})) {
    EXPECT_EQ(dsc.move_vertex(v, Point(0, .4999, 0)), 1);
  }

  Complex dsc;
  Vertex_handle v, w;
};

inline std::size_t number_of_changes(const DSC::Improvement_report& r) {
  return r.split + r.collapsed + r.flipped + r.smoothed + r.inserted;
}

// Expects that the call throws an exception and leaves the complex unchanged.
template <class Call> void expect_error(const Complex& dsc, const Call& call) {
  Complex copy = dsc;
  const auto state = copy.state();
  EXPECT_THROW(call(copy), CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(copy.state() == state);
}

} // namespace short_edge

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SHORT_EDGE_H

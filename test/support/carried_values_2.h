#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_CARRIED_VALUES_2_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_CARRIED_VALUES_2_H

#include "stamped_values.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

namespace carried_values_2 {

template <class C> using Vertex_values = stamped_values::Values<typename C::Vertex_handle>;
template <class C> using Cell_values = stamped_values::Values<typename C::Cell_handle>;

template <class C> double integral(const C& dsc, Cell_values<C>& averages, int label) {
  double result = 0;
  for (auto c : dsc.cells())
    result += c->subdomain_index() == label ? averages[c] * dsc.measure(c) : 0;
  return result;
}

// Operations that keep the interface preserve linear functions on vertices, constants on cells, and
// integrals over phases. `linear` is a linear function.
template <class C, class Linear> void expect_carried(C dsc, const Linear& linear) {
  Vertex_values<C> values;
  Cell_values<C> averages, constant;
  for (auto v : dsc.vertices())
    values.set(v, linear(dsc.position(v)));
  std::mt19937 generator(5);
  for (auto c : dsc.cells()) {
    averages.set(c, double(generator() % 100));
    constant.set(c, 7.);
  }
  const std::array<double, 2> before = {integral(dsc, averages, 0), integral(dsc, averages, 1)};
  const auto change = [&dsc](auto& visitor) {
    const auto np = CGAL::parameters::visitor(std::ref(visitor));
    const auto improved = DSC::improve_mesh(dsc, np.quality_threshold(.6)),
               split = DSC::control_detail(dsc, np.split_length(1.3).collapse_length(.9));
    return improved.flipped + improved.smoothed > 0 && split.split + split.collapsed > 0;
  };
  {
    DSC::Carried_vertex_values vertices(dsc, values.map());
    DSC::Carried_cell_averages cells(dsc, averages.map()), constants(dsc, constant.map());
    DSC::Deformation_visitor_pair both(cells, constants);
    DSC::Deformation_visitor_pair all(vertices, both);
    EXPECT_TRUE(change(all));
  }
  EXPECT_TRUE(dsc.is_valid());
  for (auto v : dsc.vertices())
    EXPECT_NEAR(values[v], linear(dsc.position(v)), 1e-12);
  for (auto c : dsc.cells())
    EXPECT_NEAR(constant[c], 7, 1e-10);
  for (int label : {0, 1})
    EXPECT_NEAR(integral(dsc, averages, label), before[std::size_t(label)], 1e-10);
}

} // namespace carried_values_2

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_CARRIED_VALUES_2_H

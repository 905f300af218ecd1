#include "../archetypes.h"
#include "../mesh_helpers.h"
#include "../stamped_values.h"

#include <CGAL/Carried_cell_averages_3.h>
#include <CGAL/Carried_vertex_values_3.h>
#include <CGAL/Curvature_size_field_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Deformation_visitor_pair_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/control_detail_3.h>
#include <CGAL/deform_interface_3.h>
#include <CGAL/face_offsetting_3.h>
#include <CGAL/improve_interface_3.h>
#include <CGAL/improve_mesh_3.h>
#include <CGAL/mean_curvature_flow_3.h>
#include <CGAL/remove_degeneracies_3.h>
#include <CGAL/restore_volumes_3.h>

#include <gtest/gtest.h>

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

// The package runs with models that offer nothing but what the concepts require, and does with them
// exactly what it does with its own models.

namespace test_archetypes {

namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;
using Tds =
    CGAL::Triangulation_data_structure_3<archetypes::Vertex_base<>, archetypes::Cell_base<>>;
using Archetype =
    CGAL::Deformable_simplicial_complex_3<archetypes::Traits, Tds, archetypes::Quality_measure>;

// The default measure without its gradient, which a model need not have.
struct Ratio
{
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return CGAL::Volume_length_ratio_3()(p, q, r, s);
  }
};
using Complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                          CGAL::Default, Ratio>;

Archetype make_archetype(const small_meshes::Labelled_mesh& mesh) {
  Archetype dsc;
  std::vector<Archetype::Point_3> points;
  for (const auto& p : mesh.points)
    points.push_back(
        mesh_helpers::exact_point(dsc, Archetype::Approximate_point_3(p.x(), p.y(), p.z())));
  dsc.assign(points, mesh.tetrahedra, mesh.labels);
  return dsc;
}

small_meshes::Labelled_mesh ball() { return small_meshes::grid(4, small_meshes::ball); }

// Runs the same on the archetype and on the default complex.
template <class Run> void expect_same(const Run& run) {
  Archetype archetype = make_archetype(ball());
  Complex reference;
  reference.assign(ball().points, ball().tetrahedra, ball().labels);
  mesh_helpers::jitter(archetype, .15, 1);
  mesh_helpers::jitter(reference, .15, 1);
  run(archetype);
  run(reference);
  EXPECT_TRUE(archetype.is_valid());
  EXPECT_TRUE(archetype.state() == reference.state());
}

TEST(Archetypes, complex) {
  Archetype dsc = make_archetype(ball());
  const Archetype copy = dsc;
  const auto state = dsc.state();
  EXPECT_TRUE(copy.state() == state);
  Archetype moved = std::move(dsc);
  moved.swap(dsc);
  dsc.sort_storage();
  dsc.restore(state);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
  EXPECT_GT(dsc.area(1), 0);
  EXPECT_GT(dsc.area(0, 1), 0);
  EXPECT_EQ(dsc.take_component_events().size(), 0u);
  dsc.relabel(dsc.cells().front(), 2);
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1, 2}));
  dsc.clear();
  EXPECT_EQ(dsc.number_of_vertices(), 0u);
}

TEST(Archetypes, improve_mesh) {
  expect_same([](auto& dsc) { CGAL::improve_mesh(dsc, parameters::quality_threshold(.6)); });
}

TEST(Archetypes, control_detail) {
  expect_same([](auto& dsc) {
    CGAL::control_detail(dsc, parameters::change_interface(true).interface_split_length(1.2));
  });
}

TEST(Archetypes, remove_degeneracies) {
  expect_same([](auto& dsc) {
    CGAL::remove_degeneracies(dsc, parameters::degenerate_quality(.3).degenerate_cosine(.9));
  });
}

TEST(Archetypes, deform_interface) {
  expect_same([](auto& dsc) {
    using Complex = std::decay_t<decltype(dsc)>;
    archetypes::Visitor<Complex> visitor;
    CGAL::deform_interface(dsc, archetypes::Destination<Complex>(dsc),
                           parameters::visitor(std::ref(visitor)));
  });
}

TEST(Archetypes, advect_interface) {
  expect_same([](auto& dsc) {
    using Complex = std::decay_t<decltype(dsc)>;
    CGAL::advect_interface(dsc, archetypes::Flow_map(), 0, 1);
    CGAL::advect_interface(dsc, archetypes::Velocity_field(), 1, 1);
    CGAL::advect_interface(dsc, archetypes::Interface_velocity<Complex>(), 2, 1);
    CGAL::advect_interface(dsc, archetypes::Interface_step<Complex>(), 3, 1);
    CGAL::advect_interface(
        dsc, archetypes::Velocity_field(), 4, 1,
        parameters::scheme(CGAL::Deformable_simplicial_complexes::Integration_scheme::adaptive));
  });
}

TEST(Archetypes, flows) {
  expect_same([](auto& dsc) {
    const double volume = dsc.volume(1);
    CGAL::advect_interface(dsc, CGAL::Face_offset_3(1), 0, .02);
    CGAL::advect_interface(
        dsc,
        CGAL::Advective_face_offset_3<archetypes::Velocity_field>(archetypes::Velocity_field()), 0,
        .5);
    CGAL::advect_interface(dsc, CGAL::Mean_curvature_flow_3(true), 0, .001);
    CGAL::advect_interface(dsc, CGAL::Mean_curvature_velocity_3(), 0, .001);
    CGAL::restore_volumes(dsc, {{1, volume}});
  });
}

TEST(Archetypes, carried_values) {
  expect_same([](auto& dsc) {
    using Complex = std::decay_t<decltype(dsc)>;
    stamped_values::Values<typename Complex::Vertex_handle> values;
    stamped_values::Values<typename Complex::Cell_handle> averages;
    for (const auto v : dsc.vertices())
      values.set(v, 1);
    for (const auto c : dsc.cells())
      averages.set(c, 1);
    {
      CGAL::Carried_vertex_values_3 vertices(dsc, values.map());
      CGAL::Carried_cell_averages_3 cells(dsc, averages.map());
      CGAL::Deformation_visitor_pair_3 both(vertices, cells);
      CGAL::improve_mesh(dsc, parameters::quality_threshold(.6).visitor(std::ref(both)));
    }
    for (const auto v : dsc.vertices())
      EXPECT_NEAR(values[v], 1, 1e-12);
    for (const auto c : dsc.cells())
      EXPECT_NEAR(averages[c], 1, 1e-12);
  });
}

TEST(Archetypes, improve_interface) {
  expect_same([](auto& dsc) {
    archetypes::Visitor<std::decay_t<decltype(dsc)>> visitor;
    CGAL::improve_interface(
        dsc,
        parameters::curved_splits(true).interface_split_length(1.2).visitor(std::ref(visitor)));
    const CGAL::Curvature_size_field_3 size(dsc, .1, .2, 1.);
    CGAL::improve_interface(dsc, parameters::size_field(size));
  });
}

} // namespace test_archetypes

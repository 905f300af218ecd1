#include "archetypes.h"
#include "mesh_helpers.h"
#include "stamped_values.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Interface_remeshing/remove_degeneracies.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>

#include <type_traits>

// The package accepts models that provide only the requirements of the concepts, and gives the same
// results as with its own models.

namespace test_archetypes {

// The default quality measure without its optional gradient.
struct Ratio
{
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return DSC::Volume_length_ratio_3()(p, q, r, s);
  }
};
using Complex = CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default, Ratio>;

small_meshes::Labeled_mesh ball() { return small_meshes::grid(4, small_meshes::ball); }

// Runs the same operations on the archetype and on the default complex.
template <class Run> void expect_same(const Run& run) {
  archetypes::Complex archetype = archetypes::make_complex(ball());
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
  archetypes::Complex dsc = archetypes::make_complex(ball());
  const archetypes::Complex copy = dsc;
  const auto state = dsc.state();
  EXPECT_TRUE(copy.state() == state);
  archetypes::Complex moved = std::move(dsc);
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
  expect_same([](auto& dsc) { DSC::improve_mesh(dsc, parameters::quality_threshold(.6)); });
}

TEST(Archetypes, control_detail) {
  expect_same([](auto& dsc) {
    DSC::control_detail(dsc, parameters::change_interface(true).interface_split_length(1.2));
  });
}

TEST(Archetypes, remove_degeneracies) {
  expect_same([](auto& dsc) {
    DSC::remove_degeneracies(dsc, parameters::degenerate_quality(.3).degenerate_cosine(.9));
  });
}

TEST(Archetypes, deform_interface) {
  expect_same([](auto& dsc) {
    using Complex = std::decay_t<decltype(dsc)>;
    archetypes::Visitor<Complex> visitor;
    DSC::deform_interface(dsc, archetypes::Destination<Complex>(dsc),
                          parameters::visitor(std::ref(visitor)));
  });
}

TEST(Archetypes, advect_interface) {
  expect_same([](auto& dsc) {
    using Complex = std::decay_t<decltype(dsc)>;
    DSC::advect_interface(dsc, archetypes::Flow_map(), 0, 1);
    DSC::advect_interface(dsc, archetypes::Velocity_field(), 1, 1);
    DSC::advect_interface(dsc, archetypes::Interface_velocity<Complex>(), 2, 1);
    DSC::advect_interface(dsc, archetypes::Interface_step<Complex>(), 3, 1);
    DSC::advect_interface(
        dsc, archetypes::Velocity_field(), 4, 1,
        parameters::scheme(CGAL::Deformable_simplicial_complexes::Integration_scheme::adaptive));
  });
}

TEST(Archetypes, flows) {
  expect_same([](auto& dsc) {
    const double volume = dsc.volume(1);
    DSC::advect_interface(dsc, DSC::Face_offset_3(1), 0, .02);
    DSC::advect_interface(
        dsc, DSC::Advective_face_offset_3<archetypes::Velocity_field>(archetypes::Velocity_field()),
        0, .5);
    DSC::advect_interface(dsc, DSC::Mean_curvature_flow(true), 0, .001);
    DSC::advect_interface(dsc, DSC::Mean_curvature_velocity(), 0, .001);
    DSC::restore_volumes(dsc, {{1, volume}});
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
      DSC::Carried_vertex_values vertices(dsc, values.map());
      DSC::Carried_cell_averages cells(dsc, averages.map());
      DSC::Deformation_visitor_pair both(vertices, cells);
      DSC::improve_mesh(dsc, parameters::quality_threshold(.6).visitor(std::ref(both)));
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
    DSC::improve_interface(dsc, parameters::curved_splits(true).interface_split_length(1.2).visitor(
                                    std::ref(visitor)));
    const DSC::Curvature_sizing_field<3> size(dsc, .1, .2, 1.);
    DSC::improve_interface(dsc, parameters::sizing_field(size));
  });
}

} // namespace test_archetypes

#include "short_edge.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_remeshing/control_detail.h>

// Splits of long edges and collapses of short edges, by thresholds and by sizing fields.

namespace test_detail_control {

using mesh_helpers::interface_triangles;
using mesh_helpers::jittered_grid;
using mesh_helpers::minimum_quality;
using small_meshes::grid;
using small_meshes::make_complex;
using namespace short_edge;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double longest_edge(const Complex& dsc) {
  double squared = 0;
  for_each_edge(dsc, [&](const Edge_in_cell& e) {
    const auto edge = dsc.position(e.cell->vertex(e.i)) - dsc.position(e.cell->vertex(e.j));
    squared = (std::max)(squared, edge.squared_length());
  });
  return std::sqrt(squared);
}

TEST(Control_detail, splits_long_edges_of_the_interface) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  // The sides of the squares are shorter than the threshold, their diagonals are longer.
  const double limit = 1.1 * dsc.mean_interface_edge();
  ASSERT_TRUE(.5 < limit && limit < std::sqrt(.5));
  const auto np = parameters::collapse_length(0.).interface_split_length(1.1);
  EXPECT_EQ(number_of_changes(DSC::control_detail(dsc, np)), 0u); // the complex must not change
  const auto report = DSC::control_detail(dsc, np.change_interface(true));
  EXPECT_EQ(report.split, 24u);
  EXPECT_EQ(number_of_changes(report), 24u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.interface_facets().size(), 96u);
  EXPECT_NEAR(dsc.volume(1), 1, tolerance);
  EXPECT_NEAR(dsc.volume(0), 7, tolerance);
  EXPECT_NEAR(dsc.area(1), 6, tolerance);
}

TEST(Control_detail, follows_the_sizing_field) {
  const auto number_of_splits = [](const auto& size) {
    Complex dsc = make_complex(grid(2, small_meshes::uniform));
    const auto report = DSC::control_detail(
        dsc, parameters::sizing_field(size).split_length(1.5).collapse_length(0.));
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_EQ(number_of_changes(report), report.split);
    EXPECT_EQ(dsc.number_of_vertices(), 27 + report.split);
    EXPECT_EQ(dsc.number_of_cells(), 48 + 6 * report.split); // around each diagonal of a cube
    EXPECT_NEAR(dsc.volume(0), 8, tolerance);
    return report.split;
  };
  EXPECT_EQ(number_of_splits([](const Point&) { return 1.; }), 8u);
  EXPECT_EQ(number_of_splits([](const Point& p) { return p.x() < 0 ? 1. : 10.; }), 4u);
  EXPECT_EQ(number_of_splits([](const Point&) { return 2.; }), 0u);
}

// Each edge between a small cube and the domain boundary is split once.
TEST(Control_detail, gives_the_interface_room_to_move) {
  Labeled_mesh mesh = grid(3, [](const Point& p) {
    return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < 1. / 3 ? 1 : 0;
  });
  const auto squeezed = [](double x) { return x < -.5 ? -1. : x < 0 ? -.05 : x < .5 ? .05 : 1.; };
  for (Point& p : mesh.points)
    p = Point(squeezed(p.x()), squeezed(p.y()), squeezed(p.z()));
  Complex dsc = make_complex(mesh);
  const auto triangles = interface_triangles(dsc);
  std::size_t tied = 0;
  for (const auto& e : dsc.triangulation().finite_edges()) {
    const Vertex_handle v = e.first->vertex(e.second), w = e.first->vertex(e.third);
    tied += (v->is_interface() && dsc.is_boundary(w)) || (w->is_interface() && dsc.is_boundary(v));
  }
  const auto report = DSC::control_detail(dsc, parameters::collapse_length(0.));
  EXPECT_GT(tied, 20u);
  EXPECT_EQ(report.split, tied);
  EXPECT_EQ(number_of_changes(report), tied);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(interface_triangles(dsc) == triangles);
  EXPECT_NEAR(dsc.volume(1), .001, tolerance);
  EXPECT_NEAR(volume_of_domain(dsc), 8, tolerance);
}

TEST(Control_detail, coarsens_the_inside_of_labels_only) {
  struct Visitor : public DSC::Deformation_visitor<Complex>
  {
    void after_split(Vertex_handle, Vertex_handle, Vertex_handle) override { ++split; }
    void before_collapse(Vertex_handle removed, Vertex_handle kept) override {
      EXPECT_FALSE(removed->is_interface() || kept->is_interface());
      EXPECT_FALSE(removed->boundary_class() != 0 || kept->boundary_class() != 0);
      ++collapsed;
    }
    std::size_t split = 0, collapsed = 0;
  };
  Complex dsc = make_complex(grid(8, small_meshes::cube));
  const auto triangles = interface_triangles(dsc);
  const std::size_t vertices = dsc.number_of_vertices();
  Visitor visitor;
  const auto report = DSC::control_detail(dsc, parameters::visitor(std::ref(visitor)));
  EXPECT_GT(report.collapsed, 5u);
  EXPECT_EQ(report.collapsed, visitor.collapsed);
  EXPECT_EQ(report.split, visitor.split);
  EXPECT_EQ(dsc.number_of_vertices(), vertices + report.split - report.collapsed);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(interface_triangles(dsc) == triangles);
  EXPECT_NEAR(dsc.volume(1), 1, tolerance);
  EXPECT_NEAR(dsc.volume(0), 7, tolerance);
}

TEST(Control_detail, makes_no_cell_below_the_quality_asked_for) {
  for (double bound : {.1, .25, .4}) {
    Complex dsc = make_complex(grid(6, small_meshes::uniform));
    const auto size = [](const Point&) { return 1.; };
    DSC::control_detail(dsc, parameters::sizing_field(size).collapse_quality(bound));
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_GE(minimum_quality(dsc), bound);
  }
}

TEST(Control_detail, makes_no_edge_that_it_would_split) {
  Complex dsc = make_complex(grid(4, small_meshes::uniform));
  const auto report = DSC::control_detail(
      dsc, parameters::sizing_field([](const Point&) { return 1.; }).split_length(1.3));
  EXPECT_GT(report.collapsed, 0u);
  EXPECT_EQ(report.split, 0u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_LE(longest_edge(dsc), 1.3);
}

TEST(Control_detail, collapses_short_edges_of_the_interface_if_it_may) {
  Grid_with_short_edge mesh(half_space);
  Complex& dsc = mesh.dsc;
  const auto state = dsc.state();
  const auto np = parameters::collapse_length(0.);
  EXPECT_EQ(number_of_changes(DSC::control_detail(dsc, np)), 0u);
  EXPECT_TRUE(dsc.state() == state);
  const auto report = DSC::control_detail(dsc, np.change_interface(true));
  EXPECT_EQ(report.collapsed, 1u);
  EXPECT_EQ(number_of_changes(report), 1u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(0), 4, tolerance);
  EXPECT_NEAR(dsc.volume(1), 4, tolerance);
}

TEST(Control_detail, keeps_the_topology_and_is_deterministic) {
  const auto run = [](unsigned seed) {
    Complex dsc = jittered_grid(4, small_meshes::two_boxes, .3, seed);
    const Complex before = dsc;
    DSC::control_detail(dsc, parameters::change_interface(true)
                                 .interface_split_length(1.3)
                                 .interface_collapse_length(1.)
                                 .collapse_quality(.05));
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_NEAR(volume_of_domain(dsc), 8, tolerance);
    EXPECT_EQ(dsc.labels(), before.labels());
    for (int label : before.labels()) {
      EXPECT_EQ(dsc.euler_characteristic(label), before.euler_characteristic(label));
      EXPECT_EQ(dsc.number_of_components(label), before.number_of_components(label));
    }
    return dsc.state();
  };
  for (unsigned seed = 0; seed < 3; ++seed)
    EXPECT_TRUE(run(seed) == run(seed));
}

// Without an interface, there is no reference length for edges.
TEST(Control_detail, without_interface_and_sizing_field_does_nothing) {
  Complex dsc = jittered_grid(4, small_meshes::uniform, .3, 1);
  const auto state = dsc.state();
  EXPECT_EQ(number_of_changes(DSC::control_detail(dsc, parameters::change_interface(true))), 0u);
  EXPECT_TRUE(dsc.state() == state);
  Complex empty;
  EXPECT_EQ(number_of_changes(DSC::control_detail(empty)), 0u);
}

// Lengths refer to an interface that did not exist when the complex was built.
TEST(Control_detail, needs_a_length) {
  Complex dsc = make_complex(grid(4, small_meshes::uniform));
  dsc.relabel(dsc.cells().front(), 1);
  expect_error(dsc, [&](Complex& copy) { DSC::control_detail(copy); });
  DSC::control_detail(dsc, parameters::sizing_field([](const Complex::Point_3&) { return 1.; }));
  dsc.measure_interface_edges();
  DSC::control_detail(dsc);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Control_detail, refuses_values_out_of_range) {
  const Complex dsc = make_complex(grid(2, small_meshes::four_phases));
  const auto refuses = [&](const auto& np) {
    expect_error(dsc, [&](Complex& copy) { DSC::control_detail(copy, np); });
  };
  for (double value : {-1., 0., not_a_number}) {
    refuses(parameters::split_length(value));
    refuses(parameters::interface_split_length(value));
    refuses(parameters::sizing_field([value](const Point&) { return value; }));
  }
  for (double value : {-1., not_a_number}) {
    refuses(parameters::collapse_length(value));
    refuses(parameters::interface_collapse_length(value));
    refuses(parameters::collapse_quality(value));
  }
  refuses(parameters::collapse_quality(2.));
  refuses(parameters::number_of_iterations(-1));
}

} // namespace test_detail_control

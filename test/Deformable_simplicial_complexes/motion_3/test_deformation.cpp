#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_deformation {

using CGAL::Deformable_simplicial_complexes::Invalid_destination_error;
using mesh_helpers::interface_triangles;
using namespace small_meshes;
using Report = DSC::Deformation_report<Complex>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Two cubes of side length 1/2 with centers at distance 1, in grids of 8^3 cubes.
int two_cubes(const Point& p) {
  return (std::max)({std::abs(std::abs(p.x()) - .5), std::abs(p.y()), std::abs(p.z())}) < .25;
}

// The cube [-1/2,1/2]^3 divided into four phases that meet along a line.
int four_phases_in_cube(const Point& p) {
  return small_meshes::cube(p) == 0 ? 0 : 1 + small_meshes::four_phases(p);
}

// Checks the statements of a report about the complex.
void expect_true(const Report& report, const Complex& dsc) {
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(report.complete,
            report.unfinished.empty() && report.stopped_at_boundary == 0 && report.is_balanced());
  for (const auto& change : report.labels) {
    EXPECT_EQ(change.volume_after, dsc.volume(change.label));
    EXPECT_EQ(change.after, dsc.number_of_components(change.label));
    EXPECT_EQ(change.before + change.split + change.appeared,
              change.after + change.merged + change.vanished);
  }
  for (int label : dsc.labels())
    EXPECT_EQ(std::count_if(report.labels.begin(), report.labels.end(),
                            [&](const auto& change) { return change.label == label; }),
              1);
}

// Deforms by displacements that depend on the position.
template <class Displacement, class... NamedParameters>
Report deform(Complex& dsc, const Displacement& displacement, const NamedParameters&... np) {
  const auto report = DSC::deform_interface(
      dsc, [&](Vertex_handle v) { return dsc.position(v) + displacement(dsc.position(v)); }, np...);
  expect_true(report, dsc);
  return report;
}

std::vector<Position> positions(const Complex& dsc, const std::vector<Vertex_handle>& vertices) {
  std::vector<Position> result;
  for (Vertex_handle v : vertices)
    result.push_back(dsc.position(v));
  return result;
}

double largest_distance(const std::vector<Position>& p, const std::vector<Position>& q) {
  double squared = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    squared = (std::max)(squared, (p[i] - q[i]).squared_length());
  return std::sqrt(squared);
}

// Rigid motions

// A full rotation about an axis changes neither the vertices nor the triangles of the interface.
TEST(Deformation, ball_rotates_without_remeshing) {
  Complex dsc = make_complex(grid(6, small_meshes::ball));
  const auto vertices = dsc.interface_vertices();
  const auto before = positions(dsc, vertices);
  const double volume = dsc.volume(1), area = dsc.area(1);
  const std::size_t triangles = dsc.interface_facets().size();
  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {1, 2, 3}, CGAL_PI / 180);
  for (int angle = 0; angle < 360; angle += 20) {
    const Report report = DSC::advect_interface(dsc, rotation, angle, 20);
    expect_true(report, dsc);
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(report.relabeled, 0u);
    ASSERT_EQ(dsc.interface_vertices(), vertices);
    EXPECT_NEAR(dsc.volume(1), volume, 1e-12);
  }
  EXPECT_LT(largest_distance(positions(dsc, vertices), before), 1e-12);
  EXPECT_NEAR(dsc.area(1), area, 1e-12);
  EXPECT_EQ(dsc.interface_facets().size(), triangles);
}

TEST(Deformation, cube_moves_to_the_side_and_back) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto triangles = interface_triangles(dsc);
  for (double step : {.125, .125, -.25, -.25, .25}) {
    const Report report = deform(dsc, [&](const Position&) { return Vector(step, step / 2, 0); });
    EXPECT_TRUE(report.complete);
    EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
    EXPECT_NEAR(dsc.area(1), 6, 1e-12);
  }
  EXPECT_TRUE(interface_triangles(dsc) == triangles);
}

// Triple lines, and points where four phases meet each other and the outside.
TEST(Deformation, four_phases_rotate) {
  Complex dsc = make_complex(grid(4, four_phases_in_cube));
  const auto labels = dsc.labels();
  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, CGAL_PI / 180);
  for (int step = 0; step < 6; ++step) {
    const Report report = DSC::advect_interface(dsc, rotation, 15 * step, 15);
    expect_true(report, dsc);
    EXPECT_TRUE(report.complete);
    ASSERT_EQ(dsc.labels(), labels);
    for (int label : {1, 2, 3, 4}) {
      EXPECT_NEAR(dsc.volume(label), .25, 1e-12);
      EXPECT_EQ(dsc.number_of_components(label), 1u);
      EXPECT_EQ(dsc.euler_characteristic(label), 2);
    }
    EXPECT_NEAR(dsc.area(1, 4), 0, 1e-12);
    EXPECT_NEAR(dsc.area(1, 2), .5, 1e-12);
    EXPECT_NEAR(dsc.area(1, 3), .5, 1e-12);
  }
}

// Zero displacements and impossible displacements

TEST(Deformation, to_where_everything_is_changes_nothing) {
  Complex dsc = mesh_helpers::jittered_grid(4, small_meshes::two_boxes, .4, 1);
  const auto state = dsc.state();
  const Report report = deform(dsc, [](const Position&) { return Vector(0, 0, 0); });
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.passes, 0u);
  EXPECT_TRUE(dsc.state() == state);
  Complex empty;
  EXPECT_TRUE(deform(empty, [](const Position&) { return Vector(1, 0, 0); }).complete);
}

TEST(Deformation, destinations_that_are_no_points_are_refused) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  const auto state = dsc.state();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {nan, infinity, -infinity})
    for (int axis = 0; axis < 3; ++axis)
      try {
        DSC::deform_interface(dsc, [&](Vertex_handle v) {
          const bool is_good = v != vertices[3] && v != vertices[20];
          return is_good ? Point(.1, .2, .3)
                         : Point(axis == 0 ? bad : 0, axis == 1 ? bad : 0, axis == 2 ? bad : 0);
        });
        ADD_FAILURE() << "accepted";
      } catch (const Invalid_destination_error& e) {
        EXPECT_EQ(e.vertices(), (std::vector<std::size_t>{3, 20}));
        EXPECT_TRUE(dsc.state() == state);
      }
  EXPECT_THROW(DSC::advect_interface(
                   dsc, [&](const Position&, double) { return Vector(nan, 0, 0); }, 0, 1),
               Invalid_destination_error);
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Deformation, refuses_thresholds_that_are_no_qualities) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  const auto stay = [](Vertex_handle v) { return v->point(); };
  using CGAL::Deformable_simplicial_complexes::Error;
  for (double threshold : {-.1, 1.1, std::nan("")}) {
    EXPECT_THROW(DSC::deform_interface(dsc, stay, parameters::quality_threshold(threshold)), Error);
    EXPECT_THROW(DSC::deform_interface(dsc, stay, parameters::relabeling_threshold(threshold)),
                 Error);
    EXPECT_THROW(DSC::improve_mesh(dsc, parameters::quality_threshold(threshold)), Error);
  }
  EXPECT_TRUE(dsc.state() == state);
}

// Negative numbers would become huge unsigned numbers.
TEST(Deformation, refuses_negative_numbers) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  const auto stay = [](Vertex_handle v) { return v->point(); };
  using CGAL::Deformable_simplicial_complexes::Error;
  EXPECT_THROW(DSC::deform_interface(dsc, stay, parameters::maximum_number_of_passes(-1)), Error);
  EXPECT_THROW(DSC::deform_interface(dsc, stay, parameters::number_of_threads(-1)), Error);
  EXPECT_THROW(DSC::improve_mesh(dsc, parameters::number_of_iterations(-1)), Error);
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Deformation, ends_within_the_passes_asked_for) {
  for (unsigned passes : {0u, 1u, 3u}) {
    Complex dsc = make_complex(grid(4, small_meshes::cube));
    const auto state = dsc.state();
    // far outside the domain
    const Report report = deform(
        dsc, [](const Position& p) { return 9 * (p - CGAL::ORIGIN); },
        parameters::maximum_number_of_passes(passes));
    EXPECT_LE(report.passes, passes);
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(dsc.state() == state, passes == 0);
  }
}

TEST(Deformation, tells_how_far_vertices_stayed) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const Report report = deform(
      dsc, [](const Position& p) { return 9 * (p - CGAL::ORIGIN); },
      parameters::maximum_number_of_passes(0u));
  const auto vertices = dsc.interface_vertices();
  ASSERT_EQ(report.unfinished.size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(report.unfinished[i].vertex, vertices[i]);
    const Position p = dsc.position(vertices[i]);
    const auto in_box = [](double x) { return (std::max)(-1., (std::min)(1., x)); };
    const Position destination(in_box(10 * p.x()), in_box(10 * p.y()), in_box(10 * p.z()));
    EXPECT_NEAR(report.unfinished[i].distance, std::sqrt((destination - p).squared_length()),
                1e-12);
  }
}

// The interface rests, and space rotates around it. On the sides of the box, vertices slide.
TEST(Deformation, lets_all_vertices_follow_the_flow) {
  for (const bool all : {false, true}) {
    SCOPED_TRACE(all);
    Complex dsc = make_complex(grid(8, [](const auto& p) {
      return std::abs(CGAL::to_double(p.x())) < .3 && std::abs(CGAL::to_double(p.y())) < .3 &&
             std::abs(CGAL::to_double(p.z())) < .3;
    }));
    const auto target = [&](Vertex_handle v) {
      const Position p = dsc.position(v);
      return p + .02 * Vector(0, 0, (p.x() + p.y()) * (1 - p.z() * p.z()));
    };
    DSC::Deformation_options<Complex> options;
    options.preserve_mesh();
    options.flow_moves_all = all;
    options.flow = [&](const std::vector<Vertex_handle>& vertices) {
      std::vector<Position> result;
      for (Vertex_handle v : vertices)
        result.push_back(v->is_interface() ? dsc.position(v) : target(v));
      return result;
    };
    const DSC::Interface_snapshot<Complex> interface_(dsc);
    std::vector<std::pair<Vertex_handle, Position>> expected;
    for (Vertex_handle v : dsc.vertices())
      if (!v->is_interface())
        expected.emplace_back(v, all ? target(v) : dsc.position(v));
    const auto report =
        DSC::deform_interface_to(dsc, interface_, interface_.positions(dsc), options);
    EXPECT_TRUE(report.complete);
    std::size_t moved = 0;
    for (const auto& [v, p] : expected)
      moved += (dsc.position(v) - p).squared_length() < 1e-20;
    // The deviation of the interface from the flow changes the flow of its neighbors.
    EXPECT_GT(moved, all ? expected.size() / 2 : expected.size() - 1);
  }
}

// Finite coordinates are accepted even if their squares overflow.
TEST(Deformation, survives_destinations_at_the_end_of_the_numbers) {
  for (double huge : {1e100, 1e200, 1e308}) {
    Complex dsc = make_complex(grid(4, small_meshes::cube));
    const Report report = deform(
        dsc, [&](const Position& p) { return p.y() > 0 ? Vector(huge, 0, 0) : Vector(0, .1, 0); },
        parameters::maximum_number_of_passes(3u));
    EXPECT_LE(report.passes, 3u);
  }
}

TEST(Deformation, stays_in_the_box) {
  Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  const Report report = deform(dsc, [](const Position& p) {
    return Vector(.1 - .2 * p.x() * p.y(), .1, p.z() + .5); // moves the top
  });
  for (Vertex_handle v : dsc.vertices())
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::abs(dsc.position(v)[axis]), 1);
      if (DSC::Boundary_class::fixes(v->boundary_class(), axis)) {
        EXPECT_EQ(std::abs(dsc.position(v)[axis]), 1);
      }
    }
  double sum = 0;
  for (int label : dsc.labels())
    sum += dsc.volume(label);
  EXPECT_NEAR(sum, 8, 1e-12);
  EXPECT_LE(report.passes, 20u);
}

// The interface may slide along the box.
TEST(Deformation, moves_along_the_sides_of_the_box) {
  Complex dsc = make_complex(grid(4, [](const Point& p) { return p.x() < 0 ? 1 : 0; }));
  for (int step = 0; step < 4; ++step)
    EXPECT_TRUE(deform(dsc, [](const Position&) { return Vector(.1, 0, 0); }).complete);
  EXPECT_NEAR(dsc.volume(1), 4 * 1.4, 1e-12);
  EXPECT_NEAR(dsc.area(1), 4, 1e-12);
}

// Changes of topology

// Sums the changes of components of label 1 over steps in which all points move towards x = 0.
Report::Label_change collide(Complex& dsc, int steps, double step) {
  Report::Label_change sum;
  for (int i = 0; i < steps; ++i) {
    const Report report =
        deform(dsc, [&](const Position& p) { return Vector(p.x() > 0 ? -step : step, 0, 0); });
    for (const auto& change : report.labels)
      if (change.label == 1) {
        sum.merged += change.merged;
        sum.split += change.split;
        sum.vanished += change.vanished;
        sum.appeared += change.appeared;
      }
  }
  return sum;
}

TEST(Deformation, two_cubes_merge) {
  Complex dsc = make_complex(grid(8, two_cubes));
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  const auto changes = collide(dsc, 4, .08);
  EXPECT_EQ(changes.merged, 1u);
  EXPECT_EQ(changes.split, 0u);
  EXPECT_EQ(changes.vanished, 0u);
  EXPECT_EQ(changes.appeared, 0u);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.number_of_components(0), 1u);
}

TEST(Deformation, two_balls_merge) {
  Complex dsc = make_complex(grid(10, small_meshes::two_balls));
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  const auto changes = collide(dsc, 4, .1);
  EXPECT_EQ(changes.merged, 1u);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.number_of_components(0), 1u); // no gap is left
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
}

// Without a unit of length, topology could not change.
TEST(Deformation, of_labels_that_came_later) {
  Complex dsc = make_complex(grid(8, small_meshes::uniform));
  for (Complex::Cell_handle c : dsc.cells())
    dsc.relabel(c, two_cubes(CGAL::centroid(c->vertex(0)->point(), c->vertex(1)->point(),
                                            c->vertex(2)->point(), c->vertex(3)->point())));
  const auto stay = [&](Vertex_handle v) { return v->point(); };
  const auto before = dsc.state();
  EXPECT_THROW(DSC::deform_interface(dsc, stay), CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(dsc.state() == before);
  dsc.measure_interface_edges();
  EXPECT_EQ(collide(dsc, 4, .08).merged, 1u);
}

// The edges of the initial interface are twenty times as long. Limits for small cells and short
// edges use the present mesh.
TEST(Deformation, limits_follow_the_mesh) {
  const auto merged = [](double unit) {
    Complex dsc = make_complex(grid(8, two_cubes));
    auto state = dsc.state();
    state.mean_interface_edge *= unit;
    state.minimum_interface_edge *= unit;
    dsc.restore(state);
    std::size_t changes = 0;
    for (double distance : {.1, .1, .1, -.1, -.1, -.1, -.1}) {
      const Report report = DSC::advect_interface(dsc, DSC::Normal_offset{distance}, 0, 1,
                                                  parameters::domain_rule(DSC::Domain_rule::stop));
      changes += report.relabeled + report.collapsed;
    }
    EXPECT_GT(changes, 0u);
    return dsc;
  };
  const Complex dsc = merged(20);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(interface_triangles(dsc) == interface_triangles(merged(1)));
}

// The vertices move in another, deterministic order.
TEST(Deformation, in_the_order_of_collisions) {
  const auto merged = [](bool collision_order) {
    Complex dsc = make_complex(grid(8, two_cubes));
    for (int i = 0; i < 4; ++i) {
      const auto to_the_middle = [](const Position& p) {
        return Vector(p.x() > 0 ? -.08 : .08, 0, 0);
      };
      deform(dsc, to_the_middle, parameters::collision_order(collision_order));
    }
    EXPECT_EQ(dsc.number_of_components(1), 1u);
    return dsc.state();
  };
  EXPECT_TRUE(merged(true) == merged(true));
  EXPECT_FALSE(merged(true) == merged(false));
}

// Visitors

struct Counting_visitor : public DSC::Deformation_visitor<Complex>
{
  void after_split(Vertex_handle, Vertex_handle, Vertex_handle) override { ++split; }
  void before_collapse(Vertex_handle removed, Vertex_handle kept) override {
    EXPECT_NE(removed, kept);
    ++collapsed;
  }
  void after_flip(const std::vector<Cell_handle>& cells) override {
    EXPECT_GE(cells.size(), 2u);
    ++flipped;
  }
  void after_relabel(Cell_handle cell, int before) override {
    EXPECT_NE(cell->subdomain_index(), before);
    ++relabeled;
  }
  bool go_further(unsigned pass) override {
    EXPECT_EQ(pass, ++passes);
    return pass <= maximum_number_of_passes;
  }
  std::size_t split = 0, collapsed = 0, flipped = 0, relabeled = 0;
  unsigned passes = 0, maximum_number_of_passes = 1000;
};

Vector swirl(const Position& p) {
  return .35 * Vector(std::sin(5 * p.y()), std::cos(4 * p.z()), std::sin(6 * p.x()));
}

TEST(Deformation, visitor_sees_what_the_report_counts) {
  Complex dsc = mesh_helpers::jittered_grid(6, small_meshes::two_boxes, .3, 2);
  std::size_t changes = 0;
  for (int step = 0; step < 3; ++step) {
    Counting_visitor visitor;
    const Report report = deform(dsc, swirl, parameters::visitor(std::ref(visitor)));
    EXPECT_EQ(report.split, visitor.split);
    EXPECT_EQ(report.collapsed, visitor.collapsed);
    EXPECT_EQ(report.flipped, visitor.flipped);
    EXPECT_EQ(report.relabeled, visitor.relabeled);
    EXPECT_EQ(report.passes, visitor.passes);
    changes += report.flipped + report.collapsed;
  }
  EXPECT_GT(changes, 10u);
}

TEST(Deformation, visitor_can_end_it) {
  for (unsigned passes : {0u, 1u, 2u}) {
    Complex dsc = make_complex(grid(4, small_meshes::cube));
    const auto state = dsc.state();
    Counting_visitor visitor;
    visitor.maximum_number_of_passes = passes;
    const Report report = deform(
        dsc, [](const Position& p) { return 3 * (p - CGAL::ORIGIN); },
        parameters::visitor(std::ref(visitor)));
    EXPECT_EQ(report.passes, passes);
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(dsc.state() == state, passes == 0);
  }
}

TEST(Deformation, exception_of_the_visitor_leaves_a_valid_complex) {
  struct Throwing_visitor : public DSC::Deformation_visitor<Complex>
  {
    void after_flip(const std::vector<Cell_handle>&) override { throw std::runtime_error("no"); }
  };
  Complex dsc = mesh_helpers::jittered_grid(6, small_meshes::two_boxes, .3, 2);
  Throwing_visitor visitor;
  EXPECT_THROW(DSC::deform_interface(
                   dsc, [&](Vertex_handle v) { return dsc.position(v) + swirl(dsc.position(v)); },
                   parameters::visitor(std::ref(visitor))),
               std::runtime_error);
  EXPECT_TRUE(dsc.is_valid());
  deform(dsc, swirl); // the exception has no effect on the next call
}

// Returns the state after two deformations, optionally through a state in between.
Complex::State deformed(unsigned number_of_threads, bool restore = false) {
  Complex dsc = mesh_helpers::jittered_grid(6, small_meshes::two_boxes, .3, 2);
  const auto threads = parameters::number_of_threads(number_of_threads);
  deform(dsc, swirl, threads);
  if (restore) {
    Complex restored;
    restored.restore(dsc.state());
    dsc = restored;
  }
  deform(dsc, swirl, threads);
  return dsc.state();
}

TEST(Deformation, tells_where_the_time_went) {
  Complex dsc = mesh_helpers::jittered_grid(6, small_meshes::two_boxes, .3, 2);
  const auto seconds = deform(dsc, swirl).seconds;
  for (double part : {seconds.extension, seconds.motion, seconds.relabeling, seconds.obstacles,
                      seconds.improvement, seconds.rest})
    EXPECT_GT(part, 0);
}

TEST(Deformation, is_deterministic) { EXPECT_TRUE(deformed(1) == deformed(1)); }

TEST(Deformation, does_not_depend_on_the_number_of_threads) {
  EXPECT_TRUE(deformed(1) == deformed(2));
  EXPECT_TRUE(deformed(1) == deformed(5));
}

TEST(Deformation, continues_from_a_state_to_the_same_bits) {
  EXPECT_TRUE(deformed(1) == deformed(1, true));
}

TEST(Deformation, visitor_may_be_given_by_value) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  Counting_visitor visitor;
  visitor.maximum_number_of_passes = 0;
  const Report report = deform(dsc, swirl, parameters::visitor(visitor));
  EXPECT_EQ(report.passes, 0u);
  EXPECT_EQ(DSC::improve_mesh(dsc, parameters::visitor(visitor)).split, 0u);
}

struct Throwing_visitor : public DSC::Deformation_visitor<Complex>
{
  bool go_further(unsigned pass) override { return pass < 2 ? true : throw pass; }
};

TEST(Deformation, stays_valid_when_a_visitor_throws) {
  Complex dsc = mesh_helpers::jittered_grid(6, small_meshes::two_boxes, .3, 2);
  EXPECT_THROW(deform(dsc, swirl, parameters::visitor(Throwing_visitor())), unsigned);
  EXPECT_TRUE(dsc.is_valid());
}

} // namespace test_deformation

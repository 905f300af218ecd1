#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

namespace test_improvement {

using mesh_helpers::interface_triangles;
using mesh_helpers::jittered_grid;
using mesh_helpers::minimum_quality;
using namespace small_meshes;

// Improves a complex and checks the invariants.
template <class NamedParameters>
DSC::Improvement_report improve(Complex& dsc, const NamedParameters& np) {
  const auto triangles = interface_triangles(dsc);
  const Complex before = dsc;
  const auto report = DSC::improve_mesh(dsc, np);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(interface_triangles(dsc) == triangles);
  EXPECT_GE(minimum_quality(dsc), minimum_quality(before));
  EXPECT_EQ(dsc.labels(), before.labels());
  for (int label : before.labels()) {
    EXPECT_NEAR(dsc.volume(label), before.volume(label), 1e-12);
    EXPECT_EQ(dsc.number_of_components(label), before.number_of_components(label));
  }
  return report;
}

std::size_t number_of_changes(const DSC::Improvement_report& r) {
  return r.split + r.collapsed + r.flipped + r.smoothed;
}

// Returns the grid of 27 cubes whose middle cubes have side length 2 a.
template <class Label> Labeled_mesh grid_with_thin_middle(Label label, double a) {
  Labeled_mesh mesh = grid(3, label);
  const auto squeezed = [&](double x) { return x < -.5 ? -1. : x < 0 ? -a : x < .5 ? a : 1.; };
  for (Point& p : mesh.points)
    p = Point(squeezed(p.x()), squeezed(p.y()), squeezed(p.z()));
  return mesh;
}

int middle(const Point& p) {
  return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < 1. / 3 ? 1 : 0;
}

struct Counting_visitor : public DSC::Deformation_visitor<Complex>
{
  void after_split(Vertex_handle, Vertex_handle, Vertex_handle) override { ++split; }
  void before_collapse(Vertex_handle, Vertex_handle) override { ++collapsed; }
  void after_flip(const std::vector<Cell_handle>&) override { ++flipped; }
  std::size_t split = 0, collapsed = 0, flipped = 0;
};

TEST(Improve_mesh, keeps_interface_and_raises_quality) {
  for (double threshold : {.15, .3, .4})
    for (unsigned seed = 0; seed < 2; ++seed)
      for (auto label : {small_meshes::uniform, small_meshes::ball, small_meshes::two_boxes,
                         small_meshes::four_phases}) {
        Complex dsc = jittered_grid(4, label, .45, seed);
        improve(dsc, parameters::quality_threshold(threshold));
      }
}

TEST(Improve_mesh, removes_most_bad_cells) {
  Complex dsc = jittered_grid(5, small_meshes::uniform, .45, 1);
  const auto number_of_bad_cells = [&] {
    const auto cells = dsc.cells();
    return std::count_if(cells.begin(), cells.end(),
                         [](Cell_handle c) { return c->quality() < .25; });
  };
  const auto before = number_of_bad_cells();
  EXPECT_GT(before, 100);
  const auto report = improve(dsc, parameters::default_values());
  EXPECT_LT(number_of_bad_cells(), before / 4);
  EXPECT_GT(report.flipped, 0u);
  EXPECT_GT(report.smoothed, 0u);
}

// No operation helps in a mesh that is squeezed in a direction.
TEST(Improve_mesh, gives_squeezed_meshes_up_soon) {
  Labeled_mesh mesh = grid(4, small_meshes::two_boxes);
  for (Point& p : mesh.points)
    p = Point(p.x(), p.y(), 1e-4 * p.z());
  Complex dsc = make_complex(mesh);
  const std::size_t before = dsc.number_of_cells();
  improve(dsc, parameters::default_values());
  EXPECT_LT(dsc.number_of_cells(), 5 * before);
}

TEST(Improve_mesh, is_deterministic) {
  const auto run = [] {
    Complex dsc = jittered_grid(4, small_meshes::ball, .45, 2);
    DSC::improve_mesh(dsc, parameters::quality_threshold(.5));
    return dsc.state();
  };
  EXPECT_TRUE(run() == run());
}

TEST(Improve_mesh, leaves_a_good_mesh_alone) {
  Complex dsc = jittered_grid(4, small_meshes::ball, .45, 3);
  const auto state = dsc.state();
  EXPECT_EQ(number_of_changes(improve(dsc, parameters::quality_threshold(1e-6))), 0u);
  for (bool aggressive : {false, true}) {
    const auto mode = parameters::aggressive(aggressive);
    EXPECT_EQ(number_of_changes(improve(dsc, mode.number_of_iterations(0u))), 0u);
    EXPECT_TRUE(dsc.state() == state);
    Complex empty;
    EXPECT_EQ(number_of_changes(DSC::improve_mesh(empty, mode)), 0u);
  }
}

TEST(Improve_mesh, tells_the_visitor_of_each_change) {
  Complex dsc = jittered_grid(4, small_meshes::ball, .45, 4);
  Counting_visitor visitor;
  const auto report = improve(dsc, parameters::quality_threshold(.5).visitor(std::ref(visitor)));
  EXPECT_EQ(report.split, visitor.split);
  EXPECT_EQ(report.collapsed, visitor.collapsed);
  EXPECT_EQ(report.flipped, visitor.flipped);
  EXPECT_GT(report.flipped, 0u);
}

TEST(Improve_mesh, exception_of_the_visitor_leaves_a_valid_complex) {
  struct Throwing_visitor : public DSC::Deformation_visitor<Complex>
  {
    void after_flip(const std::vector<Cell_handle>&) override {
      if (++flipped == 3)
        throw std::runtime_error("enough");
    }
    int flipped = 0;
  };
  Complex dsc = jittered_grid(4, small_meshes::ball, .45, 5);
  const auto triangles = interface_triangles(dsc);
  Throwing_visitor visitor;
  EXPECT_THROW(DSC::improve_mesh(dsc, parameters::visitor(std::ref(visitor))), std::runtime_error);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(interface_triangles(dsc) == triangles);
}

// Needles and caps on the interface cannot be repaired here.
TEST(Improve_mesh, keeps_degenerate_facets_of_the_interface) {
  Complex dsc = make_complex(grid(4, [](const Point& p) { return p.x() < 0 ? 1 : 0; }));
  for (Vertex_handle v : dsc.interface_vertices()) {
    const auto p = dsc.position(v);
    if (!dsc.is_boundary(v) && p.y() > -.1 && p.y() < .1)
      dsc.move_vertex(v, Point(0, .4999, p.z())); // next to the row of vertices at y = 1/2
  }
  ASSERT_TRUE(dsc.is_valid());
  improve(dsc, parameters::default_values());
}

// Without an interface, there is no reference length for long edges.
TEST(Improve_mesh, without_interface_makes_nothing_worse) {
  Complex dsc = make_complex(grid_with_thin_middle(small_meshes::uniform, .2));
  const std::size_t before = dsc.number_of_cells();
  improve(dsc, parameters::quality_threshold(.9));
  EXPECT_LT(dsc.number_of_cells(), 2 * before);
}

// Long edges between the interface and the domain boundary are split.
TEST(Improve_mesh, around_a_small_interface) {
  Complex dsc = make_complex(grid_with_thin_middle(middle, .05));
  EXPECT_NEAR(dsc.volume(1), .001, 1e-15);
  const double before = minimum_quality(dsc);
  EXPECT_GT(improve(dsc, parameters::default_values()).split, 0u);
  EXPECT_GT(minimum_quality(dsc), 4 * before);
}

TEST(Improve_mesh, inserts_vertices_and_tells_so) {
  struct Visitor : public DSC::Deformation_visitor<Complex>
  {
    void after_insertion(Vertex_handle v) override {
      EXPECT_FALSE(v->is_interface());
      ++inserted;
    }
    std::size_t inserted = 0;
  };
  std::size_t inserted = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Complex dsc = jittered_grid(4, small_meshes::two_boxes, .45, seed);
    Visitor visitor;
    const auto report = improve(dsc, parameters::quality_threshold(.5).visitor(std::ref(visitor)));
    EXPECT_EQ(report.inserted, visitor.inserted);
    inserted += report.inserted;
  }
  EXPECT_GT(inserted, 0u);
}

// Keeps a list of the vertices by the notifications of a visitor.
struct Bookkeeper : public DSC::Deformation_visitor<Complex>
{
  explicit Bookkeeper(const Complex& dsc) {
    for (Vertex_handle v : dsc.vertices())
      vertices.insert(v);
  }
  void after_split(Vertex_handle v, Vertex_handle, Vertex_handle) override { vertices.insert(v); }
  void after_insertion(Vertex_handle v) override {
    vertices.insert(v);
    ++inserted;
  }
  void before_collapse(Vertex_handle removed, Vertex_handle kept) override {
    EXPECT_TRUE(removed != kept && vertices.count(kept) == 1);
    EXPECT_EQ(vertices.erase(removed), 1u);
    ++collapsed;
  }
  void after_flip(const std::vector<Cell_handle>& cells) override {
    EXPECT_FALSE(cells.empty());
    ++flipped;
  }

  std::set<Vertex_handle> vertices;
  std::size_t inserted = 0, collapsed = 0, flipped = 0;
};

// Sums the differences of the cell qualities from a threshold, with large weights for the worst
// cells.
double deficit(const Complex& dsc, double threshold) {
  double result = 0;
  for (Cell_handle c : dsc.cells())
    result += std::pow((std::max)(0., threshold - c->quality()), 3);
  return result;
}

TEST(Improve_mesh, aggressively_reaches_a_better_quality) {
  static constexpr double threshold = .7;
  Complex once = jittered_grid(3, small_meshes::uniform, .45, 1), again = once;
  improve(once, parameters::quality_threshold(threshold));
  Bookkeeper books(again);
  const auto report = improve(
      again, parameters::quality_threshold(threshold).aggressive(true).visitor(std::ref(books)));
  EXPECT_LT(deficit(again, threshold), .5 * deficit(once, threshold));
  EXPECT_GE(minimum_quality(again), minimum_quality(once));
  EXPECT_EQ(report.inserted, books.inserted);
  EXPECT_EQ(report.collapsed, books.collapsed);
  EXPECT_EQ(report.flipped, books.flipped);
  const auto vertices = again.vertices();
  EXPECT_TRUE(books.vertices == std::set<Vertex_handle>(vertices.begin(), vertices.end()));
}

// The domain is not a box, so its boundary is fixed.
TEST(Improve_mesh, aggressively_keeps_the_boundary) {
  Labeled_mesh mesh = grid(3, small_meshes::uniform);
  for (Point& p : mesh.points)
    p = Point(p.x() + .3 * p.y() * p.z(), p.y(), p.z());
  Complex dsc = make_complex(mesh);
  const auto hull = [&] {
    std::set<std::array<double, 3>> result;
    for (Vertex_handle v : dsc.vertices())
      if (dsc.is_boundary(v))
        result.insert({v->point().x(), v->point().y(), v->point().z()});
    return result;
  };
  const auto before = hull();
  const double volume = dsc.volume(0);
  EXPECT_GT(number_of_changes(improve(dsc, parameters::quality_threshold(.6).aggressive(true))),
            0u);
  EXPECT_TRUE(hull() == before);
  EXPECT_EQ(dsc.volume(0), volume);
}

TEST(Improve_mesh, aggressively_twice_gives_the_same_bits) {
  const Complex initial = jittered_grid(3, small_meshes::two_boxes, .45, 5);
  Complex one = initial, two = initial;
  for (Complex* dsc : {&one, &two})
    DSC::improve_mesh(*dsc, parameters::aggressive(true));
  EXPECT_TRUE(one.state() == two.state());
}

// Two columns of one label that touch along a line.
TEST(Improve_mesh, aggressively_keeps_components) {
  const auto checkered = [](const Point& p) { return (p.x() < 0) == (p.y() < 0) ? 1 : 0; };
  Complex dsc = jittered_grid(4, checkered, .4, 6);
  ASSERT_EQ(dsc.number_of_components(1), 2u);
  improve(dsc, parameters::quality_threshold(.35).aggressive(true));
  EXPECT_TRUE(dsc.take_component_events().empty());
}

// A vertex of the wall between two boxes is moved within the wall, until cells are nearly
// degenerate.
TEST(Improve_mesh, smooths_the_interface_only_on_request) {
  Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  const auto vertices = dsc.vertices();
  const auto middle = *std::find_if(vertices.begin(), vertices.end(),
                                    [](Vertex_handle v) { return v->point() == CGAL::ORIGIN; });
  ASSERT_EQ(dsc.move_vertex(middle, Point(0, .47, .48)), 1);
  Complex fixed = dsc;
  improve(fixed, parameters::quality_threshold(.4));
  const double wall = dsc.area(1, 2), area = dsc.area(0);
  DSC::improve_mesh(dsc, parameters::quality_threshold(.4).smooth_interface(true));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.position(middle).x(), 0);
  EXPECT_FALSE(middle->point() == Point(0, .47, .48));
  EXPECT_NEAR(dsc.area(1, 2), wall, 1e-14);
  EXPECT_NEAR(dsc.area(0), area, 1e-14);
  EXPECT_GT(minimum_quality(dsc), minimum_quality(fixed));
}

} // namespace test_improvement

#include "betti_numbers.h"
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/null_space_smoothing_3.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_interface_improvement {

using mesh_helpers::coordinates;
using namespace small_meshes;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;

std::array<Position, 3> corners(const Complex& dsc, const Complex::Facet& f) {
  const auto v = dsc.facet_vertices(f);
  return {dsc.position(v[0]), dsc.position(v[1]), dsc.position(v[2])};
}

double worst_facet(const Complex& dsc) {
  double worst = 1;
  for (const auto& f : dsc.interface_facets())
    worst = (std::min)(worst, internal::triangle_quality(corners(dsc, f)));
  return worst;
}

double longest_interface_edge(const Complex& dsc) {
  double longest = 0;
  for (const auto& f : dsc.interface_facets()) {
    const auto p = corners(dsc, f);
    for (int i = 0; i < 3; ++i)
      longest = (std::max)(longest, (p[i] - p[(i + 1) % 3]).squared_length());
  }
  return std::sqrt(longest);
}

double radius(const Complex& dsc, Vertex_handle v) {
  return std::sqrt((dsc.position(v) - CGAL::ORIGIN).squared_length());
}

// Returns the number of coordinates on a side of the cube: 1 on sides, 2 on edges, 3 at corners.
int number_of_sides(const Position& p) {
  int result = 0;
  for (int k = 0; k < 3; ++k)
    result += std::abs(std::abs(p[k]) - .5) < 1e-12;
  return result;
}

// A cube whose vertices are displaced randomly within their sides and edges.
Complex disturbed_cube(unsigned seed) {
  Complex dsc = make_complex(grid(8, small_meshes::cube));
  mesh_helpers::Random random(seed);
  for (Vertex_handle v : dsc.interface_vertices()) {
    const Position p = dsc.position(v);
    const auto step = random.vector<Complex>(.1);
    const auto shifted = [&](int k) { return std::abs(p[k]) == .5 ? p[k] : p[k] + step[k]; };
    dsc.move_vertex(v, {shifted(0), shifted(1), shifted(2)});
  }
  return dsc;
}

const auto only_smoothing = parameters::interface_split_length(1e9)
                                .interface_collapse_length(0.)
                                .flip_angle(0.)
                                .minimum_facet_angle(0.)
                                .quality_threshold(0.);

TEST(Null_space_smoothing, moves_within_sides_and_edges) {
  Complex dsc = disturbed_cube(1);
  const auto vertices = dsc.interface_vertices();
  std::vector<Position> before;
  for (Vertex_handle v : vertices)
    before.push_back(dsc.position(v));
  const double worst = worst_facet(dsc), volume = dsc.volume(1);
  const auto report = DSC::improve_interface(dsc, only_smoothing.number_of_iterations(20));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(report.smoothed, 50u);
  EXPECT_EQ(report.split + report.flipped, 0u);
  EXPECT_GT(worst_facet(dsc), 1.5 * worst);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-13);
  ASSERT_EQ(dsc.interface_vertices(), vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(number_of_sides(dsc.position(vertices[i])), number_of_sides(before[i]));
    if (number_of_sides(before[i]) == 3) {
      EXPECT_EQ(dsc.position(vertices[i]), before[i]);
    }
  }
}

// Compares the proposal for one vertex with the definition.
TEST(Null_space_smoothing, proposes_the_mean_of_the_centroids) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  const Vertex_handle v = *std::find_if(vertices.begin(), vertices.end(), [&](Vertex_handle w) {
    return dsc.position(w) == Position(0, 0, .5);
  });
  ASSERT_EQ(dsc.move_vertex(v, {.15, .1, .5}), 1);
  std::vector<Cell_handle> star;
  dsc.star(v, star);
  CGAL::Vector_3<CGAL::Epick> sum(0, 0, 0);
  double area = 0;
  for (const auto& f : dsc.interface_facets()) {
    const auto w = dsc.facet_vertices(f);
    if (std::find(w.begin(), w.end(), v) == w.end())
      continue;
    sum = sum + dsc.area(f) *
                    (CGAL::centroid(dsc.position(w[0]), dsc.position(w[1]), dsc.position(w[2])) -
                     CGAL::ORIGIN);
    area += dsc.area(f);
  }
  Complex::Point_3 target;
  ASSERT_TRUE(DSC::propose_null_space_position(dsc, v, star, .025, 1., 0., target));
  EXPECT_NEAR(target.x(), sum.x() / area, 1e-14);
  EXPECT_NEAR(target.y(), sum.y() / area, 1e-14);
  EXPECT_NEAR(target.z(), .5, 1e-14);
  dsc.set_point(v, star, target);
  EXPECT_TRUE(dsc.is_valid());
}

// Next to small facets, the quadric does not detect a ridge or a corner.
TEST(Null_space_smoothing, keeps_edges_of_thin_sides) {
  Complex dsc = make_complex(grid(8, small_meshes::cube));
  for (Vertex_handle v : dsc.interface_vertices()) {
    const Position p = dsc.position(v);
    if (p.x() == .5 && p.z() == .25 && std::abs(p.y()) < .5) {
      ASSERT_EQ(dsc.move_vertex(v, {.5, p.y(), .499}), 1);
    }
  }
  std::vector<Cell_handle> star;
  Complex::Point_3 target;
  const double right_angle = std::acos(0.);
  for (double feature_angle : {.7, 1.1}) {
    std::size_t left = 0;
    for (Vertex_handle v : dsc.interface_vertices()) {
      dsc.star(v, star);
      if (DSC::propose_null_space_position(dsc, v, star, .025, feature_angle * right_angle, 0.,
                                           target))
        left += number_of_sides(dsc.position(v)) > number_of_sides(target);
    }
    EXPECT_EQ(left > 0, feature_angle > 1);
  }
}

TEST(Null_space_smoothing, leaves_lines_between_labels_and_the_boundary) {
  for (auto label : {small_meshes::two_boxes, small_meshes::four_phases}) {
    Complex dsc = mesh_helpers::jittered_grid(8, label, .2, 3);
    std::vector<Cell_handle> star;
    Complex::Point_3 target;
    std::size_t proposed = 0;
    for (Vertex_handle v : dsc.interface_vertices()) {
      dsc.star(v, star);
      std::vector<int> labels;
      for (Cell_handle c : star)
        if (!dsc.is_infinite(c))
          labels.push_back(c->subdomain_index());
      std::sort(labels.begin(), labels.end());
      labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
      if (!DSC::propose_null_space_position(dsc, v, star, .9, 1., 0., target))
        continue;
      ++proposed;
      EXPECT_EQ(labels.size(), 2u);
      EXPECT_FALSE(dsc.is_boundary(v));
    }
    EXPECT_GT(proposed, 0u);
  }
}

TEST(Improve_interface, splits_long_edges) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const double wanted = .3, volume = dsc.volume(1);
  const auto report = DSC::improve_interface(
      dsc, only_smoothing.aggressiveness(0.).interface_split_length(1.).sizing_field(
               [wanted](const Position&) { return wanted; }));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(report.split, 0u);
  EXPECT_LE(longest_interface_edge(dsc), wanted);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-14);
}

// New vertices lie on the sphere up to terms of higher order than the distance of the chord.
TEST(Improve_interface, splits_on_the_smooth_surface) {
  static constexpr double r = .6;
  const auto sum_of_errors = [](bool curved) {
    Complex dsc = mesh_helpers::sphere(16, r);
    DSC::improve_interface(
        dsc, only_smoothing.aggressiveness(0.).interface_split_length(.9).curved_splits(curved));
    EXPECT_TRUE(dsc.is_valid());
    double sum = 0;
    for (Vertex_handle v : dsc.interface_vertices())
      sum += std::abs(radius(dsc, v) - r);
    return sum;
  };
  EXPECT_LT(sum_of_errors(true), .1 * sum_of_errors(false));
}

// New vertices do not lie beyond the edges of a cube.
TEST(Improve_interface, curved_splits_keep_features) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const double volume = dsc.volume(1);
  const auto report = DSC::improve_interface(
      dsc, only_smoothing.aggressiveness(0.).interface_split_length(.6).curved_splits(true));
  EXPECT_GT(report.split, 0u);
  for (Vertex_handle v : dsc.interface_vertices())
    EXPECT_GE(number_of_sides(dsc.position(v)), 1);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-13);
}

TEST(Improve_interface, collapses_short_edges_within_a_bound_on_the_volume) {
  for (double swept_volume : {0., 1.}) {
    Complex dsc = mesh_helpers::sphere(8, .6);
    const std::size_t vertices = dsc.interface_vertices().size();
    const double volume = dsc.volume(1);
    const auto report = DSC::improve_interface(
        dsc,
        only_smoothing.aggressiveness(0.).interface_collapse_length(.9).swept_volume(swept_volume));
    EXPECT_TRUE(dsc.is_valid());
    if (swept_volume == 0) {
      EXPECT_EQ(dsc.interface_vertices().size(), vertices);
      EXPECT_EQ(dsc.volume(1), volume);
    } else {
      EXPECT_GT(report.collapsed, 10u);
      EXPECT_LT(dsc.interface_vertices().size(), vertices - 10);
    }
    EXPECT_EQ(dsc.euler_characteristic(1), 2);
  }
}

// Edges of planar sides that violate the criterion are flipped; edges of curved sides are not.
TEST(Improve_interface, flips_edges_of_flat_parts) {
  const auto flipping = only_smoothing.aggressiveness(0.).flip_angle(5.);
  const auto violations = [](const Complex& dsc) {
    int result = 0;
    for (const auto& f : dsc.interface_facets())
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          if (i != f.second && j != f.second) {
            const internal::Interface_edge_3<Complex> edge(dsc, f.first, i, j);
            result += edge.is_in_sheet() && edge.bend() < .01 && edge.violates_delaunay_criterion();
          }
    return result;
  };
  Complex flat = disturbed_cube(5);
  const double volume = flat.volume(1);
  const int before = violations(flat);
  ASSERT_GT(before, 4);
  DSC::improve_interface(flat, flipping.number_of_iterations(3));
  EXPECT_TRUE(flat.is_valid());
  EXPECT_LT(violations(flat), before / 2);
  EXPECT_NEAR(flat.volume(1), volume, 1e-13);
  for (Vertex_handle v : flat.interface_vertices())
    EXPECT_GE(number_of_sides(flat.position(v)), 1);

  Complex bent = mesh_helpers::sphere(4, .6); // the facets meet at more than 5 degrees
  const auto facets = mesh_helpers::interface_triangles(bent);
  DSC::improve_interface(bent, flipping);
  EXPECT_EQ(mesh_helpers::interface_triangles(bent), facets);
}

// For all interfaces and parameters, complexes stay valid, topology and labels are preserved, and
// the result is deterministic.
TEST(Improve_interface, random_complexes) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const auto label = seed % 2 == 0 ? small_meshes::eight_phases : small_meshes::ball;
    const Complex input = mesh_helpers::jittered_grid(6, label, .4, seed);
    const auto topology = betti_numbers::of_complex(input);
    mesh_helpers::Random random(seed);
    const auto np = parameters::aggressiveness(random(0, .9))
                        .interface_split_length(random(.8, 2.))
                        .interface_collapse_length(random(0, .7))
                        .flip_angle(random(0, 90))
                        .minimum_facet_angle(random(0, 30))
                        .swept_volume(random(0, .5))
                        .curved_splits(seed % 3 == 0)
                        .number_of_iterations(2);
    Complex dsc = input, again = input;
    DSC::improve_interface(dsc, np);
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_TRUE(betti_numbers::of_complex(dsc) == topology);
    EXPECT_EQ(dsc.labels(), input.labels());
    DSC::improve_interface(again, np);
    EXPECT_TRUE(dsc.state() == again.state());
  }
}

// Short edges and small angles of the sides and edges are removed; the cube keeps its shape.
TEST(Improve_interface, keeps_features) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    Complex dsc = disturbed_cube(seed);
    const double volume = dsc.volume(1);
    const auto report = DSC::improve_interface(dsc, parameters::interface_collapse_length(.9)
                                                        .minimum_facet_angle(30.)
                                                        .swept_volume(1.)
                                                        .number_of_iterations(3));
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_GT(report.collapsed, 10u);
    EXPECT_NEAR(dsc.volume(1), volume, 1e-12);
    int corners = 0;
    for (Vertex_handle v : dsc.interface_vertices()) {
      EXPECT_GE(number_of_sides(dsc.position(v)), 1);
      corners += number_of_sides(dsc.position(v)) == 3;
    }
    EXPECT_EQ(corners, 8);
  }
}

// An interface may end on a side of the domain in a ridge. New vertices must stay on the side.
TEST(Improve_interface, curved_splits_stay_on_the_boundary) {
  const auto ridge = [](const small_meshes::Point& p) {
    return p.z() < -.5 - std::abs(p.y()) ? 1 : 0;
  };
  Complex dsc = make_complex(grid(4, ridge));
  DSC::improve_interface(dsc, parameters::curved_splits(true).interface_split_length(.6));
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Improve_interface, needs_a_length) {
  Complex dsc = make_complex(grid(4, small_meshes::uniform));
  dsc.relabel(dsc.cells().front(), 1); // an interface that did not exist when the complex was built
  EXPECT_THROW(DSC::improve_interface(dsc), CGAL::Deformable_simplicial_complexes::Error);
  DSC::improve_interface(dsc, parameters::sizing_field([](const Position&) { return 1.; }));
  dsc.measure_interface_edges();
  DSC::improve_interface(dsc);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Improve_interface, removes_small_angles) {
  Complex dsc = mesh_helpers::jittered_grid(8, small_meshes::ball, .45, 8);
  const double worst = worst_facet(dsc);
  const auto report = DSC::improve_interface(dsc, only_smoothing.aggressiveness(0.)
                                                      .feature_angle(180.)
                                                      .minimum_facet_angle(30.)
                                                      .swept_volume(1.)
                                                      .number_of_iterations(3));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(report.flipped + report.collapsed, 0u);
  EXPECT_GT(worst_facet(dsc), worst);
}

TEST(Improve_interface, refuses_parameters_out_of_range) {
  Complex dsc = mesh_helpers::sphere(4, .6);
  const auto before = dsc.state();
  const double nan = std::nan("");
  using CGAL::Deformable_simplicial_complexes::Error;
  for (double bad : {-.1, 1., nan})
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::aggressiveness(bad)), Error);
  for (double bad : {-1., 91., nan})
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::flip_angle(bad)), Error);
  for (double bad : {-1., 181., nan})
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::feature_angle(bad)), Error);
  for (double bad : {-1., 31., nan})
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::minimum_facet_angle(bad)), Error);
  for (double bad : {-1., 0., nan})
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::interface_split_length(bad)), Error);
  for (double bad : {-1., nan}) {
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::interface_collapse_length(bad)), Error);
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::swept_volume(bad)), Error);
    EXPECT_THROW(DSC::improve_interface(dsc, parameters::quality_threshold(bad)), Error);
  }
  EXPECT_THROW(DSC::improve_interface(dsc, parameters::number_of_iterations(-1)), Error);
  EXPECT_TRUE(dsc.state() == before);
}

TEST(Curvature_sizing_field, of_a_sphere) {
  static constexpr double r = .6, tolerance = .002;
  const Complex dsc = mesh_helpers::sphere(8, r);
  const DSC::Curvature_sizing_field<3> size(dsc, tolerance, .01, 1.);
  const double expected = std::sqrt(8 * tolerance * r);
  for (Vertex_handle v : dsc.interface_vertices())
    EXPECT_NEAR(size(dsc.position(v)), expected, .15 * expected);
  const DSC::Curvature_sizing_field<3> bounded(dsc, tolerance, .2, .3);
  EXPECT_EQ(bounded({r, 0, 0}), .2);
  EXPECT_EQ(DSC::Curvature_sizing_field<3>(dsc, 1., .2, .3)({r, 0, 0}), .3);
}

// The target edge length is small at the edges of a cube and at the first vertices that see them.
// It grows with the distance. Without an interface, it is as large as allowed.
TEST(Curvature_sizing_field, is_graded) {
  const Complex dsc = make_complex(grid(16, small_meshes::cube));
  const DSC::Curvature_sizing_field<3> size(dsc, 1e-6, .01, 1., .5);
  EXPECT_EQ(size({.5, .5, 0}), .01);
  EXPECT_EQ(size({.5, .375, 0}), .01);
  EXPECT_NEAR(size({.5, .25, 0}), .01 + .5 * .125, 1e-12);
  EXPECT_NEAR(size({.5, .125, 0}), .01 + .5 * .25, 1e-12);
  const DSC::Curvature_sizing_field<3> slowly(dsc, 1e-6, .01, 1., .05);
  EXPECT_NEAR(slowly({.5, 0, 0}), .01 + .05 * .375, 1e-12);
  const Complex nothing = make_complex(grid(2, small_meshes::uniform));
  EXPECT_EQ(DSC::Curvature_sizing_field<3>(nothing, 1e-6, .01, 1.)({0, 0, 0}), 1);
}

// The edges of a cube are sharp features, the edges of a sphere are not.
TEST(Curvature_sizing_field, leaves_out_sharp_edges) {
  const Complex cube = make_complex(grid(16, small_meshes::cube));
  const DSC::Curvature_sizing_field<3> of_cube(cube, 1e-6, .01, 1., .5, 60.);
  for (Vertex_handle v : cube.interface_vertices())
    EXPECT_EQ(of_cube(cube.position(v)), 1);
  EXPECT_EQ(DSC::Curvature_sizing_field<3>(cube, 1e-6, .01, 1., .5, 91.)({.5, .5, 0}), .01);
  const Complex sphere = mesh_helpers::sphere(8, .6);
  const DSC::Curvature_sizing_field<3> smooth(sphere, .002, .01, 1.),
      also_smooth(sphere, .002, .01, 1., .5, 60.);
  for (Vertex_handle v : sphere.interface_vertices())
    EXPECT_EQ(smooth(sphere.position(v)), also_smooth(sphere.position(v)));
}

TEST(Curvature_sizing_field, refuses_what_makes_no_sense) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  using CGAL::Deformable_simplicial_complexes::Error;
  EXPECT_THROW(DSC::Curvature_sizing_field<3>(dsc, 0., .1, 1.), Error);
  EXPECT_THROW(DSC::Curvature_sizing_field<3>(dsc, .1, 0., 1.), Error);
  EXPECT_THROW(DSC::Curvature_sizing_field<3>(dsc, .1, 2., 1.), Error);
  EXPECT_THROW(DSC::Curvature_sizing_field<3>(dsc, .1, .1, 1., 0.), Error);
  EXPECT_THROW(DSC::Curvature_sizing_field<3>(dsc, std::nan(""), .1, 1.), Error);
  for (double bad : {-1., 181., std::nan("")})
    EXPECT_THROW(DSC::Curvature_sizing_field<3>(dsc, .1, .1, 1., .5, bad), Error);
}

} // namespace test_interface_improvement

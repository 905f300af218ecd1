#include "mesh_helpers.h"
#include "surface_measures.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Interface_remeshing/subdivide_interface_3.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

// Loop subdivision of manifold and non-manifold interfaces.

namespace test_subdivision {

using namespace surface_measures;
using mesh_helpers::jittered_grid;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;
using Surface = DSC::Interface_surface_3<Complex>;

// Returns the number of triangles at each edge; edges are pairs of points.
std::map<std::pair<std::size_t, std::size_t>, int> edges(const Surface& surface) {
  std::map<std::pair<std::size_t, std::size_t>, int> result;
  for (const auto& t : surface.triangles)
    for (int i = 0; i < 3; ++i)
      ++result[std::minmax(t[i], t[(i + 1) % 3])];
  return result;
}

// Returns the number of edges with this number of triangles.
std::map<int, std::size_t> degrees(const Surface& surface) {
  std::map<int, std::size_t> result;
  for (const auto& [edge, degree] : edges(surface))
    ++result[degree];
  return result;
}

double volume_behind(const Surface& surface, int label) {
  double volume = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const double v =
        CGAL::cross_product(surface.points[a] - CGAL::ORIGIN, surface.points[b] - CGAL::ORIGIN) *
        (surface.points[c] - CGAL::ORIGIN) / 6;
    volume += surface.labels[t][0] == label ? v : surface.labels[t][1] == label ? -v : 0;
  }
  return volume;
}

// Returns whether the triangles at a label form its closed boundary: opposite half-edges match.
bool bounds(const Surface& surface, int label) {
  std::map<std::pair<std::size_t, std::size_t>, int> balance;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const int sign = int(surface.labels[t][0] == label) - int(surface.labels[t][1] == label);
    for (int i = 0; i < 3; ++i) {
      const std::size_t p = surface.triangles[t][i], q = surface.triangles[t][(i + 1) % 3];
      balance[std::minmax(p, q)] += p < q ? sign : -sign;
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& b) { return b.second == 0; });
}

double least_radius(const Surface& surface) {
  double least = 1;
  for (const auto& p : surface.points)
    least = (std::min)(least, std::sqrt((p - CGAL::ORIGIN).squared_length()));
  return least;
}

double square_of_longest_edge(const Surface& surface) {
  double longest = 0;
  for (const auto& [ends, degree] : edges(surface))
    longest = (std::max)(
        longest, (surface.points[ends.first] - surface.points[ends.second]).squared_length());
  return longest;
}

void expect_equal(const Surface& a, const Surface& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.boundary_classes, b.boundary_classes);
}

// Checks the properties of any subdivision step: sizes, labels, handles, and numbers of edges.
void check_step(const Surface& before, const Surface& after) {
  const std::size_t n = before.triangles.size();
  ASSERT_EQ(after.triangles.size(), 4 * n);
  ASSERT_EQ(after.labels.size(), 4 * n);
  ASSERT_EQ(after.vertices.size(), after.points.size());
  ASSERT_EQ(after.boundary_classes.size(), after.points.size());
  for (std::size_t t = 0; t < 4 * n; ++t)
    ASSERT_EQ(after.labels[t], before.labels[t / 4]);
  for (std::size_t p = 0; p < after.points.size(); ++p)
    ASSERT_EQ(after.vertices[p],
              p < before.points.size() ? before.vertices[p] : Surface::Vertex_handle());
  EXPECT_EQ(measures(after).euler_characteristic, measures(before).euler_characteristic);
  auto expected = degrees(before);
  for (auto& [degree, number] : expected)
    number *= 2;
  expected[2] += 3 * n; // inside of triangles
  EXPECT_EQ(degrees(after), expected);
}

bool is_near_origin(const Point& p) {
  return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < .5;
}

// Two boxes of label 1 that touch along an edge from the origin upwards; single cubes if n is 4.
int boxes_at_an_edge(const Point& p) {
  return is_near_origin(p) && p.z() > 0 && (p.x() < 0) == (p.y() < 0) ? 1 : 0;
}

// Two boxes of label 1 that touch at the origin.
int boxes_at_a_point(const Point& p) {
  return is_near_origin(p) && (p.x() < 0) == (p.y() < 0) && (p.x() < 0) == (p.z() < 0) ? 1 : 0;
}

// The thirds of a ball around the z axis.
int sectors_of_a_ball(const Point& p) {
  if (small_meshes::ball(p) == 0)
    return 0;
  return p.x() < 0 ? 1 : p.y() < 0 ? 2 : 3;
}

TEST(Subdivide_interface, zero_times_changes_nothing) {
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  const Surface surface = DSC::extract_interface(dsc);
  expect_equal(DSC::subdivide_interface(surface, 0), surface);
  EXPECT_THROW(DSC::subdivide_interface(surface, -1), CGAL::Deformable_simplicial_complexes::Error);
}

TEST(Subdivide_interface, of_no_triangles_is_empty) {
  const Complex dsc = make_complex(grid(2, small_meshes::uniform));
  const Surface surface = DSC::subdivide_interface(DSC::extract_interface(dsc), 3);
  EXPECT_TRUE(surface.points.empty());
  EXPECT_TRUE(surface.triangles.empty());
}

TEST(Subdivide_interface, twice_is_the_same_as_two_at_once) {
  const Complex dsc = jittered_grid(4, small_meshes::eight_phases, .1, 1);
  const Surface surface = DSC::extract_interface(dsc);
  expect_equal(DSC::subdivide_interface(DSC::subdivide_interface(surface)),
               DSC::subdivide_interface(surface, 2));
}

TEST(Subdivide_interface, of_a_manifold_is_that_of_the_mesh) {
  const Complex dsc = jittered_grid(8, small_meshes::ball, .1, 2);
  const Surface surface = DSC::extract_interface(dsc);
  CGAL::Surface_mesh<Point> mesh;
  DSC::interface_to_surface_mesh(surface, mesh);
  ASSERT_EQ(mesh.number_of_vertices(), surface.points.size());
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  std::vector<Point> expected, points;
  for (const auto v : mesh.vertices())
    expected.push_back(mesh.point(v));
  for (const auto& p : DSC::subdivide_interface(surface, 2).points)
    points.emplace_back(p.x(), p.y(), p.z());
  ASSERT_EQ(points.size(), expected.size());
  // The order of summation may differ.
  for (const Point& p : points) {
    double nearest = 1;
    for (const Point& q : expected)
      nearest = (std::min)(nearest, CGAL::to_double((p - q).squared_length()));
    EXPECT_LT(nearest, 1e-30);
  }
}

TEST(Subdivide_interface, of_a_ball_stays_a_ball) {
  constexpr double radius = .6;
  const double pi = std::acos(-1.);
  Surface surface = DSC::extract_interface(mesh_helpers::sphere(8, radius));
  double least = least_radius(surface);
  for (int i = 0; i < 4; ++i) {
    const Surface next = DSC::subdivide_interface(surface);
    check_step(surface, next);
    EXPECT_EQ(degrees(next), (std::map<int, std::size_t>{{2, 3 * next.triangles.size() / 2}}));
    EXPECT_EQ(measures(next).euler_characteristic, 2);
    // New points are averages of old points whose distance from one of them, p, is at most an edge
    // length e. In the direction of p, their height is at least r - e^2 / 2 r, where r is the
    // smallest distance from the origin. The same bound holds for all points of a triangle.
    const double lowest = least - square_of_longest_edge(surface) / (2 * least);
    surface = next;
    least = least_radius(surface);
    EXPECT_GT(least, lowest);
    const double inside = least - square_of_longest_edge(surface) / (2 * least);
    EXPECT_GT(measures(surface).volume, 4 * pi / 3 * std::pow(inside, 3));
    EXPECT_LT(measures(surface).volume, 4 * pi / 3 * std::pow(radius, 3));
    for (const auto& p : surface.points)
      EXPECT_LE(std::sqrt((p - CGAL::ORIGIN).squared_length()), radius * (1 + 1e-15));
  }
}

TEST(Subdivide_interface, keeps_sheets_together_along_curves) {
  for (const auto label : {small_meshes::two_boxes, sectors_of_a_ball}) {
    const Complex dsc = jittered_grid(8, label, .1, 3);
    Surface surface = DSC::extract_interface(dsc);
    const std::size_t junctions = degrees(surface)[3];
    ASSERT_GT(junctions, 0u);
    for (int i = 1; i <= 3; ++i) {
      const Surface next = DSC::subdivide_interface(surface);
      check_step(surface, next);
      surface = next;
      EXPECT_EQ(degrees(surface).count(1), 0u);
      EXPECT_EQ(degrees(surface)[3], junctions << i);
      for (int l = 0; l <= 3; ++l)
        EXPECT_TRUE(bounds(surface, l));
      for (int l = 1; l <= 3; ++l) // the scheme shrinks
        EXPECT_NEAR(volume_behind(surface, l), dsc.volume(l), .1 * dsc.volume(l));
    }
  }
}

TEST(Subdivide_interface, moves_curves_by_the_rule_for_borders) {
  const Complex dsc = jittered_grid(4, small_meshes::two_boxes, .1, 4);
  const Surface surface = DSC::extract_interface(dsc), next = DSC::subdivide_interface(surface);
  std::map<std::size_t, std::vector<std::size_t>> neighbors;
  for (const auto& [ends, degree] : edges(surface))
    if (degree == 3) {
      neighbors[ends.first].push_back(ends.second);
      neighbors[ends.second].push_back(ends.first);
    }
  ASSERT_EQ(neighbors.size(), 8u); // around the wall between the boxes
  for (const auto& [p, others] : neighbors) {
    ASSERT_EQ(others.size(), 2u);
    const auto expected = surface.points[p] + ((surface.points[others[0]] - surface.points[p]) +
                                               (surface.points[others[1]] - surface.points[p])) /
                                                  8;
    EXPECT_LT((next.points[p] - expected).squared_length(), 1e-30);
  }
}

TEST(Subdivide_interface, holds_points_where_curves_branch) {
  const Complex dsc = jittered_grid(8, small_meshes::eight_phases, .1, 5);
  const Surface surface = DSC::extract_interface(dsc);
  std::map<std::size_t, int> curves; // at points
  for (const auto& [ends, degree] : edges(surface))
    if (degree > 2) {
      ++curves[ends.first];
      ++curves[ends.second];
    }
  const Surface next = DSC::subdivide_interface(surface);
  check_step(surface, next);
  std::size_t branchings = 0;
  for (const auto& [p, number] : curves)
    if (number > 2) {
      ++branchings;
      EXPECT_EQ(next.points[p], surface.points[p]);
    } else
      EXPECT_NE(next.points[p], surface.points[p]);
  EXPECT_GE(branchings, 7u); // the center, and the points where the axes leave the ball
}

TEST(Subdivide_interface, keeps_what_touches_together) {
  for (const std::size_t n : {std::size_t(4), std::size_t(8)})
    for (const auto label : {boxes_at_an_edge, boxes_at_a_point}) {
      Surface surface = DSC::extract_interface(make_complex(grid(n, label)));
      EXPECT_EQ(degrees(surface).count(4), label == boxes_at_an_edge ? 1u : 0u);
      for (int i = 0; i < 2; ++i) {
        const Surface next = DSC::subdivide_interface(surface);
        check_step(surface, next);
        surface = next;
      }
      EXPECT_EQ(std::count(surface.points.begin(), surface.points.end(), CGAL::ORIGIN), 1);
    }
}

TEST(Subdivide_interface, ends_in_the_boundary_as_before) {
  const Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  Surface surface = DSC::extract_interface(dsc);
  const std::size_t ends = degrees(surface)[1];
  ASSERT_GT(ends, 0u);
  for (int i = 0; i < 2; ++i) {
    const Surface next = DSC::subdivide_interface(surface);
    check_step(surface, next);
    surface = next;
  }
  EXPECT_EQ(degrees(surface)[1], 4 * ends);
  EXPECT_NEAR(measures(surface).area, 8, tolerance); // planes up to the edges of the box
  for (const auto& [points, degree] : edges(surface))
    if (degree == 1) {
      const auto p = CGAL::midpoint(surface.points[points.first], surface.points[points.second]);
      EXPECT_NEAR((std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}), 1, tolerance);
    }
}

TEST(Subdivide_interface, of_a_pair_of_labels_is_a_part_of_the_whole) {
  const Complex dsc = jittered_grid(8, small_meshes::two_boxes, .1, 7);
  const Surface whole = DSC::subdivide_interface(DSC::extract_interface(dsc), 2),
                pair = DSC::subdivide_interface(DSC::extract_interface(dsc, 1, 2), 2);
  std::set<Surface::Point_3> junction;
  double area = 0;
  for (const auto& [ends, degree] : edges(whole))
    if (degree == 3)
      junction.insert({whole.points[ends.first], whole.points[ends.second]});
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const auto& [a, b, c] = whole.triangles[t];
    if (whole.labels[t] == std::array<int, 2>{2, 1})
      area += std::sqrt(CGAL::squared_area(whole.points[a], whole.points[b], whole.points[c]));
  }
  EXPECT_NEAR(measures(pair).area, area, tolerance);
  std::set<Surface::Point_3> border;
  for (const auto& [ends, degree] : edges(pair))
    if (degree == 1)
      border.insert({pair.points[ends.first], pair.points[ends.second]});
  EXPECT_EQ(border, junction); // bitwise
}

TEST(Subdivide_interface, is_written) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const Surface surface = DSC::subdivide_interface(DSC::extract_interface(dsc), 2);
  CGAL::IO::write_interface(folder / "a.ply", surface);
  const auto read = CGAL::IO::read_labeled_surface(folder / "a.ply");
  EXPECT_EQ(read.triangles, surface.triangles);
  EXPECT_EQ(measures(read).volume, measures(surface).volume);
}

TEST(Subdivide_interface, is_written_with_values) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const Surface surface = DSC::subdivide_interface(DSC::extract_interface(dsc));
  DSC::Mesh_array height{"height", "Float32", 1, {}}, number{"number", "Float32", 1, {}};
  for (const auto& p : surface.points) {
    height.values.push_back(p.z());
    number.values.push_back(double(number.values.size()));
  }
  CGAL::IO::write_interface(folder / "a.ply", surface, {height, number});
  const auto read = CGAL::IO::read_labeled_surface(folder / "a.ply");
  EXPECT_EQ(read.triangles, surface.triangles);
  EXPECT_EQ(measures(read).volume, measures(surface).volume);
  std::istringstream file(file_bytes(folder / "a.ply"));
  std::string line, header;
  while (std::getline(file, line) && line != "end_header")
    header += line + '\n';
  EXPECT_PRED2(contains, header,
               "property double z\nproperty float height\nproperty float number\n");
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    double x, y, z, height_at, number_at;
    ASSERT_TRUE(file >> x >> y >> z >> height_at >> number_at);
    EXPECT_EQ(z, surface.points[i].z());
    EXPECT_EQ(float(height_at), float(z));
    EXPECT_EQ(number_at, double(i));
  }
  EXPECT_THROW(CGAL::IO::write_interface(folder / "a.off", surface, {height}), DSC::File_error);
}

} // namespace test_subdivision

// Surfaces with shared walls.

#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/make_patches_3.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace test_shared_walls {

using namespace small_surfaces;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;

// Twelve triangles. If `is_other` is true, the faces have the other diagonals.
Surface box(const std::array<double, 6>& b, int label, bool is_other = false) {
  Surface surface;
  for (int i = 0; i < 8; ++i)
    surface.points.emplace_back(b[i & 1 ? 3 : 0], b[i & 2 ? 4 : 1], b[i & 4 ? 5 : 2]);
  const std::array<std::size_t, 4> faces[] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces)
    if (is_other) {
      surface.triangles.push_back({f[1], f[2], f[3]});
      surface.triangles.push_back({f[1], f[3], f[0]});
    } else {
      surface.triangles.push_back({f[0], f[1], f[2]});
      surface.triangles.push_back({f[0], f[2], f[3]});
    }
  surface.label = label;
  return surface;
}

Complex complex_of(const std::vector<Surface>& surfaces) {
  Complex dsc = DSC::make_deformable_simplicial_complex_3<Complex>(
      DSC::make_patches_3(surfaces).patches, CGAL::Tetgen_tetrahedralizer_3());
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

// Concatenates surfaces into one; their points are not shared.
Surface join(const Surfaces& surfaces) {
  Surface result;
  for (const Surface& surface : surfaces)
    append(result, surface);
  return result;
}

TEST(Shared_walls, may_be_triangulated_alike_or_not) {
  for (bool is_other : {false, true}) {
    const Complex dsc =
        complex_of({box({0, 0, 0, 1, 1, 1}, 1), box({1, 0, 0, 3, 1, 1}, 2, is_other)});
    EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
    EXPECT_NEAR(dsc.volume(2), 2, 1e-12);
  }
}

TEST(Shared_walls, may_be_parts_of_faces) {
  const Complex dsc = complex_of({box({0, 0, 0, 1, 1, 1}, 4), box({1, .25, .25, 2, .5, 2}, 2)});
  EXPECT_NEAR(dsc.volume(4), 1, 1e-12);
  EXPECT_NEAR(dsc.volume(2), .25 * 1.75, 1e-12);
}

TEST(Shared_walls, may_be_those_of_nested_surfaces) {
  const Complex dsc = complex_of({box({0, 0, 0, 1, 1, 1}, 1), box({0, .25, .25, .5, .5, .5}, 2)});
  EXPECT_NEAR(dsc.volume(2), .5 * .25 * .25, 1e-12);
  EXPECT_NEAR(dsc.volume(1), 1 - .5 * .25 * .25, 1e-12);
}

TEST(Shared_walls, leave_cavities_what_they_are) {
  const Complex dsc =
      complex_of({join({box({0, 0, 0, 1, 1, 1}, 1), box({.25, .25, .25, .75, .75, .75}, 1)}),
                  box({1, 0, 0, 2, 1, 1}, 2)});
  EXPECT_NEAR(dsc.volume(1), 1 - .125, 1e-12);
  EXPECT_NEAR(dsc.volume(2), 1, 1e-12);
}

TEST(Shared_walls, of_one_surface_divide_it_into_labels) {
  // Both components contain the wall; three triangles meet at some edges.
  Surface twice = join({box({0, 0, 0, 1, 1, 1}, 1), box({1, 0, 0, 3, 1, 1}, 1)});
  Surface once = box({0, 0, 0, 1, 1, 1}, 1);
  once.triangles.push_back({0, 3, 7}); // the faces z = 0 and z = 1 have this diagonal
  once.triangles.push_back({0, 7, 4});
  twice.label = 3;
  once.label = 3;
  Surface other = box({5, 5, 5, 6, 6, 6}, 4);
  const auto patches = DSC::make_patches_3(std::vector<Surface>{twice, other});
  EXPECT_EQ(patches.labels, (std::vector<std::vector<int>>{{3, 5}, {4}}));
  const Complex two = complex_of({twice, other});
  EXPECT_NEAR(two.volume(3), 1, 1e-12);
  EXPECT_NEAR(two.volume(5), 2, 1e-12);
  EXPECT_NEAR(two.volume(4), 1, 1e-12);
  const Complex halves = complex_of({once});
  EXPECT_NEAR(halves.volume(3), .5, 1e-12);
  EXPECT_NEAR(halves.volume(4), .5, 1e-12);
  // Edges of the overlapping faces cross in a point.
  Surface shifted = join({box({0, 0, 0, 1, 1, 1}, 1), box({1, -.5, -.5, 3, .5, .5}, 1)});
  shifted.label = 3;
  const Complex overlap = complex_of({shifted});
  EXPECT_NEAR(overlap.volume(3), 1, 1e-12);
  EXPECT_NEAR(overlap.volume(4), 2, 1e-12);
}

// A box whose faces are divided into n x n squares of two triangles, turned about a skew axis. The
// coordinates are rounded, so that points that were in one plane no longer are.
Surface turned_box(const std::array<double, 6>& b, int label, int n) {
  Surface surface;
  std::map<std::array<int, 3>, std::size_t> indices;
  const auto corner = [&](const std::array<int, 3>& place) {
    const auto [known, is_new] = indices.emplace(place, surface.points.size());
    if (is_new) {
      std::array<double, 3> p;
      for (int k = 0; k < 3; ++k)
        p[k] = b[k] + (b[k + 3] - b[k]) * place[k] / n;
      // the rows are unit vectors, normal to each other
      surface.points.emplace_back((2 * p[0] - 2 * p[1] + p[2]) / 3,
                                  (p[0] + 2 * p[1] + 2 * p[2]) / 3,
                                  (2 * p[0] + p[1] - 2 * p[2]) / 3);
    }
    return known->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int end : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> place;
            place[axis] = end;
            place[(axis + 1) % 3] = u;
            place[(axis + 2) % 3] = v;
            return corner(place);
          };
          surface.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
          surface.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
  surface.label = label;
  return surface;
}

// Returns the volume that patches enclose with a label.
double volume_of(const DSC::Patches_of_surfaces_3<Point>& patches, int label) {
  double sum = 0;
  for (const auto& patch : patches.patches)
    for (const auto& t : patch.triangles) {
      const double volume =
          CGAL::volume(Point(0, 0, 0), patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
      sum += (patch.label_behind == label) * volume - (patch.label_in_front == label) * volume;
    }
  return std::abs(sum);
}

TEST(Shared_walls, may_be_rounded_and_divided_differently) {
  for (const auto& [n, m] : {std::pair(1, 7), std::pair(3, 4), std::pair(6, 5)}) {
    const std::vector<Surface> surfaces = {turned_box({0, 0, 0, 1 / 3., 1, 1}, 1, n),
                                           turned_box({1 / 3., 0, 0, 3 / 7., 1, 1}, 2, m),
                                           turned_box({0, -.7, 1 / 7., 3 / 7., 0, 5}, 3, m)};
    EXPECT_TRUE(DSC::have_contacts_3(surfaces));
    const auto patches = DSC::make_patches_3(surfaces);
    EXPECT_EQ(patches.patches.size(), 6u); // each solid touches each other one, and the outside
    EXPECT_NEAR(volume_of(patches, 1), 1 / 3., 1e-12);
    EXPECT_NEAR(volume_of(patches, 2), 3 / 7. - 1 / 3., 1e-12);
    EXPECT_NEAR(volume_of(patches, 3), 3 / 7. * .7 * (5 - 1 / 7.), 1e-12);
  }
}

TEST(Shared_walls, have_no_needles) {
  const auto patches = DSC::make_patches_3(std::vector<Surface>{
      turned_box({0, 0, 0, 1, 1, 1}, 1, 19), turned_box({1, 0, 0, 2, 1, 1}, 2, 20)});
  double shortest = 1;
  for (const auto& patch : patches.patches)
    for (const auto& t : patch.triangles)
      for (int i = 0; i < 3; ++i)
        shortest = (std::min)(shortest, std::sqrt(CGAL::squared_distance(
                                            patch.points[t[i]], patch.points[t[(i + 1) % 3]])));
  EXPECT_GT(shortest, .005); // lines of the two divisions are .0026 apart
  EXPECT_NEAR(volume_of(patches, 1), 1, 1e-12);
  EXPECT_NEAR(volume_of(patches, 2), 1, 1e-12);
}

TEST(Shared_walls, may_be_written_with_few_digits) {
  std::vector<Surface> surfaces = {turned_box({0, 0, 0, 1 / 3., 1, 1}, 1, 3),
                                   turned_box({1 / 3., 0, 0, 1, 1, 1}, 2, 4)};
  const auto round_all = [&](const auto& rounded) {
    auto result = surfaces;
    for (Surface& surface : result)
      for (Point& p : surface.points)
        p = Point(rounded(p.x()), rounded(p.y()), rounded(p.z()));
    return result;
  };
  const auto floats = round_all([](double x) { return double(float(x)); });
  const auto decimals = round_all([](double x) { return std::round(x * 1e6) / 1e6; });
  for (const auto& rounded : {floats, decimals}) {
    const auto patches = DSC::make_patches_3(rounded);
    EXPECT_EQ(patches.patches.size(), 3u);
    EXPECT_NEAR(volume_of(patches, 1), 1 / 3., 1e-5);
    EXPECT_NEAR(volume_of(patches, 2), 2 / 3., 1e-5);
  }
}

TEST(Shared_walls, are_found_though_they_do_not_touch_exactly) {
  const double gap = 1e-14;
  EXPECT_FALSE(DSC::have_contacts_3(
      std::vector<Surface>{box({0, 0, 0, 1, 1, 1}, 1), box({1.001, 0, 0, 2, 1, 1}, 2)}));
  for (double x : {1 + gap, 1 - gap}) {
    const auto patches = DSC::make_patches_3(
        std::vector<Surface>{box({0, 0, 0, 1, 1, 1}, 1), box({x, 0, 0, 2, 1, 1}, 2, true)});
    EXPECT_EQ(patches.patches.size(), 3u);
    EXPECT_TRUE(patches.overlaps.empty());
  }
}

TEST(Shared_walls, may_have_vertices_on_edges) {
  // The face x = 0 has a vertex in the middle of an edge that another face does not have.
  Surface cube = box({0, 0, 0, 1, 1, 1}, 1);
  cube.points.emplace_back(0, 0, .5);
  cube.triangles.erase(std::remove(cube.triangles.begin(), cube.triangles.end(),
                                   std::array<std::size_t, 3>{0, 4, 6}),
                       cube.triangles.end());
  cube.triangles.push_back({0, 8, 6});
  cube.triangles.push_back({8, 4, 6});
  const auto patches = DSC::make_patches_3(std::vector<Surface>{cube});
  EXPECT_NEAR(volume_of(patches, 1), 1, 1e-15);
}

TEST(Overlapping_surfaces, are_covered_by_later_and_by_inner_ones) {
  const Surface cube = box({0, 0, 0, 2, 1, 1}, 1), later = box({1, 0, 0, 4, 1, 1}, 2),
                inner = box({1.25, .25, .25, 1.75, .75, .75}, 3);
  for (const auto& surfaces : {Surfaces{cube, later, inner}, Surfaces{inner, cube, later}}) {
    const auto patches = DSC::make_patches_3(surfaces);
    EXPECT_NEAR(volume_of(patches, 1), 1, 1e-15);
    EXPECT_NEAR(volume_of(patches, 2), 3 - .125, 1e-15);
    EXPECT_NEAR(volume_of(patches, 3), .125, 1e-15);
    EXPECT_EQ(patches.overlaps.size(), 1u);
    EXPECT_TRUE(patches.covered.empty());
  }
  const auto equal = DSC::make_patches_3(Surfaces{cube, box({0, 0, 0, 2, 1, 1}, 2, true)});
  EXPECT_NEAR(volume_of(equal, 2), 2, 1e-15);
  EXPECT_EQ(equal.covered, std::vector<std::size_t>{0});
}

void expect_refusal(const std::vector<Surface>& surfaces, Reason reason,
                    const DSC::Patch_options_3& options = {}) {
  const auto error =
      thrown_by<Invalid_surface_error>([&] { DSC::make_patches_3(surfaces, options); });
  EXPECT_EQ(error.reason(), reason) << error.what();
}

TEST(Shared_walls, are_refused_where_surfaces_are_open_or_intersect_themselves) {
  const Surface cube = box({0, 0, 0, 1, 1, 1}, 1);
  Surface open = cube;
  open.triangles.pop_back();
  expect_refusal({open}, Reason::open);
  expect_refusal({join({cube, box({.5, .5, .5, 2, 2, 2}, 1)})}, Reason::self_intersection);
}

TEST(Overlapping_surfaces, are_refused_on_request) {
  DSC::Patch_options_3 options;
  options.allow_overlaps = false;
  const Surface cube = box({0, 0, 0, 1, 1, 1}, 1);
  expect_refusal({cube, box({.5, 0, 0, 1.5, 1, 1}, 2)}, Reason::crossing_surfaces, options);
  expect_refusal({cube, box({0, 0, 0, 1, 1, 1}, 2)}, Reason::crossing_surfaces, options);
  EXPECT_EQ(DSC::make_patches_3(std::vector<Surface>{cube, box({1, 0, 0, 2, 1, 1}, 2)}, options)
                .patches.size(),
            3u);
}

} // namespace test_shared_walls

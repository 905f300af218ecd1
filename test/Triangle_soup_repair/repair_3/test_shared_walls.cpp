// Surfaces with shared walls.

#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/make_patches_3.h>

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
}

void expect_refusal(const std::vector<Surface>& surfaces, Reason reason) {
  const auto error = thrown_by<Invalid_surface_error>([&] { DSC::make_patches_3(surfaces); });
  EXPECT_EQ(error.reason(), reason) << error.what();
}

TEST(Shared_walls, are_refused_where_surfaces_overlap_or_are_open) {
  const Surface cube = box({0, 0, 0, 1, 1, 1}, 1);
  expect_refusal({cube, box({.5, 0, 0, 1.5, 1, 1}, 2)}, Reason::crossing_surfaces);
  expect_refusal({cube, box({0, 0, 0, 1, 1, 1}, 2)}, Reason::crossing_surfaces);
  Surface open = cube;
  open.triangles.pop_back();
  expect_refusal({open}, Reason::open);
  expect_refusal({join({cube, box({.5, .5, .5, 2, 2, 2}, 1)})}, Reason::self_intersection);
}

} // namespace test_shared_walls

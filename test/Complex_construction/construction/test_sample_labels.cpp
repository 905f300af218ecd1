#include "mesh_helpers.h"
#include "plane.h"
#include "test.h"

#include <CGAL/Complex_construction/sample_labels.h>
#include <CGAL/Mesh_support/Error.h>

// The labels of a complex at the points of a grid.

namespace test_sample_labels {

using mesh_helpers::jittered_grid;
using small_meshes::Complex;
using Grid = DSC::Sampling_grid<3>;

// The triangulation finds the cell of each point by a walk.
TEST(Sample_labels, agree_with_point_location) {
  const Complex dsc = jittered_grid(5, small_meshes::cube, .3, 1);
  const Grid grid = {{13, 9, 11}, {.17, .29, .21}, {-1.02, -1.13, -.98}};
  const std::vector<int> labels = DSC::sample_labels(dsc, grid, 7);
  ASSERT_EQ(labels.size(), 13U * 9 * 11);
  std::size_t i = 0, outside = 0;
  for (std::size_t z = 0; z < 11; ++z)
    for (std::size_t y = 0; y < 9; ++y)
      for (std::size_t x = 0; x < 13; ++x, ++i) {
        const Complex::Point_3 p(grid.origin[0] + double(x) * grid.spacing[0],
                                 grid.origin[1] + double(y) * grid.spacing[1],
                                 grid.origin[2] + double(z) * grid.spacing[2]);
        const auto c = dsc.triangulation().locate(p);
        const bool is_outside = dsc.is_infinite(c);
        outside += is_outside;
        EXPECT_EQ(labels[i], is_outside ? 7 : dsc.label(c)) << i;
      }
  EXPECT_GT(outside, 0U);
  EXPECT_LT(outside, labels.size() / 2);
}

// A point on the interface gets the smaller label, whatever the order of the cells is.
TEST(Sample_labels, of_points_on_facets) {
  const Complex dsc = small_meshes::make_complex(small_meshes::grid(4, small_meshes::cube));
  const Grid corners = {{5, 5, 5}, {.5, .5, .5}, {-1, -1, -1}};
  const std::vector<int> labels = DSC::sample_labels(dsc, corners);
  std::size_t inside = 0;
  for (const int label : labels)
    inside += label == 1;
  EXPECT_EQ(inside, 1U); // the cube (-.5, .5)^3 contains one corner of the grid
}

TEST(Sample_labels, follow_the_coordinates_of_the_user) {
  Complex dsc = jittered_grid(5, small_meshes::cube, .3, 1);
  const Grid grid = {{9, 9, 9}, {.21, .21, .21}, {-.9, -.9, -.9}};
  const std::vector<int> before = DSC::sample_labels(dsc, grid);
  Complex::Normalization normalization; // a power of two
  normalization.scale = 4;
  normalization.translation = Complex::Vector(8, 16, 32);
  dsc.set_normalization(normalization);
  const Grid scaled = {{9, 9, 9}, {.84, .84, .84}, {4.4, 12.4, 28.4}};
  EXPECT_EQ(DSC::sample_labels(dsc, scaled), before);
}

TEST(Sample_labels, of_the_plane) {
  const plane::Complex dsc = plane::disks_in_a_square({{.3, -.2, .5, 1}}, 24, 1, 8);
  const DSC::Sampling_grid<2> grid = {{200, 200}, {.01, .01}, {-.995, -.995}};
  const std::vector<int> labels = DSC::sample_labels(dsc, grid);
  std::size_t inside = 0;
  for (const int label : labels)
    inside += label == 1;
  EXPECT_NEAR(double(inside) * 1e-4, dsc.measure(1), 2e-3);
}

TEST(Sample_labels, refuse_invalid_grids) {
  const Complex dsc = jittered_grid(3, small_meshes::cube, .1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::size_t huge = std::size_t(1) << 40;
  for (const Grid& grid :
       {Grid{{0, 1, 1}, {1, 1, 1}, {0, 0, 0}}, Grid{{1, 1, 1}, {1, -1, 1}, {0, 0, 0}},
        Grid{{1, 1, 1}, {1, 1, nan}, {0, 0, 0}}, Grid{{1, 1, 1}, {1, 1, 1}, {0, nan, 0}},
        Grid{{huge, huge, huge}, {1, 1, 1}, {0, 0, 0}}})
    EXPECT_THROW(DSC::sample_labels(dsc, grid), DSC::Error);
}

} // namespace test_sample_labels

// Grains: Voronoi labels, orientations, statistics, and their growth.
#include "grain_rates.h"
#include "planar_regions.h"
#include "test.h"

#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/Grain_orientations.h>
#include <CGAL/Interface_flows/Voronoi_labels.h>
#include <CGAL/Interface_flows/grain_statistics.h>
#include <CGAL/Interface_remeshing/remove_components.h>

#include <CGAL/Bbox_2.h>

namespace test_grain_growth {

using planar_regions::Complex;

Complex grains_in_box(std::size_t number, double edges) {
  return DSC::make_deformable_simplicial_complex_2<Complex>(
      CGAL::Bbox_2(0, 0, 1, 1), 1 / (std::sqrt(double(number)) * edges),
      DSC::Voronoi_labels<Complex>(number, {1, 1}, false));
}

TEST(Voronoi_labels, are_those_of_the_nearest_seeds) {
  static constexpr std::size_t number = 40, samples = 200;
  for (const bool is_periodic : {false, true}) {
    const DSC::Voronoi_labels<Complex> labels(number, {3, 1}, is_periodic),
        same(number, {3, 1}, is_periodic), other(number, {3, 1}, is_periodic, 2);
    // A seed is the middle of the points with its label only approximately, so regions are
    // compared: a segment between two points with the same label has this label, because regions
    // are convex.
    std::mt19937 random(3);
    const auto point = [&random] {
      return Complex::Point_2(3 * (random() / 4294967296.), random() / 4294967296.);
    };
    std::map<int, std::size_t> found;
    std::size_t differences = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      const auto p = point(), q = point();
      EXPECT_EQ(labels(p), same(p));
      differences += labels(p) != other(p);
      ++found[labels(p)];
      if (labels(p) == labels(q) && CGAL::squared_distance(p, q) < .25) {
        EXPECT_EQ(labels(CGAL::midpoint(p, q)), labels(p));
      }
    }
    EXPECT_GT(differences, samples / 2);
    EXPECT_GT(found.size(), number / 2);
    for (const auto& [label, n] : found)
      EXPECT_TRUE(label >= 1 && label <= int(number)) << n;
  }
  EXPECT_THROW(DSC::Voronoi_labels<Complex>(0, {1, 1}, true), DSC::Error);
  EXPECT_THROW(DSC::Voronoi_labels<Complex>(1, {0, 1}, true), DSC::Error);
  EXPECT_THROW(DSC::Voronoi_labels<Complex>(5, {1, 1}, true, 1, 2), DSC::Error);
}

TEST(Grain_orientations, have_misorientations_of_cubic_crystals) {
  const DSC::Grain_orientations<2> planar(100);
  const DSC::Grain_orientations<3> spatial(100);
  double largest_2 = 0, largest_3 = 0;
  for (int a = 1; a <= 100; ++a)
    for (int b = 1; b <= 100; ++b) {
      EXPECT_NEAR(planar.misorientation(a, b), planar.misorientation(b, a), 1e-12);
      largest_2 = (std::max)(largest_2, planar.misorientation(a, b));
      largest_3 = (std::max)(largest_3, spatial.misorientation(a, b));
    }
  EXPECT_NEAR(planar.misorientation(7, 7), 0, 1e-7);
  EXPECT_NEAR(spatial.misorientation(7, 7), 0, 1e-7);
  static constexpr double degree = CGAL_PI / 180;
  EXPECT_LE(largest_2, 45 * degree + 1e-12);
  EXPECT_GT(largest_2, 44 * degree);
  EXPECT_LE(largest_3, 62.8 * degree); // J. K. Mackenzie, 1958
  EXPECT_GT(largest_3, 58 * degree);
  EXPECT_EQ(DSC::read_shockley_energy(20 * degree), 1);
  EXPECT_NEAR(DSC::read_shockley_energy(7.5 * degree), .5 * (1 + std::log(2.)), 1e-12);
  EXPECT_EQ(DSC::read_shockley_energy(0), .05);
  EXPECT_THROW(DSC::read_shockley_energy(-1), DSC::Error);
}

// The label of the component decides, not its place: specks vanish, and grains stay.
TEST(Remove_components, keeps_the_largest_ones) {
  Complex complex = planar_regions::grid(
      6, 6, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
      [](std::size_t i, std::size_t j) { return i == 4 && j == 4 ? 1
                                                : i < 3          ? 1
                                                                 : 2; });
  ASSERT_EQ(complex.number_of_components(1), 2u);
  EXPECT_EQ(DSC::keep_largest_components(complex), std::vector<int>{1});
  EXPECT_EQ(complex.number_of_components(1), 1u);
  EXPECT_DOUBLE_EQ(complex.area(1), 18);
  EXPECT_DOUBLE_EQ(complex.area(2), 18);
  EXPECT_TRUE(complex.is_valid());
}

// A square between two phases goes to the one with the lower energy density.
TEST(Remove_components, gives_them_to_the_neighbor_of_least_energy) {
  for (const double density : {-10., 10.}) {
    Complex complex = planar_regions::grid(
        4, 4, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
        [](std::size_t i, std::size_t j) {
          return i > 0 && i < 3 && j > 0 && j < 3 ? 3 : i < 2 ? 1 : 2;
        });
    DSC::Interface_energy energy;
    energy.set_density([density](int label) { return label == 1 ? density : 0; });
    const auto removed = DSC::remove_components(
        complex, [](int label, std::uint32_t, double measure) { return label == 3 && measure > 3; },
        energy);
    EXPECT_EQ(removed, std::vector<int>{3});
    EXPECT_DOUBLE_EQ(complex.area(density < 0 ? 1 : 2), 10);
  }
}

// Of two neighbors that are removed, none takes cells of the other, and all of their cells go.
TEST(Remove_components, removes_neighbors_together) {
  for (const bool are_surrounded : {false, true}) {
    Complex complex = planar_regions::grid(
        6, 3, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
        [are_surrounded](std::size_t i, std::size_t j) {
          // 4 between the labels 3 only, or between 3 and 1
          return j == 1 && i == 2 ? 4 : i > 0 && i < 4 && (j == 1 || are_surrounded) ? 3 : 1;
        });
    const auto removed =
        DSC::remove_components(complex, [](int label, std::uint32_t, double) { return label > 1; });
    EXPECT_EQ(removed.size(), are_surrounded ? 2u : 3u);
    EXPECT_EQ(complex.labels(), std::vector<int>{1});
    EXPECT_DOUBLE_EQ(complex.area(1), 18);
  }
}

// 4 is between 3 and 5, which go in the order of their numbers. 5 touches 4 and 1 only.
TEST(Remove_components, removes_chains_together) {
  Complex complex = planar_regions::grid(
      5, 3, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
      [](std::size_t i, std::size_t j) {
        return j != 1 ? 1 : i == 1 ? 3 : i == 2 ? 4 : i == 3 ? 5 : 1;
      });
  EXPECT_EQ(
      DSC::remove_components(complex, [](int label, std::uint32_t, double) { return label > 1; })
          .size(),
      3u);
  EXPECT_EQ(complex.labels(), std::vector<int>{1});
}

TEST(Grain_statistics, counts_corners_and_neighbors) {
  const Complex complex = planar_regions::grid(
      6, 6, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
      [](std::size_t i, std::size_t j) {
        return i > 1 && i < 4 && j > 1 && j < 4 ? 5 : j < 3 ? (i < 3 ? 1 : 2) : 3;
      });
  const auto statistics = DSC::grain_statistics(complex);
  ASSERT_EQ(statistics.size(), 4u);
  const auto& grain = statistics.back();
  EXPECT_EQ(grain.label, 5);
  EXPECT_DOUBLE_EQ(grain.measure, 4);
  EXPECT_DOUBLE_EQ(grain.boundary, 8);
  EXPECT_EQ(grain.neighbors, 3u);
  EXPECT_EQ(grain.corners, 3u);
  EXPECT_DOUBLE_EQ(grain.growth(2), -CGAL_PI);
}

// A circle vanishes at the time R^2 / 2, and it is removed as a whole.
TEST(Grain_growth, circle_vanishes_at_its_time) {
  static constexpr double r = .3;
  Complex complex = planar_regions::region(planar_regions::circle(r, .05), {}, {-1, -1, 1, 1});
  DSC::Grain_growth<Complex> growth(complex, {}, {28, .1});
  std::size_t removed = 0;
  while (complex.area(1) > 0 && growth.time() < r * r) {
    const auto report = growth.advance();
    EXPECT_TRUE(report.deformation.complete);
    removed += report.removed.size();
  }
  EXPECT_EQ(removed, 1u);
  EXPECT_NEAR(growth.time(), r * r / 2, .02 * r * r);
}

// The law also holds for the grains at the sides and corners of a box, which their mirror images
// complete.
TEST(Grain_growth, has_the_rates_of_von_neumann_and_mullins) {
  EXPECT_NEAR(grain_rates::slope(grains_in_box(20, 8), 20), 1, .04);
}

// All grains of a box vanish but one, at the sides and in the corners, too.
TEST(Grain_growth, leaves_one_grain_of_a_box) {
  Complex complex = grains_in_box(12, 6);
  DSC::keep_largest_components(complex);
  DSC::Grain_growth<Complex> growth(complex, {}, {6, .2});
  double energy = DSC::Interface_energy()(complex);
  while (complex.labels().size() > 1 && growth.time() < 2) {
    EXPECT_TRUE(growth.advance().deformation.complete) << growth.time();
    EXPECT_LT(DSC::Interface_energy()(complex), energy);
    energy = DSC::Interface_energy()(complex);
  }
  EXPECT_EQ(complex.labels().size(), 1u);
}

TEST(Grain_growth, refuses_options_out_of_range) {
  Complex complex = planar_regions::region(planar_regions::circle(.3, .1), {}, {-1, -1, 1, 1});
  EXPECT_THROW(DSC::Grain_growth<Complex>(complex, {}, {0}), DSC::Error);
  EXPECT_THROW(DSC::Grain_growth<Complex>(complex, {}, {10, -1}), DSC::Error);
}

} // namespace test_grain_growth

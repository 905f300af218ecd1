// Integrals of images over triangles and tetrahedra.
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Image_segmentation/Image_moments.h>

namespace test_image_moments {

using Point = std::array<double, 2>;

template <int d> DSC::Gray_image<d> image_of(const std::array<std::size_t, d>& size) {
  DSC::Gray_image<d> result;
  result.grid.size = size;
  result.grid.spacing.fill(1);
  result.grid.origin.fill(.5);
  std::mt19937 random(1);
  result.channels.resize(2);
  for (auto& channel : result.channels)
    for (std::size_t i = 0; i < result.grid.number_of_points(); ++i)
      channel.push_back(float(random() % 1000) / 1000);
  return result;
}

// Returns the part of a convex polygon where sign * x[axis] <= sign * bound.
std::vector<Point> clipped(const std::vector<Point>& polygon, std::size_t axis, double sign,
                           double bound) {
  std::vector<Point> result;
  const auto outside = [&](const Point& p) { return sign * (p[axis] - bound); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = outside(p), b = outside(q);
    if (a <= 0)
      result.push_back(p);
    if ((a < 0 && b > 0) || (a > 0 && b < 0))
      result.push_back({p[0] + a / (a - b) * (q[0] - p[0]), p[1] + a / (a - b) * (q[1] - p[1])});
  }
  return result;
}

double area(const std::vector<Point>& polygon) {
  double result = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    result += (p[0] * q[1] - p[1] * q[0]) / 2;
  }
  return result;
}

// Against the areas of triangles clipped by pixels. Some triangles reach out of the image, some
// have corners and edges on the lines of the grid.
TEST(Image_moments, are_exact_in_the_plane) {
  DSC::Gray_image<2> image = image_of<2>({7, 5});
  image.mask.assign(35, 1);
  image.mask[16] = 0;
  image.channels[0][16] = NAN;
  const DSC::Image_moments<2> moments(image);
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    std::array<Point, 3> corners;
    for (Point& p : corners)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        p[axis] = double(random() % 1000) / 100 - 1;
        if (round % 3 == 0)
          p[axis] = std::floor(p[axis]);
      }
    const double doubled = 2 * area({corners[0], corners[1], corners[2]});
    if (doubled < 0)
      std::swap(corners[0], corners[1]);
    std::vector<double> found(moments.number_of_fields(), 0.), expected(found);
    moments.add(corners, found.data());
    for (std::size_t y = 0; y < 5; ++y)
      for (std::size_t x = 0; x < 7; ++x) {
        std::vector<Point> part(corners.begin(), corners.end());
        part = clipped(part, 0, 1, double(x + 1));
        part = clipped(part, 0, -1, double(x));
        part = clipped(part, 1, 1, double(y + 1));
        part = clipped(part, 1, -1, double(y));
        const std::size_t pixel = 7 * y + x;
        if (!image.has_value(pixel))
          continue;
        const double weight = area(part), a = double(image.channels[0][pixel]),
                     b = double(image.channels[1][pixel]);
        expected[0] += weight;
        expected[1] += weight * (a * a + b * b);
        expected[2] += weight * a;
        expected[3] += weight * b;
      }
    for (std::size_t f = 0; f < found.size(); ++f)
      EXPECT_NEAR(found[f], expected[f], 1e-11) << round << ' ' << f;
  }
}

// The moments of the cells of a mesh sum up to those of the image, also with other units.
TEST(Image_moments, of_a_mesh_sum_up_to_the_image) {
  DSC::Gray_image<2> image = image_of<2>({12, 9});
  image.grid.spacing = {2, .5};
  image.grid.origin = {-3, 4};
  using Complex = CGAL::Deformable_simplicial_complex_2<>;
  const auto complex = DSC::make_deformable_simplicial_complex_2<Complex>(
      CGAL::Bbox_2(-4, 3.75, 20, 8.25), .7, [](const auto&) { return 0; });
  const DSC::Image_moments<2> moments(image);
  double pixels = 0, squares = 0, sum = 0, expected_squares = 0, expected = 0;
  for (auto c : complex.cells()) {
    const auto of_cell = moments(complex, c);
    pixels += of_cell.pixels;
    squares += of_cell.squares;
    sum += of_cell.sums[1];
  }
  for (std::size_t i = 0; i < 108; ++i) {
    expected += double(image.channels[1][i]);
    for (const auto& channel : image.channels)
      expected_squares += double(channel[i]) * double(channel[i]);
  }
  EXPECT_NEAR(pixels, 108, 1e-10);
  EXPECT_NEAR(squares, expected_squares, 1e-10);
  EXPECT_NEAR(sum, expected, 1e-10);
}

// In space, volumes are exact. Integrals of a field that depends on the first axis only are nearly
// exact, and the sums over a mesh come near those of the image.
TEST(Image_moments, in_space) {
  DSC::Gray_image<3> image = image_of<3>({8, 9, 10});
  for (std::size_t i = 0; i < image.channels[0].size(); ++i)
    image.channels[0][i] = 3;
  using Complex = CGAL::Deformable_simplicial_complex_3<>;
  const auto complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(0, 0, 0, 8, 9, 10), 2.3, [](const auto&) { return 0; });
  const DSC::Image_moments<3> moments(image);
  double sum = 0, expected = 0;
  for (auto c : complex.cells()) {
    const auto of_cell = moments(complex, c);
    EXPECT_NEAR(of_cell.pixels, complex.measure(c), 1e-11);
    EXPECT_NEAR(of_cell.sums[0], 3 * complex.measure(c), 1e-11);
    sum += of_cell.sums[1];
  }
  for (const float value : image.channels[1])
    expected += double(value);
  EXPECT_NEAR(sum, expected, .01 * expected);
  // A tiny cell between the lines, one outside, and one partly outside
  std::vector<double> fields(4, 0.);
  moments.add({{{1.4, 1.41, 1.43}, {1.41, 1.41, 1.43}, {1.4, 1.42, 1.43}, {1.4, 1.41, 1.44}}},
              fields.data());
  EXPECT_NEAR(fields[2], 3 * 1e-6 / 6, 1e-15);
  moments.add({{{-9, 1, 1}, {-8, 1, 1}, {-9, 2, 1}, {-9, 1, 2}}}, fields.data());
  EXPECT_NEAR(fields[2], 3 * 1e-6 / 6, 1e-15);
  fields.assign(4, 0.);
  moments.add({{{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, fields.data()); // half inside
  EXPECT_NEAR(fields[0], 2. / 3, 1e-9);
}

// The pieces of a facet cover it, and each is in its pixel.
TEST(Image_moments, divide_facets) {
  const DSC::Gray_image<2> planar = image_of<2>({7, 5});
  double share = 0, middle = 0;
  std::vector<std::size_t> pixels;
  DSC::Image_moments<2>(planar).for_each_piece(
      {{{.5, .5}, {3.5, 1.5}}},
      [&](const std::array<double, 2>& weights, double part, std::size_t pixel) {
        EXPECT_NEAR(weights[0] + weights[1], 1, 1e-15);
        share += part;
        middle += part * weights[1];
        pixels.push_back(pixel);
      });
  EXPECT_NEAR(share, 1, 1e-15);
  EXPECT_NEAR(middle, .5, 1e-15);
  EXPECT_EQ(pixels, (std::vector<std::size_t>{0, 1, 9, 10}));
  const DSC::Gray_image<3> image = image_of<3>({8, 9, 10});
  share = 0;
  std::array<double, 3> sums = {};
  DSC::Image_moments<3>(image).for_each_piece(
      {{{1, 1, 1}, {5, 1, 2}, {2, 6, 1}}},
      [&](const std::array<double, 3>& weights, double part, std::size_t) {
        share += part;
        for (std::size_t i = 0; i < 3; ++i)
          sums[i] += part * weights[i];
      });
  EXPECT_NEAR(share, 1, 1e-12);
  for (const double sum : sums)
    EXPECT_NEAR(sum, 1. / 3, 1e-12);
}

TEST(Image_moments, refuse_bad_images) {
  const DSC::Gray_image<2> good = image_of<2>({4, 3});
  EXPECT_NO_THROW(good.check());
  DSC::Gray_image<2> bad = good;
  bad.channels.clear();
  EXPECT_THROW(DSC::Image_moments<2>{bad}, DSC::Error);
  bad = good;
  bad.channels[1].pop_back();
  EXPECT_THROW(bad.check(), DSC::Error);
  bad = good;
  bad.channels[1][3] = INFINITY;
  EXPECT_THROW(bad.check(), DSC::Error);
  bad.mask.assign(12, 1);
  bad.mask[3] = 0;
  EXPECT_NO_THROW(bad.check());
  bad.mask.assign(12, 0);
  EXPECT_THROW(bad.check(), DSC::Error);
  bad.mask.assign(11, 1);
  EXPECT_THROW(bad.check(), DSC::Error);
  bad = good;
  bad.grid.spacing[0] = 0;
  EXPECT_THROW(bad.check(), DSC::Error);
}

} // namespace test_image_moments

#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Mesh_support/Error.h>

// Complexes of images: each label has the area of its pixels, and the center of each pixel has the
// label of the pixel.

namespace test_images {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using CGAL::Deformable_simplicial_complexes::Error;

template <class LabelAt> DSC::Labeled_image_2 image(int width, int height, LabelAt label_at) {
  DSC::Labeled_image_2 result;
  result.width = std::size_t(width);
  result.height = std::size_t(height);
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x)
      result.labels.push_back(label_at(x, y));
  return result;
}

DSC::Labeled_image_2 noise(int side, int labels) {
  std::mt19937 random(5);
  return image(side, side, [&](int, int) { return int(random() % unsigned(labels)); });
}

std::map<int, double> areas_of_pixels(const DSC::Labeled_image_2& image) {
  std::map<int, double> result;
  for (int label : image.labels)
    ++result[label];
  return result;
}

bool contains(const Complex& dsc, Complex::Cell_handle c, const Complex::Point_2& p) {
  for (int i = 0; i < 3; ++i)
    if (dsc.orientation()(c->vertex(i)->point(), c->vertex((i + 1) % 3)->point(), p) ==
        CGAL::CLOCKWISE)
      return false;
  return true;
}

void expect_image(const Complex& dsc, const DSC::Labeled_image_2& image) {
  EXPECT_TRUE(dsc.is_valid(true));
  for (const auto& [label, area] : areas_of_pixels(image))
    EXPECT_NEAR(dsc.area(label), area, 1e-7) << label;
  for (const Complex::Cell_handle c : dsc.finite_cells()) {
    CGAL::Bbox_2 box;
    for (int i = 0; i < 3; ++i)
      box += c->vertex(i)->point().bbox();
    for (double x = std::floor(box.xmin()) + .5; x < box.xmax(); ++x)
      for (double y = std::floor(box.ymin()) + .5; y < box.ymax(); ++y)
        if (contains(dsc, c, {x, y})) {
          EXPECT_EQ(c->subdomain_index(), image(Complex::Point_2(x, y))) << x << ' ' << y;
        }
  }
}

TEST(Image, keeps_areas_and_centers_of_pixels) {
  const auto disks = image(60, 40, [](int x, int y) {
    return std::hypot(x - 20, y - 20) < 12 ? 3 : std::hypot(x - 45, y - 15) < 9 ? 7 : 0;
  });
  const Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(disks);
  expect_image(dsc, disks);
  // The interface is smooth. The edges of the pixels of a disk are four thirds as long as its
  // circle.
  const double radius = std::sqrt(dsc.area(3) / CGAL_PI);
  EXPECT_NEAR(dsc.length(3), 2 * CGAL_PI * radius, .04 * 2 * CGAL_PI * radius);
  EXPECT_LT(dsc.interface_facets().size(), 85u);
  EXPECT_EQ(dsc.euler_characteristic(0), -1);
}

TEST(Image, may_have_phases_that_fill_it) {
  const auto strips = image(31, 17, [](int x, int y) { return 3 * x > 2 * y + 20 ? 2 : y > 8; });
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(strips);
  expect_image(dsc, strips);
  const auto report = DSC::advect_interface(dsc, DSC::Mean_curvature_flow(false), 0., .5);
  EXPECT_TRUE(report.complete);
  EXPECT_NEAR(dsc.area(0) + dsc.area(1) + dsc.area(2), 31 * 17, 1e-9);
}

TEST(Image, may_be_noise) {
  for (int labels : {2, 3, 40}) {
    const auto pixels = noise(24, labels);
    expect_image(DSC::make_deformable_simplicial_complex_2<Complex>(pixels), pixels);
  }
}

TEST(Image, may_have_single_pixels) {
  const auto pixels = image(5, 4, [](int x, int y) { return x == 2 && y == 1 ? 9 : 1; });
  const Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(pixels);
  expect_image(dsc, pixels);
  EXPECT_DOUBLE_EQ(dsc.length(9), 4);
  const Complex one =
      DSC::make_deformable_simplicial_complex_2<Complex>(image(1, 1, [](int, int) { return 4; }));
  EXPECT_DOUBLE_EQ(one.area(4), 1);
}

TEST(Image, may_be_in_a_box) {
  const auto pixels = image(6, 6, [](int, int) { return 2; });
  const Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      pixels, 2, parameters::enclosing_box(CGAL::Bbox_2(-4, -3, 11, 9)));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.area(2), 36, 1e-9);
  EXPECT_NEAR(dsc.area(0), 15 * 12 - 36, 1e-9);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(
                   pixels, 2, parameters::enclosing_box(CGAL::Bbox_2(0, -3, 11, 9))),
               Error);
}

TEST(Image, has_triangles_along_the_interface_only) {
  const auto halves = [](int side) {
    return DSC::make_deformable_simplicial_complex_2<Complex>(
               image(side, side, [&](int x, int y) { return 2 * x + y > side; }))
        .number_of_cells();
  };
  EXPECT_LT(double(halves(400)), 5. * double(halves(100)));
}

TEST(Image, is_refused_where_it_is_none) {
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(DSC::Labeled_image_2()), Error);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(noise(3, 2), .5), Error);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(noise(800, 100)), Error);
  auto pixels = noise(3, 2);
  pixels.labels.pop_back();
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(pixels), Error);
}

} // namespace test_images

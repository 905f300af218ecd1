// Segmentation of images whose phases are known.
#include "test.h"

#if __has_include(<CGAL/Image_segmentation/compiled_3.h>) // if the component Compiled is used
#include <CGAL/Image_segmentation/compiled_2.h>
#include <CGAL/Image_segmentation/compiled_3.h>
#endif
#include <CGAL/Complex_construction/sample_labels.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Image_segmentation/segment_image.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/number_utils.h>

namespace test_segment_image {

using Complex_2 = CGAL::Deformable_simplicial_complex_2<>;
using Complex_3 = CGAL::Deformable_simplicial_complex_3<>;
template <int d> using Place = std::array<double, d>;

// Returns an image whose values are means over 3^d points of a pixel, with noise. Places are in
// pixels.
template <int d>
DSC::Gray_image<d> image_of(const std::array<std::size_t, d>& size,
                            const std::function<double(const Place<d>&)>& value, double noise) {
  static constexpr int n = 3;
  DSC::Gray_image<d> result;
  result.grid.size = size;
  result.grid.spacing.fill(1);
  result.grid.origin.fill(.5);
  result.channels.resize(1);
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1);
  for (std::size_t pixel = 0; pixel < result.grid.number_of_points(); ++pixel) {
    double sum = 0;
    const int points = int(std::lround(std::pow(n, d)));
    for (int k = 0; k < points; ++k) {
      Place<d> p;
      std::size_t rest = pixel;
      for (int axis = 0, of_point = k; axis < d; ++axis, of_point /= n) {
        p[axis] = double(rest % size[axis]) + (of_point % n + .5) / n;
        rest /= size[axis];
      }
      sum += value(p);
    }
    result.channels[0].push_back(float(sum / points + noise * normal(random)));
  }
  return result;
}

double distance(const Place<2>& p, double x, double y) { return std::hypot(p[0] - x, p[1] - y); }

// A bright disk in a gray ring, on a dark ground.
double target(const Place<2>& p) {
  const double r = distance(p, 30, 33);
  return r < 9 ? 1 : r < 20 ? .5 : 0;
}

// The distances of the vertices between two labels from a circle.
template <class Complex>
double greatest_distance(const Complex& complex, int a, int b, double x, double y, double radius) {
  double result = 0;
  for (const auto& f : complex.interface_facets(a, b))
    for (auto v : complex.facet_vertices(f)) {
      const auto p = complex.user_position(v);
      result = (std::max)(result, std::abs(std::hypot(p.x() - x, p.y() - y) - radius));
    }
  return result;
}

TEST(Segment_image, finds_a_disk_in_a_ring) {
  const auto image = image_of<2>({64, 60}, target, .1);
  DSC::Segmentation_options<2> options;
  options.phases = 3;
  const auto [complex, report] = DSC::segment_image<Complex_2>(image, options);
  EXPECT_TRUE(complex.is_valid());
  EXPECT_TRUE(report.has_converged);
  ASSERT_EQ(report.phases.size(), 3u);
  for (int label = 0; label < 3; ++label) {
    const auto& phase = report.phases[std::size_t(label)];
    EXPECT_EQ(phase.label, label);
    EXPECT_EQ(phase.components, 1u);
    EXPECT_NEAR(phase.intensities.front(), label / 2., .03);
  }
  EXPECT_NEAR(report.phases[2].measure, CGAL_PI * 81, 5);
  EXPECT_NEAR(report.phases[1].measure, CGAL_PI * (400 - 81), 10);
  EXPECT_NEAR(report.noise.front(), .1, .02);
  EXPECT_NEAR(report.residual, 1, .15);
  ASSERT_EQ(report.boundaries.size(), 2u);
  for (const auto& boundary : report.boundaries) {
    EXPECT_EQ(boundary.b, boundary.a + 1);
    const double radius = boundary.a == 0 ? 20 : 9;
    EXPECT_NEAR(boundary.measure, 2 * CGAL_PI * radius, 2);
    EXPECT_LT(boundary.uncertainty, .2);
    EXPECT_LT(greatest_distance(complex, boundary.a, boundary.b, 30, 33, radius),
              4 * boundary.uncertainty + .2);
  }
  // The energy of the report is that of its definition.
  double energy = 0;
  const DSC::Image_moments<2> moments(image);
  for (auto c : complex.cells()) {
    const auto of_cell = moments(complex, c);
    const double intensity = report.phases[std::size_t(c->subdomain_index())].intensities.front();
    energy +=
        of_cell.squares - 2 * intensity * of_cell.sums[0] + intensity * intensity * of_cell.pixels;
  }
  energy /= report.noise.front() * report.noise.front();
  EXPECT_NEAR(energy / (64 * 60), report.residual, 1e-6);
  for (const auto& boundary : report.boundaries)
    energy += report.smoothing * boundary.measure;
  EXPECT_NEAR(energy, report.energies.back(), 1e-3 * energy);
}

// The unit, the place and the threads do not change the result; anisotropic pixels are allowed.
TEST(Segment_image, uses_the_coordinates_of_the_image) {
  auto image = image_of<2>({64, 60}, target, .1);
  DSC::Segmentation_options<2> options;
  options.phases = 3;
  const auto once = DSC::segment_image<Complex_2>(image, options);
  image.grid.spacing = {.25, .25};
  image.grid.origin = {.125, .125}; // the corner is at 0
  options.number_of_threads = 2;
  const auto scaled = DSC::segment_image<Complex_2>(image, options);
  EXPECT_EQ(scaled.second.energies, once.second.energies);
  EXPECT_LT(greatest_distance(scaled.first, 1, 0, 30 / 4., 33 / 4., 5), .2);
  auto flat = image_of<2>(
      {32, 60},
      [](const Place<2>& p) {
        return target({2 * p[0], p[1]});
      },
      .1);
  flat.grid.spacing = {2, 1};
  flat.grid.origin = {1, .5};
  const auto [complex, report] = DSC::segment_image<Complex_2>(flat, options);
  EXPECT_LT(greatest_distance(complex, 1, 0, 30, 33, 20), 1.5);
  EXPECT_NEAR(report.phases[1].measure, CGAL_PI * (400 - 81) / 2, 10); // in pixels
}

TEST(Segment_image, finds_a_torus_in_space) {
  const auto image = image_of<3>(
      {36, 34, 20},
      [](const Place<3>& p) {
        const double r = std::hypot(p[0] - 18, p[1] - 17) - 10;
        return std::hypot(r, p[2] - 10) < 4.5 ? 1. : 0.;
      },
      .3);
  const auto [complex, report] = DSC::segment_image<Complex_3>(image);
  EXPECT_TRUE(complex.is_valid());
  EXPECT_EQ(report.phases[1].components, 1u);
  EXPECT_NEAR(report.phases[1].measure, 2 * CGAL_PI * CGAL_PI * 10 * 4.5 * 4.5, 300);
  const auto vertices = complex.interface_vertices();
  const auto facets = complex.interface_facets();
  EXPECT_EQ(2 * vertices.size(), facets.size()); // Euler characteristic 0
}

TEST(Segment_image, uses_channels_and_masks) {
  // Each channel shows one half of the square only.
  auto image = image_of<2>(
      {40, 40}, [](const Place<2>& p) { return p[0] < 20 ? 0. : 1.; }, .1);
  image.channels.push_back(image_of<2>(
                               {40, 40}, [](const Place<2>& p) { return p[1] < 20 ? 0. : 1.; }, .1)
                               .channels.front());
  DSC::Segmentation_options<2> options;
  options.phases = 4;
  const auto [complex, report] = DSC::segment_image<Complex_2>(image, options);
  for (const auto& phase : report.phases) {
    EXPECT_NEAR(phase.measure, 400, 10);
    EXPECT_EQ(phase.intensities.size(), 2u);
  }
  // Masked values are not used.
  auto masked = image_of<2>({64, 60}, target, .1);
  masked.mask.assign(64 * 60, 1);
  for (std::size_t i = 0; i < 64 * 10; ++i) {
    masked.mask[i] = 0;
    masked.channels[0][i] = NAN;
  }
  options.phases = 3;
  const auto with_mask = DSC::segment_image<Complex_2>(masked, options);
  EXPECT_NEAR(with_mask.second.phases[2].measure, CGAL_PI * 81, 5);
  EXPECT_NEAR(with_mask.second.residual, 1, .15);
}

// A gap of the ring is closed if the topology of the given complex, an annulus, must stay. In noise
// that cuts it, the topology stays, too.
TEST(Segment_image, keeps_a_given_topology) {
  const auto ring = [](const Place<2>& p) {
    const double r = distance(p, 32, 30);
    return r > 14 && r < 20 && !(p[0] > 45 && std::abs(p[1] - 30) < 2) ? 1. : 0.;
  };
  const auto image = image_of<2>({64, 60}, ring, .2);
  DSC::Segmentation_options<2> options;
  options.intensities = {{0}, {1}};
  const auto open = DSC::segment_image<Complex_2>(image, options);
  EXPECT_EQ(open.first.number_of_components(0), 1u);
  auto closed = DSC::segment_image<Complex_2>(image_of<2>(
                                                  {64, 60},
                                                  [](const Place<2>& p) {
                                                    const double r = distance(p, 32, 30);
                                                    return r > 14 && r < 20 ? 1. : 0.;
                                                  },
                                                  .2),
                                              options)
                    .first;
  ASSERT_EQ(closed.number_of_components(0), 2u);
  options.keeps_topology = true;
  const auto report = DSC::segment_image(closed, image, options);
  EXPECT_EQ(closed.number_of_components(0), 2u);
  EXPECT_EQ(closed.number_of_components(1), 1u);
  EXPECT_TRUE(closed.is_valid());
  EXPECT_EQ(report.phases[1].intensities, std::vector<double>{1});
}

TEST(Segment_image, keeps_the_largest_component_of_connected_labels) {
  const auto image = image_of<2>(
      {64, 60},
      [](const Place<2>& p) {
        return distance(p, 20, 30) < 12 || distance(p, 50, 30) < 6 ? 1. : 0.;
      },
      .1);
  DSC::Segmentation_options<2> options;
  EXPECT_EQ(DSC::segment_image<Complex_2>(image, options).second.phases[1].components, 2u);
  options.connected = {1};
  const auto report = DSC::segment_image<Complex_2>(image, options).second;
  EXPECT_EQ(report.phases[1].components, 1u);
  EXPECT_NEAR(report.phases[1].measure, CGAL_PI * 144, 6);
}

TEST(Segment_image, estimates_intensities_and_noise) {
  const auto image = image_of<2>({90, 90}, target, .2);
  const auto phases = DSC::estimate_phases(image, 3);
  ASSERT_EQ(phases.intensities.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(phases.intensities[k].front(), double(k) / 2, .12);
  EXPECT_NEAR(phases.noise.front(), .2, .02);
  // Without noise, a tenth of the contrast
  const auto clean = DSC::estimate_phases(image_of<2>({90, 90}, target, 0), 2);
  EXPECT_NEAR(clean.noise.front(), .1 * (clean.intensities[1][0] - clean.intensities[0][0]), 1e-9);
}

TEST(Segment_image, refuses_what_it_cannot_use) {
  const auto image = image_of<2>(
      {20, 20}, [](const Place<2>& p) { return p[0] < 9 ? 0. : 1.; }, 0);
  DSC::Segmentation_options<2> options;
  options.phases = 5;
  EXPECT_THROW(DSC::segment_image<Complex_2>(image, options), DSC::Error); // three values
  options = {};
  const auto refused = [&](const auto& change) {
    DSC::Segmentation_options<2> changed;
    change(changed);
    EXPECT_THROW(DSC::segment_image<Complex_2>(image, changed), DSC::Error);
  };
  refused([](auto& o) { o.phases = 1; });
  refused([](auto& o) { o.intensities = {{1}, {1, 2}}; });
  refused([](auto& o) { o.intensities = {{1, 0}, {1, 2}}; }); // one channel
  refused([](auto& o) { o.intensities = {{1}, {2}, {1}}; });
  refused([](auto& o) { o.connected = {2}; });
  refused([](auto& o) { o.connected = {-1}; });
  refused([](auto& o) {
    o.connected = {1};
    o.keeps_topology = true;
  });
  refused([](auto& o) { o.noise = {0}; });
  refused([](auto& o) { o.noise = {1, 1}; });
  refused([](auto& o) { o.smoothing = 0; });
  refused([](auto& o) { o.shortest_edge = .5; });
  refused([](auto& o) { o.longest_edge = 1; });
  auto [complex, report] = DSC::segment_image<Complex_2>(image);
  EXPECT_NEAR(report.phases[0].measure, 180, 1);
  complex.relabel(complex.cells().front(), 7); // no index of a phase
  const auto version = complex.version();
  EXPECT_THROW(DSC::segment_image(complex, image), DSC::Error);
  EXPECT_EQ(complex.version(), version);
  // Images of a pixel, and of a row
  EXPECT_THROW(DSC::segment_image<Complex_2>(image_of<2>(
                   {1, 1}, [](const Place<2>&) { return 1.; }, 0)),
               DSC::Error);
  const auto row = DSC::segment_image<Complex_2>(image_of<2>(
      {40, 1}, [](const Place<2>& p) { return p[0] < 20 ? 0. : 1.; }, 0));
  EXPECT_NEAR(row.second.phases[0].measure, 20, 1);
}

// A complex much larger than the image: the parts outside have no cost, and take no time.
TEST(Segment_image, accepts_complexes_larger_than_the_image) {
  const auto image = image_of<2>({64, 60}, target, .1);
  DSC::Segmentation_options<2> options;
  options.phases = 3;
  auto complex = DSC::segment_image<Complex_2>(image, options).first;
  auto normalization = complex.normalization();
  normalization.scale = 1e6;
  normalization.translation = {-3e7, -3.3e7};
  complex.set_normalization(normalization);
  EXPECT_NO_THROW(DSC::segment_image(complex, image, options));
  EXPECT_TRUE(complex.is_valid());
  normalization.translation = {1e3, 0}; // beside the image
  normalization.scale = 1;
  complex.set_normalization(normalization);
  EXPECT_THROW(DSC::segment_image(complex, image, options), DSC::Error);
}

// A large constant does not change the result, up to the precision of the values.
TEST(Segment_image, subtracts_the_mean) {
  auto image = image_of<2>({64, 60}, target, .1);
  for (float& value : image.channels[0])
    value = std::round(value * 1024);
  DSC::Segmentation_options<2> options;
  options.phases = 3;
  const auto once = DSC::segment_image<Complex_2>(image, options).second;
  for (float& value : image.channels[0])
    value += 8388608; // exact
  const auto shifted = DSC::segment_image<Complex_2>(image, options).second;
  EXPECT_NEAR(shifted.residual, once.residual, .02);
  EXPECT_NEAR(shifted.phases[2].measure, once.phases[2].measure, 3);
}

// Outliers form no phase, and strong noise in a small image is averaged.
TEST(Segment_image, estimates_are_robust) {
  auto image = image_of<2>({90, 90}, target, .1);
  image.channels[0][4000] = 1e6;
  const auto phases = DSC::estimate_phases(image, 3);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(phases.intensities[k].front(), double(k) / 2, .1);
  const auto ball = image_of<3>(
      {36, 36, 36},
      [](const Place<3>& p) {
        return std::hypot(p[0] - 18, std::hypot(p[1] - 18, p[2] - 18)) < 12 ? 1. : 0.;
      },
      1.5);
  EXPECT_NEAR(DSC::segment_image<Complex_3>(ball).second.phases[1].measure, 4 / 3. * CGAL_PI * 1728,
              900);
}

// A small region is no outlier. Pixels across its boundary decrease the mean of its intensity.
TEST(Segment_image, finds_a_small_region_in_a_large_image) {
  const auto report =
      DSC::segment_image<Complex_2>(
          image_of<2>(
              {100, 100}, [](const Place<2>& p) { return distance(p, 40, 60) < 4 ? 1. : 0.; }, .05))
          .second;
  EXPECT_EQ(report.phases[1].components, 1u);
  EXPECT_NEAR(report.phases[1].measure, CGAL_PI * 16, 6);
  EXPECT_NEAR(report.phases[1].intensities.front(), 1, .1);
}

// A ball smaller than the first cells. No single cell with its label would decrease the energy.
TEST(Segment_image, finds_regions_smaller_than_the_first_cells) {
  const auto image = image_of<3>(
      {24, 24, 24},
      [](const Place<3>& p) {
        return std::hypot(p[0] - 12, std::hypot(p[1] - 12, p[2] - 12)) < 7.3 ? 1. : 0.;
      },
      .05);
  const auto report = DSC::segment_image<Complex_3>(image).second;
  EXPECT_EQ(report.phases[1].components, 1u);
  EXPECT_NEAR(report.phases[1].measure, 4 / 3. * CGAL_PI * 389, 120);
}

TEST(Segment_image, stops_when_asked) {
  const auto image = image_of<2>({64, 60}, target, .1);
  unsigned calls = 0;
  const DSC::Progress_scope scope([&](const char*) { return ++calls < 500; },
                                  std::chrono::milliseconds(0));
  EXPECT_THROW(DSC::segment_image<Complex_2>(image), DSC::Interrupted_error);
}

} // namespace test_segment_image

// Tensions, mobilities and energy densities that depend on labels, and the flow of their energy.
#include "planar_regions.h"
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/grain_statistics.h>
#include <CGAL/Interface_remeshing/shared_measures.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace test_interface_energy {

using DSC::Interface_energy;
using planar_regions::Complex;

constexpr double degree = CGAL_PI / 180;

double mean_radius(const Complex& complex) {
  double sum = 0;
  const auto vertices = complex.interface_vertices();
  for (auto v : vertices)
    sum += std::hypot(complex.position(v).x(), complex.position(v).y());
  return sum / double(vertices.size());
}

// Returns the square [-1, 1]^2 of n^2 quadrilaterals. Labels are 3 in a disk, 1 below it and 2
// above it.
Complex disk_between_two_labels(std::size_t n, double radius) {
  const auto at = [n](double i) { return 2 * i / double(n) - 1; };
  return planar_regions::grid(
      n, n,
      [&](std::size_t i, std::size_t j) { return Complex::Point_2(at(double(i)), at(double(j))); },
      [&](std::size_t i, std::size_t j) {
        const double x = at(double(i) + .5), y = at(double(j) + .5);
        return std::hypot(x, y) < radius ? 3 : y < 0 ? 1 : 2;
      });
}

// Tensions of 1, but of `other` between the labels 1 and 2.
Interface_energy with_tension_of_1_and_2(double other) {
  Interface_energy result;
  result.set_tension([other](int a, int b) { return a == 1 && b == 2 ? other : 1; });
  return result;
}

TEST(Interface_energy, checks_its_values) {
  Interface_energy energy;
  EXPECT_EQ(energy.tension(2, 1), 1);
  EXPECT_EQ(energy.mobility(2, 1), 1);
  EXPECT_EQ(energy.density(1), 0);
  for (const double wrong : {0., -1., double(NAN), double(INFINITY)}) {
    EXPECT_THROW(energy.set_tension(wrong), DSC::Error);
    energy.set_tension([wrong](int, int) { return wrong; });
    EXPECT_THROW(energy.tension(1, 2), DSC::Error);
  }
  EXPECT_THROW(energy.set_mobility(-1), DSC::Error);
  energy.set_mobility([](int a, int b) { return a < b ? 3 : -1; });
  EXPECT_EQ(energy.mobility(2, 1), 3);
  energy.set_density([](int) { return NAN; });
  EXPECT_THROW(energy.density(0), DSC::Error);
}

TEST(Interface_energy, has_the_angles_of_young) {
  const auto equal = Interface_energy().young_angles(1, 2, 3);
  ASSERT_TRUE(equal);
  for (const double angle : *equal)
    EXPECT_NEAR(angle, 120 * degree, 1e-14);
  const auto other = with_tension_of_1_and_2(1.5).young_angles(1, 2, 3);
  ASSERT_TRUE(other);
  EXPECT_NEAR((*other)[2], 82.8192 * degree, 1e-6);
  EXPECT_NEAR((*other)[0] + (*other)[1] + (*other)[2], 2 * CGAL_PI, 1e-14);
  EXPECT_FALSE(with_tension_of_1_and_2(2).young_angles(1, 2, 3)); // 3 wets the interface
}

TEST(Junctions, have_the_angles_of_labels) {
  // Square 5 in the middle of the labels 1, 2 (below) and 3 (above)
  const Complex complex = planar_regions::grid(
      6, 6, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
      [](std::size_t i, std::size_t j) {
        return i > 1 && i < 4 && j > 1 && j < 4 ? 5 : j < 3 ? (i < 3 ? 1 : 2) : 3;
      });
  const auto found = DSC::internal::junctions(complex);
  ASSERT_EQ(found.size(), 3u);
  for (const auto& junction : found) {
    const auto p = complex.position(junction.vertices[0]);
    EXPECT_EQ(junction.angles.size(), 3u);
    EXPECT_NEAR(junction.angles.at(5), CGAL_PI, 1e-12); // a side of the square
    for (const auto& [label, angle] : junction.angles)
      if (label != 5) {
        EXPECT_NEAR(angle, CGAL_PI / 2, 1e-12);
      }
    EXPECT_TRUE((p.x() == 3 && p.y() == 2) || (p.y() == 3 && (p.x() == 2 || p.x() == 4)));
  }
  EXPECT_EQ(DSC::labels_around(complex, found[0].vertices[0]).size(), 3u);
  const auto shared = DSC::shared_measures(complex);
  EXPECT_DOUBLE_EQ(shared.at({1, 2}), 2);
  EXPECT_DOUBLE_EQ(shared.at({1, 5}), 2);
  EXPECT_DOUBLE_EQ(shared.at({3, 5}), 4);
  EXPECT_EQ(shared.size(), 6u);
}

// Four blocks of a box meet at a straight line, and three at another one.
TEST(Junctions, are_edges_in_space) {
  using Complex_3 = CGAL::Deformable_simplicial_complex_3<>;
  std::vector<Complex_3::Point_3> points;
  std::vector<std::array<std::size_t, 4>> cells;
  std::vector<int> labels;
  // Prisms over the four triangles of a square around its center
  for (const double z : {0., 1.})
    for (const auto& [x, y] : {std::pair(0., 0.), {2., 0.}, {2., 2.}, {0., 2.}, {.5, 1.}})
      points.emplace_back(x, y, z);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t a = i, b = (i + 1) % 4, c = 4;
    cells.push_back({a, b, c, c + 5});
    cells.push_back({a, b, c + 5, b + 5});
    cells.push_back({a, b + 5, c + 5, a + 5});
    labels.insert(labels.end(), 3, i == 3 ? 1 : int(i) + 1); // two prisms have the label 1
  }
  const auto complex = DSC::make_deformable_simplicial_complex_3<Complex_3>(
      points, cells, labels, CGAL::parameters::improve(false));
  const auto found = DSC::internal::junctions(complex);
  ASSERT_EQ(found.size(), 1u);
  double sum = 0;
  for (const auto& [label, angle] : found[0].angles)
    sum += angle;
  EXPECT_NEAR(sum, 2 * CGAL_PI, 1e-12);
  EXPECT_NEAR(found[0].angles.at(2), 2 * std::atan(1 / 1.5), 1e-12);
}

TEST(Interface_energy, is_the_sum_over_pairs_and_labels) {
  const Complex complex = disk_between_two_labels(8, .6);
  Interface_energy energy = with_tension_of_1_and_2(1.5);
  energy.set_density([](int label) { return .1 * label; });
  double length = 0, area = 0;
  for (const auto& facet : complex.interface_facets())
    length +=
        complex.measure(facet) *
        (facet.first->subdomain_index() + facet.first->neighbor(facet.second)->subdomain_index() ==
                 3
             ? 1.5
             : 1);
  for (int label : {1, 2, 3})
    area += .1 * label * complex.area(label);
  EXPECT_NEAR(energy(complex), length + area, 1e-12);
}

// R' = m (g - s / R), where g is the density outside minus that inside.
TEST(Interface_energy, circle_moves_by_tension_mobility_and_density) {
  static constexpr double tension = .5, mobility = 2, drive = 3, dt = .002, end = .04;
  Interface_energy energy;
  energy.set_tension(tension);
  energy.set_mobility(mobility);
  energy.set_density([](int label) { return label == 1 ? -drive : 0; });
  std::vector<double> errors;
  for (const double edge : {.06, .03}) {
    Complex complex = planar_regions::region(planar_regions::circle(.3, edge), {}, {-1, -1, 1, 1});
    const auto rate = [](double r) { return mobility * (drive - tension / r); };
    double exact = .3;
    for (int k = 0; k < 1000; ++k) { // midpoint rule
      const double h = end / 1000;
      exact += h * rate(exact + h / 2 * rate(exact));
    }
    for (double t = 0; t < end - dt / 2; t += dt)
      EXPECT_TRUE(DSC::advect_interface(complex, DSC::Mean_curvature_flow(energy), t, dt).complete);
    errors.push_back(std::abs(mean_radius(complex) - exact));
  }
  EXPECT_LT(errors[1], 1e-3);
  EXPECT_LT(errors[1], errors[0] / 3);
}

TEST(Interface_energy, explicit_and_implicit_steps_agree) {
  Interface_energy energy = with_tension_of_1_and_2(1.5);
  energy.set_mobility([](int a, int b) { return a + b; });
  energy.set_density([](int label) { return label; });
  const Complex complex = disk_between_two_labels(8, .6);
  const DSC::Interface_snapshot<Complex> snapshot(complex);
  const auto positions = snapshot.positions(complex);
  std::vector<Complex::Vector> velocities;
  DSC::Mean_curvature_velocity{energy}(snapshot, positions, 0, velocities);
  static constexpr double dt = 1e-8;
  std::vector<Complex::Point> destinations;
  DSC::Mean_curvature_flow{energy}(snapshot, positions, 0, dt, destinations);
  std::size_t compared = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto difference = (destinations[v] - positions[v]) / dt - velocities[v];
    EXPECT_LT(std::sqrt(difference.squared_length()),
              1e-5 * (1 + std::sqrt(velocities[v].squared_length())));
    ++compared;
  }
  EXPECT_GT(compared, 15u);
}

// The walls stay on their line, but their ends move along it.
TEST(Interface_energy, walls_of_mobility_0_stay) {
  Interface_energy energy;
  energy.set_mobility([](int a, int b) { return a == 1 && b == 2 ? 0 : 1; });
  Complex complex = disk_between_two_labels(12, .6);
  const auto expect_on_line = [&] {
    for (const auto& facet : complex.interface_facets())
      if (facet.first->subdomain_index() + facet.first->neighbor(facet.second)->subdomain_index() ==
          3)
        for (auto v : complex.facet_vertices(facet)) {
          EXPECT_EQ(complex.position(v).y(), 0);
        }
  };
  const double area = complex.area(3), length = DSC::shared_measures(complex).at({1, 2});
  for (const bool keeps_volumes : {true, false}) {
    const DSC::Mean_curvature_flow flow(energy, keeps_volumes);
    EXPECT_TRUE(DSC::advect_interface(complex, flow, 0, .01).complete);
    expect_on_line();
    if (keeps_volumes) {
      EXPECT_NEAR(complex.area(3), area, 1e-9);
    }
  }
  EXPECT_LT(complex.area(3), area - 1e-3);
  EXPECT_NE(DSC::shared_measures(complex).at({1, 2}), length);
}

// A wall between the labels 1 and 2 that a difference of densities drives along a channel of width
// 1, to a particle of radius r in the middle. The boundary of the particle does not move. The wall
// ends at right angles at the particle and at the sides, so its halves are arcs: g r_0 = sin(phi)
// for an arc of radius 1 / g from the particle at the angle phi, with r_0 = 1/2 - r cos(phi). The
// drive g is greatest for cos(phi) = 2 r: 1 / sqrt(1/4 - r^2).
TEST(Interface_energy, particle_pins_a_wall) {
  static constexpr double r = .2, edge = .05;
  const double greatest = 1 / std::sqrt(.25 - r * r);
  for (const double part : {.95, 1.05}) {
    Complex complex = planar_regions::region(planar_regions::circle(r, edge), {}, {-1, -.5, 1, .5});
    std::vector<Complex::Cell_handle> ahead;
    for (auto c : complex.cells()) {
      double x = 0;
      for (int i = 0; i < 3; ++i)
        x += complex.position(c->vertex(i)).x() / 3;
      if (c->subdomain_index() == 0 && x > 0)
        ahead.push_back(c);
    }
    for (auto c : ahead)
      complex.relabel(c, 2);
    Interface_energy energy;
    energy.set_mobility([](int a, int b) { return a == 1 || b == 1 ? 0 : 1; });
    energy.set_density([&](int label) { return label == 2 ? part * greatest : 0; });
    DSC::Grain_growth_options options;
    options.edges_of_grain = std::sqrt(2. / 3) / edge;
    options.step = .2;
    DSC::Grain_growth<Complex> growth(complex, energy, options);
    const double particle = complex.area(1);
    static constexpr double passed = .65; // area in front of a wall that the particle cannot hold
    while (growth.time() < 4 && complex.area(2) > passed)
      EXPECT_TRUE(growth.advance().deformation.complete);
    EXPECT_EQ(complex.area(2) > passed, part < 1);
    EXPECT_NEAR(complex.area(1), particle, .02 * particle);
  }
}

// A thin layer with the label 3 between the labels 1 and 2. Two of its interfaces have more energy
// than one interface between 1 and 2, except if the layer wets this interface.
TEST(Interface_energy, thin_layer_stays_if_it_wets) {
  const Complex complex = planar_regions::grid(
      4, 3,
      [](std::size_t i, std::size_t j) {
        return Complex::Point_2(double(i), j < 2 ? double(j) : double(j - 1) + (j == 2 ? 1e-3 : 0));
      },
      [](std::size_t, std::size_t j) { return j == 0   ? 1
                                              : j == 1 ? 3
                                                       : 2; });
  for (const double tension : {1., 1.9, 2.1}) {
    const Interface_energy energy = with_tension_of_1_and_2(tension);
    std::size_t proposed = 0;
    int label = 0;
    for (auto c : complex.cells())
      proposed +=
          c->subdomain_index() == 3 && DSC::propose_relabeling(complex, c, .1, label, energy);
    EXPECT_EQ(proposed, tension < 2 ? 8u : 0u);
  }
}

// Two grains pull the two others at their common wall apart. The tension of the new wall decides.
TEST(Interface_energy, decides_whether_neighbors_are_exchanged) {
  // Four grains around a wall of length .1 along the y-axis: 1 on the left, 2 on the right, 3 above
  // and 4 below it.
  const auto grains = [] {
    return planar_regions::grid(
        4, 5,
        [](std::size_t i, std::size_t j) {
          static constexpr double ys[] = {-1, -.5, -.05, .05, .5, 1};
          return Complex::Point_2(.5 * double(i) - 1, ys[j]);
        },
        [](std::size_t i, std::size_t j) {
          return j == 2  ? (i < 2 ? 1 : 2)
                 : j > 2 ? (i == 0   ? 1
                            : i == 3 ? 2
                                     : 3)
                         : (i == 0   ? 1
                            : i == 3 ? 2
                                     : 4);
        });
  };
  for (const double tension : {1., 20.}) { // between 3 and 4
    Interface_energy energy;
    energy.set_tension([tension](int a, int b) { return a == 3 && b == 4 ? tension : 1; });
    const Complex complex = grains();
    DSC::Cavity<Complex> cavity(complex);
    bool is_proposed = false;
    for (auto c : complex.cells())
      for (int i = 0; i < 3; ++i)
        if (c->subdomain_index() == 1 && c->neighbor(i)->subdomain_index() == 2)
          is_proposed =
              is_proposed ||
              DSC::propose_neighbor_exchange(complex, c, i, .5, cavity, energy).has_value();
    EXPECT_EQ(is_proposed, tension == 1);
  }
}

// Returns a channel of width 1 with n edges in the width. The label 3 is at the end of the wall
// between the labels 1 and 2.
Complex channel(std::size_t n) {
  return planar_regions::grid(
      3 * n, n,
      [n](std::size_t i, std::size_t j) {
        return Complex::Point_2(double(i) / double(n), double(j) / double(n));
      },
      [n](std::size_t i, std::size_t j) { return i >= 2 * n  ? 3
                                                 : j < n / 2 ? 1
                                                             : 2; });
}

// In a channel of width 1, the label 3 displaces the wall between the labels 1 and 2. Its boundary
// turns from the normal of a side to the angle of Young at the junction, and travels like a grim
// reaper: the speed times half the width is the angle of this turn.
TEST(Interface_energy, junction_travels_at_its_speed) {
  static constexpr std::size_t n = 10; // edges in the width
  const double exact = 2 * (CGAL_PI / 2 - 82.8192 / 2 * degree);
  Complex complex = channel(n);
  DSC::Grain_growth_options options;
  options.edges_of_grain = n;
  DSC::Grain_growth<Complex> growth(complex, with_tension_of_1_and_2(1.5), options);
  while (growth.time() < .3)
    growth.advance();
  const double area = complex.area(3), begin = growth.time();
  while (growth.time() < .5)
    growth.advance();
  EXPECT_NEAR((complex.area(3) - area) / (growth.time() - begin), exact, .01 * exact);
}

// A phase that wets the wall between two others separates them, also where the wall ends at a side
// of the domain. Then the two others vanish.
TEST(Interface_energy, phase_that_wets_advances) {
  static constexpr std::size_t n = 10;
  Complex complex = channel(n);
  const Interface_energy energy = with_tension_of_1_and_2(2.5);
  DSC::Grain_growth_options options;
  options.edges_of_grain = n;
  DSC::Grain_growth<Complex> growth(complex, energy, options);
  double energy_before = energy(complex);
  bool are_neighbors = true;
  while (growth.time() < 1 && complex.labels().size() > 1) {
    EXPECT_TRUE(growth.advance().deformation.complete);
    EXPECT_LT(energy(complex), energy_before);
    energy_before = energy(complex);
    const bool were_neighbors = are_neighbors;
    are_neighbors = DSC::shared_measures(complex).count({1, 2}) > 0;
    EXPECT_LE(are_neighbors, were_neighbors);
    if (growth.time() < .45) {
      EXPECT_TRUE(are_neighbors);
    }
  }
  EXPECT_EQ(complex.labels(), std::vector<int>{3});
}

// A lens of constant area between two labels. Its two arcs are circular, so its angle follows from
// its width and height.
TEST(Interface_energy, lens_has_the_angle_of_young) {
  static constexpr double dt = .002;
  const Interface_energy energy = with_tension_of_1_and_2(1.5);
  Complex complex = disk_between_two_labels(32, .3);
  double last = energy(complex), area = 0;
  for (int k = 0; k < 150; ++k) {
    DSC::advect_adaptively(complex, DSC::Mean_curvature_flow(energy, true), k * dt, dt);
    EXPECT_LT(energy(complex), last * (1 + 1e-5)) << k;
    last = energy(complex);
    if (k == 10) // the steps of the grid are gone
      area = complex.area(3);
  }
  EXPECT_NEAR(complex.area(3), area, 1e-9);
  double width = 0, height = 0;
  for (const auto& facet : complex.interface_facets())
    if (facet.first->subdomain_index() == 3 ||
        facet.first->neighbor(facet.second)->subdomain_index() == 3)
      for (auto v : complex.facet_vertices(facet)) {
        width = (std::max)(width, std::abs(complex.position(v).x()));
        height = (std::max)(height, std::abs(complex.position(v).y()));
      }
  EXPECT_NEAR(4 * std::atan(height / width) / degree, 82.8192, .5);
}

} // namespace test_interface_energy

#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

namespace {

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<3>;
using Complex = CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default,
                                                      DSC::Volume_length_ratio_3, Domain>;
using Position = Complex::Point_3;
using Vector = Complex::Vector_3;

double distance_on_unit_torus(const Position& p, const Position& q) {
  const auto along = [](double difference) { return difference - std::round(difference); };
  return std::hypot(along(p.x() - q.x()), along(p.y() - q.y()), along(p.z() - q.z()));
}

// A ball about the corner of the box, where all seams meet.
Complex ball_on_the_seams(double radius, double edge) {
  return DSC::fill_torus<Complex>(Domain(), edge, [&](const Position& p) {
    return distance_on_unit_torus(p, CGAL::ORIGIN) < radius ? 1 : 0;
  });
}

TEST(Torus_3, is_filled_without_boundary) {
  const Complex dsc =
      DSC::fill_torus<Complex>(Domain({1, 1.5, 2}), .3, [](const Position&) { return 7; });
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.number_of_vertices(), 2u * 3 * 5 * 7);
  EXPECT_EQ(dsc.number_of_cells(), 12u * 3 * 5 * 7);
  EXPECT_NEAR(dsc.volume(7), 3, 1e-14);
  EXPECT_EQ(dsc.number_of_components(7), 1u);
}

TEST(Torus_3, is_built_from_a_function) {
  const Complex dsc = ball_on_the_seams(.3, .1);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
  EXPECT_NEAR(dsc.volume(1) / (4 * std::acos(-1.) / 3 * .027), 1,
              .1); // smaller, because its vertices lie on the sphere
  for (auto v : dsc.interface_vertices())
    EXPECT_NEAR(distance_on_unit_torus(dsc.position(v), CGAL::ORIGIN), .3, .015);
}

struct Translation
{
  Vector velocity;
  Vector operator()(const Position&, double) const { return velocity; }
};

TEST(Torus_3, carries_a_ball_once_around) {
  Complex dsc = ball_on_the_seams(.3, .125);
  std::map<std::size_t, Position> start;
  for (auto v : dsc.interface_vertices())
    start[v->time_stamp()] = dsc.position(v);
  const std::size_t facets = dsc.interface_facets().size();
  const double volume = dsc.volume(1);
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) {
    const auto report =
        DSC::advect_interface(dsc, Translation{Vector(1, 2, -1)}, double(i) / steps, 1. / steps);
    ASSERT_TRUE(report.complete);
    ASSERT_TRUE(dsc.is_valid(true));
    ASSERT_EQ(dsc.interface_facets().size(), facets);
    ASSERT_NEAR(dsc.volume(1), volume, 1e-13);
  }
  for (auto v : dsc.interface_vertices()) {
    ASSERT_EQ(start.count(v->time_stamp()), 1u);
    EXPECT_LT(distance_on_unit_torus(dsc.position(v), start[v->time_stamp()]), 1e-12);
  }
}

TEST(Torus_3, merges_a_growing_ball_with_itself_through_the_seams) {
  Complex dsc = ball_on_the_seams(.35, .125);
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
  for (int i = 0; i < 12; ++i) {
    DSC::advect_interface(dsc, DSC::Normal_offset{1.}, 0, .02);
    ASSERT_TRUE(dsc.is_valid(true));
  }
  // Three handles, each of which crosses one seam.
  EXPECT_EQ(dsc.euler_characteristic(1), -4);
  EXPECT_EQ(dsc.number_of_components(0), 1u);
}

class Random_field
{
public:
  explicit Random_field(std::mt19937& random) {
    std::uniform_int_distribution<int> number(-2, 2);
    std::normal_distribution<double> amplitude(0, .1);
    for (Wave& w : m_waves) {
      w.numbers = {number(random), number(random), number(random)};
      w.amplitude = Vector(amplitude(random), amplitude(random), amplitude(random));
      w.phase = 10 * amplitude(random);
    }
  }
  Vector operator()(const Position& p, double) const {
    static const double two_pi = 2 * std::acos(-1.);
    Vector result(0, 0, 0);
    for (const Wave& w : m_waves)
      result =
          result +
          std::sin(two_pi * (w.numbers[0] * p.x() + w.numbers[1] * p.y() + w.numbers[2] * p.z()) +
                   w.phase) *
              w.amplitude;
    return result;
  }

private:
  struct Wave
  {
    std::array<int, 3> numbers;
    Vector amplitude;
    double phase;
  };
  std::array<Wave, 6> m_waves;
};

TEST(Torus_3, stays_valid_whatever_happens) {
  for (int labels : {2, 5}) {
    std::mt19937 random{unsigned(labels)};
    std::vector<int> label_of(64);
    for (int& label : label_of)
      label = int(random() % unsigned(labels));
    Complex dsc = DSC::fill_torus<Complex>(Domain(), .2, [&](const Position& p) {
      return label_of[std::size_t(4 * p.x()) * 16 + std::size_t(4 * p.y()) * 4 +
                      std::size_t(4 * p.z())];
    });
    for (int i = 0; i < 3; ++i) {
      DSC::advect_interface(dsc, Random_field(random), 0, .2);
      ASSERT_TRUE(dsc.is_valid(true)) << labels << " labels, field " << i;
      DSC::control_detail(dsc);
      ASSERT_TRUE(dsc.is_valid(true)) << labels << " labels, field " << i;
    }
    DSC::improve_interface(dsc);
    ASSERT_TRUE(dsc.is_valid(true));
    DSC::improve_mesh(dsc);
    ASSERT_TRUE(dsc.is_valid(true));
  }
}

} // namespace

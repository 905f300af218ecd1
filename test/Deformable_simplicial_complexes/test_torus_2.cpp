#include "test.h"
#include "torus.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_2.h>
#include <CGAL/Interface_remeshing/control_detail.h>

namespace test_torus {

using torus::Complex;
using torus::Domain;
using torus::Point;
using Vertex_handle = Complex::Vertex_handle;
using Vector = Complex::Vector_2;

template <class Point_2> double distance_on_unit_torus(const Point_2& p, const Point& q) {
  const auto along = [](double difference) { return difference - std::round(difference); };
  return std::hypot(along(p.x() - q.x()), along(p.y() - q.y()));
}

// A disk about a corner of the box, which intersects both seams.
Complex disk_on_the_seams(std::size_t n, double radius) {
  return torus::grid(
      n, [&](const Point& p) { return distance_on_unit_torus(p, Point(0, 0)) < radius ? 1 : 0; });
}

TEST(Torus_domain, rounds_positions_to_images_in_the_box) {
  const Domain domain({1, 3});
  EXPECT_EQ(domain.canonical(Point(.25, 2)), Point(.25, 2));
  EXPECT_EQ(domain.canonical(Point(-.25, 4)), Point(.75, 1));
  EXPECT_EQ(domain.canonical(Point(7.5, -3)), Point(.5, 0));
  EXPECT_EQ(domain.canonical(Point(-1e-30, 1e-30)), Point(0, 0));
  EXPECT_EQ(domain.canonical(Point(1, 3)), Point(0, 0));
  // Images that are many periods away are as accurate as their coordinates.
  EXPECT_EQ(domain.canonical(Point(1e15 + .5, 3e15)), Point(.5, 0));
}

TEST(Torus_domain, sees_nearest_images_without_rounding) {
  const Domain domain({1, 3});
  EXPECT_EQ(domain.nearest_image(Point(.125, .125), Point(.875, 2.875)), Point(-.125, -.125));
  EXPECT_EQ(domain.nearest_image(Point(.875, 2.875), Point(.125, .125)), Point(1.125, 3.125));
  EXPECT_EQ(domain.nearest_image(Point(.5, .5), Point(.625, .75)), Point(.625, .75));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 3);
  for (int i = 0; i < 1000; ++i) {
    const Point p = domain.canonical(Point(coordinate(random), coordinate(random))),
                q = domain.canonical(Point(coordinate(random), coordinate(random)));
    EXPECT_EQ(domain.canonical(domain.nearest_image(p, q)), q);
    EXPECT_EQ(domain.nearest_image(q, domain.nearest_image(p, q)), q);
  }
}

TEST(Torus_domain, rounds_periods_and_refuses_bad_ones) {
  using CGAL::Deformable_simplicial_complexes::Error;
  const double pi = std::acos(-1.);
  EXPECT_NEAR(Domain({2 * pi, pi}).periods()[0], 2 * pi, 4e-15);
  EXPECT_THROW(Domain({1, 0}), Error);
  EXPECT_THROW(Domain({1, -1}), Error);
  EXPECT_THROW(Domain({1, 1e-7}), Error);
  EXPECT_THROW(Domain({1, std::nan("")}), Error);
  EXPECT_THROW(Domain({1e31, 1e31}), Error);
}

TEST(Torus, is_filled_without_boundary) {
  const Complex dsc = torus::grid(5, [](const Point&) { return 7; });
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.number_of_vertices(), 25u);
  EXPECT_EQ(dsc.number_of_cells(), 50u);
  EXPECT_NEAR(dsc.area(7), 1, 1e-15);
  EXPECT_EQ(dsc.number_of_components(7), 1u);
  EXPECT_TRUE(dsc.interface_facets().empty());
  for (auto v : dsc.finite_vertices()) {
    EXPECT_FALSE(dsc.is_infinite(v));
    EXPECT_FALSE(dsc.is_boundary(v));
  }
}

TEST(Torus, joins_components_through_the_seams) {
  const Complex dsc = disk_on_the_seams(20, .3);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.number_of_components(0), 1u);
  EXPECT_NEAR(dsc.area(1), .09 * std::acos(-1.), .01);
  EXPECT_LT(dsc.mean_interface_edge(), .1);
}

TEST(Torus, refuses_cells_that_are_too_long) {
  using Error = CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
  const auto one = [](const Point&) { return 1; };
  EXPECT_THROW(torus::grid(2, one), Error);
  EXPECT_TRUE(torus::grid(3, one).is_valid());
}

TEST(Torus, refuses_cells_that_cover_it_twice_or_not_at_all) {
  using Error = CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
  // A grid over two periods, mapped to the torus.
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  const std::size_t n = 5;
  const auto index = [&](std::size_t i, std::size_t j) { return i % (2 * n) * n + j % n; };
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      points.emplace_back(.2 * double(i), .2 * double(j));
      triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  Complex dsc;
  EXPECT_THROW(dsc.assign(points, triangles, std::vector<int>(triangles.size(), 1)), Error);
  triangles.pop_back();
  EXPECT_THROW(dsc.assign(points, triangles, std::vector<int>(triangles.size(), 1)), Error);
  EXPECT_EQ(dsc.number_of_cells(), 0u);
}

TEST(Torus, is_copied_and_restored_to_the_same_bits) {
  Complex dsc = disk_on_the_seams(12, .3);
  const Complex copy = dsc;
  EXPECT_TRUE(copy.is_valid(true));
  EXPECT_TRUE(copy.state() == dsc.state());
  Complex other((Domain({2, 5})));
  other.restore(dsc.state());
  EXPECT_TRUE(other.state() == dsc.state());
  EXPECT_EQ(other.domain().periods(), dsc.domain().periods());
  dsc.sort_storage();
  EXPECT_TRUE(dsc.is_valid(true));
  Complex assigned;
  assigned = dsc;
  EXPECT_TRUE(assigned.state() == dsc.state());
}

TEST(Torus, moves_a_vertex_across_the_seam) {
  Complex dsc = torus::grid(5, [](const Point&) { return 1; });
  const auto at_origin = [](Vertex_handle v) { return v->point() == Point(0, 0); };
  const auto all = dsc.vertices();
  const Vertex_handle v = *std::find_if(all.begin(), all.end(), at_origin);
  EXPECT_EQ(dsc.move_vertex(v, Point(-.0625, -.03125)), 1);
  EXPECT_EQ(v->point(), Point(.9375, .96875));
  EXPECT_TRUE(dsc.is_valid(true));
  // As far as the star permits.
  const double way = dsc.move_vertex(v, Point(.55, .96875));
  EXPECT_GT(way, 0);
  EXPECT_LT(way, 1);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.move_vertex(v, Point(1, 1)), 1);
  EXPECT_EQ(v->point(), Point(0, 0));
}

struct Translation
{
  Vector velocity;
  Vector operator()(const Complex::Point_2&, double) const { return velocity; }
};

TEST(Torus, carries_a_disk_once_around) {
  Complex dsc = disk_on_the_seams(16, .3);
  std::map<std::size_t, Point> start;
  for (Vertex_handle v : dsc.interface_vertices())
    start[v->time_stamp()] = v->point();
  const std::size_t facets = dsc.interface_facets().size();
  const double area = dsc.area(1);
  const int steps = 50;
  for (int i = 0; i < steps; ++i) {
    const auto report =
        DSC::advect_interface(dsc, Translation{Vector(1, 2)}, double(i) / steps, 1. / steps);
    ASSERT_TRUE(report.complete);
    ASSERT_TRUE(dsc.is_valid(true));
    ASSERT_EQ(dsc.interface_facets().size(), facets);
    ASSERT_NEAR(dsc.area(1), area, 1e-13);
  }
  for (Vertex_handle v : dsc.interface_vertices()) {
    ASSERT_EQ(start.count(v->time_stamp()), 1u);
    EXPECT_LT(distance_on_unit_torus(v->point(), start[v->time_stamp()]), 1e-12);
  }
}

// Returns V - E + F of the cells of a label.
int euler_characteristic(const Complex& dsc, int label) {
  std::set<Vertex_handle> vertices;
  int edges = 0, cells = 0;
  for (auto c : dsc.finite_cells())
    if (c->subdomain_index() == label) {
      ++cells;
      for (int i = 0; i < 3; ++i) {
        vertices.insert(c->vertex(i));
        edges += c->neighbor(i)->subdomain_index() != label ||
                 c->time_stamp() < c->neighbor(i)->time_stamp();
      }
    }
  return int(vertices.size()) - edges + cells;
}

TEST(Torus, merges_a_growing_disk_with_itself_through_the_seams) {
  Complex dsc = disk_on_the_seams(24, .35);
  EXPECT_EQ(euler_characteristic(dsc, 1), 1);
  for (int i = 0; i < 24; ++i) {
    DSC::advect_interface(dsc, DSC::Normal_offset{1.}, 0, .01);
    ASSERT_TRUE(dsc.is_valid(true));
  }
  EXPECT_EQ(euler_characteristic(dsc, 1), -1);
  EXPECT_EQ(euler_characteristic(dsc, 0), 1);
  EXPECT_GT(dsc.area(1), .8);
}

TEST(Torus, keeps_its_topology_where_that_is_wanted) {
  namespace parameters = CGAL::parameters;
  using CGAL::Deformable_simplicial_complexes::Forbid_topology_changes;
  Complex dsc = disk_on_the_seams(24, .35);
  for (int i = 0; i < 24; ++i) {
    DSC::advect_interface(dsc, DSC::Normal_offset{1.}, 0, .01,
                          parameters::topology_control(Forbid_topology_changes()));
    ASSERT_TRUE(dsc.is_valid(true));
    ASSERT_EQ(euler_characteristic(dsc, 1), 1);
    ASSERT_EQ(euler_characteristic(dsc, 0), -1);
  }
  EXPECT_GT(dsc.area(1), .6);
}

// Returns sums of waves with the periods of the torus.
class Random_field
{
public:
  explicit Random_field(std::mt19937& random) {
    std::uniform_int_distribution<int> number(-3, 3);
    std::normal_distribution<double> amplitude(0, .1);
    for (Wave& w : m_waves)
      w = {number(random),
           number(random),
           {amplitude(random), amplitude(random)},
           10 * amplitude(random)};
  }
  Vector operator()(const Complex::Point_2& p, double) const {
    static const double two_pi = 2 * std::acos(-1.);
    Vector result(CGAL::NULL_VECTOR);
    for (const Wave& w : m_waves)
      result = result + std::sin(two_pi * (w.k * p.x() + w.l * p.y()) + w.phase) * w.amplitude;
    return result;
  }

private:
  struct Wave
  {
    int k, l;
    Vector amplitude;
    double phase;
  };
  std::array<Wave, 6> m_waves;
};

TEST(Torus, stays_valid_whatever_happens) {
  for (int labels : {2, 5})
    for (unsigned seed = 0; seed < 5; ++seed) {
      std::mt19937 random(seed);
      Complex dsc = torus::grid(8, [&](const Point&) { return int(random() % unsigned(labels)); });
      for (int i = 0; i < 8; ++i) {
        DSC::advect_interface(dsc, Random_field(random), 0, .25);
        ASSERT_TRUE(dsc.is_valid(true)) << labels << " labels, seed " << seed << ", field " << i;
      }
    }
}

// Compresses along x about the center of the box. A stretch along y would turn a wall that is not
// exactly horizontal.
struct Squeeze
{
  Vector operator()(const Complex::Point_2& p, double) const {
    return Vector(std::sin(2 * std::acos(-1.) * p.x()), 0);
  }
};

// Four phases about the center. Phases 1 (top) and 2 (bottom) have a common wall, until phases 3
// (left) and 4 (right) are pressed together.
class Four_phases : public testing::Test
{
protected:
  Four_phases()
      : dsc(DSC::fill_torus<Complex>(Domain(), .05, [](const Complex::Point_2& p) {
          const double x = p.x() - .5, y = p.y() - .5;
          if (std::abs(x) > std::abs(y) + .1)
            return x < 0 ? 3 : 4;
          return y > 0 ? 1 : 2;
        })) {}

  bool have_wall(int a, int b) const { return !dsc.interface_facets(a, b).empty(); }

  Complex dsc;
};

TEST_F(Four_phases, exchange_neighbors) {
  namespace parameters = CGAL::parameters;
  std::size_t exchanges = 0;
  for (int i = 0; i < 40 && exchanges == 0; ++i) {
    DSC::control_detail(dsc, parameters::change_interface(true));
    const auto report = DSC::advect_interface(dsc, Squeeze(), 0, .02);
    ASSERT_TRUE(dsc.is_valid(true));
    exchanges = report.exchanges.size();
    if (exchanges > 0) {
      EXPECT_EQ(exchanges, 1u);
      EXPECT_EQ(std::minmax(report.exchanges[0].parted[0], report.exchanges[0].parted[1]),
                std::minmax(1, 2));
      EXPECT_EQ(std::minmax(report.exchanges[0].joined[0], report.exchanges[0].joined[1]),
                std::minmax(3, 4));
      EXPECT_LT(distance_on_unit_torus(report.exchanges[0].where, Point(.5, .5)), .05);
    }
  }
  EXPECT_EQ(exchanges, 1u);
  EXPECT_TRUE(have_wall(3, 4));
}

TEST_F(Four_phases, keep_their_neighbors_where_that_is_wanted) {
  namespace parameters = CGAL::parameters;
  using CGAL::Deformable_simplicial_complexes::Forbid_topology_changes;
  for (int i = 0; i < 40; ++i) {
    DSC::control_detail(dsc, parameters::change_interface(true));
    const auto report = DSC::advect_interface(
        dsc, Squeeze(), 0, .02, parameters::topology_control(Forbid_topology_changes()));
    ASSERT_TRUE(dsc.is_valid(true));
    ASSERT_TRUE(report.exchanges.empty());
    ASSERT_TRUE(have_wall(1, 2));
  }
}

TEST(Curve_shortening, shrinks_a_circle_on_the_seams_at_its_rate) {
  Complex dsc = DSC::fill_torus<Complex>(Domain(), .05, [](const Complex::Point_2& p) {
    return distance_on_unit_torus(p, Point(0, 0)) < .3 ? 1 : 0;
  });
  const double two_pi = 2 * std::acos(-1.), dt = .001;
  for (int i = 0; i < 10; ++i) {
    const double before = dsc.area(1);
    ASSERT_TRUE(DSC::advect_interface(dsc, DSC::Mean_curvature_flow(), 0, dt).complete);
    EXPECT_NEAR((dsc.area(1) - before) / dt, -two_pi, .005 * two_pi);
  }
}

TEST(Curve_shortening, brings_a_bubble_of_a_kept_area_to_rest) {
  Complex dsc = DSC::fill_torus<Complex>(Domain(), .05, [](const Complex::Point_2& p) {
    return std::abs(p.x() - .5) < .3 && std::abs(p.y() - .5) < .15 ? 1 : 0;
  });
  const double area = dsc.area(1), radius = std::sqrt(area / std::acos(-1.));
  const DSC::Mean_curvature_flow flow(true);
  for (int i = 0; i < 100; ++i)
    ASSERT_TRUE(DSC::advect_interface(dsc, flow, 0, .002).complete);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.area(1), area, 1e-9);
  for (auto v : dsc.interface_vertices())
    EXPECT_NEAR(distance_on_unit_torus(dsc.position(v), Point(.5, .5)), radius, .03 * radius);
}

using Curve = DSC::Labeled_curve_2<Point>;

Curve circle(double x, double y, double radius, int n, int label) {
  Curve curve;
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * i / n;
    points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  curve.add_polyline(points);
  curve.label = label;
  return curve;
}

TEST(Make_complex_on_a_torus, of_nested_curves_across_the_seams) {
  const Domain domain({1, 2});
  const std::vector<Curve> curves = {circle(1, 2.05, .4, 60, 1), circle(1.05, 2, .2, 40, 2)};
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(domain, curves);
  EXPECT_TRUE(dsc.is_valid(true));
  const auto area = [](double radius, int n) {
    return radius * radius * n * std::sin(2 * std::acos(-1.) / n) / 2;
  };
  EXPECT_NEAR(dsc.area(2), area(.2, 40), 1e-13);
  EXPECT_NEAR(dsc.area(1), area(.4, 60) - area(.2, 40), 1e-13);
  EXPECT_NEAR(dsc.area(0) + dsc.area(1) + dsc.area(2), 2, 1e-13);
  std::size_t on_interface = 0;
  for (auto v : dsc.interface_vertices()) {
    ++on_interface;
    EXPECT_TRUE(std::any_of(curves.begin(), curves.end(), [&](const Curve& curve) {
      return std::any_of(curve.points.begin(), curve.points.end(), [&](const Point& p) {
        const Point q = domain.nearest_image(p, Point(dsc.position(v).x(), dsc.position(v).y()));
        return std::hypot(p.x() - q.x(), p.y() - q.y()) < 1e-14;
      });
    }));
  }
  EXPECT_EQ(on_interface, 100u);
}

TEST(Make_complex_on_a_torus, refuses_curves_that_do_not_fit) {
  using namespace CGAL::Deformable_simplicial_complexes;
  const auto make = [](const std::vector<Curve>& curves) {
    return DSC::make_deformable_simplicial_complex_2<Complex>(Domain(), curves);
  };
  EXPECT_THROW(make({}), Error);
  EXPECT_THROW(make({circle(0, 0, .51, 20, 1)}), Invalid_surface_error);
  EXPECT_THROW(make({circle(0, 0, .2, 20, 1), circle(.9, 0, .2, 20, 1)}), Invalid_surface_error);
  EXPECT_THROW(make({circle(0, 0, .2, 20, 1), circle(.1, 0, .2, 20, 1)}), Invalid_surface_error);
  EXPECT_TRUE(make({circle(7.5, -3.5, .45, 20, 1)}).is_valid(true));
}

} // namespace test_torus

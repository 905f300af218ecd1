#include "mesh_helpers.h"
#include "stamped_values.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>
#include <CGAL/Interface_remeshing/remove_degeneracies.h>

// Values on vertices and averages on cells that follow changes of the mesh.

namespace test_carried_values {

using mesh_helpers::jittered_grid;
using mesh_helpers::Random;
using namespace small_meshes;

constexpr double tolerance = 1e-12;

using stamped_values::Values;
using Vertex_values = Values<Vertex_handle>;
using Cell_values = Values<Cell_handle>;

double volume(const Complex& dsc, Cell_handle c) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  return internal::signed_measure<Complex::Space>(internal::cell_corners(dsc, c));
}

Cell_values random_averages(const Complex& dsc, unsigned seed, double minimum, double maximum) {
  Random random(seed);
  Cell_values result;
  for (Cell_handle c : dsc.cells())
    result.set(c, random(minimum, maximum));
  return result;
}

double integral(const Complex& dsc, Cell_values& averages) {
  double result = 0;
  for (Cell_handle c : dsc.cells())
    result += averages[c] * volume(dsc, c);
  return result;
}

double integral(const Complex& dsc, Cell_values& averages, int label) {
  double result = 0;
  for (Cell_handle c : dsc.cells())
    result += c->subdomain_index() == label ? averages[c] * volume(dsc, c) : 0;
  return result;
}

std::pair<double, double> range(const Complex& dsc, Cell_values& averages) {
  std::pair<double, double> result(1e300, -1e300);
  for (Cell_handle c : dsc.cells()) {
    result.first = (std::min)(result.first, averages[c]);
    result.second = (std::max)(result.second, averages[c]);
  }
  return result;
}

// A box of which half has label 1. The vertices of the common wall are disturbed within its plane.
// No operation may change the volumes of the halves.
int half(const Point& p) { return p.x() < 0 ? 1 : 0; }

Complex flat_interface(std::size_t n, double part, unsigned seed) {
  Complex dsc = make_complex(grid(n, half));
  Random random(seed);
  for (Vertex_handle v : dsc.vertices()) {
    const Vector way = random.vector<Complex>(part * 2. / double(n));
    dsc.move_vertex(v, dsc.position(v) + Vector(v->is_interface() ? 0 : way.x(), way.y(), way.z()));
  }
  return dsc;
}

// All operations that improve a mesh at rest, by name.
template <class Visitor>
DSC::Improvement_report improve(const std::string& name, Complex& dsc, Visitor& visitor) {
  const auto np = parameters::visitor(std::ref(visitor));
  if (name == "control_detail")
    return DSC::control_detail(dsc, np.split_length(1.2).collapse_length(1.).collapse_quality(.1));
  if (name == "control_detail of the interface")
    return DSC::control_detail(
        dsc, np.change_interface(true).interface_split_length(1.2).interface_collapse_length(.8));
  if (name == "improve_mesh")
    return DSC::improve_mesh(dsc, np.quality_threshold(.5).smooth_interface(true));
  if (name == "improve_mesh, aggressively")
    return DSC::improve_mesh(dsc, np.quality_threshold(.4).aggressive(true));
  if (name == "improve_interface")
    return DSC::improve_interface(
        dsc, np.quality_threshold(.4).curved_splits(true).interface_split_length(1.2));
  if (name == "improve_interface without smoothing")
    return DSC::improve_interface(
        dsc, np.quality_threshold(.4).aggressiveness(0.).interface_split_length(1.2));
  return DSC::remove_degeneracies(dsc, np.degenerate_quality(.2).degenerate_cosine(.9));
}

const std::vector<std::string> improvements = {
    "control_detail",     "control_detail of the interface",
    "improve_mesh",       "improve_mesh, aggressively",
    "improve_interface",  "improve_interface without smoothing",
    "remove_degeneracies"};

std::size_t number_of_changes(const DSC::Improvement_report& r) {
  return r.split + r.collapsed + r.flipped + r.smoothed + r.inserted;
}

double linear(const Position& p) { return 2 * p.x() - 3 * p.y() + p.z() + 4; }

Vertex_values linear_values(const Complex& dsc) {
  Vertex_values result;
  for (Vertex_handle v : dsc.vertices())
    result.set(v, linear(dsc.position(v)));
  return result;
}

double largest_error(const Complex& dsc, Vertex_values& values) {
  double result = 0;
  for (Vertex_handle v : dsc.vertices())
    result = (std::max)(result, std::abs(values[v] - linear(dsc.position(v))));
  return result;
}

// Runs a function with a visitor that carries values on vertices and averages on cells.
template <class Run>
auto carry(Complex& dsc, Vertex_values& values, Cell_values& averages, const Run& run) {
  DSC::Carried_vertex_values<Complex, Vertex_values::Map> vertices(dsc, values.map());
  DSC::Carried_cell_averages<Complex, Cell_values::Map> cells(dsc, averages.map());
  DSC::Deformation_visitor_pair both(vertices, cells);
  return run(both);
}

std::size_t improve(const std::string& name, Complex& dsc, Vertex_values& values,
                    Cell_values& averages) {
  const auto report =
      carry(dsc, values, averages, [&](auto& visitor) { return improve(name, dsc, visitor); });
  EXPECT_TRUE(dsc.is_valid());
  return number_of_changes(report);
}

// Changes of the mesh at rest

TEST(Carried_values, keep_a_linear_function_and_the_integral) {
  for (const std::string& name : improvements)
    for (auto label : {small_meshes::two_boxes, small_meshes::ball}) {
      SCOPED_TRACE(name);
      Complex dsc = jittered_grid(4, label, .35, 1);
      Vertex_values values = linear_values(dsc);
      Cell_values averages = random_averages(dsc, 2, 1, 10);
      std::map<int, double> before;
      for (int l : dsc.labels())
        before[l] = integral(dsc, averages, l);
      EXPECT_GT(improve(name, dsc, values, averages), 10u);
      EXPECT_LT(largest_error(dsc, values), tolerance);
      for (int l : dsc.labels())
        EXPECT_NEAR(integral(dsc, averages, l), before[l], tolerance * before[l]);
    }
}

TEST(Carried_values, keep_a_constant_where_volumes_stay) {
  for (const std::string& name : improvements)
    for (unsigned seed : {1, 2}) {
      SCOPED_TRACE(name);
      Complex dsc = flat_interface(4, .35, seed);
      const double volume = dsc.volume(1);
      Vertex_values values = linear_values(dsc);
      Cell_values averages = random_averages(dsc, 1, 3, 3);
      EXPECT_GT(improve(name, dsc, values, averages), 10u);
      ASSERT_NEAR(dsc.volume(1), volume, tolerance);
      const auto [least, most] = range(dsc, averages);
      EXPECT_NEAR(least, 3, tolerance);
      EXPECT_NEAR(most, 3, tolerance);
      EXPECT_LT(largest_error(dsc, values), tolerance);
    }
}

TEST(Carried_values, keep_bounds_where_the_interface_stays) {
  for (const std::string name : {"control_detail", "improve_mesh", "improve_mesh, aggressively"}) {
    SCOPED_TRACE(name);
    Complex dsc = flat_interface(4, .35, 3);
    Vertex_values values = linear_values(dsc);
    Cell_values averages = random_averages(dsc, 4, -1, 2);
    const auto before = range(dsc, averages);
    improve(name, dsc, values, averages);
    const auto after = range(dsc, averages);
    EXPECT_GT(after.first, before.first - tolerance);
    EXPECT_LT(after.second, before.second + tolerance);
  }
}

// The mean gradient keeps a linear function, and flattens a maximum less than the gradient of a
// cell does.
TEST(Carried_values, follow_mean_gradients) {
  const auto sum_of_squares = [](const Position& p) {
    return 1 - (p - CGAL::ORIGIN).squared_length();
  };
  std::map<DSC::Carried_gradient, double> change;
  for (const auto gradient : {DSC::Carried_gradient::of_cell, DSC::Carried_gradient::mean})
    for (const bool is_linear : {true, false}) {
      Complex dsc = jittered_grid(6, small_meshes::ball, .35, 1);
      Vertex_values values;
      for (Vertex_handle v : dsc.vertices())
        values.set(v, is_linear ? linear(dsc.position(v)) : sum_of_squares(dsc.position(v)));
      const auto map = values.map();
      DSC::Carried_vertex_values<Complex, Vertex_values::Map> visitor(
          dsc, map, [](Cell_handle) { return true; }, gradient);
      EXPECT_GT(DSC::improve_mesh(dsc, parameters::visitor(std::ref(visitor))).smoothed, 10u);
      if (is_linear) {
        EXPECT_LT(largest_error(dsc, values), tolerance);
        continue;
      }
      for (Vertex_handle v : dsc.vertices())
        change[gradient] += values[v] - sum_of_squares(dsc.position(v));
    }
  EXPECT_LT(std::abs(change[DSC::Carried_gradient::mean]),
            .5 * std::abs(change[DSC::Carried_gradient::of_cell]));
}

// The values may be NaN.
TEST(Carried_values, may_be_vectors) {
  Complex dsc = jittered_grid(3, small_meshes::ball, .35, 1);
  const Vector velocity(1, -2, 3);
  Values<Vertex_handle, Vector> positions;
  for (Vertex_handle v : dsc.vertices())
    positions.set(v, dsc.position(v) - CGAL::ORIGIN);
  Values<Cell_handle, Vector> momenta;
  for (Cell_handle c : dsc.cells())
    momenta.set(c, velocity);
  {
    DSC::Carried_vertex_values vertices(dsc, positions.map());
    DSC::Carried_cell_averages cells(dsc, momenta.map());
    DSC::Deformation_visitor_pair both(vertices, cells);
    EXPECT_GT(number_of_changes(
                  DSC::control_detail(dsc, parameters::split_length(1.2).visitor(std::ref(both)))),
              10u);
  }
  for (Vertex_handle v : dsc.vertices())
    EXPECT_LT((dsc.position(v) - CGAL::ORIGIN - positions[v]).squared_length(),
              tolerance * tolerance);
  for (Cell_handle c : dsc.cells())
    EXPECT_LT((momenta[c] - velocity).squared_length(), tolerance * tolerance);
}

// Deformations

// Moves the vertices of the interface by random vectors up to a length.
template <class Visitor>
DSC::Deformation_report<Complex> shake(Complex& dsc, double distance, unsigned seed,
                                       Visitor& visitor) {
  Random random(seed);
  std::map<Vertex_handle, Point> destinations;
  for (Vertex_handle v : dsc.interface_vertices())
    destinations[v] = dsc.position(v) + random.vector<Complex>(distance);
  return DSC::deform_interface(
      dsc, [&](Vertex_handle v) { return destinations.at(v); },
      parameters::maximum_number_of_passes(6).visitor(std::ref(visitor)));
}

TEST(Carried_values, keep_the_integral_in_deformations) {
  for (auto label : {small_meshes::two_balls, small_meshes::eight_phases}) {
    Complex dsc = jittered_grid(6, label, .3, 1);
    Vertex_values values = linear_values(dsc);
    Cell_values averages = random_averages(dsc, 2, 0, 1);
    const double before = integral(dsc, averages);
    DSC::Improvement_report changes;
    std::size_t relabeled = 0;
    for (unsigned seed : {3, 4, 5}) {
      const auto report = carry(dsc, values, averages,
                                [&](auto& visitor) { return shake(dsc, .4, seed, visitor); });
      changes += report;
      relabeled += report.relabeled;
      EXPECT_NEAR(integral(dsc, averages), before, tolerance * before);
      EXPECT_GE(range(dsc, averages).first, 0);
    }
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_GT(changes.collapsed, 0u);
    EXPECT_GT(changes.flipped, 100u);
    EXPECT_GT(changes.smoothed, 100u);
    EXPECT_GT(relabeled, 10u);
    for (Vertex_handle v : dsc.vertices()) // bounds of the function in the box
      EXPECT_NEAR(values[v], 4, 6 + tolerance);
  }
}

// A rigid motion of everything keeps values and averages.
TEST(Carried_values, move_with_the_flow) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  Vertex_values values = linear_values(dsc);
  Cell_values averages;
  for (Cell_handle c : dsc.cells())
    averages.set(c, c->subdomain_index());
  const Vector way(.02, .01, 0);
  carry(dsc, values, averages, [&](auto& visitor) {
    return DSC::deform_interface(
        dsc, [&](Vertex_handle v) { return dsc.position(v) + way; },
        parameters::visitor(std::ref(visitor)));
  });
  for (Vertex_handle v : dsc.interface_vertices())
    EXPECT_NEAR(values[v], linear(dsc.position(v) - way), tolerance);
  EXPECT_NEAR(integral(dsc, averages, 1), 1, tolerance);
}

// Other visitors

// Counts notifications, and throws at the n-th notification.
struct Recorder : public DSC::Deformation_visitor<Complex>
{
  void record(const std::string& what) {
    if (++told[what] == limit && what == last)
      throw std::runtime_error(what);
  }
  void before_replacement(const DSC::Cavity<Complex>&) override { record("before_replacement"); }
  void after_replacement(const DSC::Cavity<Complex>&) override { record("after_replacement"); }
  void before_smoothing(Vertex_handle, const Star&, const Complex::Point&) override {
    record("before_smoothing");
  }
  void after_smoothing(Vertex_handle, const Star&) override { record("after_smoothing"); }
  void after_split(Vertex_handle, Vertex_handle, Vertex_handle) override { record("after_split"); }
  void after_insertion(Vertex_handle) override { record("after_insertion"); }
  void before_collapse(Vertex_handle, Vertex_handle) override { record("before_collapse"); }
  void after_flip(const Star&) override { record("after_flip"); }
  void after_relabel(Complex::Cell_handle, int) override { record("after_relabel"); }
  void after_topology_event(const Event&) override { record("after_topology_event"); }
  bool go_further(unsigned pass) override {
    record("go_further");
    return pass <= maximum_number_of_passes;
  }

  std::string last;
  int limit = 1;
  unsigned maximum_number_of_passes = 100;
  std::map<std::string, int> told;
};

void tell_everything(DSC::Deformation_visitor<Complex>& visitor) {
  const Complex dsc;
  const Complex::Cavity cavity(dsc);
  const Complex::Vertex_handle v;
  visitor.before_replacement(cavity);
  visitor.after_replacement(cavity);
  visitor.before_smoothing(v, {}, Complex::Point());
  visitor.after_smoothing(v, {});
  visitor.after_split(v, v, v);
  visitor.after_insertion(v);
  visitor.before_collapse(v, v);
  visitor.after_flip({});
  visitor.after_relabel({}, 1);
  visitor.after_topology_event({});
}

TEST(Visitor_pair, forwards_everything) {
  Recorder first, second;
  DSC::Deformation_visitor_pair pair(first, second);
  tell_everything(pair);
  EXPECT_TRUE(pair.go_further(1));
  EXPECT_EQ(first.told.size(), 11u);
  EXPECT_EQ(first.told, second.told);
  for (Recorder* one : {&first, &second}) {
    one->maximum_number_of_passes = 5;
    EXPECT_FALSE(pair.go_further(6)); // both visitors are asked
    one->maximum_number_of_passes = 100;
  }
  EXPECT_EQ(first.told["go_further"], 3);
  EXPECT_EQ(first.told, second.told);
}

TEST(Visitor_pair, tells_the_second_of_what_has_happened) {
  for (const std::string what : {"after_replacement", "before_replacement"}) {
    Recorder first, second;
    first.last = what;
    DSC::Deformation_visitor_pair pair(first, second);
    EXPECT_THROW(tell_everything(pair), std::runtime_error);
    EXPECT_EQ(second.told[what], what == "after_replacement" ? 1 : 0);
  }
}

TEST(Visitor, is_told_before_and_after_each_change) {
  Complex dsc = jittered_grid(4, small_meshes::two_boxes, .4, 1);
  Recorder visitor, nobody;
  DSC::Deformation_visitor_pair pair(visitor, nobody);
  auto& told = visitor.told;
  int replaced = 0, smoothed = 0;
  const auto count = [&](const DSC::Improvement_report& r) {
    EXPECT_EQ(told["after_split"], int(r.split));
    EXPECT_EQ(told["before_collapse"], int(r.collapsed));
    EXPECT_EQ(told["after_flip"], int(r.flipped));
    EXPECT_EQ(told["after_insertion"], int(r.inserted));
    replaced = int(r.split + r.collapsed + r.flipped + r.inserted);
    smoothed = int(r.smoothed);
    for (const std::string when : {"before", "after"}) {
      EXPECT_EQ(told[when + "_replacement"], replaced);
      EXPECT_EQ(told[when + "_smoothing"], smoothed);
    }
    told.clear();
  };
  count(improve("improve_mesh", dsc, pair));
  EXPECT_TRUE(replaced > 10 && smoothed > 10);
  count(improve("improve_interface", dsc, pair));
  EXPECT_TRUE(replaced > 10 && smoothed > 10);
  count(improve("control_detail of the interface", dsc, pair));
  EXPECT_GT(replaced, 10);
  const auto report = shake(dsc, .3, 2, pair);
  EXPECT_EQ(told["before_replacement"], told["after_replacement"]);
  EXPECT_EQ(told["after_relabel"], int(report.relabeled));
  EXPECT_EQ(told["before_smoothing"], told["after_smoothing"]);
  // A vertex can be relocated more than once.
  EXPECT_GE(told["after_smoothing"], int(report.smoothed + report.relocated));
}

// An exception of a visitor stops a deformation. After any exception, the maps contain averages
// again.
TEST(Visitor, may_throw_at_any_time) {
  const Complex initial = jittered_grid(4, small_meshes::two_boxes, .45, 4);
  Recorder all, nobody_else;
  {
    Complex dsc = initial;
    DSC::Deformation_visitor_pair pair(all, nobody_else);
    improve("improve_mesh", dsc, pair);
  }
  for (const std::string what : {"before_replacement", "after_replacement", "before_smoothing",
                                 "after_smoothing", "before_collapse", "after_flip"})
    for (const int limit : {1, static_cast<int>(all.told[what])}) // the first and the last call
      for (bool is_first : {true, false}) {
        SCOPED_TRACE(what);
        Complex dsc = initial;
        Cell_values averages = random_averages(dsc, 1, 1, 2);
        const double before = integral(dsc, averages);
        Recorder recorder;
        recorder.last = what;
        recorder.limit = limit;
        {
          DSC::Carried_cell_averages<Complex, Cell_values::Map> cells(dsc, averages.map());
          if (is_first) {
            DSC::Deformation_visitor_pair pair(recorder, cells);
            EXPECT_THROW(improve("improve_mesh", dsc, pair), std::runtime_error);
          } else {
            DSC::Deformation_visitor_pair pair(cells, recorder);
            EXPECT_THROW(improve("improve_mesh", dsc, pair), std::runtime_error);
          }
        }
        EXPECT_TRUE(dsc.is_valid());
        EXPECT_NEAR(integral(dsc, averages), before, tolerance * before);
        EXPECT_GT(range(dsc, averages).first, 1 - tolerance);
        EXPECT_LT(range(dsc, averages).second, 2 + tolerance);
      }
  for (const std::string what : {"before_replacement", "before_smoothing", "before_collapse"}) {
    Complex dsc = initial;
    Recorder visitor, nobody;
    visitor.last = what;
    DSC::Deformation_visitor_pair pair(visitor, nobody);
    EXPECT_THROW(improve("improve_mesh", dsc, pair), std::runtime_error);
    const bool is_changed = visitor.told["after_replacement"] + visitor.told["after_smoothing"] > 0;
    EXPECT_EQ(dsc.state() == initial.state(), !is_changed);
  }
}

} // namespace test_carried_values

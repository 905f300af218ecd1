// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves a surface by a flow that changes its topology. Counts components and the Euler
// characteristic from scratch after each step. Prints a row of a table with the changes and their
// times. Fails if the changes are not the expected ones.

#include "counts.h"
#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/number_utils.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

struct Topology
{
  long solids, outsides, euler_characteristic; // components of label 1 and of label 0

  friend bool operator==(const Topology& a, const Topology& b) {
    return std::tie(a.solids, a.outsides, a.euler_characteristic) ==
           std::tie(b.solids, b.outsides, b.euler_characteristic);
  }
  friend std::ostream& operator<<(std::ostream& out, const Topology& t) {
    return out << t.solids << ", " << t.outsides << ", " << t.euler_characteristic;
  }
};

struct Stage
{
  Topology topology;
  double time; // start of the stage
};

constexpr double any_time = std::numeric_limits<double>::quiet_NaN(); // matches all times

// Returns the position at t + dt of a point that is at p at time t. It is a map and not a velocity,
// because the flows stop at an axis or a plane, which an integration step would cross.
using Flow = std::function<Point(const Point& p, double t, double dt)>;

struct Scenario
{
  Surface surface;
  Flow flow; // the speed is at most one, so times are distances
  std::vector<Stage> stages;
  std::vector<std::string> events;
  double end; // time limit for all stages
};

// Moves towards the x axis with a speed that depends on x.
Flow to_axis(const std::function<double(double)>& speed) {
  return [speed](const Point& p, double, double dt) {
    const double r = std::hypot(p.y(), p.z());
    const double scale = r > 0 ? (std::max)(0., 1 - speed(p.x()) * dt / r) : 0.;
    return Point(p.x(), scale * p.y(), scale * p.z());
  };
}

// The hole of radius 0.4 closes when the displacement reaches its radius.
Scenario shrinking_torus(std::size_t n) {
  static constexpr double tube_radius = .6;
  return {torus(tube_radius, n),
          to_axis([](double) { return 1.; }),
          {{{1, 1, 0}, 0}, {{1, 1, 2}, 1 - tube_radius}},
          {},
          .8};
}

// Pinched in the middle.
Scenario pinched_dumbbell(std::size_t n) {
  const auto bump = [](double x) {
    const double y = 1 - 4 * x * x;
    return y > 0 ? y * y : 0.;
  };
  return {dumbbell(n),
          to_axis(bump),
          {{{1, 1, 2}, 0}, {{2, 1, 4}, dumbbell_bar_radius}},
          {"label 1 split 1 → 2"},
          .5};
}

// A hollow ball whose walls contract around x = 0, first where y > 0 and z = 0, last on the
// opposite side. The tear runs around both ways until two cups are left.
Scenario shell(std::size_t n) {
  static constexpr double inner_radius = .8, middle = (1 + inner_radius) / 2, half = 1 - middle;
  static constexpr double width = .3, decay = 1;
  Surface surface = sphere(1, n);
  append(surface, sphere(inner_radius, n));
  const Flow tear = [](const Point& p, double, double dt) {
    const auto from_center = p - CGAL::ORIGIN;
    const double r = std::sqrt(from_center.squared_length());
    const double speed =
        std::exp(-p.x() * p.x() / (width * width) - decay * std::abs(std::atan2(p.z(), p.y())));
    const double left = (std::max)(0., std::abs(r - middle) - speed * dt);
    return CGAL::ORIGIN + (middle + std::copysign(left, r - middle)) / r * from_center;
  };
  return {surface,
          tear,
          {{{1, 2, 4}, 0}, {{1, 1, 2}, half}, {{2, 1, 4}, any_time}},
          {"label 0 merged 2 → 1", "label 1 split 1 → 2"},
          half * std::exp(decay * CGAL_PI) + .3};
}

// A ball is pinched along the plane x = 0 until it splits. The halves move apart, and the reversed
// flow moves them back until they merge. Pinching and separation alternate: a reversed simultaneous
// motion would flatten the tips of the halves to disks that meet everywhere at once.
Scenario split(std::size_t n) {
  static constexpr double pinched = 1.15, parted = 1.35;
  const Flow pinch = to_axis([](double x) { return std::exp(-4 * x * x); });
  const Flow flow = [pinch](const Point& p, double t, double dt) {
    if (t < pinched)
      return pinch(p, t, dt);
    const double way = t < parted ? dt : -dt;
    return Point(std::copysign((std::max)(0., std::abs(p.x()) + way), p.x()), p.y(), p.z());
  };
  return {sphere(1, n),
          flow,
          {{{1, 1, 2}, 0}, {{2, 1, 4}, 1}, {{1, 1, 2}, any_time}},
          {"label 1 split 1 → 2", "label 1 merged 2 → 1"},
          2.2};
}

std::string to_string(const DSC::Component_event& event) {
  static constexpr const char* kinds[] = {"merged", "split", "vanished", "appeared"};
  return "label " + std::to_string(event.label) + ' ' + kinds[static_cast<int>(event.kind)] + ' ' +
         std::to_string(event.before.size()) + " → " + std::to_string(event.after.size());
}

// Returns the stages, and whether all counts equal those of the complex.
class Observer
{
public:
  explicit Observer(const Complex& complex) { observe(complex, 0); }

  const Topology& observe(const Complex& complex, double t) {
    const Topology now = {components(complex, 1), components(complex, 0),
                          euler_characteristic(complex)};
    if (m_stages.empty() || !(m_stages.back().topology == now))
      m_stages.push_back({now, t});
    m_is_right =
        m_is_right && check(complex) &&
        now == Topology{long(complex.number_of_components(1)),
                        long(complex.number_of_components(0)), complex.euler_characteristic(1)};
    return m_stages.back().topology;
  }

  const std::vector<Stage>& stages() const { return m_stages; }

  // Returns whether the stages are the expected ones and in time.
  bool is_right(const std::vector<Stage>& expected, double tolerance) const {
    const auto is_same = [tolerance](const Stage& a, const Stage& b) {
      return a.topology == b.topology && !(std::abs(a.time - b.time) > tolerance);
    };
    return m_is_right &&
           std::equal(m_stages.begin(), m_stages.end(), expected.begin(), expected.end(), is_same);
  }

private:
  std::vector<Stage> m_stages;
  bool m_is_right = true;
};

template <class Range, class Print>
void print_list(const Range& range, const char* separator, const Print& print) {
  const char* before = "";
  for (const auto& item : range) {
    std::cout << before;
    print(item);
    before = separator;
  }
  std::cout << " | ";
}

// Steps of a quarter of a mean edge, and four more steps after the last stage, which must not
// change the topology.
int run(const std::string& name, const Scenario& scenario, bool prints_steps) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{scenario.surface}, CGAL::Tetgen_tetrahedralizer_3());
  const double edge = complex.mean_interface_edge(), dt = edge / 4;
  const std::size_t triangles = complex.interface_facets().size();
  Observer observer(complex);
  std::vector<std::string> events;
  std::size_t steps = 0, steps_at_end = 0, incomplete = 0;
  const double begin = processor_seconds();
  for (; double(steps) * dt < scenario.end && steps_at_end < 4; ++steps) {
    const auto report = DSC::advect_interface(complex, scenario.flow, double(steps) * dt, dt,
                                              parameters::manifold_interface(true));
    const double t = double(steps + 1) * dt;
    const Topology& topology = observer.observe(complex, t);
    incomplete += report.complete ? 0 : 1;
    steps_at_end += observer.stages().size() >= scenario.stages.size();
    if (prints_steps)
      std::cerr << "t = " << t << ": " << topology << "; unfinished " << report.unfinished.size();
    for (const auto& event : report.events) {
      events.push_back(to_string(event));
      if (prints_steps)
        std::cerr << "; " << events.back() << " at " << event.where;
    }
    if (prints_steps)
      std::cerr << '\n';
  }
  const double seconds = processor_seconds() - begin;
  const bool is_right = observer.is_right(scenario.stages, edge) && events == scenario.events;

  std::cout.precision(4);
  std::cout << "| " << name << " | " << triangles << " | " << edge << " | " << steps << " | ";
  print_list(observer.stages(), " → ", [](const Stage& s) { std::cout << s.topology; });
  print_list(observer.stages(), ", ", [](const Stage& s) { std::cout << s.time; });
  print_list(scenario.stages, ", ",
             [](const Stage& s) { std::isnan(s.time) ? std::cout << "–" : std::cout << s.time; });
  print_list(events, "; ", [](const std::string& event) { std::cout << event; });
  std::cout << incomplete << " | " << (is_right ? "yes" : "**no**") << " | " << seconds << " |"
            << std::endl;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  using namespace dsc_benchmark;
  CLI::App app("Moves a surface by a flow that changes its topology.");
  const std::map<std::string, Scenario (*)(std::size_t)> scenarios = {
      {"torus", shrinking_torus},
      {"dumbbell", pinched_dumbbell},
      {"shell", shell},
      {"split", split}};
  std::string name;
  std::size_t n = 10;
  bool prints_steps = false;
  app.add_option("scenario", name)->required()->check(CLI::IsMember(&scenarios));
  app.add_option("-n", n, "resolution; edges are about 1.2 / n long")->check(CLI::Range(4, 100));
  app.add_flag("--steps", prints_steps, "a line for each step, on the error stream");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(name, scenarios.at(name)(n), prints_steps);
  } catch (const std::exception& error) {
    std::cerr << "topology_changes: " << name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Deforms small complexes in the plane and on a flat torus, of 2 and of 5 labels, by random fields
// under all kinds of topology control. Checks after each deformation that the complex is valid,
// that its cells fill the domain, and that forbidden changes of topology did not happen.

#include "Worst_cells.h"
#include "time_limit.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/advect_interface.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace time_limit = dsc_benchmark::time_limit;

namespace {

using namespace CGAL::Deformable_simplicial_complexes;
using Planar = CGAL::Deformable_simplicial_complex_2<>;
using Torus = CGAL::Deformable_simplicial_complex_2<CGAL::Epick, CGAL::Default, Torus_domain<2>>;
using Point = Planar::Point_2;
using Vector = Planar::Vector_2;
using Field = std::vector<Vector>; // displacements in the order of `interface_vertices()`

constexpr double size = 2; // side length of the domains

class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  // The distributions of the standard library differ between implementations, so they are not used.
  double number(double minimum, double maximum) {
    return minimum + (maximum - minimum) * std::ldexp(double(m_engine() >> 11), -53);
  }

  Vector vector(double bound) {
    const double x = number(-bound, bound);
    return {x, number(-bound, bound)};
  }

  // Waves, noise, or a translation of everything.
  template <class Complex> Field field(const Complex& complex) {
    const auto vertices = complex.interface_vertices();
    const double amplitude = 3 * complex.mean_interface_edge() * number(0, 1), kind = number(0, 1);
    Field result(vertices.size(), Vector(0, 0));
    if (kind < .45) {
      for (int wave = 0; wave < 3; ++wave) {
        const Vector direction = vector(amplitude / 2), number_of_waves = vector(CGAL_PI);
        const double phase = number(0, 2 * CGAL_PI);
        for (std::size_t i = 0; i < result.size(); ++i)
          result[i] =
              result[i] +
              std::sin(number_of_waves * (complex.position(vertices[i]) - CGAL::ORIGIN) + phase) *
                  direction;
      }
    } else if (kind < .9) {
      for (Vector& v : result)
        v = vector(amplitude);
    } else {
      result.assign(result.size(), vector(amplitude));
    }
    return result;
  }

private:
  std::mt19937_64 m_engine;
};

// Returns the components and the Euler characteristic (V - E + F) of each label.
using Topology = std::map<int, std::pair<std::size_t, int>>;

template <class Complex> Topology topology(const Complex& complex) {
  Topology result;
  std::set<std::pair<int, typename Complex::Vertex_handle>> vertices;
  for (const auto c : complex.cells()) {
    const int label = complex.label(c);
    auto& [components, characteristic] = result[label];
    components = complex.number_of_components(label);
    ++characteristic;
    for (int i = 0; i < 3; ++i) {
      characteristic += vertices.emplace(label, c->vertex(i)).second;
      const auto d = c->neighbor(i);
      const bool is_shared = !complex.is_infinite(d) && complex.label(d) == label;
      characteristic -= !is_shared || c->time_stamp() < d->time_stamp();
    }
  }
  return result;
}

struct Counts
{
  std::size_t fields = 0, refused = 0, complete = 0, incomplete = 0, restarts = 0, relabeled = 0,
              exchanges = 0, merged = 0, split = 0, vanished = 0;
  dsc_benchmark::Worst_cells worst_cells;
};

void require(bool condition, const char* message) {
  if (!condition)
    throw std::runtime_error(message);
}

template <class Complex> class Victim
{
public:
  Victim(const Complex& initial, Random& random)
      : m_initial(initial), m_complex(initial), m_random(random) {}

  // All combinations of options in turn as the number increases.
  void deform(std::size_t number, Counts& counts) {
    const auto choose = [&](std::size_t choices) {
      const std::size_t digit = number % choices;
      number /= choices;
      return digit;
    };
    const std::size_t control = choose(3);
    const auto allows = [&](const Complex& complex, typename Complex::Cell_handle c, int) {
      return control == 0 || (control == 1 && complex.position(c->vertex(0)).x() > 0);
    };
    const auto np = CGAL::parameters::scheme(Integration_scheme::euler)
                        .topology_control(allows)
                        .maximum_number_of_passes(choose(2) == 0 ? 20 : 3)
                        .manifold_interface(choose(2) == 1)
                        .collision_order(choose(2) == 1)
                        .relabeling_threshold(choose(2) == 0 ? .01 : .1)
                        .minimum_angle(choose(2) == 0 ? 5. : 0.);
    Field field = m_random.field(m_complex);
    const bool is_bad = m_random.number(0, 1) < .02;
    if (is_bad)
      field[std::size_t(m_random.number(0, double(field.size())))] =
          Vector(std::numeric_limits<double>::quiet_NaN(), 0);
    const auto velocity = [&](const auto&, const std::vector<Point>&, double, Field& velocities) {
      velocities = field;
    };
    const Topology before = topology(m_complex);
    ++counts.fields;
    try {
      const auto report = DSC::advect_interface(m_complex, velocity, 0., 1., np);
      require(!is_bad, "a destination that is not finite was accepted");
      ++(report.complete ? counts.complete : counts.incomplete);
      counts.relabeled += report.relabeled;
      counts.exchanges += report.exchanges.size();
      counts.worst_cells.add(m_complex, report);
      for (const auto& label : report.labels) {
        counts.merged += label.merged;
        counts.split += label.split;
        counts.vanished += label.vanished;
      }
    } catch (const Invalid_destination_error&) {
      require(is_bad, "a destination that is finite was refused");
      ++counts.refused;
    }
    require(m_complex.is_valid(), "the complex is invalid");
    require(control != 2 || topology(m_complex) == before, "a change of topology was not granted");
    double area = 0;
    for (const int label : m_complex.labels())
      area += m_complex.area(label);
    require(std::abs(area - size * size) < 1e-10, "the domain is not filled");
    if (4 * m_complex.interface_vertices().size() < m_initial.interface_vertices().size() ||
        m_complex.labels() != m_initial.labels()) {
      m_complex = m_initial;
      ++counts.restarts;
    }
  }

private:
  const Complex m_initial;
  Complex m_complex;
  Random& m_random;
};

template <class Complex>
void abuse(const std::string& name, const Complex& initial, std::size_t number_of_fields,
           Random& random) {
  Counts c;
  Victim<Complex> victim(initial, random);
  for (std::size_t i = 0; i < number_of_fields; ++i) {
    time_limit::begin(name + ", field " + std::to_string(i));
    victim.deform(i, c);
  }
  time_limit::end();
  std::cout << "| " << name;
  for (std::size_t count : {c.fields, c.refused, c.complete, c.incomplete, c.restarts, c.relabeled,
                            c.exchanges, c.merged, c.split, c.vanished})
    std::cout << " | " << count;
  std::cout << " | " << c.worst_cells << " |\n";
}

// A ring with a disk inside; or three disks of different labels between two layers of another
// label.
int two_labels(const Point& p) {
  const double r = std::hypot(p.x() - 1, p.y() - 1);
  return r < .25 || (r > .45 && r < .8) ? 1 : 0;
}
int five_labels(const Point& p) {
  for (int i = 0; i < 3; ++i)
    if (std::hypot(p.x() - .5 - .5 * i, p.y() - 1) < .24)
      return i + 1;
  return std::abs(p.y() - 1) > .3 && std::abs(p.y() - 1) < .6 ? 4 : 0;
}

void run(std::size_t number_of_fields, std::uint64_t seed) {
  static constexpr double edge = .1;
  Random random(seed);
  std::cout
      << "| domain, labels | fields | refused | complete | incomplete | restarts | relabeled | "
         "exchanges | merged | divided | vanished | worst quality | fields with cells below the "
         "floor | most cells |\n"
         "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
         "---: | ---: |\n";
  for (const auto& [labels, label_at] :
       {std::make_pair("2", two_labels), std::make_pair("5", five_labels)}) {
    abuse(std::string("plane, ") + labels,
          DSC::make_deformable_simplicial_complex_2<Planar>(CGAL::Bbox_2(0, 0, size, size), edge,
                                                            label_at),
          number_of_fields / 4, random);
    abuse(std::string("torus, ") + labels,
          DSC::fill_torus<Torus>(Torus_domain<2>({size, size}), edge, label_at),
          number_of_fields / 4, random);
  }
  std::cout << "\nEvery state was valid.\n";
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Deforms small complexes of the plane and of a torus at random.");
  std::size_t number_of_fields = 10000;
  std::uint64_t seed = 1;
  app.add_option("--fields", number_of_fields, "number of displacement fields");
  app.add_option("--seed", seed, "of the random numbers");
  CLI11_PARSE(app, argc, argv);
  try {
    run(number_of_fields, seed);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "random_abuse_2: " << time_limit::operation << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Deforms small complexes by random displacement fields under all policies in turn. Checks that the
// complexes stay valid, that each deformation terminates, and that topology changes only as the
// policy permits. The output and the files depend only on the number of fields and on the seed.
// Compare them between runs, with other numbers of threads, and without address space randomization
// (`setarch -R`).

#include "Worst_cells.h"
#include "betti_numbers.h"
#include "measures.h"
#include "random_fields.h"
#include "small_meshes.h"
#include "time_limit.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Mesh_files/checkpoint.h>

#include <CLI/CLI.hpp>
#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace time_limit = dsc_benchmark::time_limit;

namespace {

using dsc_benchmark::Complex;
using dsc_benchmark::Field;
using dsc_benchmark::Point;
using dsc_benchmark::Random_fields;
using Report = DSC::Deformation_report<Complex>;
using Topology_control = std::function<bool(const Complex&, Complex::Cell_handle, int)>;
namespace parameters = CGAL::parameters;

// Options of a deformation.
struct Policy
{
  std::string name; // the columns of the table for the policies that change topology
  Topology_control topology_control;
  unsigned maximum_number_of_passes;
  bool manifold_interface, collision_order;
  unsigned number_of_threads;

  // All combinations in turn as the number increases; each option is a digit of the number.
  static Policy decode(std::size_t number, unsigned threads) {
    using namespace CGAL::Deformable_simplicial_complexes;
    static const std::pair<const char*, Topology_control> controls[] = {
        {"allow", Allow_topology_changes()},
        {"forbid", Forbid_topology_changes()},
        {"labels 1, 3", Allow_topology_changes_between({std::pair<int, int>(1, 3)})},
        {"right half", [](const Complex& complex, Complex::Cell_handle c, int) {
           return complex.position(c->vertex(0)).x() > 0;
         }}};
    const auto choose = [&](std::size_t choices) {
      const std::size_t digit = number % choices;
      number /= choices;
      return digit;
    };
    Policy policy;
    const auto& [name, control] = controls[choose(std::size(controls))];
    policy.topology_control = control;
    policy.maximum_number_of_passes = choose(2) == 0 ? 20 : 3;
    policy.manifold_interface = choose(2) == 1;
    policy.collision_order = choose(2) == 1;
    policy.number_of_threads = choose(2) == 0 ? threads : 1;
    policy.name = std::string(name) + (policy.manifold_interface ? " | manifold" : " | any");
    return policy;
  }
};

// The CRC-32 of all previous states, as a checkpoint would store them.
class Checksum
{
public:
  void add(const Complex::State& state) {
    namespace internal = CGAL::Deformable_simplicial_complexes::internal;
    const std::string bytes =
        std::apply([](const auto&... members) { return internal::encoded(members...); },
                   internal::members(state));
    m_crc.process_bytes(bytes.data(), bytes.size());
  }
  std::uint32_t value() const { return m_crc.checksum(); }

private:
  boost::crc_32_type m_crc;
};

struct Counts
{
  std::size_t fields = 0, refused = 0, complete = 0, incomplete = 0, restarts = 0;
  std::size_t split = 0, collapsed = 0, flipped = 0, relabeled = 0;
  std::size_t merged_components = 0, split_components = 0, vanished_components = 0;
  dsc_benchmark::Worst_cells worst_cells;

  void add(const Report& report) {
    ++(report.complete ? complete : incomplete);
    split += report.split;
    collapsed += report.collapsed;
    flipped += report.flipped;
    relabeled += report.relabeled;
    for (const auto& label : report.labels) {
      merged_components += label.merged;
      split_components += label.split;
      vanished_components += label.vanished;
    }
  }
};

// A complex that is deformed repeatedly, and the properties that must hold after each deformation.
class Victim
{
public:
  explicit Victim(const Complex& initial) : m_initial(initial) { restart(); }

  const Complex& complex() const { return m_complex; }

  void restart() {
    m_complex = m_initial;
    m_topology = betti_numbers::of_complex(m_complex);
  }

  // Returns whether a label or most of the interface has vanished.
  bool is_worn() const {
    return 4 * m_complex.interface_vertices().size() < m_initial.interface_vertices().size() ||
           m_complex.labels() != m_initial.labels();
  }

  void deform(const Field& field, const Policy& policy, Counts& counts) {
    std::set<int> granted; // labels whose topology may change
    const auto control = [&](const Complex& complex, Complex::Cell_handle c, int label) {
      const bool is_granted = policy.topology_control(complex, c, label);
      if (is_granted)
        granted.insert({c->subdomain_index(), label});
      return is_granted;
    };
    const Report report = advect(field, policy, control);
    counts.add(report);
    counts.worst_cells.add(m_complex, report);
    require(dsc_benchmark::check(m_complex), "the complex is invalid");
    const auto topology = betti_numbers::of_complex(m_complex);
    require(differ_only_in(granted, m_topology, topology), "a change of topology was not granted");
    m_topology = topology;
  }

  void refuse(const Field& bad_field, const Policy& policy) {
    const Complex::State before = m_complex.state();
    bool is_refused = false;
    try {
      advect(bad_field, policy, policy.topology_control);
    } catch (const CGAL::Deformable_simplicial_complexes::Invalid_destination_error&) {
      is_refused = true;
    }
    require(is_refused, "a destination that is not finite was accepted");
    require(m_complex.state() == before, "a deformation was refused, but not without a change");
    require(dsc_benchmark::check(m_complex), "the complex is invalid");
  }

private:
  static void require(bool condition, const char* message) {
    if (!condition)
      throw std::runtime_error(message);
  }

  Report advect(const Field& field, const Policy& policy, const Topology_control& control) {
    using CGAL::Deformable_simplicial_complexes::Integration_scheme;
    const auto velocity = [&](const DSC::Interface_snapshot<Complex>&, const std::vector<Point>&,
                              double, Field& velocities) { velocities = field; };
    return DSC::advect_interface(m_complex, velocity, 0., 1.,
                                 parameters::scheme(Integration_scheme::euler)
                                     .topology_control(control)
                                     .maximum_number_of_passes(policy.maximum_number_of_passes)
                                     .manifold_interface(policy.manifold_interface)
                                     .collision_order(policy.collision_order)
                                     .number_of_threads(policy.number_of_threads));
  }

  const Complex m_initial;
  Complex m_complex;
  betti_numbers::Topology m_topology;
};

void print(const std::string& mesh, const std::string& policy, const Counts& c, std::ostream& out) {
  out << "| " << mesh << " | " << policy;
  for (std::size_t count :
       {c.fields, c.refused, c.complete, c.incomplete, c.restarts, c.split, c.collapsed, c.flipped,
        c.relabeled, c.merged_components, c.split_components, c.vanished_components})
    out << " | " << count;
  out << " | " << c.worst_cells << " |\n";
}

// Prints the rows of a mesh and returns its last complex.
Complex abuse(const std::string& mesh, const Complex& initial, std::size_t number_of_fields,
              unsigned threads, Random_fields& fields, Checksum& checksum, std::ostream& out) {
  std::map<std::string, Counts> counts; // by policy
  Victim victim(initial);
  for (std::size_t i = 0; i < number_of_fields; ++i) {
    const Policy policy = Policy::decode(i, threads);
    time_limit::begin(mesh + ", field " + std::to_string(i) + ", " + policy.name);
    Counts& c = counts[policy.name];
    ++c.fields;
    Field field = fields(victim.complex());
    if (fields.spoil(field)) {
      victim.refuse(field, policy);
      ++c.refused;
    } else {
      victim.deform(field, policy, c);
    }
    checksum.add(victim.complex().state());
    if (victim.is_worn()) {
      victim.restart();
      ++c.restarts;
    }
  }
  time_limit::end();
  for (const auto& [policy, c] : counts)
    print(mesh, policy, c, out);
  return victim.complex();
}

void run(std::size_t number_of_fields, std::uint64_t seed, unsigned threads,
         const std::string& checkpoint) {
  using namespace small_meshes;
  const std::pair<const char*, Complex> meshes[] = {
      {"ball", make_complex(grid(6, ball))},
      {"quadrants", make_complex(grid(6, four_phases))},
      {"octants", make_complex(grid(6, eight_phases))}};
  Random_fields fields(seed);
  Checksum checksum;
  std::ostringstream out;
  out << "| mesh | topology | interface | fields | refused | complete | incomplete | restarts | "
         "split "
         "| collapsed | flipped | relabeled | merged | divided | vanished | worst quality | fields "
         "with cells below the floor | most cells |\n"
         "| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: "
         "| ---: | ---: | ---: | ---: | ---: |\n";
  Complex last;
  std::size_t done = 0, left = std::size(meshes);
  for (const auto& [name, initial] : meshes) {
    const std::size_t n = (number_of_fields - done) / left--;
    last = abuse(name, initial, n, threads, fields, checksum, out);
    done += n;
  }
  out << "\nEvery state was valid. CRC-32 of all states: " << std::hex << checksum.value() << '\n';
  std::cout << out.str();
  if (!checkpoint.empty())
    CGAL::IO::write_checkpoint(checkpoint, last.state(), out.str());
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Deforms small complexes at random and checks that they stay valid.");
  std::size_t number_of_fields = 10000;
  std::uint64_t seed = 1;
  unsigned threads = 2;
  std::string checkpoint;
  app.add_option("--fields", number_of_fields, "number of displacement fields");
  app.add_option("--seed", seed, "of the random numbers");
  app.add_option("--threads", threads, "number of threads where a policy uses several");
  app.add_option("--checkpoint", checkpoint, "a file for the last complex and what is printed");
  CLI11_PARSE(app, argc, argv);
  try {
    run(number_of_fields, seed, threads, checkpoint);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "random_abuse: " << time_limit::operation << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

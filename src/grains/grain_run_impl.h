// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_RUN_IMPL_H
#define DSC_GRAIN_RUN_IMPL_H

#include "Grain_run.h"
#include "output/step_folder.h"
#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/Grain_orientations.h>
#include <CGAL/Interface_flows/Voronoi_labels.h>
#include <CGAL/Interface_flows/grain_statistics.h>
#include <CGAL/Interface_remeshing/remove_components.h>
#include <CGAL/Interface_remeshing/shared_measures.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/SVG_2.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace dsc {

/// Writes the states of a run, with the misorientations of the facets of the interface, and a
/// checkpoint of the last one.
class Grain_files
{
public:
  /// \throws Input_error if nothing can be written in the folder, or if it contains a run
  explicit Grain_files(const Grain_run& run) : m_run(run) {
    if (!run.output.empty())
      m_folder.emplace(run.output);
  }

  /// Writes a state unless it is written already.
  template <class Complex>
  void write(const Complex& complex, const Grain_state& state,
             const DSC::Grain_orientations<Complex::dimension>& orientations) {
    if (!m_folder || m_last == state.step)
      return;
    m_last = state.step;
    DSC::Mesh_arrays arrays;
    arrays.cells.push_back({"misorientation", "Float64", 1, {}});
    static constexpr double none = -1; // at particles, which have no orientation
    for (const auto& facet : complex.interface_facets()) {
      const int a = facet.first->subdomain_index(),
                b = facet.first->neighbor(facet.second)->subdomain_index();
      arrays.cells.back().values.push_back(
          (std::min)(a, b) == particle_label ? none : orientations.misorientation(a, b) / degree);
    }
    m_folder->require();
    // The most precious file comes first, because the disk may be full.
    CGAL::IO::write_checkpoint(m_folder->file("checkpoint.dsc"), complex.state(),
                               Json{{"grains", to_json(m_run)},
                                    {"time", state.time},
                                    {"step", state.step},
                                    {"energy_before", state.energy_before}}
                                   .dump());
    m_folder->write(complex, state.step, state.time, arrays);
  }

  /// \throws Input_error if the folder no longer belongs to this run
  void require() const {
    if (m_folder)
      m_folder->require();
  }

private:
  const Grain_run& m_run;
  std::optional<Step_folder> m_folder; // none if nothing is written
  std::optional<unsigned> m_last;      // step of the last state
};

/// Compares the growth of grains with the law for unit tension and mobility: a regression through
/// the origin.
template <class Complex> class Growth_law
{
public:
  using Statistics = std::vector<DSC::Grain_statistics>;

  /// Takes the statistics before a step.
  void begin(const Complex& complex) { m_before = grain_statistics(complex); }

  /// Adds the rates of growth in a step; in the plane, of the grains whose numbers of corners have
  /// not changed. Mean rates are those of grains that touch no side.
  void end(const Complex& complex, double dt) {
    std::map<int, DSC::Grain_statistics> after;
    for (const auto& grain : grain_statistics(complex))
      after.emplace(grain.label, grain);
    for (const auto& grain : m_before)
      if (const auto found = after.find(grain.label);
          found != after.end() && found->second.corners == grain.corners &&
          found->second.right_angles == grain.right_angles)
        add(grain, (found->second.measure - grain.measure) / dt);
  }

  /// Writes the slope, the correlation and the mean rates.
  void write(Grain_result& result) const {
    result.slope = m_xx > 0 ? m_xy / m_xx : 0;
    result.correlation = m_xx > 0 && m_yy > 0 ? m_xy / std::sqrt(m_xx * m_yy) : 0;
    result.rates = m_rates;
  }

private:
  static constexpr int d = Complex::dimension;

  void add(const DSC::Grain_statistics& grain, double rate) {
    const double x = grain.growth(d);
    m_xx += x * x;
    m_xy += x * rate;
    m_yy += rate * rate;
    if (d == 2 && grain.right_angles == 0) {
      m_rates[grain.corners].sum += rate;
      ++m_rates[grain.corners].number;
    }
  }

  Statistics m_before;
  double m_xx = 0, m_xy = 0, m_yy = 0;
  std::map<std::size_t, Grain_rate> m_rates;
};

/// Returns the radius of the particles of a run.
template <int d> double particle_radius(const Grain_run& run) {
  return run.particle_radius * std::pow(double(run.number), -1. / d);
}

/// Balls of the same radius at random places of a torus or a box of size 1, apart from each other
/// and from the sides of the box.
/// \tparam d the dimension
template <int d> class Particles
{
public:
  /// \throws Input_error if there is no room
  explicit Particles(const Grain_run& run)
      : m_radius(particle_radius<d>(run)), m_is_periodic(run.is_periodic) {
    static constexpr double apart = 3, margin = 1.5;   // radii from another center, from a side
    static constexpr std::size_t most_attempts = 1000; // for each particle
    std::mt19937 random(run.seed + 1);                 // not the sequence of the grains
    const double begin = run.is_periodic ? 0 : margin * m_radius;
    std::size_t attempts = 0; // since the last particle
    while (m_centers.size() < run.particles) {
      if (++attempts > most_attempts || apart * m_radius >= 1)
        throw Input_error("there is no room for the particles; choose fewer or smaller ones");
      Center p;
      for (double& x : p)
        x = begin + (1 - 2 * begin) * (random() / 4294967296.);
      if (std::none_of(m_centers.begin(), m_centers.end(),
                       [&](const Center& q) { return distance(p, q) < apart * m_radius; })) {
        m_centers.push_back(p);
        attempts = 0;
      }
    }
  }

  /// Returns whether a point is in a particle.
  template <class Point> bool contain(const Point& p) const {
    const Center x = DSC::coordinates_of<d>(p);
    return std::any_of(m_centers.begin(), m_centers.end(),
                       [&](const Center& q) { return distance(x, q) < m_radius; });
  }

private:
  using Center = std::array<double, d>;

  double distance(const Center& p, const Center& q) const {
    double result = 0;
    for (int axis = 0; axis < d; ++axis) {
      double x = std::abs(p[axis] - q[axis]);
      if (m_is_periodic)
        x = (std::min)(x, 1 - x);
      result += x * x;
    }
    return std::sqrt(result);
  }

  double m_radius;
  bool m_is_periodic;
  std::vector<Center> m_centers;
};

/// Adds the misorientations and the measures of the grain boundaries to a result, without the
/// surfaces of particles.
template <class Complex>
void measure_boundaries(const Complex& complex,
                        const DSC::Grain_orientations<Complex::dimension>& orientations,
                        Grain_result& result) {
  for (const auto& [labels, area] : DSC::shared_measures(complex)) {
    if (labels.first == particle_label)
      continue;
    result.misorientations.push_back(orientations.misorientation(labels.first, labels.second) /
                                     degree);
    result.areas.push_back(area);
  }
}

/// Returns the greatest length of edges in a run, so that edges resolve particles.
template <int d> double longest_edge(const Grain_run& run) {
  static constexpr double edges_of_radius = 2;
  return run.particles > 0 ? particle_radius<d>(run) / edges_of_radius
                           : (std::numeric_limits<double>::max)();
}

/// Returns the options of the growth of a run.
template <int d> DSC::Grain_growth_options growth_options(const Grain_run& run) {
  DSC::Grain_growth_options result;
  result.edges_of_grain = run.edges;
  result.step = run.step;
  result.fastest = run.energy.fastest();
  result.longest_edge = longest_edge<d>(run);
  result.number_of_threads = run.threads;
  return result;
}

/// Lets grains grow, see `grow_grains()`.
/// \param state the state at the beginning
template <class Complex>
Grain_result grow_grains(const Grain_run& run, Grain_files& files, const Complex& complex,
                         DSC::Grain_growth<Complex>& growth,
                         const DSC::Grain_orientations<Complex::dimension>& orientations,
                         Grain_state state, const std::function<void(const Grain_state&)>& on) {
  using namespace DSC;
  static constexpr int d = Complex::dimension;
  const Interface_energy& energy = growth.energy();
  const bool has_law = run.energy.kind == Grain_energy::Kind::isotropic && run.particles == 0;
  const unsigned first = state.step;
  const auto measure = [&] {
    state.time = growth.time();
    state.energy = energy(complex);
    const auto labels = complex.labels();
    state.grains =
        labels.size() - std::size_t(std::count(labels.begin(), labels.end(), particle_label));
    state.cells = complex.number_of_cells();
  };
  const auto tell = [&] {
    if (state.step % run.every == 0)
      files.write(complex, state, orientations);
    on(state);
  };
  measure();
  if (run.resume.empty())
    state.energy_before = state.energy;
  tell();

  // The rates of the law hold after the angles at junctions have settled. In space, the statistics
  // of all cells take time, so they are not computed in each step.
  static constexpr double settled = .5; // time in squares of an edge
  static constexpr unsigned interval = d == 2 ? 1 : 5;
  Growth_law<Complex> law;
  // Few grains can become strips around the torus, which do not move.
  static constexpr double still = 1e-6; // relative decrease of the energy in such a time
  const auto steps_of_edge = unsigned(std::ceil(1 / run.step)); // time of a squared edge
  static constexpr double rounding = 1e-9;
  // The law does not hold for grains around the torus, which few grains form.
  static constexpr std::size_t fewest = 20;
  bool moves = true;
  const auto goal = std::size_t(std::ceil(run.until * double(run.number) - rounding));
  while (state.grains > (std::max)(goal, std::size_t(1)) && moves &&
         (run.steps == 0 || state.step - first < run.steps)) {
    const bool compares = has_law && state.grains >= (std::min)(fewest, run.number) &&
                          state.step * run.step > settled && state.step % interval == 0;
    if (compares)
      law.begin(complex);
    const auto report = growth.advance();
    ++state.step;
    state.removed = report.removed.size();
    state.unfinished = report.deformation.unfinished.size();
    if (compares && report.removed.empty()) // no grain got another one
      law.end(complex, report.dt);
    measure();
    if (state.step % steps_of_edge == 0) {
      moves = state.energy_before - state.energy > still * state.energy_before;
      state.energy_before = state.energy;
    }
    tell();
  }
  files.write(complex, state, orientations);
  Grain_result result;
  for (const auto& grain : grain_statistics(complex))
    if (grain.label != particle_label)
      result.grains.push_back(grain);
  law.write(result);
  measure_boundaries(complex, orientations, result);
  return result;
}

/// Returns the grains at the beginning of a run, in a complex that `make(edge, labels)` makes.
template <class Complex, class Make>
Complex first_grains(const Grain_run& run, const DSC::Interface_energy& energy, const Make& make) {
  using namespace DSC;
  static constexpr int d = Complex::dimension;
  std::array<double, d> sides;
  sides.fill(1);
  const Voronoi_labels<Complex> grains(run.number, sides, run.is_periodic, run.seed);
  const double edge =
      (std::min)(longest_edge<d>(run), std::pow(double(run.number), -1. / d) / run.edges);
  if (run.particles == 0) {
    Complex result = make(edge, grains);
    keep_largest_components(result, energy);
    return result;
  }
  // The interface is fitted to the particles before the grains get their labels, so that particles
  // are round.
  using Point = typename Complex::Point;
  const Particles<d> particles(run);
  Complex result =
      make(edge, [&](const Point& p) { return particles.contain(p) ? particle_label : 1; });
  for (auto c : result.cells())
    if (c->subdomain_index() != particle_label) {
      const Point first = result.position(c->vertex(0));
      auto middle = first;
      for (int i = 1; i <= d; ++i)
        middle = middle + (result.position_near(first, c->vertex(i)) - first) / (d + 1);
      result.relabel(c, grains(result.domain().canonical(middle)));
    }
  keep_largest_components(result, energy, nullptr,
                          [](int label) { return label != particle_label; });
  return result;
}

/// Returns the result of a run.
template <class Complex, class Make>
Grain_result grow_grains(const Grain_run& run, const Make& make,
                         const std::function<void(const Grain_state&)>& on) {
  using namespace DSC;
  static constexpr int d = Complex::dimension;
  Grain_files files(run);
  const Grain_orientations<d> orientations(run.number, run.seed);
  const Interface_energy energy = run.energy.of(orientations, run.particles > 0);
  Complex complex;
  // The growth keeps the particles of the beginning, also if the run is resumed.
  if (run.resume.empty() || run.particles > 0)
    complex = first_grains<Complex>(run, energy, make);
  Grain_state state;
  Grain_growth<Complex> growth(complex, energy, growth_options<d>(run));
  if (!run.resume.empty()) {
    const auto saved = CGAL::IO::read_checkpoint<d>(run.resume);
    const Json json = Json::parse(saved.metadata); // read_grains() accepts it
    complex.restore(saved.state);
    state.time = json.at("time");
    state.step = json.at("step");
    state.energy_before = json.at("energy_before");
    growth.set_time(state.time);
  }
  const Grain_result result = grow_grains(run, files, complex, growth, orientations, state, on);
  if constexpr (d == 2)
    if (!run.picture.empty())
      CGAL::IO::write_SVG(run.picture, complex);
  files.require();
  return result;
}

} // namespace dsc

#endif // DSC_GRAIN_RUN_IMPL_H

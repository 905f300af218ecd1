// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_RUN_IMPL_H
#define DSC_GRAIN_RUN_IMPL_H

#include "Grain_run.h"

#include "errors.h"
#include "files.h"

#include <CGAL/Deformable_simplicial_complexes/IO/PVD_series.h>
#include <CGAL/Deformable_simplicial_complexes/IO/VTU_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/VTU_3.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/Deformable_simplicial_complexes/remove_components.h>
#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/Grain_orientations.h>
#include <CGAL/Interface_flows/Voronoi_labels.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>

namespace dsc {

/// The sums of a regression through the origin.
class Regression
{
public:
  void add(double x, double y) {
    m_xx += x * x;
    m_xy += x * y;
    m_yy += y * y;
  }
  double slope() const { return m_xx > 0 ? m_xy / m_xx : 0; }
  double correlation() const { return m_xx > 0 && m_yy > 0 ? m_xy / std::sqrt(m_xx * m_yy) : 0; }

private:
  double m_xx = 0, m_xy = 0, m_yy = 0;
};

/// Writes the states of a run for ParaView.
class Grain_files
{
public:
  /// \throws Input_error if nothing can be written in the folder, or if it contains a run
  explicit Grain_files(const Grain_run& run) : m_run(run), m_series(run.output + "/grains.pvd") {
    if (run.output.empty())
      return;
    std::error_code error;
    std::filesystem::create_directories(run.output, error);
    if (error)
      throw Input_error("the folder " + run.output + " cannot be created: " + error.message() +
                        "; use another folder");
    if (std::filesystem::exists(m_series.path()))
      throw Input_error("the folder " + run.output +
                        " contains a run; remove it, or use another folder");
    require_writable(m_series.path());
  }

  template <class Complex> void write(const Complex& complex, const Grain_state& state) {
    if (m_run.output.empty() || state.step % m_run.every != 0)
      return;
    std::array<char, 32> name;
    std::snprintf(name.data(), name.size(), "/grains_%06u.vtu", state.step);
    const std::string file = m_run.output + name.data();
    CGAL::IO::write_VTU(file, complex);
    m_series.append(state.time, file);
  }

private:
  const Grain_run& m_run;
  CGAL::IO::PVD_series m_series;
};

/// Lets grains grow, see `grow_grains_2()`.
/// \tparam Complex a complex on a torus
template <class Complex>
Grain_result grow_grains(const Grain_run& run, Grain_files& files, Complex& complex,
                         const std::function<void(const Grain_state&)>& on) {
  using namespace CGAL::Deformable_simplicial_complexes;
  static constexpr int d = Complex::dimension;
  static constexpr double degree = CGAL_PI / 180;
  const Grain_orientations<d> orientations(run.number, run.seed);
  Interface_energy energy;
  const bool is_isotropic = run.energy == Grain_run::Energy::isotropic;
  if (!is_isotropic)
    energy.set_tension([&orientations, largest = run.largest_angle * degree](int a, int b) {
      return read_shockley_energy(orientations.misorientation(a, b), largest);
    });
  keep_largest_components(complex, energy);
  Grain_growth_options options;
  options.edges_of_grain = run.edges;
  options.step = run.step;
  options.number_of_threads = run.threads;
  Grain_growth<Complex> growth(complex, energy, options);
  Grain_state state;
  const auto tell = [&] {
    state.time = growth.time();
    state.energy = energy(complex);
    state.grains = complex.labels().size();
    state.cells = complex.number_of_cells();
    files.write(complex, state);
    on(state);
  };
  tell();

  // The rates of the law hold after the angles at junctions have settled. In space, the statistics
  // of all cells take time, so they are not computed in each step.
  static constexpr double settled = .5; // time in squares of an edge
  static constexpr unsigned interval = d == 2 ? 1 : 5;
  Regression regression;
  Grain_result result;
  // Few grains can become strips around the torus, which do not move.
  static constexpr double still = 1e-9; // relative decrease of the energy in a step
  static constexpr double rounding = 1e-9;
  bool moves = true;
  const auto goal = std::size_t(std::ceil(run.until * double(run.number) - rounding));
  while (state.grains > std::max(goal, std::size_t(1)) && moves &&
         (run.steps == 0 || state.step < run.steps)) {
    std::vector<Grain_statistics> before;
    if (is_isotropic && state.step * run.step > settled && state.step % interval == 0)
      before = grain_statistics(complex);
    const double energy_before = state.energy;
    const auto report = growth.advance();
    ++state.step;
    state.removed = report.removed.size();
    state.unfinished = report.deformation.unfinished.size();
    if (!before.empty() && report.removed.empty()) { // no grain got another one
      std::map<int, Grain_statistics> after;
      for (const Grain_statistics& grain : grain_statistics(complex))
        after.emplace(grain.label, grain);
      for (const Grain_statistics& grain : before)
        if (const auto found = after.find(grain.label);
            found != after.end() && found->second.corners == grain.corners) {
          const double rate = (found->second.measure - grain.measure) / report.dt;
          regression.add(grain.growth(d), rate);
          if (d == 2) {
            result.rates[grain.corners].sum += rate;
            ++result.rates[grain.corners].number;
          }
        }
    }
    tell();
    moves = energy_before - state.energy > still * energy_before;
  }
  result.grains = grain_statistics(complex);
  result.slope = regression.slope();
  result.correlation = regression.correlation();
  std::map<std::pair<int, int>, double> areas;
  for (const auto& facet : complex.interface_facets())
    areas[std::minmax({facet.first->label(), facet.first->neighbor(facet.second)->label()})] +=
        complex.measure(facet);
  for (const auto& [labels, area] : areas) {
    result.misorientations.push_back(orientations.misorientation(labels.first, labels.second) /
                                     degree);
    result.areas.push_back(area);
  }
  return result;
}

/// Returns a Voronoi diagram on a torus with periods of 1, with the edges of a run.
/// \param make `make(edge, labels)` makes the complex
template <class Complex, class Make>
Complex voronoi_grains(const Grain_run& run, const Make& make) {
  using namespace CGAL::Deformable_simplicial_complexes;
  std::array<double, Complex::dimension> sides;
  sides.fill(1);
  const Voronoi_labels<Complex> labels(run.number, sides, true, run.seed);
  return make(std::pow(double(run.number), -1. / Complex::dimension) / run.edges, labels);
}

} // namespace dsc

#endif // DSC_GRAIN_RUN_IMPL_H

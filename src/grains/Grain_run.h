// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_RUN_H
#define DSC_GRAIN_RUN_H

#include "Grain_energy.h"

#include <CGAL/Interface_flows/grain_statistics.h>

namespace dsc {

/// The growth of grains on a torus with periods of 1, or in a box with sides of 1.
struct Grain_run
{
  int dimension = 2;
  bool is_periodic = true;  ///< whether the domain is the torus
  std::size_t number = 100; ///< of grains at the beginning
  Grain_energy energy;
  std::size_t particles = 0;   ///< number of particles, which hold grain boundaries
  double particle_radius = .2; ///< in diameters of a mean grain at the beginning
  double edges = 10;           ///< in the diameter of a mean grain
  double step = .1;            ///< time step in squares of an edge
  std::uint32_t seed = 1;      ///< number of the random sequence

  double until = .5;  ///< fraction of grains that ends the run, in (0, 1)
  unsigned steps = 0; ///< greatest number of steps of this run; no bound if 0
  unsigned threads = 1;
  unsigned every = 10; ///< number of steps from one file to the next
  std::string resume;  ///< checkpoint to continue from; empty for new grains
  std::string output;  ///< folder for ParaView files and a checkpoint; empty for none
  std::string picture; ///< file, in the plane; empty for none
};

/// Reads the grains of a checkpoint into a run: the members from `dimension` to `seed`.
/// \throws Input_error if the checkpoint contains no grains, or a value is out of its range
/// \throws File_error if the file is no checkpoint
void read_grains(const std::string& checkpoint, Grain_run& run);

/// Returns the grains of a run as JSON, for reports and checkpoints: the members from `dimension`
/// to `seed`.
Json to_json(const Grain_run& run);

inline constexpr int particle_label = 0; ///< label of all particles

/// The state after a step of the growth of grains.
struct Grain_state
{
  unsigned step = 0;
  double time = 0, energy = 0;
  double energy_before = 0; ///< at the last test whether the energy decreases
  std::size_t grains = 0, cells = 0, removed = 0, unfinished = 0;
};

/// The mean rate of growth of grains with a number of sides, in the plane.
struct Grain_rate
{
  double sum = 0;         ///< of the rates
  std::size_t number = 0; ///< of grains and steps
};

/// The result of the growth of grains.
struct Grain_result
{
  std::vector<DSC::Grain_statistics> grains; ///< at the end
  std::vector<double> misorientations;       ///< in degrees, weighted by `areas`
  std::vector<double> areas;                 ///< of the interfaces with these misorientations
  /// Slope and uncentered correlation of the measured rates of growth over those of the law for
  /// unit tension and mobility, see `Grain_statistics::growth()`. Zero if none were measured.
  double slope = 0, correlation = 0;
  std::map<std::size_t, Grain_rate> rates; ///< by the number of sides, in the plane
};

/// Lets grains grow, and calls a function with the state at the beginning and after each step.
/// \throws Input_error if the output folder contains a run, or nothing can be written there
/// \throws std::runtime_error if a file cannot be written, or the flow cannot be computed
Grain_result grow_grains(const Grain_run& run, const std::function<void(const Grain_state&)>& on);

/// The same for the two dimensions.
Grain_result grow_grains_2(const Grain_run& run, const std::function<void(const Grain_state&)>& on);
Grain_result grow_grains_3(const Grain_run& run, const std::function<void(const Grain_state&)>& on);

} // namespace dsc

#endif // DSC_GRAIN_RUN_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_H
#define DSC_TRACKED_COMPLEX_H

#include "motion.h"
#include "statistics.h"
#include "surface.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc {

/// A deformable simplicial complex of either dimension behind a wall, so that few files compile its
/// templates. All functions throw std::runtime_error if a file cannot be read or written, or makes
/// no complex.
class Tracked_complex
{
public:
  virtual ~Tracked_complex() = default;

  virtual int dimension() const = 0;

  /// The length of a step in time.
  virtual double time_step(const Motion& motion) const = 0;

  /// Deforms the interface by one step that starts at `time`. If this throws, the complex may have
  /// been prepared for the step, or worse: go_back(). \throws Usage_error if the motion is none of
  /// this dimension
  virtual Step_outcome advance(const Step_options& options, double time, unsigned threads) = 0;

  /// Whether the interface is well inside the domain.
  virtual bool has_room() const = 0;

  /// Enlarges the domain, a box, around the interface, which stays as it is.
  virtual void grow_domain() = 0;

  /// Keeps the complex as it is, to go back to, until forget().
  virtual void keep() = 0;
  virtual void forget() = 0;
  virtual void go_back() = 0; ///< if there is something to go back to

  virtual Statistics statistics() const = 0;

  /// The vertices of the interface, in the coordinates of the input; at height 0 in the plane.
  virtual std::vector<Surface_point> interface_points() const = 0;

  /// The mean length of an interface edge of the input.
  virtual double mean_edge() const = 0;

  /// Seconds that one pass over all cells takes which only evaluates the exact orientation and the
  /// quality of their corners: the unit that steps are compared by.
  virtual double sweep_seconds() const = 0;

  /// Writes the interface, in the plane the regions, or the cells, in the format of the extension.
  /// \throws Usage_error if it is none of this dimension
  virtual void write(const std::string& path) const = 0;
  virtual void write_interface_vtu(const std::string& path) const = 0;
  virtual void write_volume_vtu(const std::string& path) const = 0;
  /// In the plane, draws the complex to `stem` + ".svg".
  virtual void write_picture(const std::string& stem) const = 0;
  virtual void write_checkpoint(const std::string& path, const std::string& metadata) const = 0;
  /// Writes the interface, subdivided so many times. \throws Usage_error in the plane
  virtual void write_subdivided(const std::string& path, int subdivisions) const = 0;
};

/// Fills the space inside and around surfaces. Surfaces may share walls, and a surface with walls
/// inside gets a label for each of its regions.
/// \param names of the surfaces, for messages
/// \param domain least and largest coordinates of the box; that of the library if not set
/// \param notes is told the labels of surfaces with walls inside, unless it is null
std::unique_ptr<Tracked_complex> track_surfaces(const std::vector<Surface>& surfaces,
                                                const std::vector<std::string>& names,
                                                const std::optional<std::array<double, 6>>& domain,
                                                std::ostream* notes);

/// The complex of the files of the plane, or of the figure, that a run starts from.
/// \param domain as above, at heights 0
std::unique_ptr<Tracked_complex> track_figure(const Run_start& start,
                                              const std::optional<std::array<double, 6>>& domain);

/// The complex in a checkpoint, and what was written with it.
std::unique_ptr<Tracked_complex> track_checkpoint(const std::string& path, std::string& metadata);

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The median time of a pass over cells that evaluates a number for each.
template <class Cells, class Evaluate>
double seconds_of_sweep(const Cells& cells, const Evaluate& evaluate) {
  std::array<double, 9> seconds;
  [[maybe_unused]] volatile double sum; // so that no pass can be optimized away
  for (double& s : seconds) {
    double total = 0;
    const auto start = Clock::now();
    for (const auto c : cells)
      total += evaluate(c);
    s = seconds_since(start);
    sum = total;
  }
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  // A clock may be too coarse for a few cells, but nothing is ever divided by zero.
  return std::max(seconds[seconds.size() / 2], 1e-9);
}

/// What a step did, by the report of the library.
template <class Report> Step_outcome step_outcome(double seconds, const Report& report) {
  return {seconds,
          report.complete,
          report.unfinished.size(),
          report.stopped_at_boundary,
          report.flat.size(),
          report.passes,
          report.split,
          report.collapsed,
          report.flipped,
          report.relabeled,
          std::nullopt};
}

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_H

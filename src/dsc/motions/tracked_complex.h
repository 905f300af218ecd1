// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_H
#define DSC_TRACKED_COMPLEX_H

#include "input/surface.h"
#include "motions/motion.h"
#include "output/statistics.h"

#include <CGAL/Mesh_files/Label_names.h>

#include <chrono>
#include <functional>
#include <memory>

namespace dsc {

/// A deformable simplicial complex of either dimension, behind an abstract interface, so that few
/// source files instantiate its templates. All functions throw std::runtime_error if a file cannot
/// be read or written, or does not define a complex.
class Tracked_complex
{
public:
  virtual ~Tracked_complex() = default;

  virtual int dimension() const = 0;

  DSC::Label_names label_names; ///< from the input

  /// Calls a function on one process. A complex can be distributed among processes, which all call
  /// the same functions; one of them writes files. If `function()` throws, all of them throw.
  virtual void run_once(const std::function<void()>& function) const { function(); }

  /// Returns the number that the process on which `run_once()` calls functions gives. It is at
  /// least 0.
  virtual double agreed(double number) const { return number; }

  /// Returns the extension of the files of `write_volume_vtu()` and `write_interface_vtu()`.
  virtual std::string grid_extension() const { return ".vtu"; }

  /// Deforms the interface by one time step that starts at `time`. After an exception, the complex
  /// may be modified: call go_back().
  /// \throws Usage_error if the motion is not available in this dimension
  virtual Step_outcome advance(const Step_options& options, double time, unsigned threads) = 0;

  /// Returns whether the interface has a sufficient distance from the boundary of the domain.
  virtual bool has_room() const = 0;

  /// Enlarges the domain, a box, around the interface. The interface does not change.
  virtual void grow_domain() = 0;

  /// Stores the current complex for go_back(), until forget() is called.
  virtual void keep() = 0;
  virtual void forget() = 0;
  virtual void go_back() = 0; ///< to the stored complex, if any

  /// Returns the estimated number of further facets of the interface that would resolve its thin
  /// parts.
  virtual std::size_t missing_facets(double edge_per_thickness) const = 0;

  /// Returns the statistics. Some passes over all cells, so call it for output only.
  virtual Statistics statistics() const = 0;

  /// Returns the lowest quality of a cell.
  virtual double worst_quality() const = 0;

  /// Returns the vertices of the interface in input coordinates; with z = 0 in the plane.
  virtual std::vector<Surface_point> interface_points() const = 0;

  /// Returns the mean length of an interface edge of the input.
  virtual double mean_edge() const = 0;

  /// Returns the time, in seconds, of one pass over all cells that computes the exact orientation
  /// and the quality of each cell. It is the unit for the comparison of step times.
  virtual double sweep_seconds() const = 0;

  /// Writes the interface or the cells, in the plane the regions, in the format of the extension.
  /// \throws Usage_error if the format is not available in this dimension
  virtual void write(const std::string& path) const = 0;
  virtual void write_interface_vtu(const std::string& path) const = 0;
  virtual void write_volume_vtu(const std::string& path) const = 0;
  /// Draws the complex to `stem` + ".svg", in the plane only.
  virtual void write_picture(const std::string& /*stem*/) const {}
  virtual void write_checkpoint(const std::string& path, const std::string& metadata) const = 0;
  /// Writes the interface after a number of subdivisions.
  /// \throws Usage_error in the plane
  virtual void write_subdivided(const std::string& path, int subdivisions) const = 0;
};

/// Builds the initial complex of a run in the plane, from its files or its figure.
/// \param domain lower and upper bounds of the box, with z = 0; the default of the library if not set
std::unique_ptr<Tracked_complex> track_figure(const Run_start& start,
                                              const std::optional<std::array<double, 6>>& domain);

/// Reads the complex and the metadata of a checkpoint, in space or in the plane.
std::unique_ptr<Tracked_complex> track_checkpoint(const std::string& path, std::string& metadata);

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Returns the median time, in seconds, of a pass over cells that evaluates a number for each cell.
template <class Cells, class Evaluate>
double seconds_of_sweep(const Cells& cells, const Evaluate& evaluate) {
  std::array<double, 9> seconds;
  [[maybe_unused]] volatile double sum; // prevents the optimizer from removing a pass
  for (double& s : seconds) {
    double total = 0;
    const auto start = Clock::now();
    for (const auto c : cells)
      total += evaluate(c);
    s = seconds_since(start);
    sum = total;
  }
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  // The clock may be too coarse for a few cells. The lower bound avoids a division by zero.
  return (std::max)(seconds[seconds.size() / 2], 1e-9);
}

/// Returns the changes of components in a report of the library.
template <class Complex, class Report>
std::vector<Step_event> step_events(const Complex& complex, const Report& report) {
  const auto& normalization = complex.normalization();
  const double scale = std::pow(normalization.scale, Complex::dimension);
  std::vector<Step_event> result;
  for (const auto& event : report.events) {
    Step_event entry{event, {}};
    for (auto* components : {&entry.change.before, &entry.change.after})
      for (auto& component : *components)
        component.volume *= scale;
    for (int i = 0; i < Complex::dimension; ++i)
      entry.where[std::size_t(i)] =
          normalization.translation[i] + normalization.scale * event.where[i];
    result.push_back(std::move(entry));
  }
  return result;
}

/// Returns the balances of volumes in a report of the library.
template <class Complex, class Report>
std::vector<Label_balance> label_balances(const Complex& complex, const Report& report) {
  const double scale = std::pow(complex.normalization().scale, Complex::dimension);
  std::vector<Label_balance> result;
  for (const auto& change : report.labels)
    result.push_back({change.label, change.before, change.after, scale * change.volume_before,
                      scale * change.volume_after, scale * change.volume_swept,
                      scale * change.volume_of_overlaps, scale * change.volume_unexplained()});
  return result;
}

/// Returns the outcome of a step from the report of the library.
template <class Complex, class Report>
Step_outcome step_outcome(double seconds, const Complex& complex, const Report& report) {
  return {seconds,
          report.complete,
          report.unfinished.size(),
          report.estimated_error * complex.normalization().scale,
          report.stopped_at_boundary,
          report.flat.size(),
          report.steps,
          report.passes,
          report.split,
          report.collapsed,
          report.flipped,
          report.relabeled,
          step_events(complex, report),
          label_balances(complex, report),
          std::nullopt};
}

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_H
#define DSC_TRACKED_COMPLEX_H

#include "options.h"
#include "statistics.h"
#include "surface.h"

#include <CGAL/Deformable_simplicial_complexes/State.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc {

/// A deformable simplicial complex behind a wall, so that a single file compiles its templates.
/// All functions throw std::runtime_error if a file cannot be read or written, or makes no complex.
class Tracked_complex
{
public:
  using State = CGAL::Deformable_simplicial_complex_state_3;

  /// Fills the space inside and around surfaces.
  /// \param names of the surfaces, for messages
  /// \param domain least and largest coordinates of the box; that of the library if not set
  static Tracked_complex from_surfaces(const std::vector<Surface>& surfaces,
                                       const std::vector<std::string>& names,
                                       const std::optional<std::array<double, 6>>& domain);

  /// The labelled tetrahedra of a MEDIT or VTU file; points that none of them uses are left out.
  static Tracked_complex from_mesh(const std::string& path);

  /// The complex in a checkpoint, and what was written with it.
  static Tracked_complex from_checkpoint(const std::string& path, std::string& metadata);

  Tracked_complex(Tracked_complex&&);
  ~Tracked_complex();

  /// The length of a step in time.
  double time_step(const Motion& motion) const;

  /// Deforms the interface by one step that starts at `time`. If this throws, the complex may have
  /// been prepared for the step, or worse: go back by restore().
  Step_outcome advance(const Step_options& options, double time, unsigned threads);

  /// The complex in numbers, to go back to.
  State state() const;
  void restore(const State& state);

  /// Improves the tetrahedra; neither the interface nor the boundary changes its shape.
  Improvement_outcome improve(const Improve_options& options);

  Statistics statistics() const;

  /// The vertices of the interface, in the coordinates of the input.
  std::vector<Surface_point> interface_points() const;

  /// The mean length of an interface edge of the input.
  double mean_edge() const;

  /// Seconds that one pass over all tetrahedra takes which only evaluates the exact orientation and
  /// the quality of their corners: the unit that steps are compared by.
  double sweep_seconds() const;

  /// Writes the interface as a surface, in the format of the extension.
  void write_interface(const std::string& path) const;
  void write_interface_vtu(const std::string& path) const;
  void write_volume_vtu(const std::string& path) const;
  void write_mesh(const std::string& path) const;
  void write_checkpoint(const std::string& path, const std::string& metadata) const;

private:
  struct Implementation;
  explicit Tracked_complex(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> m_implementation;
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_H

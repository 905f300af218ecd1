// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_FILES_H
#define DSC_GRAIN_FILES_H

#include "Grain_run.h"
#include "grain_checkpoint.h"

#include "step_folder.h"

#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>
#include <CGAL/Interface_flows/Grain_orientations.h>

#include <algorithm>
#include <optional>

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
             const CGAL::Deformable_simplicial_complexes::Grain_orientations<Complex::dimension>&
                 orientations) {
    if (!m_folder || m_last == state.step)
      return;
    m_last = state.step;
    CGAL::Deformable_simplicial_complexes::Mesh_arrays arrays;
    arrays.cells.push_back({"misorientation", "Float64", 1, {}});
    static constexpr double none = -1; // at particles, which have no orientation
    for (const auto& facet : complex.interface_facets()) {
      const int a = facet.first->label(), b = facet.first->neighbor(facet.second)->label();
      arrays.cells.back().values.push_back(
          std::min(a, b) == particle_label ? none : orientations.misorientation(a, b) / degree);
    }
    m_folder->write(complex, state.step, state.time, arrays);
    write_grains(m_folder->file("checkpoint.dsc"), m_run, complex, state);
  }

private:
  const Grain_run& m_run;
  std::optional<Step_folder> m_folder; // none if nothing is written
  std::optional<unsigned> m_last;      // step of the last state
};

} // namespace dsc

#endif // DSC_GRAIN_FILES_H

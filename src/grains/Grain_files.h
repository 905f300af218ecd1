// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_FILES_H
#define DSC_GRAIN_FILES_H

#include "Grain_run.h"

#include "errors.h"
#include "files.h"

#include <CGAL/Deformable_simplicial_complexes/IO/PVD_series.h>
#include <CGAL/Deformable_simplicial_complexes/IO/VTU_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/VTU_3.h>
#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>
#include <CGAL/Interface_flows/Grain_orientations.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace dsc {

inline constexpr double degree = CGAL_PI / 180;

/// Writes the states of a run for ParaView and `dsc view`.
class Grain_files
{
public:
  /// \throws Input_error if nothing can be written in the folder, or if it contains a run
  explicit Grain_files(const Grain_run& run)
      : m_run(run), m_volume(run.output + "/volume.pvd"),
        m_interface(run.output + "/interface.pvd") {
    if (run.output.empty())
      return;
    std::error_code error;
    std::filesystem::create_directories(run.output, error);
    if (error)
      throw Input_error("the folder " + run.output + " cannot be created: " + error.message() +
                        "; use another folder");
    if (std::filesystem::exists(m_volume.path()))
      throw Input_error("the folder " + run.output +
                        " contains a run; remove it, or use another folder");
    require_writable(m_volume.path());
  }

  /// Writes the cells and the interface, with the misorientations of its facets, unless the state
  /// is written already.
  template <class Complex>
  void write(const Complex& complex, const Grain_state& state,
             const CGAL::Deformable_simplicial_complexes::Grain_orientations<Complex::dimension>&
                 orientations) {
    if (m_run.output.empty() || m_last == state.step)
      return;
    m_last = state.step;
    std::array<char, 32> name;
    std::snprintf(name.data(), name.size(), "_%06u.vtu", state.step);
    const std::string volume = m_run.output + "/volume" + name.data(),
                      interface = m_run.output + "/interface" + name.data();
    CGAL::Deformable_simplicial_complexes::Mesh_arrays arrays;
    arrays.cells.push_back({"misorientation", "Float64", 1, {}});
    for (const auto& facet : complex.interface_facets())
      arrays.cells.back().values.push_back(
          orientations.misorientation(facet.first->label(),
                                      facet.first->neighbor(facet.second)->label()) /
          degree);
    CGAL::IO::write_VTU(volume, complex);
    CGAL::IO::write_interface_VTU(interface, complex, arrays);
    m_volume.append(state.time, volume);
    m_interface.append(state.time, interface);
  }

private:
  const Grain_run& m_run;
  CGAL::IO::PVD_series m_volume, m_interface;
  std::optional<unsigned> m_last; // step of the last state
};

} // namespace dsc

#endif // DSC_GRAIN_FILES_H

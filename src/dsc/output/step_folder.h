// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_STEP_FOLDER_H
#define DSC_STEP_FOLDER_H

#include "input/claimed_folder.h"
#include "input/files.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/PVD_series.h>
#include <CGAL/Mesh_files/VTU_2.h>
#include <CGAL/Mesh_files/VTU_3.h>

namespace dsc {

/// An output folder with the cells and the interface of each step of a run that is not resumed, for
/// ParaView and `dsc view`.
class Step_folder
{
public:
  /// Claims the folder.
  /// \throws Input_error if the folder cannot be claimed, or contains other steps
  explicit Step_folder(const std::string& path)
      : m_claim(path), m_volume(file("volume.pvd")), m_interface(file("interface.pvd")) {
    if (exists(m_volume.path()))
      throw Input_error("the folder '" + path +
                        "' contains the steps of another run; choose another folder");
  }

  /// \throws Input_error if the folder no longer belongs to this run
  void require() const { m_claim.require(); }

  /// \param arrays of the interface
  template <class Complex>
  void write(const Complex& complex, std::size_t step, double time,
             const DSC::Mesh_arrays& arrays = {}) {
    require();
    char name[40];
    std::snprintf(name, sizeof name, "_%06zu.vtu", step);
    const std::string volume = file(std::string("volume") + name),
                      interface = file(std::string("interface") + name);
    CGAL::IO::write_VTU(volume, complex);
    CGAL::IO::write_interface_VTU(interface, complex, arrays);
    m_volume.append(time, volume);
    m_interface.append(time, interface);
  }

  /// Returns the path of a file in the folder.
  std::string file(const std::string& name) const { return m_claim.file(name); }

private:
  Claimed_folder m_claim;
  CGAL::IO::PVD_series m_volume, m_interface;
};

} // namespace dsc

#endif // DSC_STEP_FOLDER_H

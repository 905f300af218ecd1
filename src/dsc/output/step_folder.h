// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_STEP_FOLDER_H
#define DSC_STEP_FOLDER_H

#include "input/files.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/PVD_series.h>
#include <CGAL/Mesh_files/VTU_2.h>
#include <CGAL/Mesh_files/VTU_3.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>

namespace dsc {

/// An output folder with the cells and the interface of each step of a run that is not resumed, for
/// ParaView and `dsc view`.
class Step_folder
{
public:
  /// Creates the folder if necessary.
  /// \throws Input_error if the folder cannot be created, or contains other steps
  explicit Step_folder(const std::string& path)
      : m_path(path), m_volume(file("volume.pvd")), m_interface(file("interface.pvd")) {
    create_folder(path);
    if (exists(m_volume.path()))
      throw Input_error("the folder '" + path +
                        "' contains the steps of another run; choose another folder");
    require_writable(m_volume.path());
  }

  /// \param arrays of the interface
  template <class Complex>
  void write(const Complex& complex, std::size_t step, double time,
             const DSC::Mesh_arrays& arrays = {}) {
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
  std::string file(const std::string& name) const {
    return (std::filesystem::path(m_path) / name).string();
  }

private:
  std::string m_path;
  CGAL::IO::PVD_series m_volume, m_interface;
};

} // namespace dsc

#endif // DSC_STEP_FOLDER_H

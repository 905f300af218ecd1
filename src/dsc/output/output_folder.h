// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OUTPUT_FOLDER_H
#define DSC_OUTPUT_FOLDER_H

#include "motions/run_position.h"
#include "motions/tracked_complex.h"

#include <CGAL/Mesh_files/PVD_series.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace dsc {

/// The output files of a run. Each written state has two VTU files; in the plane also a picture
/// and, if requested, a smooth surface. The folder also contains the two collections of these
/// files, and the checkpoint of the last state.
class Output_folder
{
public:
  /// Creates the folder if necessary.
  /// \param subdivisions of the interface, for a smooth surface; none if 0
  /// \throws Input_error if nothing can be written there, or if the folder contains another run
  /// than the run of the checkpoint `resume`
  Output_folder(const std::string& path, const std::string& resume, int subdivisions);

  /// Continues the collections of an earlier run in this folder, up to a time.
  void keep_until(double time);

  /// Returns whether the checkpoint is from this position or a later one.
  bool holds(const Run_position& position) const { return position.time <= m_checkpoint_time; }

  /// Writes a state, except files that already exist. The checkpoint is written last, when all
  /// other files are complete.
  /// \throws std::runtime_error if a file cannot be written
  void write(const Tracked_complex& complex, const Run_position& position,
             const std::string& metadata);

  std::string checkpoint() const;

private:
  std::string file(const std::string& name) const;

  std::string m_path;
  int m_subdivisions;
  CGAL::IO::PVD_series m_volume, m_interface;
  double m_last_time = -std::numeric_limits<double>::infinity(); // last time in the collections
  double m_checkpoint_time = m_last_time;
};

/// Time, and file of the state.
using Moment = std::pair<double, std::string>;

/// Returns the files that a collection (.pvd) lists, in their order. Paths are relative to the
/// working directory. Files need not exist. Returns nothing if the collection does not exist.
/// \throws Input_error if an entry has no file or no finite time
/// \throws DSC::File_error if the collection is not XML
std::vector<Moment> moments_of_collection(const std::string& collection);

} // namespace dsc

#endif // DSC_OUTPUT_FOLDER_H

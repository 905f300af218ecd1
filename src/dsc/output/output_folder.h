// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OUTPUT_FOLDER_H
#define DSC_OUTPUT_FOLDER_H

#include "input/claimed_folder.h"
#include "motions/run_position.h"
#include "motions/tracked_complex.h"

#include <CGAL/Mesh_files/PVD_series.h>

namespace dsc {

/// The output files of a run. Each written state has two VTU files; in the plane also a picture
/// and, if requested, a smooth surface. The folder also contains the two collections of these
/// files, and the checkpoint of the last state.
class Output_folder
{
public:
  /// \param subdivisions of the interface, for a smooth surface; none if 0
  Output_folder(const std::string& path, int subdivisions);

  /// Claims the folder for this process, the first one of the run.
  /// \throws Input_error if nothing can be written there, or if the folder contains another run
  /// than the run of the checkpoint `resume`
  void claim(const std::string& resume);

  /// Continues the collections of an earlier run in this folder, up to a time.
  void keep_until(double time);

  /// Writes the checkpoint unless it is from this position or a later one.
  /// \throws std::runtime_error if it cannot be written
  void save(const Tracked_complex& complex, const Run_position& position,
            const std::string& metadata);

  /// Writes the other files of a state unless they exist.
  /// \throws std::runtime_error if a file cannot be written
  void write(const Tracked_complex& complex, const Run_position& position);

  /// \throws std::runtime_error if the folder no longer belongs to this run
  void require(const Tracked_complex& complex) const;

  std::string checkpoint() const;

private:
  std::string file(const std::string& name) const;

  std::string m_path;
  std::optional<Claimed_folder> m_claim; // of the first process
  int m_subdivisions;
  CGAL::IO::PVD_series m_volume, m_interface;
  double m_last_time = -std::numeric_limits<double>::infinity(); // last time in the collections
  double m_checkpoint_time = m_last_time;
};

/// Saves a run that cannot go on: writes the checkpoint of its last state in the folder or, if
/// there is none or it can no longer be written, under a new name in the working directory.
/// \param stem of the new name
/// \return the name of the checkpoint, in the first process
/// \throws std::runtime_error if neither can be written
std::string save_run(std::optional<Output_folder>& folder, const std::string& stem,
                     const Tracked_complex& complex, const Run_position& position,
                     const std::string& metadata);

/// Saves a run after an error of any kind in a step, so that the previous steps are kept. Returns
/// the message, which also tells where they are, or why they could not be saved.
/// \param save returns the name of the checkpoint; empty if there is nothing to save
std::string message_after_saving(const std::exception& error, unsigned step,
                                 const std::function<std::string()>& save,
                                 const std::function<void()>& write_report);

/// Time, and file of the state.
using Moment = std::pair<double, std::string>;

/// Returns the files that a collection (.pvd) lists, in their order. Paths are relative to the
/// working directory. Files need not exist. Returns nothing if the collection does not exist.
/// \throws Input_error if an entry has no file or no finite time
/// \throws DSC::File_error if the collection is not XML
std::vector<Moment> moments_of_collection(const std::string& collection);

} // namespace dsc

#endif // DSC_OUTPUT_FOLDER_H

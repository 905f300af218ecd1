// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OUTPUT_FOLDER_H
#define DSC_OUTPUT_FOLDER_H

#include "run_position.h"
#include "tracked_complex.h"

#include <CGAL/Deformable_simplicial_complexes/IO/PVD_series.h>

#include <limits>
#include <string>

namespace dsc {

/// The files of a run: one pair of VTU files for each written step, in the plane also a picture,
/// and if asked for a smooth surface; the two collections of them, and the checkpoint of the last.
class Output_folder
{
public:
  /// Creates the folder if need be. \throws Input_error if nothing can be written there, or if it
  /// holds another run than that of the checkpoint `resume`
  /// \param subdivisions of the interface, for a smooth surface; none if 0
  Output_folder(const std::string& path, const std::string& resume, int subdivisions);

  /// Goes on with the collections of an earlier run in this folder, up to a moment.
  void keep_until(double time);

  /// Whether the checkpoint is that of a moment, or of a later one.
  bool holds(const Run_position& position) const { return position.time <= m_checkpoint_time; }

  /// Writes a state, less what is there already. The checkpoint comes last, when all it promises is
  /// there. \throws std::runtime_error if that fails
  void write(const Tracked_complex& complex, const Run_position& position,
             const std::string& metadata);

  std::string checkpoint() const;

private:
  std::string file(const std::string& name) const;

  std::string m_path;
  int m_subdivisions;
  CGAL::IO::PVD_series m_volume, m_interface;
  double m_last_time = -std::numeric_limits<double>::infinity(); // in the collections
  double m_checkpoint_time = m_last_time;
};

} // namespace dsc

#endif // DSC_OUTPUT_FOLDER_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_REPORT_H
#define DSC_REPORT_H

#include "input/surface.h"
#include "motions/motion_list.h"
#include "motions/run.h"
#include "motions/run_balance.h"
#include "motions/run_position.h"
#include "output/report_json.h"
#include "output/statistics.h"

#include <chrono>

namespace dsc {

/// The report of all steps, as one JSON object in a file. The file is replaced atomically, so that
/// it is complete whenever the program ends.
class Report
{
public:
  Report(const Run_options& options, const Run_start& start, const Repairs& repairs,
         double sweep_seconds, CGAL::Deformable_simplicial_complexes::Label_names names);

  /// Adds the state after a step.
  void add(const Run_position& position, const Step_outcome& outcome, const Statistics& statistics);

  /// Writes the file unless it was written less than a second ago.
  /// \throws std::runtime_error if the file cannot be written
  void write_now_and_then();

  /// Adds the balance of the whole run.
  void set_balance(const Run_balance& balance);

  /// Writes the file.
  /// \throws std::runtime_error if the file cannot be written
  void write();

private:
  std::string m_path;
  double m_sweep_seconds;
  CGAL::Deformable_simplicial_complexes::Label_names m_names;
  Json m_json;
  std::chrono::steady_clock::time_point m_next_write;
};

/// Returns a description of the repairs of a surface, in one line.
std::string what_was_repaired(const DSC::Surface_repair_report_3& report);

} // namespace dsc

#endif // DSC_REPORT_H

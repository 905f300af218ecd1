// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_COMMANDS_H
#define DSC_RUN_COMMANDS_H

#include "options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <set>
#include <string>

namespace dsc {

/// Adds the option that tells which array of a .vtu file holds the labels.
CLI::Option* add_labels_option(CLI::App& command, std::string& labels);

/// Lets `--labels` be given for files that have arrays only.
/// \throws Usage_error
void require_file_with_arrays(const std::string& path, const std::string& labels);

/// The subcommands that move an interface.
class Run_commands
{
public:
  explicit Run_commands(CLI::App& app);
  Run_commands(const Run_commands&) = delete; // the command line writes into it

  /// What was asked for, once the command line was parsed and if it has one of these commands.
  /// \throws Usage_error
  Run_options options() const;

private:
  CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description);
  void add_flow_options(CLI::App& command);
  void add_tolerance_option(CLI::App& command);
  std::optional<double> tolerance(const std::set<std::string>& given) const;
  void require_dimension(const Run_options& options, bool is_planar) const;
  void require_kind(const Run_options& options, bool is_planar) const;
  Motion motion(const std::set<std::string>& given) const;
  Advection advection(Advection::Field field, const std::set<std::string>& given,
                      double default_period) const;

  CLI::App *m_rotate, *m_offset, *m_enright, *m_vortex, *m_advect, *m_mean_curvature, *m_zalesak;
  Run_options m_options;
  // As they were written.
  std::string m_axis, m_angle, m_distance, m_expressions, m_period, m_dt, m_tolerance, m_domain,
      m_aggressiveness, m_edge, m_largest_hole;
  std::string m_scheme = "rk4";
  bool m_moves_faces = false, m_fits = false, m_keeps_volumes = false, m_is_planar = false;
};

} // namespace dsc

#endif // DSC_RUN_COMMANDS_H

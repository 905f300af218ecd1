// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ANGLE_TABLE_H
#define DSC_ANGLE_TABLE_H

#include <string>
#include <vector>

namespace dsc {

/// The tension and the mobility of grain boundaries at some misorientations.
struct Angle_table
{
  /// A row of the table.
  struct Row
  {
    double angle;        ///< in degrees
    double tension;      ///< positive
    double mobility = 1; ///< positive
  };
  std::vector<Row> rows; ///< by increasing angles

  /// Returns the tension at an angle: linear between rows, constant outside the table.
  double tension(double angle) const { return value(angle, &Row::tension); }
  /// Returns the mobility at an angle, as above.
  double mobility(double angle) const { return value(angle, &Row::mobility); }

private:
  double value(double angle, double Row::*member) const;
};

/// Reads a table: a line for each row, with the angle, the tension and, if given, the mobility.
/// Text behind # is a comment.
/// \throws Input_error if the file cannot be read, a line is no row, or angles do not increase
Angle_table read_angle_table(const std::string& path);

} // namespace dsc

#endif // DSC_ANGLE_TABLE_H

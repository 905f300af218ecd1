// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_ENERGY_H
#define DSC_GRAIN_ENERGY_H

#include "output/report_json.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Interface_flows/Grain_orientations.h>

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

inline constexpr double degree = CGAL_PI / 180;

/// The energy of grain boundaries by their misorientation.
struct Grain_energy
{
  enum class Kind { isotropic, read_shockley, table };

  Kind kind = Kind::isotropic;
  double largest_angle = 15; ///< in degrees, for Read and Shockley
  Angle_table table;

  /// Returns the greatest product of a tension and a mobility.
  double fastest() const;

  /// Returns the energy of grains with given orientations. It refers to the orientations.
  /// \param has_particles whether the label 0 is that of particles, whose interfaces have the
  /// tension 1 and do not move
  template <int d>
  DSC::Interface_energy of(const DSC::Grain_orientations<d>& orientations,
                           bool has_particles) const {
    DSC::Interface_energy result;
    const auto angle = [&orientations](int a, int b) {
      return orientations.misorientation(a, b) / degree;
    };
    if (kind != Kind::isotropic)
      result.set_tension([energy = *this, angle, has_particles](int a, int b) {
        return has_particles && a == 0 ? 1 : energy.tension(angle(a, b));
      });
    if (kind == Kind::table || has_particles)
      result.set_mobility([energy = *this, angle, has_particles](int a, int b) {
        if (has_particles && a == 0)
          return 0.;
        return energy.kind == Kind::table ? energy.table.mobility(angle(a, b)) : 1.;
      });
    return result;
  }

private:
  double tension(double angle) const;
};

/// Returns an energy as JSON, for reports and checkpoints.
Json to_json(const Grain_energy& energy);

/// Returns the energy of `to_json()`.
/// \throws Json::exception, Input_error if it is none
Grain_energy energy_of_json(const Json& json);

} // namespace dsc

#endif // DSC_GRAIN_ENERGY_H

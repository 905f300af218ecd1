// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INVALID_POINTS_ERROR_H
#define CGAL_SOLID_RECONSTRUCTION_3_INVALID_POINTS_ERROR_H

#include <CGAL/Mesh_support/Error.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgSolidReconstruction3Ref

Exception thrown if points do not bound a solid, so that no solid can be reconstructed from them.
*/
class Invalid_points_error : public Error
{
public:
  /// Kind of the error.
  enum class Reason {
    not_finite,   ///< coordinates are not finite numbers
    out_of_range, ///< the extent of the points is not between 1e-30 and 1e30
    too_few,      ///< fewer than four points are different
    flat,         ///< all points lie in a plane
    /// the points enclose nothing, or a volume that is too thin in relation to their distances
    open,
    sheet ///< the points sample an open sheet, not a solid with holes
  };

  /// Constructs the error; the arguments are returned by the functions below.
  Invalid_points_error(Reason reason, const std::string& message,
                       std::vector<std::size_t> points = {})
      : Error(message), m_reason(reason), m_points(std::move(points)) {}

  /// Returns the kind of the error.
  Reason reason() const { return m_reason; }

  /// Returns the indices of the offending input points, increasing; empty if the error concerns all
  /// points equally.
  const std::vector<std::size_t>& points() const { return m_points; }

private:
  Reason m_reason;
  std::vector<std::size_t> m_points;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_SOLID_RECONSTRUCTION_3_INVALID_POINTS_ERROR_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CUT_LOCI_GEODESIC_SOURCE_H
#define DSC_CUT_LOCI_GEODESIC_SOURCE_H

#include "Any_surface.h"

#include <CGAL/Cut_loci_2/cut_locus_2.h>

#include <array>
#include <memory>
#include <string>

namespace dsc {

/// A point of a closed surface, from which geodesics start. The class hides the type of the
/// surface, so that its functions are compiled once for all programs.
///
/// A spacing is a length in the chart, a step is a length on the surface. The functions throw
/// `CGAL::Deformable_simplicial_complexes::Error` if a parameter is out of its range or the metric
/// is not positive definite, and `Interrupted_error` if a `Progress_scope` is stopped.
class Geodesic_source
{
public:
  using Point = CGAL::Simple_cartesian<double>::Point_2; ///< of the chart

  /// A distance ball.
  struct Ball
  {
    double radius;
    bool is_everything; ///< whether it covers the surface
  };

  virtual ~Geodesic_source() = default;

  /// Returns a spacing that also resolves short cut loci.
  virtual double default_spacing() const = 0;
  /// Returns half of the spacing, as a length on the surface.
  virtual double default_step(double spacing) const = 0;
  virtual DSC::Cut_locus_2 cut_locus(double spacing, double step) const = 0;
  /// Computes the distance ball of a radius.
  /// \param path picture (.svg) or triangles (.vtu) of the chart; empty for none
  /// \throws std::out_of_range if the radius is smaller than the one of the initial front
  virtual Ball ball(double radius, double spacing, double step, const std::string& path) const = 0;
  /// Writes a picture of the cut locus (.svg).
  virtual void draw(const DSC::Cut_locus_2& locus, const std::string& path) const = 0;
  /// Returns the image of a point of the chart, in space.
  virtual std::array<double, 3> image(const Point& p) const = 0;
};

/// Returns a point of a surface with a periodic chart.
/// \param point u and v
std::unique_ptr<Geodesic_source> source_in_chart(const Chart_surface& surface,
                                                 const std::array<double, 2>& periods,
                                                 const std::array<double, 2>& point);

/// Returns a point of a surface that is the image of the unit sphere.
/// \param direction the point is the image of this direction, of any length
std::unique_ptr<Geodesic_source> source_on_sphere(const Sphere_surface& surface,
                                                  const std::array<double, 3>& direction);

/// A cut locus with the spacing and the step of its computation.
struct Found_cut_locus
{
  DSC::Cut_locus_2 locus;
  double spacing, step;
};

/// Computes the cut locus of a source. With the default spacing, halves the spacing twice at most,
/// until the cut locus is complete.
/// \param spacing, step 0 for the default
Found_cut_locus find_cut_locus(const Geodesic_source& source, double spacing, double step);

} // namespace dsc

#endif // DSC_CUT_LOCI_GEODESIC_SOURCE_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_SEGMENTATION_REPORT_H
#define CGAL_IMAGE_SEGMENTATION_SEGMENTATION_REPORT_H

#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgImageSegmentationRef

Result of `segment_image()`. Measures are in numbers of pixels, lengths and areas in their
sides.
*/
struct Segmentation_report
{
  /// A phase.
  struct Phase
  {
    int label;                       ///< its label
    std::vector<double> intensities; ///< mean value of each channel, or the given value
    double measure;                  ///< area or volume, in pixels
    std::size_t components;          ///< number of connected components
  };
  /// The boundary between two phases.
  struct Boundary
  {
    /// \var a
    /// smaller label
    /// \var b
    /// larger label
    int a, b;
    double measure;     ///< length or area
    double uncertainty; ///< standard deviation of its position by the noise, in pixels
  };
  std::vector<Phase> phases;        ///< by increasing label; vanished phases have the measure 0
  std::vector<Boundary> boundaries; ///< by increasing labels
  std::vector<double> noise;        ///< standard deviation of each channel
  double smoothing = 0;             ///< energy of the interface, see `Segmentation_options`
  std::vector<double> energies;     ///< after every fifth motion, and at the end
  double residual =
      0; ///< mean squared deviation of pixels from their phases, in units of the noise
  /// Whether the energies after the last two motions with steps of full length differ by less than
  /// 2 % of the energy of the interface. It is true if the interface has vanished.
  bool has_converged = false;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_SEGMENTATION_REPORT_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Image_segmentation, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMAGE_SEGMENTATION_SEGMENT_IMAGE_H
#define CGAL_IMAGE_SEGMENTATION_SEGMENT_IMAGE_H

#include <CGAL/license/Image_segmentation.h>

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>
#include <CGAL/Image_segmentation/Segmentation_options.h>
#include <CGAL/Image_segmentation/Segmentation_report.h>
#include <CGAL/Image_segmentation/estimate_phases.h>
#include <CGAL/Image_segmentation/internal/segmentation/Cell_costs.h>
#include <CGAL/Image_segmentation/internal/segmentation/Segmenter.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

namespace internal {

// Returns the side of a square or a cube with the measure of a pixel.
template <int d> double side_of_pixel(const Sampling_grid<d>& grid) {
  double measure = 1;
  for (const double x : grid.spacing)
    measure *= x;
  return std::pow(measure, 1. / d);
}

// Returns a mesh of the pixels of an image, with a single label. The unit of length is the side of
// a pixel.
template <class Complex>
Complex mesh_of_image(const Sampling_grid<Complex::dimension>& grid, double edge) {
  static constexpr int d = Complex::dimension;
  const double side = side_of_pixel(grid);
  std::array<double, d> sizes, corner;
  for (int axis = 0; axis < d; ++axis) {
    sizes[axis] = double(grid.size[axis]) * grid.spacing[axis] / side;
    corner[axis] = grid.origin[axis] - grid.spacing[axis] / 2;
  }
  const auto label = [](const auto&) { return 0; };
  Complex result = [&] {
    if constexpr (d == 2)
      return make_deformable_simplicial_complex_2<Complex>(Bbox_2(0, 0, sizes[0], sizes[1]), edge,
                                                           label);
    else
      return make_deformable_simplicial_complex_3<Complex>(
          Bbox_3(0, 0, 0, sizes[0], sizes[1], sizes[2]), edge, label);
  }();
  result.set_normalization({vector_of<Complex>(corner), side});
  return result;
}

// Completes options by estimates.
template <int d>
Image_phases phases_of(const Gray_image<d>& image, const Segmentation_options<d>& options) {
  options.check();
  Image_phases result = {options.intensities, options.noise};
  if (options.intensities.empty() || options.noise.empty()) {
    const Image_phases estimate = estimate_phases(
        image, options.intensities.empty() ? options.phases : unsigned(options.intensities.size()));
    if (options.intensities.empty())
      result.intensities = estimate.intensities;
    if (options.noise.empty())
      result.noise = estimate.noise;
  }
  if (result.noise.size() != image.channels.size() ||
      result.intensities.front().size() != image.channels.size())
    throw Error("the intensities or the noise do not have one number for each of the " +
                std::to_string(image.channels.size()) + " channels of the image");
  return result;
}

// Segments an image on a mesh, which gets its best labels first if `is_new`.
template <class Complex>
Segmentation_report segment(Complex& complex, const Gray_image<Complex::dimension>& image,
                            const Segmentation_options<Complex::dimension>& options,
                            Image_phases phases, bool is_new) {
  static constexpr int d = Complex::dimension;
  const Progress_phase phase("segmenting the image");
  Gray_image<d> scaled = image; // with noise of deviation 1
  for (std::size_t k = 0; k < scaled.channels.size(); ++k) {
    for (float& value : scaled.channels[k])
      value = float(double(value) / phases.noise[k]);
    for (auto& intensity : phases.intensities)
      intensity[k] /= phases.noise[k];
  }
  Cell_costs<Complex> costs(complex, scaled, phases.intensities);
  Segmenter<Complex> segmenter(complex, costs, options);
  if (is_new)
    segmenter.label_cells();
  Segmentation_report result;
  segmenter.run(result);
  result.noise = phases.noise;
  result.smoothing = segmenter.smoothing();
  const double unit = costs.pixels_in_unit();
  double pixels = 0;
  for (const auto c : complex.cells())
    pixels += costs.fields(c)[0];
  result.residual = costs.total() / (pixels * double(scaled.channels.size()));
  for (std::size_t label = 0; label < costs.intensities().size(); ++label) {
    std::vector<double> intensities = costs.intensities()[label];
    for (std::size_t k = 0; k < intensities.size(); ++k)
      intensities[k] *= phases.noise[k];
    result.phases.push_back({int(label), std::move(intensities),
                             complex.measure(int(label)) * std::pow(unit, d),
                             complex.number_of_components(int(label))});
  }
  std::map<std::pair<int, int>, double> measures;
  for (const auto& facet : complex.interface_facets())
    measures[{facet.first->neighbor(facet.second)->label(), facet.first->label()}] +=
        complex.measure(facet);
  for (const auto& [labels, area] : measures) {
    // The noise is averaged over an edge, or over the distance along which the smoothing acts.
    const double contrast = std::sqrt(costs.squared_contrast(labels.first, labels.second)),
                 averaged =
                     (std::max)(options.shortest_edge, std::sqrt(result.smoothing) / contrast);
    result.boundaries.push_back({labels.first, labels.second, area * std::pow(unit, d - 1),
                                 1 / (contrast * std::pow(averaged, (d - 1) / 2.))});
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgImageSegmentationRef

Divides an image into phases of constant intensity (piecewise constant model of Mumford and Shah).
The result minimizes locally

\f[ E = \sum_a \int_{\Omega_a} \sum_k (I_k - c_{ak})^2 / \sigma_k^2 + \alpha |\Gamma| \f]

Here, \f$\Omega_a\f$ are the cells with the label a, \f$I_k\f$ is a channel of the image with the
noise \f$\sigma_k\f$, \f$c_{ak}\f$ are the intensities of the phase, \f$\Gamma\f$ is the interface,
and
\f$\alpha\f$ is `Segmentation_options::smoothing`. Lengths are in pixels.

The mesh begins with equal cells. Cells get the labels that decrease the energy; cells across
boundaries are bisected; vertices of the interface move against the gradient of the energy. This is
repeated with shorter and shorter edges. The mesh stays coarse inside phases.

\tparam Complex a deformable simplicial complex whose domain is a box

\param image the image
\param options the options
\return the complex and the report. Labels are the indices of phases, by increasing intensities; the
        user coordinates of the complex are those of the image.
\throws Error if the image or an option cannot be used, or the image has fewer different values than
        phases
\throws Interrupted_error if the callback of a `Progress_scope` returned `false`

The time is linear in the number of pixels, plus n log n in the number of cells for each of about a
hundred motions.
*/
template <class Complex>
std::pair<Complex, Segmentation_report>
segment_image(const Gray_image<Complex::dimension>& image,
              const Segmentation_options<Complex::dimension>& options = {}) {
  image.check();
  const Image_phases phases = internal::phases_of(image, options);
  std::pair<Complex, Segmentation_report> result{
      internal::mesh_of_image<Complex>(image.grid, options.longest_edge), {}};
  result.second = internal::segment(result.first, image, options, phases, true);
  return result;
}

/*!
\ingroup PkgImageSegmentationRef

Improves the segmentation that a complex is: the same as above, from the labels of the complex. So
the topology can be prescribed, with `Segmentation_options::keeps_topology`. Pixels outside the
domain are not used; cells outside the image have no cost.

\param complex the complex. Its labels are indices of phases, and its user coordinates are those of
       the image, see `Labelled_complex::normalization()`.
\param image, options as above
 eturn the report
        hrows Error as above, and if a label is no index of a phase. The complex is then unchanged.
        hrows Interrupted_error as above; the complex is then valid.
*/
template <class Complex>
Segmentation_report segment_image(Complex& complex, const Gray_image<Complex::dimension>& image,
                                  const Segmentation_options<Complex::dimension>& options = {}) {
  image.check();
  const Image_phases phases = internal::phases_of(image, options);
  for (const int label : complex.labels())
    if (label < 0 || std::size_t(label) >= phases.intensities.size())
      throw Error("the label " + std::to_string(label) + " of the complex is no index of a phase");
  complex.measure_interface_edges();
  return internal::segment(complex, image, options, phases, false);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_IMAGE_SEGMENTATION_SEGMENT_IMAGE_H

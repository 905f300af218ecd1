// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_SEGMENT_IMAGE_H
#define CGAL_IMAGE_SEGMENTATION_SEGMENT_IMAGE_H

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Image_segmentation/Segmentation_options.h>
#include <CGAL/Image_segmentation/Segmentation_report.h>
#include <CGAL/Image_segmentation/estimate_phases.h>
#include <CGAL/Image_segmentation/internal/segmentation/Cell_costs.h>
#include <CGAL/Image_segmentation/internal/segmentation/Segmenter.h>
#include <CGAL/Interface_remeshing/shared_measures.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {

// Returns a mesh of the pixels of an image, with a single label. The unit of length is the side of
// a pixel.
template <class Complex>
Complex mesh_of_image(const Gray_image<Complex::dimension>& image, double longest_edge) {
  static constexpr int d = Complex::dimension;
  const auto& grid = image.grid;
  const double side = image.side();
  std::array<double, d> sizes, corner;
  for (int axis = 0; axis < d; ++axis) {
    sizes[axis] = double(grid.size[axis]) * grid.spacing[axis] / side;
    corner[axis] = grid.origin[axis] - grid.spacing[axis] / 2;
  }
  const double edge = (std::min)(longest_edge, *std::max_element(sizes.begin(), sizes.end()));
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
  if (options.intensities.empty()) {
    result = estimate_phases(image, options.phases);
    if (!options.noise.empty())
      result.noise = options.noise;
  } else if (options.noise.empty() && options.intensities.front().size() == image.channels.size()) {
    const Progress_phase progress("estimating the noise of the image");
    const std::vector<double> noise = noise_of_differences(image);
    result.noise =
        noise_of(image, noise, averaging_blocks(image, noise, options.intensities.size()),
                 options.intensities);
  }
  if (result.noise.size() != image.channels.size() ||
      result.intensities.front().size() != image.channels.size())
    throw Error(
        "the intensities or the noise do not fit the image: give one number for each of its " +
        std::to_string(image.channels.size()) + " channels");
  return result;
}

// An image with noise of deviation 1 in each channel, and the intensities in this unit. Values
// farther than 10 deviations from all intensities and from the means of all small blocks are
// clamped. These are the values of defective pixels.
template <int d> struct Normalized_image
{
  Normalized_image(const Gray_image<d>& original, const Image_phases& phases)
      : image(original), intensities(phases.intensities), noise(phases.noise) {
    static constexpr double farthest = 10; // in deviations of the noise
    static constexpr std::size_t side = 3; // of a block, in pixels
    const Block_means blocks(original, side, noise);
    for (std::size_t k = 0; k < image.channels.size(); ++k) {
      double sum = 0;
      for (const auto& intensity : intensities)
        sum += intensity[k];
      centers.push_back(sum / double(intensities.size()));
      double low = 0, high = 0;
      for (auto& intensity : intensities) {
        intensity[k] = (intensity[k] - centers[k]) / noise[k];
        low = (std::min)(low, intensity[k] - farthest);
        high = (std::max)(high, intensity[k] + farthest);
      }
      for (const auto& of_block : blocks.means) {
        low = (std::min)(low, (of_block[k] - centers[k]) / noise[k] - farthest);
        high = (std::max)(high, (of_block[k] - centers[k]) / noise[k] + farthest);
      }
      for (std::size_t i = 0; i < image.channels[k].size(); ++i) {
        Progress_scope::check();
        if (image.has_value(i))
          image.channels[k][i] =
              float(std::clamp((double(image.channels[k][i]) - centers[k]) / noise[k], low, high));
      }
    }
  }

  // Returns intensities in the unit of the original image.
  std::vector<double> original(std::vector<double> intensity) const {
    for (std::size_t k = 0; k < intensity.size(); ++k)
      intensity[k] = centers[k] + noise[k] * intensity[k];
    return intensity;
  }

  Gray_image<d> image;
  std::vector<std::vector<double>> intensities;
  std::vector<double> noise, centers; // of each channel
};

// Adds the phases to a report.
template <class Complex>
void report_phases(const Complex& complex, const Cell_costs<Complex>& costs,
                   const Normalized_image<Complex::dimension>& image, Segmentation_report& report) {
  const double pixels = std::pow(costs.pixels_in_unit(), Complex::dimension);
  for (std::size_t label = 0; label < costs.intensities().size(); ++label)
    report.phases.push_back({int(label), image.original(costs.intensities()[label]),
                             complex.measure(int(label)) * pixels,
                             complex.number_of_components(int(label))});
}

// Adds the boundaries to a report. The noise is averaged over an edge, or over the distance along
// which the smoothing acts.
template <class Complex>
void report_boundaries(const Complex& complex, const Cell_costs<Complex>& costs,
                       double shortest_edge, Segmentation_report& report) {
  static constexpr int d = Complex::dimension;
  const double pixels = std::pow(costs.pixels_in_unit(), d - 1);
  for (const auto& [labels, area] : shared_measures(complex)) {
    const double contrast = std::sqrt(costs.squared_contrast(labels.first, labels.second)),
                 averaged = (std::max)(shortest_edge, std::sqrt(report.smoothing) / contrast);
    report.boundaries.push_back({labels.first, labels.second, area * pixels,
                                 1 / (contrast * std::pow(averaged, (d - 1) / 2.))});
  }
}

// Segments an image on a mesh, which gets its best labels first if `is_new`.
template <class Complex>
Segmentation_report segment(Complex& complex, const Gray_image<Complex::dimension>& image,
                            const Segmentation_options<Complex::dimension>& options,
                            const Image_phases& phases, bool is_new) {
  const Progress_phase phase("segmenting the image");
  const Normalized_image<Complex::dimension> normalized(image, phases);
  Cell_costs<Complex> costs(complex, normalized.image, normalized.intensities);
  static constexpr double few = .5; // pixels, more than rounding errors
  if (!(costs.pixels() > few))
    throw Error("no cell of the complex contains a pixel with a value: use a complex with the "
                "coordinates of the image");
  Segmenter<Complex> segmenter(complex, costs, options);
  if (is_new)
    segmenter.label_cells();
  complex.measure_interface_edges();
  Segmentation_report result;
  result.noise = normalized.noise;
  result.smoothing = segmenter.smoothing();
  segmenter.run(result);
  result.residual = costs.total() / (costs.pixels() * double(costs.channels()));
  report_phases(complex, costs, normalized, result);
  report_boundaries(complex, costs, options.shortest_edge, result);
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
and \f$\alpha\f$ is `Segmentation_options::smoothing`. Lengths are in pixels. A value that
is more than \f$10\,\sigma_k\f$ below or above all intensities and the means of all blocks of
three pixels is clamped. So defective pixels have little effect.

The mesh begins with equal cells. Cells get the labels that decrease the energy; cells across
boundaries are bisected; vertices of the interface move against the gradient of the energy. This is
repeated with shorter and shorter edges. The mesh stays coarse inside phases.

\tparam Complex a deformable simplicial complex whose domain is a box

\param image the image
\param options the options
\return the complex and the report. Labels are the indices of phases: of the given intensities, or in
        the order of the estimated ones. The user coordinates of the complex are those of the image.
\throws Error if the image or an option cannot be used, or if there are fewer separate classes of
        values than phases
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
      internal::mesh_of_image<Complex>(image, options.longest_edge), {}};
  result.second = internal::segment(result.first, image, options, phases, true);
  return result;
}

/*!
\ingroup PkgImageSegmentationRef

Improves a segmentation. The labels of a complex are the initial labels. So the topology can be
prescribed, with `Segmentation_options::keeps_topology`. Pixels outside the domain are not used, and
the image is 0 outside its pixels without any cost.

\param complex the complex. Its labels are indices of phases, and its user coordinates are those of
       the image, see `Labeled_complex::normalization()`.
\param image, options as above
\return the report
\throws Error as above, and if a label is no index of a phase, or no cell contains a pixel with a
        value. The complex is then unchanged.
\throws Interrupted_error as above; the complex is then valid.
*/
template <class Complex>
Segmentation_report segment_image(Complex& complex, const Gray_image<Complex::dimension>& image,
                                  const Segmentation_options<Complex::dimension>& options = {}) {
  image.check();
  const Image_phases phases = internal::phases_of(image, options);
  for (const int label : complex.labels())
    if (label < 0 || std::size_t(label) >= phases.intensities.size())
      throw Error("the label " + std::to_string(label) +
                  " of the complex is no index of a phase: use " +
                  std::to_string(phases.intensities.size()) + " phases from 0 on");
  return internal::segment(complex, image, options, phases, false);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_SEGMENT_IMAGE_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_ESTIMATE_PHASES_H
#define CGAL_IMAGE_SEGMENTATION_ESTIMATE_PHASES_H

#include <CGAL/Image_segmentation/Gray_image.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <Eigen/Dense>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgImageSegmentationRef
/// The phases and the noise of an image.
struct Image_phases
{
  std::vector<std::vector<double>> intensities; ///< for each phase, one for each channel
  std::vector<double> noise;                    ///< the standard deviation of each channel
};

namespace internal {

// Returns the middle value. Changes the order of the values. 0 if there are none.
inline double median(std::vector<double>& values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The standard deviation of normal numbers is this multiple of the median of their absolute values.
constexpr double deviation_over_median = 1.4826;

// Estimates the standard deviation of noise by second differences along the first axis, where a
// smooth image does not contribute. 0 if there are fewer than three pixels in a row.
template <int d> double noise_of_differences(const Gray_image<d>& image, std::size_t channel) {
  const std::vector<float>& values = image.channels[channel];
  std::vector<double> differences;
  const std::size_t n = image.grid.size[0];
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    Progress_scope::check();
    if (i % n != 0 && i % n != n - 1 && image.has_value(i - 1) && image.has_value(i) &&
        image.has_value(i + 1))
      differences.push_back(
          std::abs(double(values[i - 1]) - 2 * double(values[i]) + double(values[i + 1])));
  }
  return deviation_over_median / std::sqrt(6.) * median(differences);
}

// Means of an image over blocks of pixels, without values far from the median of a block. So
// defective pixels do not change them.
struct Block_means
{
  // Computes the means over blocks with a given side. `noise` is the deviation of each channel.
  template <int d>
  Block_means(const Gray_image<d>& image, std::size_t side, const std::vector<double>& noise) {
    std::array<std::size_t, d> blocks;
    std::size_t n = 1;
    for (int axis = 0; axis < d; ++axis)
      n *= blocks[axis] = (image.grid.size[axis] + side - 1) / side;
    std::vector<std::vector<std::size_t>> pixels(n); // of each block
    block_of.resize(image.channels.front().size());
    for (std::size_t pixel = 0; pixel < block_of.size(); ++pixel) {
      Progress_scope::check();
      std::size_t rest = pixel, block = 0, stride = 1;
      for (int axis = 0; axis < d; ++axis) {
        block += rest % image.grid.size[axis] / side * stride;
        stride *= blocks[axis];
        rest /= image.grid.size[axis];
      }
      block_of[pixel] = block;
      if (image.has_value(pixel))
        pixels[block].push_back(pixel);
    }
    std::vector<std::size_t> number_of(n, 0);
    std::vector<double> values;
    for (std::size_t block = 0; block < n; ++block) {
      number_of[block] = means.size();
      if (pixels[block].empty())
        continue;
      Progress_scope::check();
      means.emplace_back();
      for (std::size_t k = 0; k < image.channels.size(); ++k) {
        values.clear();
        for (const std::size_t pixel : pixels[block])
          values.push_back(double(image.channels[k][pixel]));
        means.back().push_back(clipped_mean(values, noise[k]));
      }
    }
    for (std::size_t& block : block_of)
      block = number_of[block];
  }

  std::vector<std::vector<double>> means; // for each block with values, of each channel
  std::vector<std::size_t> block_of;      // for each pixel with a value

private:
  static double clipped_mean(std::vector<double>& values, double noise) {
    static constexpr double distant = 4; // in deviations of the noise
    const double middle = median(values);
    double sum = 0;
    std::size_t n = 0;
    for (const double x : values)
      if (std::abs(x - middle) <= distant * noise) {
        sum += x;
        ++n;
      }
    return sum / double(n);
  }
};

// The largest number of phases, which is the number of bins of histograms.
constexpr std::size_t most_phases = 256;

// Divides numbers into k classes with the least sum of squared distances from the means of classes,
// by dynamic programming over a histogram. Outliers count in the outer bins. Returns the means;
// there are fewer if there are fewer different bins.
inline std::vector<double> means_of_classes(const std::vector<double>& numbers, std::size_t k) {
  static constexpr std::size_t bins = most_phases;
  const auto [least, largest] = std::minmax_element(numbers.begin(), numbers.end());
  const double low = *least, width = (*largest - low) / double(bins);
  if (!(width > 0))
    return {low};
  std::array<double, bins + 1> count = {}, sum = {}, squares = {}; // of the bins below
  for (const double x : numbers) {
    const std::size_t bin = (std::min)(std::size_t((x - low) / width), bins - 1) + 1;
    count[bin] += 1;
    sum[bin] += x - low;
    squares[bin] += (x - low) * (x - low);
  }
  for (std::size_t bin = 1; bin <= bins; ++bin) {
    count[bin] += count[bin - 1];
    sum[bin] += sum[bin - 1];
    squares[bin] += squares[bin - 1];
  }
  const auto scatter = [&](std::size_t from, std::size_t to) {
    const double n = count[to] - count[from], s = sum[to] - sum[from];
    return n > 0 ? squares[to] - squares[from] - s * s / n : 0.;
  };
  // The best division of the bins below `to` into classes, with the beginning of the last class.
  std::vector<std::array<double, bins + 1>> cost(k + 1);
  std::vector<std::array<std::size_t, bins + 1>> begin(k + 1);
  cost[0].fill(std::numeric_limits<double>::infinity());
  cost[0][0] = 0;
  for (std::size_t classes = 1; classes <= k; ++classes) {
    Progress_scope::check();
    for (std::size_t to = 0; to <= bins; ++to) {
      cost[classes][to] = std::numeric_limits<double>::infinity();
      begin[classes][to] = to;
      for (std::size_t from = 0; from <= to; ++from)
        if (const double c = cost[classes - 1][from] + scatter(from, to); c < cost[classes][to]) {
          cost[classes][to] = c;
          begin[classes][to] = from;
        }
    }
  }
  std::vector<double> result;
  for (std::size_t classes = k, to = bins; classes > 0; --classes) {
    const std::size_t from = begin[classes][to];
    if (const double n = count[to] - count[from]; n > 0)
      result.push_back(low + (sum[to] - sum[from]) / n);
    to = from;
  }
  std::reverse(result.begin(), result.end());
  return result;
}

inline double squared_distance_of(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    result += (a[k] - b[k]) * (a[k] - b[k]);
  return result;
}

inline std::size_t nearest_of(const std::vector<std::vector<double>>& centers,
                              const std::vector<double>& point) {
  std::size_t result = 0;
  for (std::size_t i = 1; i < centers.size(); ++i)
    if (squared_distance_of(centers[i], point) < squared_distance_of(centers[result], point))
      result = i;
  return result;
}

// Returns the direction of the largest variance of points.
inline Eigen::VectorXd principal_direction(const std::vector<std::vector<double>>& points) {
  const auto n = Eigen::Index(points.front().size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
  for (const auto& p : points)
    mean += Eigen::Map<const Eigen::VectorXd>(p.data(), n) / double(points.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (const auto& p : points) {
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(p.data(), n) - mean;
    covariance += x * x.transpose();
  }
  Eigen::VectorXd result =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(covariance).eigenvectors().col(n - 1);
  Eigen::Index largest = 0;
  result.cwiseAbs().maxCoeff(&largest);
  return result[largest] < 0 ? Eigen::VectorXd(-result) : result;
}

// Divides points into k classes (Lloyd's algorithm), from the best classes along
// the direction of the largest variance. Returns the means of the classes, in the order along this
// direction.
inline std::vector<std::vector<double>> means_of_classes(std::vector<std::vector<double>> points,
                                                         std::size_t k) {
  static constexpr int most_rounds = 100;
  const auto n = Eigen::Index(points.front().size());
  const Eigen::VectorXd direction = principal_direction(points);
  std::vector<double> along;
  along.reserve(points.size());
  for (const auto& p : points)
    along.push_back(direction.dot(Eigen::Map<const Eigen::VectorXd>(p.data(), n)));
  const std::vector<double> first = means_of_classes(along, k);
  std::vector<std::size_t> class_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 1; j < first.size(); ++j)
      if (std::abs(along[i] - first[j]) < std::abs(along[i] - first[class_of[i]]))
        class_of[i] = j;
  std::vector<std::vector<double>> result(first.size(), std::vector<double>(std::size_t(n), 0.));
  bool has_changed = true;
  for (int round = 0; round < most_rounds && has_changed; ++round) {
    std::vector<std::vector<double>> sums(result.size(), std::vector<double>(std::size_t(n), 0.));
    std::vector<std::size_t> counts(result.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ++counts[class_of[i]];
      for (std::size_t c = 0; c < std::size_t(n); ++c)
        sums[class_of[i]][c] += points[i][c];
    }
    for (std::size_t j = 0; j < result.size(); ++j)
      for (std::size_t c = 0; c < std::size_t(n) && counts[j] > 0; ++c)
        result[j][c] = sums[j][c] / double(counts[j]);
    has_changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Progress_scope::check();
      const std::size_t nearest = nearest_of(result, points[i]);
      has_changed = has_changed || nearest != class_of[i];
      class_of[i] = nearest;
    }
  }
  return result;
}

// Returns the range of a channel.
inline double range_of(const std::vector<std::vector<double>>& points, std::size_t channel) {
  const auto [least, largest] =
      std::minmax_element(points.begin(), points.end(), [channel](const auto& a, const auto& b) {
        return a[channel] < b[channel];
      });
  return (*largest)[channel] - (*least)[channel];
}

// Estimates the standard deviation of noise by the deviations of pixels from the intensity nearest
// to the mean of their block. In contrast to differences, textures count as noise.
template <int d>
double noise_of_phases(const Gray_image<d>& image, std::size_t channel, const Block_means& blocks,
                       const std::vector<std::vector<double>>& intensities) {
  std::vector<double> nearest, deviations;
  for (const auto& point : blocks.means)
    nearest.push_back(intensities[nearest_of(intensities, point)][channel]);
  for (std::size_t i = 0; i < blocks.block_of.size(); ++i)
    if (image.has_value(i))
      deviations.push_back(
          std::abs(double(image.channels[channel][i]) - nearest[blocks.block_of[i]]));
  return deviation_over_median * median(deviations);
}

// Returns the noise of differences of all channels.
template <int d> std::vector<double> noise_of_differences(const Gray_image<d>& image) {
  std::vector<double> result;
  for (std::size_t k = 0; k < image.channels.size(); ++k)
    result.push_back(noise_of_differences(image, k));
  return result;
}

// Returns the means over blocks that are large enough to average noise of the given deviations.
template <int d>
Block_means averaging_blocks(const Gray_image<d>& image, const std::vector<double>& noise,
                             std::size_t phases) {
  static constexpr double averaged = .03;   // noise of a block relative to the range of blocks
  static constexpr std::size_t largest = 9; // side of a block in pixels
  static constexpr std::size_t fewest = 64; // blocks for each phase
  std::size_t side = 3;
  Block_means blocks(image, side, noise);
  const auto is_averaged = [&] {
    for (std::size_t k = 0; k < noise.size(); ++k)
      if (noise[k] * std::pow(double(side), -d / 2.) > averaged * range_of(blocks.means, k))
        return false;
    return true;
  };
  if (blocks.means.size() < fewest * phases)
    return Block_means(image, 1, noise);
  while (side < largest && !is_averaged()) {
    Block_means larger(image, side += 2, noise);
    if (larger.means.size() < fewest * phases)
      break;
    blocks = std::move(larger);
  }
  return blocks;
}

// Returns the noise of an image with phases of given intensities, see `estimate_phases()`. `result`
// is the noise of differences.
template <int d>
std::vector<double> noise_of(const Gray_image<d>& image, std::vector<double> result,
                             const Block_means& blocks,
                             const std::vector<std::vector<double>>& intensities) {
  static constexpr double least_noise = .1; // relative to the smallest contrast
  for (std::size_t k = 0; k < image.channels.size(); ++k) {
    double contrast = std::numeric_limits<double>::infinity();
    for (const auto& a : intensities)
      for (const auto& b : intensities)
        if (a[k] < b[k])
          contrast = (std::min)(contrast, b[k] - a[k]);
    result[k] = (std::max)(result[k], noise_of_phases(image, k, blocks, intensities));
    if (std::isfinite(contrast))
      result[k] = (std::max)(result[k], least_noise * contrast);
    if (!(result[k] > 0))
      result[k] = 1; // a constant channel
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgImageSegmentationRef

Estimates the intensities of the phases of an image, and its noise. Means over blocks of pixels,
without defective pixels, are divided into classes with the least squared deviations (k-means; for
one channel, the classes of Otsu). The blocks are large enough to average the noise. The noise is
the larger one of two robust estimates: by second differences of neighbors, and by the deviations of
pixels from the classes. So a texture counts as noise. The noise is at least a tenth of the smallest
contrast, because the pixels of an image without noise do not follow a smooth boundary. A phase that
fills no block is not found.

n log n in the number of pixels, times the number of phases.

\param image the image
\param phases the number of phases, from 1 to 256
\return the phases in the order of their intensities, for several channels in the direction of the
        largest variance
\throws Error if the image cannot be used, the number of phases is out of range, or there are fewer
        separate classes of values
\throws Interrupted_error if the callback of a `Progress_scope` returned `false`
*/
template <int d> Image_phases estimate_phases(const Gray_image<d>& image, unsigned phases) {
  const Progress_phase progress("estimating the phases of the image");
  image.check();
  if (phases == 0 || phases > internal::most_phases)
    throw Error("the number of phases is out of range: use 1 to 256");
  const std::vector<double> noise = internal::noise_of_differences(image);
  const internal::Block_means blocks = internal::averaging_blocks(image, noise, phases);
  Image_phases result;
  result.intensities = internal::means_of_classes(blocks.means, phases);
  if (result.intensities.size() < phases)
    throw Error("only " + std::to_string(result.intensities.size()) +
                " separate classes of values were found: use fewer phases than " +
                std::to_string(phases) + ", or give the intensities of the phases");
  result.noise = internal::noise_of(image, noise, blocks, result.intensities);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_ESTIMATE_PHASES_H

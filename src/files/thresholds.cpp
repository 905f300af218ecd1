// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Translation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace dsc_files {
namespace {

constexpr std::size_t bins = 256;
constexpr int most_thresholds = 8;

/// Sums of the values in the first bins of a histogram.
struct Sums
{
  std::array<double, bins + 1> number = {}, value = {};

  /// Returns the contribution of a class of bins to the variance between classes.
  double variance(std::size_t begin, std::size_t end) const {
    const double n = number[end] - number[begin], sum = value[end] - value[begin];
    return n > 0 ? sum * sum / n : 0;
  }
};

/// Returns the thresholds that maximize the variance between the classes of values (N. Otsu, "A
/// threshold selection method from gray-level histograms", 1979), with a histogram of 256 classes.
/// Values that are not finite are ignored.
/// \param number from 1 to 8
/// \throws Failure if there are not enough different values
std::vector<double> otsu_thresholds(const std::vector<double>& values, int number) {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const double value : values)
    if (std::isfinite(value)) {
      least = (std::min)(least, value);
      largest = (std::max)(largest, value);
    }
  if (!(least < largest))
    throw Failure("has a single value, so that no threshold can be chosen");
  const double width = largest / bins - least / bins;
  Sums sums;
  for (const double value : values)
    if (std::isfinite(value)) {
      const auto bin = (std::min)(bins - 1, std::size_t((value - least) / width));
      sums.number[bin + 1] += 1;
      sums.value[bin + 1] += double(bin);
    }
  for (std::size_t i = 0; i < bins; ++i) {
    sums.number[i + 1] += sums.number[i];
    sums.value[i + 1] += sums.value[i];
  }
  // best[k][end]: largest variance of k + 1 classes that cover the first bins.
  const auto classes = std::size_t(number) + 1;
  std::vector<std::array<double, bins + 1>> best(classes);
  std::vector<std::array<std::size_t, bins + 1>> begin(classes);
  for (std::size_t end = 0; end <= bins; ++end)
    best[0][end] = sums.variance(0, end);
  for (std::size_t k = 1; k < classes; ++k)
    for (std::size_t end = 0; end <= bins; ++end) {
      best[k][end] = -1;
      for (std::size_t cut = 0; cut <= end; ++cut)
        if (const double variance = best[k - 1][cut] + sums.variance(cut, end);
            variance > best[k][end]) {
          best[k][end] = variance;
          begin[k][end] = cut;
        }
    }
  std::vector<double> result;
  std::size_t end = bins;
  for (std::size_t k = classes - 1; k > 0; --k) {
    end = begin[k][end];
    result.push_back(least + double(end) * width);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace

std::vector<double> thresholds_of(const std::string& option, const std::vector<double>& values) {
  const std::string automatic = "otsu";
  if (option == automatic)
    return otsu_thresholds(values, 1);
  if (option.compare(0, automatic.size() + 1, automatic + ':') == 0) {
    const std::string number = option.substr(automatic.size() + 1);
    if (number.size() != 1 || number[0] < '1' || number[0] > '0' + most_thresholds)
      throw Failure("--threshold " + option + ": write otsu:1 to otsu:8");
    return otsu_thresholds(values, number[0] - '0');
  }
  std::vector<double> result;
  std::istringstream words(option);
  for (std::string word; std::getline(words, word, ',');) {
    std::istringstream in(word);
    double value = 0;
    if (!(in >> value) || !in.eof() || (!result.empty() && !(value > result.back())))
      throw Failure("--threshold " + option +
                    ": write increasing numbers like 100,200, or otsu, or otsu:2");
    result.push_back(value);
  }
  if (result.empty())
    throw Failure("--threshold is empty");
  return result;
}

} // namespace dsc_files

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_HISTOGRAMS_H
#define DSC_HISTOGRAMS_H

#include <cstddef>
#include <string>
#include <vector>

namespace dsc {

/// The distribution of a quantity.
struct Histogram
{
  std::string quantity;        ///< its name and unit, below the axis
  std::vector<double> values;  ///< of the quantity
  std::vector<double> weights; ///< of the values; 1 for all if empty
  double low = 0, high = 1;    ///< range of the axis; other values count in the outer bins
  std::size_t bins = 20;
  bool is_integer = false; ///< whether each bin is an integer, which names it

  /// Returns the density in each bin: the integral over the axis is 1; 0 without values.
  std::vector<double> densities() const;
};

/// Draws histograms next to each other (.svg).
/// \throws std::runtime_error if the file cannot be written
void write_histograms(const std::string& path, const std::vector<Histogram>& histograms);

} // namespace dsc

#endif // DSC_HISTOGRAMS_H

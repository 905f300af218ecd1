// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_WORST_CELLS_H
#define DSC_BENCHMARK_WORST_CELLS_H

#include <CGAL/determinant.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace dsc_benchmark {

/// The quality of a cell from the coordinates of its corners, 1 for the regular cell. In space, it
/// is the volume divided by the cube of the root mean square edge length. In the plane, it is the
/// area divided by the mean square edge length. An independent implementation that verifies the
/// measures of the complexes.
template <class Complex>
double volume_length_ratio(const Complex& complex, typename Complex::Cell_handle c) {
  constexpr int d = Complex::dimension;
  double edges[d][d], squares = 0;
  for (int i = 0; i < d; ++i)
    for (int k = 0; k < d; ++k)
      edges[i][k] = complex.corner(c, i + 1)[k] - complex.corner(c, 0)[k];
  for (int k = 0; k < d; ++k)
    for (int i = 0; i < d; ++i) {
      squares += edges[i][k] * edges[i][k];
      for (int j = 0; j < i; ++j)
        squares += (edges[i][k] - edges[j][k]) * (edges[i][k] - edges[j][k]);
    }
  const double mean = squares / (d * (d + 1) / 2);
  if constexpr (d == 3)
    return std::sqrt(2.) *
           CGAL::determinant(edges[0][0], edges[0][1], edges[0][2], edges[1][0], edges[1][1],
                             edges[1][2], edges[2][0], edges[2][1], edges[2][2]) /
           (mean * std::sqrt(mean));
  else
    return 2 / std::sqrt(3.) *
           CGAL::determinant(edges[0][0], edges[0][1], edges[1][0], edges[1][1]) / mean;
}

/// The worst cells of a complex after each step, with a verification of reports.
struct Worst_cells
{
  std::size_t steps = 0;      ///< that were examined
  std::size_t flat_steps = 0; ///< after which a cell was below the floor
  std::size_t most = 0;       ///< the largest number of these cells after a step
  double quality = 1;         ///< the worst quality after any step

  /// Adds a step.
  /// \throws std::runtime_error unless `report.flat` contains exactly the cells below the floor,
  /// with their qualities.
  template <class Complex, class Report> void add(const Complex& complex, const Report& report) {
    std::map<typename Complex::Cell_handle, double> named;
    for (const auto& item : report.flat)
      named.emplace(item.cell, item.quality);
    std::size_t count = 0;
    for (const typename Complex::Cell_handle c : complex.cells()) {
      const double q = volume_length_ratio(complex, c);
      quality = (std::min)(quality, q);
      if (!(q < Complex::quality_floor))
        continue;
      ++count;
      const auto item = named.find(c);
      static constexpr double rounding = 1e-9; // relative difference of two formulas
      if (item == named.end() || !(std::abs(item->second - q) <= rounding))
        fail("a cell below the floor is not reported as it is", q);
    }
    if (count != report.flat.size())
      fail("more cells are reported than are below the floor", double(report.flat.size()));
    ++steps;
    flat_steps += count > 0;
    most = (std::max)(most, count);
  }

private:
  static void fail(const std::string& message, double number) {
    std::ostringstream out;
    out << message << ": " << number;
    throw std::runtime_error(out.str());
  }
};

/// The cells of a table: worst quality, steps with cells below the floor, largest number of such
/// cells.
inline std::ostream& operator<<(std::ostream& out, const Worst_cells& worst) {
  return out << worst.quality << " | " << worst.flat_steps << " | " << worst.most;
}

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_WORST_CELLS_H

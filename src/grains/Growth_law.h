// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GROWTH_LAW_H
#define DSC_GROWTH_LAW_H

#include "Grain_run.h"

#include <CGAL/Interface_flows/grain_statistics.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace dsc {

/// Compares the growth of grains with the law for unit tension and mobility: a regression through
/// the origin.
template <class Complex> class Growth_law
{
public:
  using Statistics = std::vector<CGAL::Deformable_simplicial_complexes::Grain_statistics>;

  /// Takes the statistics before a step.
  void begin(const Complex& complex) { m_before = grain_statistics(complex); }

  /// Adds the rates of growth in a step; in the plane, of the grains whose numbers of corners have
  /// not changed. Mean rates are those of grains that touch no side.
  void end(const Complex& complex, double dt) {
    std::map<int, CGAL::Deformable_simplicial_complexes::Grain_statistics> after;
    for (const auto& grain : grain_statistics(complex))
      after.emplace(grain.label, grain);
    for (const auto& grain : m_before)
      if (const auto found = after.find(grain.label);
          found != after.end() && found->second.corners == grain.corners &&
          found->second.right_angles == grain.right_angles)
        add(grain, (found->second.measure - grain.measure) / dt);
  }

  /// Writes the slope, the correlation and the mean rates.
  void write(Grain_result& result) const {
    result.slope = m_xx > 0 ? m_xy / m_xx : 0;
    result.correlation = m_xx > 0 && m_yy > 0 ? m_xy / std::sqrt(m_xx * m_yy) : 0;
    result.rates = m_rates;
  }

private:
  static constexpr int d = Complex::dimension;

  void add(const CGAL::Deformable_simplicial_complexes::Grain_statistics& grain, double rate) {
    const double x = grain.growth(d);
    m_xx += x * x;
    m_xy += x * rate;
    m_yy += rate * rate;
    if (d == 2 && grain.right_angles == 0) {
      m_rates[grain.corners].sum += rate;
      ++m_rates[grain.corners].number;
    }
  }

  Statistics m_before;
  double m_xx = 0, m_xy = 0, m_yy = 0;
  std::map<std::size_t, Grain_rate> m_rates;
};

} // namespace dsc

#endif // DSC_GROWTH_LAW_H

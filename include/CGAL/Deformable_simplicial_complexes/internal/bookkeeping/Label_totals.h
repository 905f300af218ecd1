// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_LABEL_TOTALS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_LABEL_TOTALS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Number of cells and volume of every label, kept up to date cell by cell. Volumes are added in
// fixed point, so that the totals do not depend on the order of the changes and never drift: they
// are at any time the sum over the cells that exist.
class Label_totals
{
public:
  struct Total
  {
    int label;
    std::size_t cells;
    std::int64_t volume;
  };

  // The unit is 2^-62 of a power of two above the volume of the domain.
  explicit Label_totals(double domain_volume = 1) {
    int exponent;
    std::frexp(domain_volume, &exponent);
    m_to_units = std::ldexp(1., 61 - exponent);
  }

  std::int64_t units(double volume) const { return std::llrint(volume * m_to_units); }

  double volume_of(std::int64_t units) const { return double(units) / m_to_units; }

  // Changes of this label's totals need no memory afterwards.
  void make_room(int label) { total(label); }

  void add_cell(int label, double volume) {
    Total& t = total(label);
    ++t.cells;
    t.volume += units(volume);
  }

  void remove_cell(int label, double volume) {
    Total& t = total(label);
    --t.cells;
    t.volume -= units(volume);
  }

  void add_volume(int label, std::int64_t units) { total(label).volume += units; }

  std::int64_t units_of(int label) const {
    const Total* t = find(label);
    return t ? t->volume : 0;
  }

  double volume(int label) const {
    const Total* t = find(label);
    return t ? volume_of(t->volume) : 0.;
  }

  std::size_t cells(int label) const {
    const Total* t = find(label);
    return t ? t->cells : 0;
  }

  // Sorted by label; labels that once had cells stay.
  const std::vector<Total>& totals() const { return m_totals; }

private:
  static bool is_below(const Total& t, int label) { return t.label < label; }

  const Total* find(int label) const {
    const auto it = std::lower_bound(m_totals.begin(), m_totals.end(), label, is_below);
    return it != m_totals.end() && it->label == label ? &*it : nullptr;
  }

  Total& total(int label) {
    auto it = std::lower_bound(m_totals.begin(), m_totals.end(), label, is_below);
    if (it == m_totals.end() || it->label != label)
      it = m_totals.insert(it, {label, 0, 0});
    return *it;
  }

  double m_to_units;
  std::vector<Total> m_totals;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_LABEL_TOTALS_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_LABEL_TOTALS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_LABEL_TOTALS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The number of cells and the volume of every label, updated cell by cell. Volumes are added in
// fixed point. The totals therefore do not depend on the order of changes and accumulate no
// rounding errors: they always equal the sums over the existing cells.
class Label_totals
{
public:
  struct Total
  {
    int label;
    std::size_t cells;
    std::int64_t volume;
  };

  // Chooses the unit of volumes: 2^-61 times the smallest power of two greater than
  // `domain_volume`.
  explicit Label_totals(double domain_volume = 1) {
    int exponent;
    std::frexp(domain_volume, &exponent);
    m_to_units = std::ldexp(1., 61 - exponent);
  }

  std::int64_t units(double volume) const { return std::llrint(volume * m_to_units); }

  double volume_of(std::int64_t units) const { return double(units) / m_to_units; }

  // Allocates the entry of a label, so that later changes of its totals need no memory.
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

  // Returns the totals, sorted by label. Labels that no longer have cells are included.
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_LABEL_TOTALS_H

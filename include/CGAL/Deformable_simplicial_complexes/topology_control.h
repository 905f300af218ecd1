// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_CONTROL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_CONTROL_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <algorithm>
#include <utility>
#include <vector>

/// \file
/// Models of `TopologyControl`: values of the parameter `topology_control()`, which permit or
/// forbid changes of the topology of the interface.

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Topology control that permits all changes: components of a phase may merge, split, appear and
/// vanish. This is the default.
/// \cgalModels{TopologyControl}
struct Allow_topology_changes
{
  /// Returns true.
  template <class Complex>
  bool operator()(const Complex& /*complex*/, typename Complex::Cell_handle /*cell*/,
                  typename Complex::Label /*label*/) const {
    return true;
  }
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Topology control that forbids all changes: the Betti numbers of each phase and of the interface
/// stay the same. Vertices that would have to pass through another part of the interface do not
/// reach their destinations.
/// \cgalModels{TopologyControl}
struct Forbid_topology_changes
{
  /// Returns false.
  template <class Complex>
  bool operator()(const Complex& /*complex*/, typename Complex::Cell_handle /*cell*/,
                  typename Complex::Label /*label*/) const {
    return false;
  }
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Topology control that permits changes only where space passes from one label of a given pair to
/// the other, in either direction.
/// \cgalModels{TopologyControl}
class Allow_topology_changes_between
{
public:
  /// Constructs the control.
  /// \param pairs pairs of labels; the order in a pair does not matter
  explicit Allow_topology_changes_between(std::vector<std::pair<int, int>> pairs)
      : m_pairs(std::move(pairs)) {}

  /// Returns whether the label of the cell and the new label are one of the pairs.
  template <class Complex>
  bool operator()(const Complex& /*complex*/, typename Complex::Cell_handle cell,
                  typename Complex::Label label) const {
    const auto is_pair = [&](const std::pair<int, int>& pair) {
      return pair == std::pair<int, int>(cell->subdomain_index(), label) ||
             pair == std::pair<int, int>(label, cell->subdomain_index());
    };
    return std::any_of(m_pairs.begin(), m_pairs.end(), is_pair);
  }

private:
  std::vector<std::pair<int, int>> m_pairs;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_CONTROL_H

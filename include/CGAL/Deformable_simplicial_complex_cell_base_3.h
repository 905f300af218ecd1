// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H

#include <CGAL/Triangulation_cell_base_3.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Cell of a deformable simplicial complex: a label, the quality cached by the complex, the connected
component of its label that it belongs to, and a time stamp that orders cells by creation. The
setters are for the complex; calling them from outside breaks what it caches.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Cb a cell base class of 3D triangulations

\cgalModels `DeformableSimplicialComplexCellBase_3`
*/
template <class Traits, class Cb = Triangulation_cell_base_3<Traits>>
class Deformable_simplicial_complex_cell_base_3 : public Cb
{
public:
  using Has_timestamp = Tag_true; ///< makes the container of the cells number them

  /// The cell of another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Cb2 = typename Cb::template Rebind_TDS<Tds2>::Other;            ///< `Cb` for `Tds2`
    using Other = Deformable_simplicial_complex_cell_base_3<Traits, Cb2>; ///< the same for `Tds2`
  };

  using Cb::Cb;

  /// The number in the order of creation; `std::size_t(-1)` for a cell outside a container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// The phase that fills the cell; 0 for infinite cells, where it means nothing.
  int label() const { return m_label; }
  /// Sets `label()`.
  void set_label(int label) { m_label = label; }

  /// Quality by the measure of the complex, as of the last change of the cell.
  double quality() const { return m_quality; }
  /// Sets `quality()`.
  void set_quality(double quality) { m_quality = quality; }

  /// Identifies the connected component of the label.
  std::uint32_t component() const { return m_component; }
  /// Sets `component()`.
  void set_component(std::uint32_t component) { m_component = component; }

  /// Quality at which improving the cell was last tried in vain; above 1 if it never was.
  float exhausted_quality() const { return m_exhausted_quality; }
  /// Sets `exhausted_quality()`.
  void set_exhausted_quality(float quality) { m_exhausted_quality = quality; }

private:
  int m_label = 0;
  std::uint32_t m_component = 0;
  float m_exhausted_quality = 2;
  double m_quality = 1;
  std::size_t m_time_stamp = std::size_t(-1);
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H

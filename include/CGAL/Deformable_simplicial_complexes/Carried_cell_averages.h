// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CARRIED_CELL_AVERAGES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CARRIED_CELL_AVERAGES_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/cell_corners.h>
#include <CGAL/Deformable_simplicial_complexes/internal/values/redistribute_contents.h>

#include <CGAL/property_map.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A visitor by which averages over cells, such as densities or concentrations, follow changes of the
mesh conservatively: the integral over the domain, the sum of averages times volumes, stays what it
is up to rounding.

<b>While there is such a visitor, the map holds integrals over cells</b>: the constructor multiplies
all averages by the volumes of their cells, the destructor divides by those of then. In between, the
map must not be written to. So that a deformation is a motion of what is in the cells, each carries
its integral along: its average rises where it is compressed, and a cell that is relabeled gives
what is in it to the other phase. A step of a simulation makes a visitor, deforms and improves, and
is done with it.

Where cells are replaced or a vertex is smoothed, what was in the old cells goes to the new ones of
the same label. A new cell takes from each old one what their common volume had. If the interface
is elsewhere, what was in old cells outside the new ones of their label fills, evenly, what those
cover in addition; what there is no room for goes to all of them by volume. If there is no new cell
of the label any more, the others take it. Thus

- each phase keeps its integral in all changes of the mesh that leave it a cell there;
- where volumes of phases stay the same, a constant stays the same, up to rounding;
- where the interface stays as it is, averages stay within the bounds of those replaced.

Rounding is that of volumes: relative to the quality of the thinnest cells for averages, relative to
the largest magnitude for the integral.

\tparam Complex an instance of `Deformable_simplicial_complex_2` or `Deformable_simplicial_complex_3`
\tparam CellValueMap model of `ReadWritePropertyMap` with the key type `Complex::Cell_handle`. It is
        copied, and reads and writes of cells that there are must not throw. Cells that are gone
        keep their values, and handles of new ones may equal those of old ones: identify cells by
        their time stamps. Values can be added, `v + w`, and multiplied, `2. * v`.

\cgalModels `DeformationVisitor`
*/
template <class Complex, class CellValueMap>
class Carried_cell_averages : public Deformation_visitor
{
public:
  using Cell_handle = typename Complex::Cell_handle;     ///< cell of the complex
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Point = typename Complex::Point;                 ///< as in the complex
  using Cavity = typename Complex::Cavity;               ///< as in the complex
  using Value = typename boost::property_traits<CellValueMap>::value_type; ///< an average

  /// Turns the averages of all finite cells into integrals. The complex must outlive the visitor.
  /// \pre each finite cell has a value. Linear in the number of cells.
  Carried_cell_averages(const Complex& complex, const CellValueMap& averages)
      : m_complex(complex), m_values(averages) {
    for (Cell_handle c : m_complex.finite_cells())
      multiply(c, volume(c));
  }

  /// Turns integrals into averages again, whether or not a deformation ended by an exception.
  /// Linear in the number of cells.
  ~Carried_cell_averages() {
    for (Cell_handle c : m_complex.finite_cells())
      multiply(c, 1 / volume(c));
  }

  /// Not to be copied: pass it by `std::ref()`.
  Carried_cell_averages(const Carried_cell_averages&) = delete;
  /// Not to be copied: pass it by `std::ref()`.
  Carried_cell_averages& operator=(const Carried_cell_averages&) = delete;

  /// Computes what will be in new cells. n log n in the number of old and new cells, plus the pairs
  /// of them that overlap along the x-axis.
  void before_replacement(const Cavity& cavity) {
    begin(cavity.removed());
    for (const auto& t : cavity.planned())
      if (!cavity.is_infinite(t.vertices)) {
        Corners corners;
        for (int i = 0; i < Complex::corners; ++i)
          corners[i] = near(cavity.vertices()[t.vertices[i]].position);
        add_target(corners, t.parent->label());
      }
    redistribute();
  }
  /// Gives new cells their values.
  void after_replacement(const Cavity& cavity) { put_contents(cavity.created()); }

  /// Computes what will be in the cells around `v`. n log n in their number, plus the pairs of old
  /// and new ones that overlap along the x-axis.
  void before_smoothing(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const Point& target) {
    begin(star);
    const auto position = near(m_complex.approximate(target));
    for (Cell_handle c : star)
      if (!m_complex.is_infinite(c)) {
        Corners moved = internal::cell_corners(m_complex, c, m_middle);
        moved[c->index(v)] = position;
        add_target(moved, c->label());
      }
    redistribute();
  }
  /// Gives the cells around the vertex their values.
  void after_smoothing(Vertex_handle, const std::vector<Cell_handle>& star) { put_contents(star); }

private:
  using Space = typename Complex::Space;
  using Simplex = internal::Filled_simplex<Space, Value>;
  using Clipping = internal::Clipping_simplex<Space>;
  using Corners = internal::Cell_corners<Complex>;

  double volume(Cell_handle c) const {
    return internal::positive_measure<Space>(internal::cell_corners(m_complex, c));
  }

  // On a torus, all is seen from one place.
  typename Complex::Approximate_point near(const typename Complex::Approximate_point& p) const {
    return m_complex.domain().near(m_middle, p);
  }

  void multiply(Cell_handle c, double factor) {
    const Value product = factor * get(m_values, c);
    put(m_values, c, product);
  }

  // Begins with the contents of cells, and without targets.
  void begin(const std::vector<Cell_handle>& cells) {
    m_from.clear();
    m_to.clear();
    for (Cell_handle c : cells) {
      if (m_complex.is_infinite(c))
        continue;
      if (m_from.empty())
        m_middle = m_complex.position(c->vertex(0));
      m_from.push_back(
          {Clipping(internal::cell_corners(m_complex, c, m_middle)), c->label(), get(m_values, c)});
    }
  }

  void add_target(const Corners& corners, int label) {
    const Value nothing = 0. * m_from.front().content;
    m_to.push_back({Clipping(corners), label, nothing});
  }

  void redistribute() { internal::redistribute_contents(m_from, m_to); }

  // Finite cells have contents, in the order in which they are planned.
  void put_contents(const std::vector<Cell_handle>& cells) {
    auto next = m_to.begin();
    for (Cell_handle c : cells)
      if (!m_complex.is_infinite(c))
        put(m_values, c, (next++)->content);
  }

  const Complex& m_complex;
  CellValueMap m_values;
  std::vector<Simplex> m_from, m_to;
  typename Complex::Approximate_point m_middle; // of what is replaced, about
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CARRIED_CELL_AVERAGES_H

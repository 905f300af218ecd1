// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_CARRIED_CELL_AVERAGES_H
#define CGAL_INTERFACE_REMESHING_CARRIED_CELL_AVERAGES_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/property_map.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Returns the measure of a simplex, which is positive in spite of rounding: thin simplices have
// contents, too.
template <class Space, class Corners> double positive_measure(const Corners& corners) {
  static constexpr double least = 1e-150; // below the rounding error of any measure
  return (std::max)(least, signed_measure<Space>(corners));
}

// A positively oriented triangle or tetrahedron, and its content.
template <class Space, class Value> struct Filled_simplex
{
  Clipping_simplex<Space> simplex;
  int label;
  Value content;

  double measure() const { return positive_measure<Space>(simplex.corners()); }
};

// Returns the pairs of indices of a source and a target whose bounding boxes intersect, sorted.
template <class Space, class Simplex>
std::vector<std::pair<std::size_t, std::size_t>>
pairs_that_may_overlap(const std::vector<const Simplex*>& sources,
                       const std::vector<Simplex*>& targets) {
  using Box = Box_intersection_d::Box_with_info_d<double, Space::dimension, std::size_t>;
  const auto boxes_of = [](const auto& simplices) {
    std::vector<Box> result;
    for (std::size_t i = 0; i < simplices.size(); ++i)
      result.emplace_back(simplices[i]->simplex.bbox(), i);
    return result;
  };
  std::vector<Box> from = boxes_of(sources), to = boxes_of(targets);
  std::vector<std::pair<std::size_t, std::size_t>> result;
  box_intersection_d(from.begin(), from.end(), to.begin(), to.end(),
                     [&](const Box& s, const Box& t) { result.emplace_back(s.info(), t.info()); });
  std::sort(result.begin(), result.end());
  return result;
}

// Transfers the contents of `sources` to `targets`. Where they overlap, a source fills a target
// with its own density. The content of the sources outside the targets fills the uncovered parts of
// the targets. If these parts are smaller than the uncovered parts of the sources, the rest is
// distributed to all targets by measure.
template <class Space, class Value>
void pour(const std::vector<const Filled_simplex<Space, Value>*>& sources,
          const std::vector<Filled_simplex<Space, Value>*>& targets) {
  std::vector<double> gaps, overlaps;
  double measure = 0; // of all targets
  for (const auto* t : targets) {
    gaps.push_back(t->measure());
    measure += gaps.back();
  }
  double excess = 0; // measure of sources outside the targets
  Value left = 0. * sources.front()->content;
  const auto pairs = pairs_that_may_overlap<Space>(sources, targets);
  auto pair = pairs.begin();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto* s = sources[i];
    const auto first = pair;
    overlaps.clear();
    double sum = 0;
    for (; pair != pairs.end() && pair->first == i; ++pair) {
      overlaps.push_back(overlap_measure(s->simplex, targets[pair->second]->simplex));
      sum += overlaps.back();
    }
    const double whole = (std::max)(sum, s->measure()); // less by rounding only
    for (std::size_t k = 0; k < overlaps.size(); ++k) {
      const std::size_t j = first[std::ptrdiff_t(k)].second;
      targets[j]->content = targets[j]->content + overlaps[k] / whole * s->content;
      gaps[j] -= overlaps[k];
    }
    left = left + (whole - sum) / whole * s->content;
    excess += whole - sum;
  }
  if (!(excess > 0))
    return;
  double gap = 0;
  for (double& g : gaps)
    gap += g = (std::max)(0., g); // negative because of rounding only
  const double fill = 1 / (std::max)(gap, excess), spread = (1 - fill * gap) / measure;
  for (std::size_t j = 0; j < targets.size(); ++j)
    targets[j]->content =
        targets[j]->content + (fill * gaps[j] + spread * targets[j]->measure()) * left;
}

// Transfers contents label by label: the content of the sources of a label goes to the targets of
// the same label, or to all targets if there are none.
template <class Space, class Value>
void redistribute_contents(const std::vector<Filled_simplex<Space, Value>>& from,
                           std::vector<Filled_simplex<Space, Value>>& to) {
  using Simplex = Filled_simplex<Space, Value>;
  std::vector<int> labels;
  for (const Simplex& t : from)
    if (std::find(labels.begin(), labels.end(), t.label) == labels.end())
      labels.push_back(t.label);
  for (int label : labels) {
    std::vector<const Simplex*> sources;
    std::vector<Simplex*> targets;
    for (const Simplex& t : from)
      if (t.label == label)
        sources.push_back(&t);
    for (Simplex& t : to)
      if (t.label == label)
        targets.push_back(&t);
    if (targets.empty())
      for (Simplex& t : to)
        targets.push_back(&t);
    pour(sources, targets);
  }
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Visitor that transfers averages over cells, such as densities or concentrations, when the mesh
changes. The transfer is conservative: the integral over the domain, which is the sum of averages
times volumes, stays the same up to rounding.

<b>While such a visitor exists, the map holds integrals over cells.</b> The constructor multiplies
all averages by the volumes of their cells. The destructor divides by the volumes at that time. In
between, the map must not be written to. During a deformation, each cell keeps its integral. The
average of a compressed cell thus rises, and the content of a relabeled cell goes to the other
phase. A time step of a simulation constructs a visitor, deforms and improves the mesh, and destroys
the visitor.

When cells are replaced or a vertex is smoothed, the content of the old cells goes to the new cells
of the same label. A new cell takes from each old cell the content of their intersection. If the
interface has changed, some content lies in parts of old cells outside the new cells of their label.
This content fills, evenly, the parts of the new cells outside the old cells of the label. If there
are no such parts, the content is distributed over all new cells of the label by volume. If there is
no new cell of the label, the cells of the other labels take the content. Hence:

- each phase keeps its integral in all changes of the mesh that leave it a cell there;
- where volumes of phases stay the same, a constant stays the same, up to rounding;
- where the interface stays the same, averages stay within the bounds of the averages that they
  replace.

The rounding errors are those of the volumes. For averages, they are relative to the quality of the
thinnest cells; for the integral, relative to the largest magnitude.

\tparam Complex an instance of `Deformable_simplicial_complex_2` or
        `Deformable_simplicial_complex_3`
\tparam CellValueMap model of `ReadWritePropertyMap` with the key type `Complex::Cell_handle`. The
        visitor copies the map. Reads and writes for existing cells must not throw. Removed cells
        keep their values, and handles of new cells may equal those of removed cells; identify cells
        by their time stamps. Values can be added, `v + w`, and multiplied, `2. * v`.
*/
template <class Complex, class CellValueMap>
class Carried_cell_averages : public Deformation_visitor<Complex>
{
public:
  using Cell_handle = typename Complex::Cell_handle;     ///< cell of the complex
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Point = typename Complex::Point;                 ///< point of the complex
  using Cavity = typename Complex::Cavity;               ///< cavity of the complex
  using Value = typename boost::property_traits<CellValueMap>::value_type; ///< average over a cell

  /// Turns the averages of all finite cells into integrals. Linear in the number of cells. The
  /// complex must outlive the visitor.
  /// \pre each finite cell has a value
  Carried_cell_averages(const Complex& complex, const CellValueMap& averages)
      : m_complex(complex), m_values(averages) {
    for (Cell_handle c : m_complex.finite_cells())
      multiply(c, volume(c));
  }

  /// Turns the integrals into averages again, also after an exception. Linear in the number of
  /// cells.
  ~Carried_cell_averages() override {
    for (Cell_handle c : m_complex.finite_cells())
      multiply(c, 1 / volume(c));
  }

  /// Not copyable; pass the visitor by `std::ref()`.
  Carried_cell_averages(const Carried_cell_averages&) = delete;
  /// Not copyable; pass the visitor by `std::ref()`.
  Carried_cell_averages& operator=(const Carried_cell_averages&) = delete;

  /// Computes the contents of the new cells. About n log n in the number of old and new cells, plus
  /// the number of pairs whose bounding boxes intersect.
  void before_replacement(const Cavity& cavity) override {
    begin(cavity.removed());
    for (const auto& t : cavity.planned())
      if (!cavity.is_infinite(t.vertices)) {
        Corners corners;
        for (int i = 0; i < Complex::corners; ++i)
          corners[i] = nearest_image(cavity.vertices()[t.vertices[i]].position);
        add_target(corners, t.parent->subdomain_index());
      }
    redistribute();
  }
  /// Stores the contents of the new cells.
  void after_replacement(const Cavity& cavity) override { put_contents(cavity.created()); }

  /// Computes the contents of the cells around `v` after the move, in the same time.
  void before_smoothing(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const Point& target) override {
    begin(star);
    const auto position = nearest_image(target);
    for (Cell_handle c : star)
      if (!m_complex.is_infinite(c)) {
        Corners moved = internal::cell_corners(m_complex, c, m_middle);
        moved[c->index(v)] = position;
        add_target(moved, c->subdomain_index());
      }
    redistribute();
  }
  /// Stores the contents of the cells around the vertex.
  void after_smoothing(Vertex_handle, const std::vector<Cell_handle>& star) override {
    put_contents(star);
  }

private:
  using Space = typename Complex::Space;
  using Simplex = internal::Filled_simplex<Space, Value>;
  using Clipping = internal::Clipping_simplex<Space>;
  using Corners = internal::Cell_corners<Complex>;

  double volume(Cell_handle c) const {
    return internal::positive_measure<Space>(internal::cell_corners(m_complex, c));
  }

  // Returns the image of p nearest to `m_middle`: on a torus, all images are taken near one place.
  typename Complex::Point nearest_image(const typename Complex::Point& p) const {
    return m_complex.domain().nearest_image(m_middle, p);
  }

  void multiply(Cell_handle c, double factor) {
    const Value product = factor * get(m_values, c);
    put(m_values, c, product);
  }

  // Starts a transfer with the contents of the given cells, and without targets.
  void begin(const std::vector<Cell_handle>& cells) {
    m_from.clear();
    m_to.clear();
    for (Cell_handle c : cells) {
      if (m_complex.is_infinite(c))
        continue;
      if (m_from.empty())
        m_middle = m_complex.position(c->vertex(0));
      m_from.push_back({Clipping(internal::cell_corners(m_complex, c, m_middle)),
                        c->subdomain_index(), get(m_values, c)});
    }
  }

  void add_target(const Corners& corners, int label) {
    const Value nothing = 0. * m_from.front().content;
    m_to.push_back({Clipping(corners), label, nothing});
  }

  void redistribute() { internal::redistribute_contents(m_from, m_to); }

  // Stores the contents of the finite cells, in the order in which they were planned.
  void put_contents(const std::vector<Cell_handle>& cells) {
    auto next = m_to.begin();
    for (Cell_handle c : cells)
      if (!m_complex.is_infinite(c))
        put(m_values, c, (next++)->content);
  }

  const Complex& m_complex;
  CellValueMap m_values;
  std::vector<Simplex> m_from, m_to;
  typename Complex::Point m_middle; // near the cells that are replaced
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_CARRIED_CELL_AVERAGES_H

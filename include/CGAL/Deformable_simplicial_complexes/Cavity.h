// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CAVITY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CAVITY_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/enum.h>

#include <array>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if a proposal is committed after the complex has changed, so that the proposal may
be invalid. The complex is unchanged; make a new proposal.
*/
class Stale_proposal_error : public Error
{
public:
  /// Constructs the error.
  Stale_proposal_error()
      : Error("the complex has changed since the proposal was made: make a new proposal") {}
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// The kind of a proposed replacement, by its effect on the vertices.
enum class Proposal_kind {
  flip,        ///< the vertices stay, and other cells connect them
  split,       ///< an edge gets a new vertex, the last one of the cavity
  collapse,    ///< a vertex is merged into the vertex at the other end of an edge
  insertion,   ///< a cell gets a new vertex, the last one of the cavity
  replacement, ///< everything else: any vertices are created, removed or moved
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A proposed replacement: cells to remove, cells to create in their place, and the worst quality
before and after. A mesh operation fills a cavity without changing the complex.
`Labeled_complex::replace()` then commits the whole proposal, or the proposal is dropped. A cavity
stores the version of the complex at its beginning. A proposal can be committed only to this
version.

Vertices have indices within the cavity. A vertex whose cells are all removed may be moved. It
vanishes if no planned cell contains it. Infinite cells may take part; a planned cell with the
infinite vertex has no orientation and no quality. If the planned cells have the boundary of the
removed cells and all finite planned cells are positive, they fill exactly the same space. No other
geometric test is needed.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Cavity
{
public:
  static constexpr int corners = Complex::dimension + 1; ///< number of vertices of a cell
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Cell_handle = typename Complex::Cell_handle;     ///< cell of the complex
  using Point = typename Complex::Point;                 ///< point of the complex
  using Index = std::uint32_t; ///< index of a vertex within the cavity, into `vertices()`
  static constexpr Index none = Index(-1);    ///< no vertex
  using Indices = std::array<Index, corners>; ///< vertices of a planned cell

  /// Vertex of the complex, or vertex to be created.
  struct Vertex
  {
    Vertex_handle handle;        ///< null until the vertex is created
    Point position;              ///< position after the replacement
    std::uint8_t boundary_class; ///< see `Boundary_class`
  };

  /// Cell to be created.
  struct Planned_cell
  {
    Indices vertices;   ///< indices into `vertices()`; one of the vertices may be infinite
    Cell_handle parent; ///< removed cell that passes on its label and its component
    double quality;     ///< infinity if a vertex is infinite
  };

  using Tetrahedron = Planned_cell; ///< name of a planned cell in three dimensions

  /// Constructs an empty cavity for a proposal to the complex in its present version. The complex
  /// must outlive the cavity.
  explicit Cavity(const Complex& complex) : m_complex(&complex), m_version(complex.version()) {}

  /// Empties the cavity for a proposal to the complex in its present version. The memory is kept.
  void begin(Proposal_kind kind) {
    clear();
    m_kind = kind;
  }

  /// Empties the cavity for a proposal of the kind `Proposal_kind::replacement`.
  void clear() {
    m_kind = Proposal_kind::replacement;
    m_version = m_complex->version();
    m_vertices.clear();
    m_indices.clear();
    m_removed.clear();
    m_planned.clear();
    m_created.clear();
    m_vanishing_vertex = m_kept_vertex = Vertex_handle();
    m_quality_before = m_quality_after = std::numeric_limits<double>::infinity();
  }

  /// Returns the index of a vertex of the complex; `none` if the cavity does not contain it.
  /// \pre the complex has not changed since the cavity was begun
  Index index_of(Vertex_handle v) const { return m_indices.find(v->id()); }

  /// Adds v to the vertices of the cavity if it is not one of them. Returns its index.
  Index add(Vertex_handle v) {
    if (const Index known = index_of(v); known != none)
      return known;
    if (m_complex->is_infinite(v)) // the infinite vertex has no position
      m_vertices.push_back({v, Point(), v->boundary_class()});
    else
      m_vertices.push_back({v, v->point(), v->boundary_class()});
    const Index index = Index(m_vertices.size() - 1);
    try {
      m_indices.insert(v->id(), index);
    } catch (...) {
      m_vertices.pop_back();
      throw;
    }
    return index;
  }

  /// Adds v to the vertices of the cavity, to be moved to p. Returns its index. Call this
  /// function before cells are planned.
  /// \pre all cells of v are removed, or p is the position of v
  Index add(Vertex_handle v, const Point& p) {
    const Index index = add(v);
    m_vertices[index].position = m_complex->canonical(p);
    return index;
  }

  /// Adds a vertex to be created at p. Returns its index.
  Index add(const Point& p, std::uint8_t boundary_class) {
    m_vertices.push_back({Vertex_handle(), m_complex->canonical(p), boundary_class});
    return Index(m_vertices.size() - 1);
  }

  /// Plans the removal of a cell, and adds its vertices to the cavity.
  void remove(Cell_handle c) {
    for (int i = 0; i < corners; ++i)
      add(c->vertex(i));
    m_removed.push_back(c);
    if (!m_complex->is_infinite(c))
      m_quality_before = (std::min)(m_quality_before, c->quality());
  }

  /// Declares that v collapses into `kept`. All cells of v are removed.
  void collapse(Vertex_handle v, Vertex_handle kept) {
    m_vanishing_vertex = v;
    m_kept_vertex = kept;
  }

  /// Plans a cell in the place of the removed cell `parent`. Returns its quality.
  double create(const Indices& vertices, Cell_handle parent) {
    const double quality = this->quality(vertices);
    m_planned.push_back({vertices, parent, quality});
    m_quality_after = (std::min)(m_quality_after, quality);
    return quality;
  }

  /// Returns whether one of the cavity vertices is the infinite vertex.
  bool is_infinite(const Indices& cell) const {
    return std::any_of(cell.begin(), cell.end(),
                       [&](Index i) { return m_complex->is_infinite(m_vertices[i].handle); });
  }

  /// Returns the quality of a cell of cavity vertices, by the measure of the complex.
  double quality(const Indices& cell) const {
    if (is_infinite(cell))
      return std::numeric_limits<double>::infinity();
    return m_complex->domain().template apply<Complex>(
        m_complex->quality_measure(),
        [&](int i) -> const Point& { return m_vertices[cell[i]].position; });
  }

  /// Returns whether all finite planned cells are positively oriented, exactly.
  bool is_positive() const {
    return std::all_of(m_planned.begin(), m_planned.end(), [&](const Planned_cell& cell) {
      return is_infinite(cell.vertices) || is_positive(cell.vertices);
    });
  }

  /// Returns whether the worst planned cell keeps the quality of the worst removed cell, see
  /// `Labeled_complex::keeps_quality()`.
  bool keeps_quality() const { return Complex::keeps_quality(m_quality_before, m_quality_after); }

  /// Returns whether the planned cells keep the quality and are positively oriented.
  bool is_admissible() const { return keeps_quality() && is_positive(); }

  /// Returns whether a cell of finite cavity vertices is positively oriented, exactly.
  bool is_positive(const Indices& cell) const {
    return m_complex->domain().orientation(*m_complex, [&](int i) -> const Point& {
      return m_vertices[cell[i]].position;
    }) == POSITIVE;
  }

  /// Returns the kind of the proposal.
  Proposal_kind kind() const { return m_kind; }
  /// Returns the `Complex::version()` at which the cavity was begun.
  std::uint64_t version() const { return m_version; }

  /// Returns the worst quality of the removed finite cells; infinity if there is none.
  double quality_before() const { return m_quality_before; }
  /// Returns the worst quality of the planned finite cells; infinity if there is none.
  double quality_after() const { return m_quality_after; }

  /// Returns the vertices of the cavity, by index.
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  /// Returns the cells to be removed, infinite ones included. They do not exist any more after a
  /// commit.
  const std::vector<Cell_handle>& removed() const { return m_removed; }
  /// Returns the cells to be created, in the order of the calls of `create()`.
  const std::vector<Planned_cell>& planned() const { return m_planned; }
  /// Returns `planned()`, by its name in three dimensions.
  const std::vector<Planned_cell>& tetrahedra() const { return m_planned; }
  /// Returns the vertex that collapses; null if there is none.
  Vertex_handle vanishing_vertex() const { return m_vanishing_vertex; }
  /// Returns the vertex that `vanishing_vertex()` collapses into; null if there is none.
  Vertex_handle kept_vertex() const { return m_kept_vertex; }

  /// Returns the cells that a commit created, parallel to `planned()`; empty before a commit.
  const std::vector<Cell_handle>& created() const { return m_created; }

private:
  template <class Derived, class Space, class Quality, class Domain> friend class Labeled_complex;

  const Complex* m_complex;
  Proposal_kind m_kind = Proposal_kind::replacement;
  std::uint64_t m_version;
  std::vector<Vertex> m_vertices;
  internal::Id_map m_indices; // of the vertices that exist in the complex
  std::vector<Cell_handle> m_removed;
  std::vector<Planned_cell> m_planned;
  std::vector<Cell_handle> m_created;
  Vertex_handle m_vanishing_vertex, m_kept_vertex;
  double m_quality_before = std::numeric_limits<double>::infinity();
  double m_quality_after = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CAVITY_H

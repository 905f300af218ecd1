// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_CAVITY_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_CAVITY_3_H

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

A proposed replacement: cells to remove, tetrahedra to create in their place, and the worst quality
before and after. A mesh operation fills a cavity without touching the complex;
`Deformable_simplicial_complex_3::replace()` then commits it whole, or it is dropped.

Vertices have indices within the cavity. Those that have only removed cells may be moved, and vanish
if no tetrahedron is planned for them. Infinite cells may take part; a tetrahedron with the
infinite vertex has no orientation and no quality. If the tetrahedra have the boundary of the
removed cells and all finite ones are positive, they fill exactly the same space: no further
geometric test is needed.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
*/
template <class Complex> class Cavity_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;             ///< vertex of the complex
  using Cell_handle = typename Complex::Cell_handle;                 ///< cell of the complex
  using Point_3 = typename Complex::Point_3;                         ///< as in the complex
  using Approximate_point_3 = typename Complex::Approximate_point_3; ///< as in the complex
  using Index = std::uint32_t; ///< index of a vertex within the cavity, into `vertices()`

  /// A vertex of the complex, or one to be created.
  struct Vertex
  {
    Vertex_handle handle;         ///< null while the vertex is yet to be created
    Point_3 point;                ///< where it is to be
    Approximate_point_3 position; ///< the same, with coordinates of type `double`
    std::uint8_t boundary_class;  ///< see `Boundary_class`
  };

  /// A tetrahedron to be created.
  struct Tetrahedron
  {
    std::array<Index, 4> vertices; ///< infinite ones may be among them
    Cell_handle parent;            ///< the removed cell whose label and component it inherits
    double quality;                ///< infinity if a vertex is infinite
  };

  /// An empty cavity in a complex, which must outlive it.
  explicit Cavity_3(const Complex& complex) : m_complex(&complex) {}

  /// Empties the cavity and keeps its memory.
  void clear() {
    m_vertices.clear();
    m_removed.clear();
    m_tetrahedra.clear();
    m_created.clear();
    m_vanishing_vertex = m_kept_vertex = Vertex_handle();
    m_quality_before = m_quality_after = std::numeric_limits<double>::infinity();
  }

  /// The index of v, which becomes a vertex of the cavity if it was none.
  Index add(Vertex_handle v) {
    const Index known = v->scratch_index();
    if (known < m_vertices.size() && m_vertices[known].handle == v)
      return known;
    v->set_scratch_index(Index(m_vertices.size()));
    m_vertices.push_back({v, v->point(), m_complex->position(v), v->boundary_class()});
    return Index(m_vertices.size() - 1);
  }

  /// The index of v, which is to be at p. To be called before tetrahedra are planned.
  /// \pre all cells of v are removed, or p is where v is
  Index add(Vertex_handle v, const Point_3& p) {
    const Index index = add(v);
    m_vertices[index].point = p;
    m_vertices[index].position = m_complex->geom_traits().construct_approximate_point_3_object()(p);
    return index;
  }

  /// The index of a vertex to be created at p.
  Index add(const Point_3& p, std::uint8_t boundary_class) {
    const auto approximate = m_complex->geom_traits().construct_approximate_point_3_object();
    m_vertices.push_back({Vertex_handle(), p, approximate(p), boundary_class});
    return Index(m_vertices.size() - 1);
  }

  /// Plans the removal of a cell, whose vertices become vertices of the cavity.
  void remove(Cell_handle c) {
    for (int i = 0; i < 4; ++i)
      add(c->vertex(i));
    m_removed.push_back(c);
    if (!m_complex->is_infinite(c))
      m_quality_before = (std::min)(m_quality_before, c->quality());
  }

  /// Tells that the vertex v, all of whose cells are removed, collapses into `kept`.
  void remove(Vertex_handle v, Vertex_handle kept) {
    m_vanishing_vertex = v;
    m_kept_vertex = kept;
  }

  /// Plans a tetrahedron in the place of `parent`, a removed cell. Returns its quality.
  double create(const std::array<Index, 4>& vertices, Cell_handle parent) {
    const double quality = this->quality(vertices);
    m_tetrahedra.push_back({vertices, parent, quality});
    m_quality_after = (std::min)(m_quality_after, quality);
    return quality;
  }

  /// Whether the infinite vertex is among cavity vertices.
  bool is_infinite(const std::array<Index, 4>& t) const {
    return std::any_of(t.begin(), t.end(),
                       [&](Index i) { return m_complex->is_infinite(m_vertices[i].handle); });
  }

  /// Quality of a tetrahedron of cavity vertices by the measure of the complex.
  double quality(const std::array<Index, 4>& t) const {
    if (is_infinite(t))
      return std::numeric_limits<double>::infinity();
    return m_complex->quality_measure()(m_vertices[t[0]].position, m_vertices[t[1]].position,
                                        m_vertices[t[2]].position, m_vertices[t[3]].position);
  }

  /// Whether all finite planned tetrahedra are positively oriented, exactly.
  bool is_positive() const {
    const auto orientation = m_complex->geom_traits().orientation_3_object();
    return std::all_of(m_tetrahedra.begin(), m_tetrahedra.end(), [&](const Tetrahedron& t) {
      const auto& v = t.vertices;
      return is_infinite(v) ||
             orientation(m_vertices[v[0]].point, m_vertices[v[1]].point, m_vertices[v[2]].point,
                         m_vertices[v[3]].point) == POSITIVE;
    });
  }

  /// Worst quality of the removed cells; infinity if there is none.
  double quality_before() const { return m_quality_before; }
  /// Worst quality of the planned tetrahedra; infinity if there is none.
  double quality_after() const { return m_quality_after; }

  /// The vertices of the cavity by their indices.
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  /// The cells to be removed, infinite ones included; no longer there after a commit.
  const std::vector<Cell_handle>& removed() const { return m_removed; }
  /// The tetrahedra to be created, in the order of the calls of `create()`.
  const std::vector<Tetrahedron>& tetrahedra() const { return m_tetrahedra; }
  /// The vertex that collapses, null if there is none.
  Vertex_handle vanishing_vertex() const { return m_vanishing_vertex; }
  /// The vertex that it collapses into, null if there is none.
  Vertex_handle kept_vertex() const { return m_kept_vertex; }

  /// The cells that a commit made, parallel to `tetrahedra()`; empty before.
  const std::vector<Cell_handle>& created() const { return m_created; }

private:
  friend Complex;

  const Complex* m_complex;
  std::vector<Vertex> m_vertices;
  std::vector<Cell_handle> m_removed;
  std::vector<Tetrahedron> m_tetrahedra;
  std::vector<Cell_handle> m_created;
  Vertex_handle m_vanishing_vertex, m_kept_vertex;
  double m_quality_before = std::numeric_limits<double>::infinity();
  double m_quality_after = std::numeric_limits<double>::infinity();
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_CAVITY_3_H

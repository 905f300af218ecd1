// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERFACE_GRAPH_3_H
#define CGAL_INTERFACE_REMESHING_INTERFACE_GRAPH_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/functional/hash.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <unordered_map>

namespace CGAL::Deformable_simplicial_complexes {

template <class Complex_> class Interface_graph_3;

namespace internal {

// A vertex ('v'), halfedge ('h'), edge ('e') or face ('f') of an `Interface_graph_3`: a handle of
// the complex and a number. The last bit of the number of an edge tells the direction, which does
// not distinguish edges.
template <class Handle, char kind> struct Interface_graph_item
{
  using Self = Interface_graph_item;
  Handle handle = Handle();
  int number = 0;

  int key() const { return kind == 'e' ? number / 2 : number; }
  friend bool operator==(const Self& a, const Self& b) {
    return a.handle == b.handle && a.key() == b.key();
  }
  friend bool operator!=(const Self& a, const Self& b) { return !(a == b); }
  friend bool operator<(const Self& a, const Self& b) {
    return a.handle == b.handle ? a.key() < b.key() : a.handle < b.handle;
  }
  friend std::size_t hash_value(const Self& a) {
    return a.handle == Handle() ? 0 : 32 * (a.handle->time_stamp() + 1) + std::size_t(a.key());
  }
};

// The internal property map of points.
template <class Complex> struct Interface_graph_points
{
  using type = Interface_graph_points; // for `boost::property_map`
  using const_type = Interface_graph_points;
  using category = boost::readable_property_map_tag;
  using key_type = Interface_graph_item<typename Complex::Vertex_handle, 'v'>;
  using value_type = typename Complex::Point_3;
  using reference = const value_type&;
  friend reference get(const type& /*points*/, const key_type& v) { return v.handle->point(); }
};

// The types of `boost::graph_traits`.
template <class Complex> struct Interface_graph_types
{
  using Graph = Interface_graph_3<Complex>;
  using size_type = std::size_t;
  using vertex_descriptor = Interface_graph_item<typename Complex::Vertex_handle, 'v'>;
  using halfedge_descriptor = Interface_graph_item<typename Complex::Cell_handle, 'h'>;
  using edge_descriptor = Interface_graph_item<typename Complex::Cell_handle, 'e'>;
  using face_descriptor = Interface_graph_item<typename Complex::Cell_handle, 'f'>;

  struct Get_halfedge
  {
    const Graph* graph = nullptr;
    halfedge_descriptor operator()(size_type i) const { return graph->halfedge_at(i); }
  };
  struct Is_first
  {
    const Graph* graph = nullptr;
    bool operator()(halfedge_descriptor h) const { return h < opposite(h, *graph); }
  };
  struct Get_edge
  {
    edge_descriptor operator()(halfedge_descriptor h) const { return {h.handle, 2 * h.number}; }
  };
  using vertex_iterator = typename std::vector<vertex_descriptor>::const_iterator;
  using halfedge_iterator =
      boost::transform_iterator<Get_halfedge, boost::counting_iterator<size_type>>;
  using First_halfedge_iterator = boost::filter_iterator<Is_first, halfedge_iterator>;
  using edge_iterator = boost::transform_iterator<Get_edge, First_halfedge_iterator>;
  using face_iterator = typename std::vector<face_descriptor>::const_iterator;

  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag
  {
  };
  using vertices_size_type = size_type;
  using halfedges_size_type = size_type;
  using edges_size_type = size_type;
  using faces_size_type = size_type;
  using degree_size_type = size_type;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

The interface of a label as a face graph. The class is a view: points and incidences are read from
the complex. The view stores lists of faces, vertices and border halfedges. Functions of
`Polygon_mesh_processing` that do not modify the surface work on the view.

The faces are the facets between the label and other labels, with normals out of the label. The
surface is an oriented 2-manifold, even where the interface is not:
- Two faces are adjacent at an edge if cells of the label fill the angle between them. If two parts
  of the label share an edge of the complex, the graph has two edges there. They can have the same
  two vertices.
- The faces at a vertex of the complex form one or more umbrellas. Each umbrella is a vertex of the
  graph. The vertices at one vertex of the complex have the same point.

Facets on the boundary of the domain belong to no interface. Where the interface of the label ends
at the boundary of the domain, the surface has border halfedges.

The property map `CGAL::vertex_point_t` is internal. Points are in the coordinates of the complex,
as volumes and areas are. Descriptors are ordered and hashed by time stamps. Vertices and faces are
listed in this order. `opposite()` and `edge()` are linear in the number of cells around the edge.
`halfedge(v, g)` is logarithmic in the number of vertices. Numbers of simplices take constant time.
Any number of threads may use a graph.

\tparam Complex_ an instance of `Deformable_simplicial_complex_3` whose domain is not a torus. On a
        torus, a vertex has several points; see `extract_interface()`.

\pre The complex outlives the graph and does not change as long as the graph is used. The functions
     that return ranges check this.

\cgalModels{VertexListGraph}
\cgalModels{EdgeListGraph}
\cgalModels{HalfedgeListGraph}
\cgalModels{FaceListGraph}

\sa `extract_interface()`
*/
template <class Complex_> class Interface_graph_3
{
  static_assert(Complex_::dimension == 3, "Interface_graph_3: the complex is in space");
  static_assert(Complex_::Domain::has_outside,
                "Interface_graph_3: vertices of a complex on a torus have several points; "
                "use extract_interface()");
  using Graph = Interface_graph_3;
  using Types = internal::Interface_graph_types<Complex_>;
  using Cell_handle = typename Complex_::Cell_handle;

public:
  using Complex = Complex_;                                        ///< the complex
  using vertex_descriptor = typename Types::vertex_descriptor;     ///< umbrella at a vertex
  using halfedge_descriptor = typename Types::halfedge_descriptor; ///< side of an edge
  using edge_descriptor = typename Types::edge_descriptor;         ///< two opposite halfedges
  using face_descriptor = typename Types::face_descriptor;         ///< facet of the interface

  /// Constructs the graph of the interface of a label; empty if there is none. Linear in the number
  /// of cells, and n log n in the size of the interface.
  Interface_graph_3(const Complex& complex, typename Complex::Label label)
      : m_complex(&complex), m_label(label), m_version(complex.version()) {
    for (Cell_handle c : complex.finite_cells())
      for (int i = 0; i < 4 && complex.label(c) == label; ++i)
        if (complex.is_interface(typename Complex::Facet(c, i)))
          m_faces.push_back({c, i});
    std::sort(m_faces.begin(), m_faces.end());
    collect_vertices();
  }

  /// Returns the vertex of the complex at a vertex of the graph.
  typename Complex::Vertex_handle vertex_handle(vertex_descriptor v) const { return v.handle; }
  /// Returns the facet of a face, given by its cell of the label.
  typename Complex::Facet facet(face_descriptor f) const { return {f.handle, f.number}; }

#ifndef DOXYGEN_RUNNING
  friend halfedge_descriptor next(halfedge_descriptor h, const Graph& g) {
    if (!is_border(h))
      return halfedge_of(h.handle, facet_of(h), source_corner(h));
    h = opposite(h, g);
    while (!is_border(h))
      h = opposite(prev(h, g), g);
    return h;
  }
  friend halfedge_descriptor prev(halfedge_descriptor h, const Graph& g) {
    if (!is_border(h))
      return halfedge_of(h.handle, facet_of(h), target_corner(h));
    h = opposite(h, g);
    while (!is_border(h))
      h = opposite(next(h, g), g);
    return h;
  }
  friend halfedge_descriptor opposite(halfedge_descriptor h, const Graph& g) {
    // Turns around the edge inside the label. In each cell, `from` and `to` are opposite to the
    // facets that contain the edge.
    Cell_handle c = h.handle;
    int from = facet_of(h), to = corner_of(h);
    for (;;) {
      const Cell_handle n = c->neighbor(to);
      if (is_border(h) || g.m_complex->is_infinite(n))
        return {h.handle, h.number ^ 1};
      if (g.m_complex->label(n) != g.m_label)
        return halfedge_of(c, to, from);
      to = n->index(c->vertex(from));
      from = n->index(c);
      c = n;
    }
  }
  friend vertex_descriptor target(halfedge_descriptor h, const Graph& g) {
    const auto umbrella = g.m_umbrellas.find(h);
    return {target_handle(h), umbrella == g.m_umbrellas.end() ? 0 : umbrella->second};
  }
  friend vertex_descriptor source(halfedge_descriptor h, const Graph& g) {
    return target(is_border(h) ? opposite(h, g) : prev(h, g), g);
  }
  friend vertex_descriptor target(edge_descriptor e, const Graph& g) {
    return target(halfedge(e, g), g);
  }
  friend vertex_descriptor source(edge_descriptor e, const Graph& g) {
    return source(halfedge(e, g), g);
  }
  friend face_descriptor face(halfedge_descriptor h, const Graph& /*g*/) {
    return is_border(h) ? face_descriptor() : face_descriptor{h.handle, facet_of(h)};
  }
  friend edge_descriptor edge(halfedge_descriptor h, const Graph& g) {
    const halfedge_descriptor o = opposite(h, g);
    return o < h ? edge_descriptor{o.handle, 2 * o.number + 1}
                 : edge_descriptor{h.handle, 2 * h.number};
  }
  friend halfedge_descriptor halfedge(edge_descriptor e, const Graph& g) {
    const halfedge_descriptor h = {e.handle, e.number / 2};
    return e.number % 2 != 0 ? opposite(h, g) : h;
  }
  friend halfedge_descriptor halfedge(face_descriptor f, const Graph& /*g*/) {
    return halfedge_of(f.handle, f.number, (f.number + 1) % 4);
  }
  friend halfedge_descriptor halfedge(vertex_descriptor v, const Graph& g) {
    const auto place = std::lower_bound(g.m_vertices.begin(), g.m_vertices.end(), v);
    return g.m_halfedges_to_vertices[std::size_t(place - g.m_vertices.begin())];
  }
  friend auto halfedge(vertex_descriptor u, vertex_descriptor v, const Graph& g) {
    for (halfedge_descriptor h : halfedges_around_target(v, g))
      if (source(h, g) == u)
        return std::make_pair(h, true);
    return std::make_pair(halfedge_descriptor(), false);
  }
  friend std::size_t degree(vertex_descriptor v, const Graph& g) {
    return halfedges_around_target(v, g).size();
  }
  friend std::size_t degree(face_descriptor /*f*/, const Graph& /*g*/) { return 3; }

  friend auto vertices(const Graph& g) {
    g.check_version();
    return make_range(g.m_vertices.begin(), g.m_vertices.end());
  }
  friend auto halfedges(const Graph& g) {
    g.check_version();
    return make_range(g.halfedge_iterator(0), g.halfedge_iterator(num_halfedges(g)));
  }
  friend auto edges(const Graph& g) {
    using First = typename Types::First_halfedge_iterator;
    g.check_version();
    const First begin({&g}, g.halfedge_iterator(0), g.halfedge_iterator(3 * num_faces(g)));
    const First end({&g}, begin.end(), begin.end());
    return make_range(typename Types::edge_iterator(begin), typename Types::edge_iterator(end));
  }
  friend auto faces(const Graph& g) {
    g.check_version();
    return make_range(g.m_faces.begin(), g.m_faces.end());
  }
  friend std::size_t num_vertices(const Graph& g) { return g.m_vertices.size(); }
  friend std::size_t num_halfedges(const Graph& g) { return 3 * num_faces(g) + g.m_border.size(); }
  friend std::size_t num_edges(const Graph& g) { return num_halfedges(g) / 2; }
  friend std::size_t num_faces(const Graph& g) { return g.m_faces.size(); }

  friend auto get(vertex_point_t, const Graph& /*g*/) {
    return internal::Interface_graph_points<Complex>();
  }
  friend decltype(auto) get(vertex_point_t tag, const Graph& g, vertex_descriptor v) {
    return get(get(tag, g), v);
  }
#endif

private:
  friend Types;

  // The number of a halfedge combines the index of its facet in the cell, the index of the corner
  // opposite to its edge in the facet, and whether it is the border halfedge opposite to this side.
  static halfedge_descriptor halfedge_of(Cell_handle c, int facet, int corner) {
    return {c, 8 * facet + 2 * corner};
  }
  static int facet_of(halfedge_descriptor h) { return h.number / 8; }
  static int corner_of(halfedge_descriptor h) { return h.number / 2 % 4; }
  static bool is_border(halfedge_descriptor h) { return h.number % 2 != 0; }
  // Return the ends of the side, counterclockwise seen from outside the cell.
  static int source_corner(halfedge_descriptor h) {
    return Complex::Triangulation::next_around_edge(facet_of(h), corner_of(h));
  }
  static int target_corner(halfedge_descriptor h) {
    return Complex::Triangulation::next_around_edge(corner_of(h), facet_of(h));
  }
  static auto target_handle(halfedge_descriptor h) {
    return h.handle->vertex(is_border(h) ? source_corner(h) : target_corner(h));
  }
  // Returns one of the halfedges of the faces, followed by the border halfedges.
  halfedge_descriptor halfedge_at(std::size_t i) const {
    if (i >= 3 * m_faces.size())
      return m_border[i - 3 * m_faces.size()];
    const face_descriptor f = m_faces[i / 3];
    return halfedge_of(f.handle, f.number, (f.number + 1 + int(i % 3)) % 4);
  }
  auto halfedge_iterator(std::size_t i) const {
    return typename Types::halfedge_iterator(boost::counting_iterator<std::size_t>(i), {this});
  }
  void check_version() const {
    CGAL_precondition_msg(m_complex->version() == m_version,
                          "the complex has changed: construct the graph again");
  }

  // Finds the border halfedges, and the umbrellas of all vertices.
  void collect_vertices() {
    std::vector<std::pair<std::size_t, std::size_t>> targets; // time stamps, halfedges
    for (std::size_t i = 0; i < 3 * m_faces.size(); ++i) {
      const halfedge_descriptor h = halfedge_at(i), o = opposite(h, *this);
      targets.emplace_back(target_handle(h)->time_stamp(), i);
      if (is_border(o))
        m_border.push_back(o);
    }
    std::sort(targets.begin(), targets.end());
    std::vector<halfedge_descriptor> found; // to the vertex, in its previous umbrellas
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const halfedge_descriptor first = halfedge_at(targets[i].second);
      if (i == 0 || targets[i].first != targets[i - 1].first)
        found.clear();
      else if (std::find(found.begin(), found.end(), first) != found.end())
        continue;
      const int umbrella = found.empty() ? 0 : m_vertices.back().number + 1;
      m_vertices.push_back({target_handle(first), umbrella});
      m_halfedges_to_vertices.push_back(first);
      for (halfedge_descriptor h : halfedges_around_target(first, *this)) {
        found.push_back(h);
        if (umbrella > 0)
          m_umbrellas.emplace(h, umbrella);
      }
    }
  }

  const Complex* m_complex;
  typename Complex::Label m_label;
  std::uint64_t m_version;
  std::vector<face_descriptor> m_faces;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges_to_vertices, m_border;
  std::unordered_map<halfedge_descriptor, int> m_umbrellas; // of targets; without the number 0
};

} // namespace CGAL::Deformable_simplicial_complexes

#ifndef DOXYGEN_RUNNING
template <class Complex>
struct boost::graph_traits<CGAL::Deformable_simplicial_complexes::Interface_graph_3<Complex>>
    : CGAL::Deformable_simplicial_complexes::internal::Interface_graph_types<Complex>
{
};
template <class Complex>
struct boost::graph_traits<const CGAL::Deformable_simplicial_complexes::Interface_graph_3<Complex>>
    : CGAL::Deformable_simplicial_complexes::internal::Interface_graph_types<Complex>
{
};
template <class Complex>
struct boost::property_map<CGAL::Deformable_simplicial_complexes::Interface_graph_3<Complex>,
                           CGAL::vertex_point_t>
    : CGAL::Deformable_simplicial_complexes::internal::Interface_graph_points<Complex>
{
};
template <class Complex>
struct CGAL::graph_has_property<CGAL::Deformable_simplicial_complexes::Interface_graph_3<Complex>,
                                CGAL::vertex_point_t> : CGAL::Tag_true
{
};
template <class Handle, char kind>
struct std::hash<
    CGAL::Deformable_simplicial_complexes::internal::Interface_graph_item<Handle, kind>>
    : boost::hash<
          CGAL::Deformable_simplicial_complexes::internal::Interface_graph_item<Handle, kind>>
{
};
#endif

#endif // CGAL_INTERFACE_REMESHING_INTERFACE_GRAPH_3_H

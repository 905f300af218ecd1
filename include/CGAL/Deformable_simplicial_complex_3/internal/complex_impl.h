// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_IMPL_H

// Member functions of Deformable_simplicial_complex_3: access, labels, interface, measures.
// Included by its header only.

#define CGAL_DSC_TEMPLATE template <class Tr, class Tds, class Qm>
#define CGAL_DSC_CLASS Deformable_simplicial_complex_3<Tr, Tds, Qm>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

struct Less_time_stamp
{
  template <class Handle> bool operator()(Handle a, Handle b) const {
    return a->time_stamp() < b->time_stamp();
  }
};

} // namespace internal
} // namespace Deformable_simplicial_complexes

CGAL_DSC_TEMPLATE
CGAL_DSC_CLASS::Deformable_simplicial_complex_3(const Geom_traits& traits,
                                                const Quality_measure& quality)
    : m_triangulation(traits), m_quality_measure(quality) {}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::swap(Deformable_simplicial_complex_3& other) {
  using std::swap;
  m_triangulation.swap(other.m_triangulation);
  swap(m_quality_measure, other.m_quality_measure);
  swap(m_totals, other.m_totals);
  swap(m_normalization, other.m_normalization);
  swap(m_mean_interface_edge, other.m_mean_interface_edge);
  swap(m_minimum_interface_edge, other.m_minimum_interface_edge);
  swap(m_components, other.m_components);
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::number_of_cells() const -> size_type {
  size_type n = 0;
  for (const auto& total : m_totals.totals())
    n += total.cells;
  return n;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::vertices() const -> std::vector<Vertex_handle> {
  std::vector<Vertex_handle> result;
  result.reserve(number_of_vertices());
  for (Vertex_handle v : m_triangulation.finite_vertex_handles())
    result.push_back(v);
  std::sort(result.begin(), result.end(),
            Deformable_simplicial_complexes::internal::Less_time_stamp());
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::cells() const -> std::vector<Cell_handle> {
  std::vector<Cell_handle> result;
  result.reserve(number_of_cells());
  for (Cell_handle c : m_triangulation.finite_cell_handles())
    result.push_back(c);
  std::sort(result.begin(), result.end(),
            Deformable_simplicial_complexes::internal::Less_time_stamp());
  return result;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::star(Vertex_handle v, std::vector<Cell_handle>& star) const {
  star.clear();
  star.push_back(v->cell());
  v->cell()->tds_data().mark_in_conflict();
  for (size_type i = 0; i < star.size(); ++i) {
    const Cell_handle c = star[i];
    for (int j = 0; j < 4; ++j)
      if (c->vertex(j) != v) {
        const Cell_handle n = c->neighbor(j);
        if (!n->tds_data().is_in_conflict()) {
          n->tds_data().mark_in_conflict();
          star.push_back(n);
        }
      }
  }
  for (Cell_handle c : star)
    c->tds_data().clear();
}

// Labels, interface, measures

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::labels() const -> std::vector<Label> {
  std::vector<Label> result;
  for (const auto& total : m_totals.totals())
    if (total.cells > 0)
      result.push_back(total.label);
  return result;
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_interface(const Edge& e) const {
  auto facet = m_triangulation.tds().incident_facets(e), last = facet;
  do {
    if (is_interface(Facet(*facet)))
      return true;
  } while (++facet != last);
  return false;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_vertices() const -> std::vector<Vertex_handle> {
  std::vector<Vertex_handle> result;
  for (Vertex_handle v : m_triangulation.finite_vertex_handles())
    if (v->is_interface())
      result.push_back(v);
  std::sort(result.begin(), result.end(),
            Deformable_simplicial_complexes::internal::Less_time_stamp());
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_facets() const -> std::vector<Facet> {
  std::vector<Facet> result;
  for (Cell_handle c : m_triangulation.finite_cell_handles())
    for (int i = 0; i < 4; ++i) {
      const Cell_handle n = c->neighbor(i);
      if (n->label() < c->label() && !is_infinite(n))
        result.emplace_back(c, i);
    }
  std::sort(result.begin(), result.end(), [](const Facet& a, const Facet& b) {
    return a.first != b.first ? a.first->time_stamp() < b.first->time_stamp() : a.second < b.second;
  });
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_facets(Label a, Label b) const -> std::vector<Facet> {
  std::vector<Facet> result = interface_facets();
  const auto other = [&](const Facet& f) {
    return std::minmax(f.first->label(), f.first->neighbor(f.second)->label()) != std::minmax(a, b);
  };
  result.erase(std::remove_if(result.begin(), result.end(), other), result.end());
  return result;
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::area(Label label) const {
  double result = 0;
  for (const Facet& f : interface_facets())
    if (f.first->label() == label || f.first->neighbor(f.second)->label() == label)
      result += area(f);
  return result;
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::area(Label a, Label b) const {
  double result = 0;
  for (const Facet& f : interface_facets(a, b))
    result += area(f);
  return result;
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::area(const Facet& f) const {
  const auto v = facet_vertices(f);
  const Approximate_point_3 p = position(v[0]);
  return std::sqrt(cross_product(position(v[1]) - p, position(v[2]) - p).squared_length()) / 2;
}

CGAL_DSC_TEMPLATE
int CGAL_DSC_CLASS::euler_characteristic(Label label) const {
  std::vector<size_type> vertices;
  std::vector<std::pair<size_type, size_type>> edges;
  int facets = 0;
  for (const Facet& f : interface_facets()) {
    if (f.first->label() != label && f.first->neighbor(f.second)->label() != label)
      continue;
    ++facets;
    const auto v = facet_vertices(f);
    for (int i = 0; i < 3; ++i) {
      const size_type a = v[i]->time_stamp(), b = v[(i + 1) % 3]->time_stamp();
      vertices.push_back(a);
      edges.push_back(std::minmax(a, b));
    }
  }
  const auto count_distinct = [](auto& items) {
    std::sort(items.begin(), items.end());
    return int(std::unique(items.begin(), items.end()) - items.begin());
  };
  return count_distinct(vertices) - count_distinct(edges) + facets;
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_IMPL_H

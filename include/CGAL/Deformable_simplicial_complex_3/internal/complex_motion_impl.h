// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_MOTION_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_MOTION_IMPL_H

// Member functions of Deformable_simplicial_complex_3: motion, change of the mesh.
// Included by its header only.

namespace CGAL {

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::cell_volume(Cell_handle c) const {
  return geom_traits().compute_approximate_volume_3_object()(
      position(c->vertex(0)), position(c->vertex(1)), position(c->vertex(2)),
      position(c->vertex(3)));
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::cell_quality(Cell_handle c) const {
  return m_quality_measure(position(c->vertex(0)), position(c->vertex(1)), position(c->vertex(2)),
                           position(c->vertex(3)));
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_positive(Cell_handle c) const {
  return geom_traits().orientation_3_object()(c->vertex(0)->point(), c->vertex(1)->point(),
                                              c->vertex(2)->point(),
                                              c->vertex(3)->point()) == POSITIVE;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::admissible_destination(Vertex_handle v, const Point_3& q) const -> Point_3 {
  if (!is_boundary(v))
    return q;
  const auto approximate = geom_traits().construct_approximate_point_3_object();
  const Approximate_point_3 from = approximate(v->point()), to = approximate(q);
  if (Boundary_class::fixes(v->boundary_class(), 0) &&
      Boundary_class::fixes(v->boundary_class(), 1) &&
      Boundary_class::fixes(v->boundary_class(), 2))
    return v->point();
  const auto coordinate = [&](int axis) {
    return Boundary_class::fixes(v->boundary_class(), axis) ? from[axis] : to[axis];
  };
  return geom_traits().construct_exact_point_3_object()(
      Approximate_point_3(coordinate(0), coordinate(1), coordinate(2)));
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_positive_star(Vertex_handle v, const std::vector<Cell_handle>& star,
                                      const Point_3& q) const {
  const auto orientation = geom_traits().orientation_3_object();
  return std::all_of(star.begin(), star.end(), [&](Cell_handle c) {
    const auto point = [&](int i) -> const Point_3& {
      return c->vertex(i) == v ? q : c->vertex(i)->point();
    };
    return is_infinite(c) || orientation(point(0), point(1), point(2), point(3)) == POSITIVE;
  });
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::move_vertex(Vertex_handle v, const Point_3& destination, double margin) {
  const Point_3 q = admissible_destination(v, destination);
  if (q == v->point())
    return 1;
  star(v, m_star);
  if (is_positive_star(v, m_star, q)) {
    set_point(v, m_star, q);
    return 1;
  }

  // The first cell to become flat: volumes are linear along the ray.
  double way = 1;
  const auto volume = geom_traits().compute_approximate_volume_3_object();
  const auto approximate = geom_traits().construct_approximate_point_3_object();
  for (Cell_handle c : m_star) {
    if (is_infinite(c))
      continue;
    const auto f = facet_vertices(Facet(c, c->index(v)));
    const Approximate_point_3 a = position(f[0]), b = position(f[1]), d = position(f[2]);
    // With v last no precision is lost where q is far away.
    const double here = volume(d, b, a, position(v)), there = volume(d, b, a, approximate(q));
    if (there < here)
      way = (std::min)(way, here / (here - there));
  }

  // Rounding may ask for more distance than the margin.
  const Approximate_point_3 from = position(v), to = approximate(q);
  static constexpr int maximum_number_of_halvings = 40;
  way *= 1 - margin;
  for (int i = 0; i < maximum_number_of_halvings && way > 0; ++i, way /= 2) {
    const Point_3 p = geom_traits().construct_exact_point_3_object()(from + way * (to - from));
    if (is_positive_star(v, m_star, p)) {
      if (p == v->point())
        return 0;
      set_point(v, m_star, p);
      return way;
    }
  }
  return 0;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::set_point(Vertex_handle v, const std::vector<Cell_handle>& star,
                               const Point_3& p) {
  for (Cell_handle c : star)
    if (!is_infinite(c))
      m_totals.add_volume(c->label(), -m_totals.units(cell_volume(c)));
  v->set_point(p);
  for (Cell_handle c : star)
    if (!is_infinite(c)) {
      CGAL_assertion(is_positive(c));
      m_totals.add_volume(c->label(), m_totals.units(cell_volume(c)));
      c->set_quality(cell_quality(c));
    }
}

CGAL_DSC_TEMPLATE
template <class ForEachIndex>
void CGAL_DSC_CLASS::set_points(const std::vector<Vertex_handle>& vertices,
                                const std::vector<Point_3>& points,
                                const std::vector<Cell_handle>& cells,
                                const ForEachIndex& for_each_index) {
  m_volume_changes.resize(cells.size());
  for_each_index(cells.size(), [&](size_type i) {
    m_volume_changes[i] = is_infinite(cells[i]) ? 0 : m_totals.units(cell_volume(cells[i]));
  });
  for (size_type i = 0; i < vertices.size(); ++i)
    vertices[i]->set_point(points[i]);
  for_each_index(cells.size(), [&](size_type i) {
    if (is_infinite(cells[i]))
      return;
    CGAL_assertion(is_positive(cells[i]));
    m_volume_changes[i] = m_totals.units(cell_volume(cells[i])) - m_volume_changes[i];
    cells[i]->set_quality(cell_quality(cells[i]));
  });
  for (size_type i = 0; i < cells.size(); ++i)
    if (!is_infinite(cells[i]))
      m_totals.add_volume(cells[i]->label(), m_volume_changes[i]);
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::has_interface_facet(Vertex_handle v) const {
  star(v, m_star);
  return std::any_of(m_star.begin(), m_star.end(), [&](Cell_handle c) {
    for (int i = 0; i < 4; ++i)
      if (c->vertex(i) != v && is_interface(Facet(c, i)))
        return true;
    return false;
  });
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::relabel(Cell_handle c, Label label) {
  const double volume = cell_volume(c);
  m_totals.remove_cell(c->label(), volume);
  m_totals.add_cell(label, volume);
  c->set_label(label);
  for (int i = 0; i < 4; ++i)
    if (c->neighbor(i)->label() == label && !is_infinite(c->neighbor(i)))
      c->set_component(c->neighbor(i)->component());
  for (int i = 0; i < 4; ++i)
    c->vertex(i)->set_interface(has_interface_facet(c->vertex(i)));
  m_components.invalidate();
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::replace(Cavity& cavity) {
  CGAL_precondition(cavity.is_positive());
  Triangulation_data_structure& tds = m_triangulation.tds();
  bool is_label_mixed = false;
  const Cell_handle* finite = nullptr;
  for (const Cell_handle& c : cavity.removed())
    if (!is_infinite(c)) {
      is_label_mixed = is_label_mixed || (finite && c->label() != (*finite)->label());
      finite = &c;
      m_totals.remove_cell(c->label(), cell_volume(c));
    }

  for (auto& v : cavity.m_vertices)
    if (v.handle == Vertex_handle()) {
      v.handle = tds.create_vertex();
      v.handle->set_point(v.point);
      v.handle->set_boundary_class(v.boundary_class);
    } else if (!is_infinite(v.handle) && !(v.handle->point() == v.point)) {
      v.handle->set_point(v.point);
    }
  for (const auto& t : cavity.tetrahedra()) {
    const Cell_handle c = tds.create_cell();
    for (int i = 0; i < 4; ++i)
      c->set_vertex(i, cavity.m_vertices[t.vertices[i]].handle);
    c->set_component(t.parent->component());
    cavity.m_created.push_back(c);
    if (!is_infinite(c)) {
      c->set_label(t.parent->label());
      c->set_quality(t.quality);
      m_totals.add_cell(c->label(), cell_volume(c));
    }
  }
  sew(cavity);

  for (const auto& v : cavity.vertices())
    if (v.handle->cell()->tds_data().is_in_conflict()) // a removed cell: it has no other
      tds.delete_vertex(v.handle);
    else if (is_label_mixed && !is_infinite(v.handle))
      v.handle->set_interface(has_interface_facet(v.handle));
  for (Cell_handle c : cavity.removed())
    tds.delete_cell(c);
  if (is_label_mixed)
    m_components.invalidate();
}

// Makes the created cells neighbors of each other and of the cells around the cavity.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::sew(Cavity& cavity) {
  for (std::size_t i = 0; i < cavity.m_vertices.size(); ++i)
    cavity.m_vertices[i].handle->set_scratch_index(std::uint32_t(i));
  m_half_facets.clear();
  const auto add = [&](std::array<std::uint32_t, 3> key, Cell_handle c, int i) {
    std::sort(key.begin(), key.end());
    m_half_facets.push_back({key, c, i});
  };
  for (Cell_handle c : cavity.removed())
    c->tds_data().mark_in_conflict();
  for (Cell_handle c : cavity.removed())
    for (int i = 0; i < 4; ++i) {
      const Cell_handle outside = c->neighbor(i);
      if (!outside->tds_data().is_in_conflict())
        add({c->vertex((i + 1) % 4)->scratch_index(), c->vertex((i + 2) % 4)->scratch_index(),
             c->vertex((i + 3) % 4)->scratch_index()},
            outside, outside->index(c));
    }
  for (std::size_t t = 0; t < cavity.tetrahedra().size(); ++t) {
    const auto& v = cavity.tetrahedra()[t].vertices;
    for (int i = 0; i < 4; ++i) {
      add({v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]}, cavity.created()[t], i);
      cavity.m_vertices[v[i]].handle->set_cell(cavity.created()[t]);
    }
  }
  std::sort(m_half_facets.begin(), m_half_facets.end(),
            [](const Half_facet& a, const Half_facet& b) { return a.vertices < b.vertices; });
  CGAL_assertion(m_half_facets.size() % 2 == 0);
  for (std::size_t i = 0; i + 1 < m_half_facets.size(); i += 2) {
    const Half_facet &a = m_half_facets[i], &b = m_half_facets[i + 1];
    CGAL_assertion(a.vertices == b.vertices);
    m_triangulation.tds().set_adjacency(a.cell, a.index, b.cell, b.index);
  }
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_MOTION_IMPL_H

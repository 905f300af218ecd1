// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_STORAGE_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_STORAGE_IMPL_H

// Member functions of Deformable_simplicial_complex_3: creation, state, validity.
// Included by its header only.

namespace CGAL {

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::assign(const std::vector<Point_3>& points,
                            const std::vector<std::array<size_type, 4>>& tetrahedra,
                            const std::vector<Label>& labels) -> std::vector<Vertex_handle> {
  using Deformable_simplicial_complexes::Invalid_tetrahedra_error;
  namespace internal = Deformable_simplicial_complexes::internal;
  if (tetrahedra.empty())
    throw Invalid_tetrahedra_error("there are no tetrahedra; give at least one");
  if (labels.size() != tetrahedra.size())
    throw Invalid_tetrahedra_error("give exactly one label for each tetrahedron");
  static constexpr size_type maximum =
      std::uint32_t(-1) / 8; // numbers of cells and facets have 32 bits
  if (tetrahedra.size() > maximum)
    throw Invalid_tetrahedra_error("there are more than 2^29 tetrahedra");

  Deformable_simplicial_complex_3 result(geom_traits(), m_quality_measure);
  const auto approximate = geom_traits().construct_approximate_point_3_object();
  const auto orientation = geom_traits().orientation_3_object();
  std::vector<Approximate_point_3> positions;
  for (const Point_3& p : points) {
    positions.push_back(approximate(p));
    if (!internal::has_finite_coordinates(positions.back()))
      throw Invalid_tetrahedra_error(
          "coordinates are no finite numbers: correct or remove the point", {},
          {positions.size() - 1});
  }
  if (!internal::has_measurable_extent(positions))
    throw Invalid_tetrahedra_error("the extent of the domain is not between 1e-30 and 1e30; scale "
                                   "the points, so that volumes and qualities can be computed");
  std::vector<bool> is_used(points.size(), false);
  std::vector<Approximate_point_3> barycenters;
  for (size_type t = 0; t < tetrahedra.size(); ++t) {
    const auto& v = tetrahedra[t];
    Approximate_vector_3 sum(0, 0, 0);
    for (size_type i : v) {
      if (i >= points.size())
        throw Invalid_tetrahedra_error("a tetrahedron names a point that does not exist", {t}, {i});
      is_used[i] = true;
      sum = sum + (positions[i] - CGAL::ORIGIN);
    }
    barycenters.push_back(CGAL::ORIGIN + sum / 4);
    if (orientation(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) != POSITIVE)
      throw Invalid_tetrahedra_error("a tetrahedron is flat or negatively oriented; give its "
                                     "vertices in positive order",
                                     {t}, {v.begin(), v.end()});
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end())
    throw Invalid_tetrahedra_error("a point belongs to no tetrahedron; leave it out", {},
                                   {size_type(unused - is_used.begin())});

  const std::vector<size_type> vertex_order = internal::hilbert_order(positions);
  const std::vector<size_type> cell_order = internal::hilbert_order(barycenters);
  internal::prepare_for_cells(result.m_triangulation);
  std::vector<size_type> rank(points.size());
  std::vector<Vertex_handle> handles(1, result.m_triangulation.infinite_vertex());
  for (size_type i = 0; i < vertex_order.size(); ++i) {
    rank[vertex_order[i]] = i + 1;
    handles.push_back(result.m_triangulation.tds().create_vertex());
    handles.back()->set_point(points[vertex_order[i]]);
  }
  std::vector<Vertex_indices> cells;
  for (size_type t : cell_order) {
    const auto& v = tetrahedra[t];
    cells.push_back({rank[v[0]], rank[v[1]], rank[v[2]], rank[v[3]]});
  }
  try {
    internal::append_infinite_cells(cells);
    const auto cell_handles = internal::create_cells(result.m_triangulation.tds(), handles, cells);
    for (size_type i = 0; i < cell_order.size(); ++i)
      cell_handles[i]->set_label(labels[cell_order[i]]);
    result.check_stars(handles);
    internal::check_boundary(cells);
  } catch (const Invalid_tetrahedra_error& e) {
    // Translate indices along the curve to those of the caller.
    std::vector<size_type> where, who;
    for (size_type t : e.tetrahedra())
      if (t < cell_order.size())
        where.push_back(cell_order[t]);
    for (size_type v : e.vertices())
      if (v != 0)
        who.push_back(vertex_order[v - 1]);
    std::sort(where.begin(), where.end());
    throw Invalid_tetrahedra_error(e.what(), where, who);
  }
  result.initialize_boundary_classes();
  result.initialize_caches();
  result.measure_interface_edges();
  result.m_normalization = m_normalization;
  swap(result);

  std::vector<Vertex_handle> in_input_order;
  for (size_type r : rank)
    in_input_order.push_back(handles[r]);
  return in_input_order;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::sort_storage() {
  if (number_of_cells() == 0)
    return;
  const State before = state();
  std::vector<Approximate_point_3> positions, barycenters;
  for (const auto& p : before.points)
    positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& c : before.cells) {
    Approximate_vector_3 sum(0, 0, 0);
    int finite = 0;
    for (std::uint32_t v : c)
      if (v != 0) {
        sum = sum + (positions[v - 1] - CGAL::ORIGIN);
        ++finite;
      }
    barycenters.push_back(CGAL::ORIGIN + sum / finite);
  }
  namespace internal = Deformable_simplicial_complexes::internal;
  const std::vector<size_type> vertex_order = internal::hilbert_order(positions);
  const std::vector<size_type> cell_order = internal::hilbert_order(barycenters);

  State after = before;
  std::vector<std::uint32_t> vertex_rank(positions.size() + 1, 0), cell_rank(before.cells.size());
  for (size_type i = 0; i < vertex_order.size(); ++i) {
    vertex_rank[vertex_order[i] + 1] = std::uint32_t(i + 1);
    after.points[i] = before.points[vertex_order[i]];
    after.boundary_classes[i] = before.boundary_classes[vertex_order[i]];
  }
  for (size_type i = 0; i < cell_order.size(); ++i) {
    const size_type old = cell_order[i];
    cell_rank[old] = std::uint32_t(i);
    for (int j = 0; j < 4; ++j)
      after.cells[i][j] = vertex_rank[before.cells[old][j]];
    after.cell_labels[i] = before.cell_labels[old];
    after.exhausted_qualities[i] = before.exhausted_qualities[old];
  }
  for (size_type v = 0; v < before.vertex_cells.size(); ++v)
    after.vertex_cells[vertex_rank[v]] = cell_rank[before.vertex_cells[v]];
  std::vector<Point_3> points;
  const std::vector<Vertex_handle> vertices = this->vertices();
  for (size_type i : vertex_order)
    points.push_back(vertices[i]->point());
  rebuild(after, points);
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::state() const -> State {
  State result;
  result.mean_interface_edge = m_mean_interface_edge;
  result.minimum_interface_edge = m_minimum_interface_edge;
  const Approximate_vector_3& t = m_normalization.translation;
  result.normalization_translation = {t.x(), t.y(), t.z()};
  result.normalization_scale = m_normalization.scale;
  if (number_of_cells() == 0)
    return result;

  const auto order = Deformable_simplicial_complexes::internal::Less_time_stamp();
  std::vector<Cell_handle> cells;
  for (Cell_handle c : m_triangulation.all_cell_handles())
    cells.push_back(c);
  std::sort(cells.begin(), cells.end(), order);
  std::vector<Vertex_handle> vertices = this->vertices();
  vertices.insert(vertices.begin(), m_triangulation.infinite_vertex());

  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    vertices[i]->set_scratch_index(i);
    const auto position =
        std::lower_bound(cells.begin(), cells.end(), vertices[i]->cell(), order) - cells.begin();
    result.vertex_cells.push_back(std::uint32_t(position));
    if (i > 0) {
      const Approximate_point_3 p = this->position(vertices[i]);
      result.points.push_back({p.x(), p.y(), p.z()});
      result.boundary_classes.push_back(vertices[i]->boundary_class());
    }
  }
  for (Cell_handle c : cells) {
    const auto index = [&](int i) { return c->vertex(i)->scratch_index(); };
    result.cells.push_back({index(0), index(1), index(2), index(3)});
    result.cell_labels.push_back(c->label());
    result.exhausted_qualities.push_back(c->exhausted_quality());
  }
  return result;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::restore(const State& state) {
  using Deformable_simplicial_complexes::Invalid_tetrahedra_error;
  if (!Deformable_simplicial_complexes::internal::is_consistent(state))
    throw Invalid_tetrahedra_error("the arrays of the state do not fit together");
  std::vector<Point_3> points;
  for (const auto& p : state.points)
    points.push_back(
        geom_traits().construct_exact_point_3_object()(Approximate_point_3(p[0], p[1], p[2])));
  rebuild(state, points);
}

// `points` are those of the state before rounding.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::rebuild(const State& state, const std::vector<Point_3>& points) {
  Deformable_simplicial_complex_3 result(geom_traits(), m_quality_measure);
  const auto& t = state.normalization_translation;
  result.m_normalization = {Approximate_vector_3(t[0], t[1], t[2]), state.normalization_scale};
  result.m_mean_interface_edge = state.mean_interface_edge;
  result.m_minimum_interface_edge = state.minimum_interface_edge;
  if (!state.cells.empty())
    result.create_items(state, points);
  if (!result.is_valid())
    throw Deformable_simplicial_complexes::Invalid_tetrahedra_error(
        "the state is none of a valid complex");
  swap(result);
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::create_items(const State& state, const std::vector<Point_3>& points) {
  namespace internal = Deformable_simplicial_complexes::internal;
  internal::prepare_for_cells(m_triangulation);
  std::vector<Vertex_handle> vertices(1, m_triangulation.infinite_vertex());
  for (size_type i = 0; i < state.points.size(); ++i) {
    vertices.push_back(m_triangulation.tds().create_vertex());
    vertices.back()->set_point(points[i]);
    vertices.back()->set_boundary_class(state.boundary_classes[i]);
  }
  std::vector<Vertex_indices> indices;
  for (const auto& c : state.cells)
    indices.push_back({c[0], c[1], c[2], c[3]});
  const auto cells = internal::create_cells(m_triangulation.tds(), vertices, indices);
  for (size_type i = 0; i < cells.size(); ++i) {
    if (!is_infinite(cells[i]))
      cells[i]->set_label(state.cell_labels[i]);
    cells[i]->set_exhausted_quality(state.exhausted_qualities[i]);
  }
  for (size_type v = 0; v < vertices.size(); ++v)
    vertices[v]->set_cell(cells[state.vertex_cells[v]]);
  check_stars(vertices);
  internal::check_boundary(indices);
  initialize_caches();
}

// A vertex whose cells are not all connected through facets would pinch the domain.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::check_stars(const std::vector<Vertex_handle>& vertices) const {
  std::vector<size_type> degrees(vertices.size(), 0);
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    vertices[i]->set_scratch_index(i);
  for (Cell_handle c : m_triangulation.all_cell_handles())
    for (int i = 0; i < 4; ++i)
      ++degrees[c->vertex(i)->scratch_index()];
  const auto is_connected = [&](size_type i) {
    star(vertices[i], m_star);
    return m_star.size() == degrees[i];
  };
  for (size_type i = 1; i < vertices.size(); ++i)
    if (!is_connected(i))
      throw Deformable_simplicial_complexes::Invalid_tetrahedra_error(
          "the tetrahedra around a vertex are not connected through facets; give a mesh whose "
          "domain "
          "is a ball",
          {}, {i});
  if (!is_connected(0))
    throw Deformable_simplicial_complexes::Invalid_tetrahedra_error(
        "the boundary of the tetrahedra is not connected; give a mesh whose domain is a ball");
}

// Everything that follows from points, cells and labels.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::initialize_caches() {
  Bbox_3 box;
  for (Vertex_handle v : m_triangulation.finite_vertex_handles())
    box += position(v).bbox();
  m_totals = Deformable_simplicial_complexes::internal::Label_totals(
      (box.xmax() - box.xmin()) * (box.ymax() - box.ymin()) * (box.zmax() - box.zmin()));
  for (Cell_handle c : m_triangulation.finite_cell_handles()) {
    m_totals.add_cell(c->label(), cell_volume(c));
    c->set_quality(cell_quality(c));
    for (int i = 0; i < 4; ++i)
      if (is_interface(Facet(c, i)))
        for (Vertex_handle v : facet_vertices(Facet(c, i)))
          v->set_interface(true);
  }
  m_components.reset(m_triangulation, Cell_volumes{*this});
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::initialize_boundary_classes() {
  std::vector<Facet> hull;
  star(m_triangulation.infinite_vertex(), m_star);
  Bbox_3 box;
  for (Cell_handle c : m_star) {
    hull.emplace_back(c, c->index(m_triangulation.infinite_vertex()));
    for (Vertex_handle v : facet_vertices(hull.back()))
      box += position(v).bbox();
  }
  const auto sides = [&](Vertex_handle v) {
    Boundary_class::Bits bits = Boundary_class::inside;
    for (int axis = 0; axis < 3; ++axis) {
      bits |= position(v)[axis] == box.min(axis) ? 1 << (2 * axis) : 0;
      bits |= position(v)[axis] == box.max(axis) ? 2 << (2 * axis) : 0;
    }
    return bits;
  };
  const bool is_box = std::all_of(hull.begin(), hull.end(), [&](const Facet& f) {
    const auto v = facet_vertices(f);
    return (sides(v[0]) & sides(v[1]) & sides(v[2])) != 0;
  });
  for (const Facet& f : hull)
    for (Vertex_handle v : facet_vertices(f))
      v->set_boundary_class(is_box ? sides(v) : Boundary_class::fixed);
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::measure_interface_edges() {
  double sum = 0, minimum = 0;
  size_type n = 0;
  for (const Facet& f : interface_facets()) {
    const auto v = facet_vertices(f);
    for (int i = 0; i < 3; ++i) {
      const double length = std::sqrt((position(v[i]) - position(v[(i + 1) % 3])).squared_length());
      sum += length;
      minimum = n == 0 ? length : (std::min)(minimum, length);
      ++n;
    }
  }
  m_mean_interface_edge = n == 0 ? 0 : sum / n;
  m_minimum_interface_edge = minimum;
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::report(bool ok, const char* what, bool verbose) const {
  if (!ok && verbose)
    std::cerr << "Deformable_simplicial_complex_3: " << what << std::endl;
  return ok;
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_valid(bool verbose) const {
  if (m_triangulation.dimension() < 3) // empty
    return report(number_of_cells() == 0, "cells without space", verbose);
  if (!report(m_triangulation.tds().is_valid(verbose), "invalid data structure", verbose))
    return false;

  auto totals = Deformable_simplicial_complexes::internal::Label_totals(m_totals);
  for (const auto& t : m_totals.totals())
    totals.add_volume(t.label, -t.volume);
  size_type count = 0;
  for (Cell_handle c : m_triangulation.finite_cell_handles()) {
    ++count;
    totals.add_volume(c->label(), totals.units(cell_volume(c)));
    if (!report(is_positive(c), "a cell is not positively oriented", verbose) ||
        !report(c->quality() == cell_quality(c), "a cached quality is stale", verbose))
      return false;
  }
  if (!report(count == number_of_cells(), "the number of cells is stale", verbose))
    return false;
  for (const auto& t : m_totals.totals()) {
    if (!report(totals.units_of(t.label) == t.volume, "the volume of a label is stale", verbose))
      return false;
  }

  std::vector<Cell_handle> cells;
  for (Vertex_handle v : m_triangulation.finite_vertex_handles()) {
    if (!report(v->is_interface() == has_interface_facet(v), "an interface flag is stale", verbose))
      return false;
    star(v, cells);
    const bool is_on_hull =
        std::any_of(cells.begin(), cells.end(), [&](Cell_handle c) { return is_infinite(c); });
    if (!report(is_on_hull == is_boundary(v), "a boundary class is wrong", verbose))
      return false;
  }

  star(m_triangulation.infinite_vertex(), cells);
  return std::all_of(cells.begin(), cells.end(), [&](Cell_handle c) {
    return report(is_on_side(Facet(c, c->index(m_triangulation.infinite_vertex()))),
                  "a boundary facet lies on no side of the domain", verbose);
  });
}

// Whether a boundary facet stays in its plane whatever its vertices may do.
CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_on_side(const Facet& f) const {
  const auto v = facet_vertices(f);
  const auto sides = v[0]->boundary_class() & v[1]->boundary_class() & v[2]->boundary_class();
  if ((sides & Boundary_class::fixed) != 0)
    return true;
  for (int axis = 0; axis < 3; ++axis)
    if ((sides >> (2 * axis) & 3) != 0 && position(v[0])[axis] == position(v[1])[axis] &&
        position(v[0])[axis] == position(v[2])[axis])
      return true;
  return false;
}

} // namespace CGAL

#undef CGAL_DSC_TEMPLATE
#undef CGAL_DSC_CLASS

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPLEX_STORAGE_IMPL_H

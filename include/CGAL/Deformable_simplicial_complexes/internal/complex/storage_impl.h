// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_STORAGE_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_STORAGE_IMPL_H

// Member functions of `Labeled_complex`: cells and states, from and to arrays; validity.

#include <CGAL/Deformable_simplicial_complexes/Labeled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Item_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/hilbert_order.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <CGAL/Origin.h>

#include <iostream>

#define CGAL_DSC_TEMPLATE template <class Derived, class Space, class Quality, class Domain>
#define CGAL_DSC_CLASS Labeled_complex<Derived, Space, Quality, Domain>

namespace CGAL::Deformable_simplicial_complexes {

// Returns all cells, including infinite ones, in the order of time stamps.
CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::all_cells() const -> std::vector<Cell_handle> {
  return internal::by_time_stamp<Cell_handle>(Space::all_cells(m_triangulation),
                                              [](Cell_handle) { return true; });
}

// Moves a complex. `other` becomes empty.
CGAL_DSC_TEMPLATE
CGAL_DSC_CLASS::Labeled_complex(Labeled_complex&& other) noexcept
    : m_triangulation(std::move(other.m_triangulation)),
      m_numbers(std::exchange(other.m_numbers, Item_numbers())),
      m_quality_measure(other.m_quality_measure), m_domain(other.m_domain),
      m_totals(std::move(other.m_totals)),
      m_normalization(std::exchange(other.m_normalization, Normalization())),
      m_mean_interface_edge(std::exchange(other.m_mean_interface_edge, 0)),
      m_minimum_interface_edge(std::exchange(other.m_minimum_interface_edge, 0)),
      m_number_of_flat_cells(std::exchange(other.m_number_of_flat_cells, 0)),
      m_version(other.m_version++), m_components(std::move(other.m_components)) {
  other.m_components = internal::Component_tracker<Cell_handle>();
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::swap(Labeled_complex& other) noexcept {
  using std::swap;
  m_triangulation.swap(other.m_triangulation);
  swap(m_numbers, other.m_numbers);
  swap(m_quality_measure, other.m_quality_measure);
  swap(m_domain, other.m_domain);
  swap(m_totals, other.m_totals);
  swap(m_normalization, other.m_normalization);
  swap(m_mean_interface_edge, other.m_mean_interface_edge);
  swap(m_minimum_interface_edge, other.m_minimum_interface_edge);
  swap(m_number_of_flat_cells, other.m_number_of_flat_cells);
  swap(m_components, other.m_components);
  // Earlier proposals to either complex become invalid.
  m_version = other.m_version = (std::max)(m_version, other.m_version) + 1;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::check_number_of_cells(size_type number) {
  static constexpr size_type maximum =
      std::uint32_t(-1) / 8; // numbers of cells and facets have 32 bits
  if (number == 0)
    throw Invalid_cells_error("there are no cells; give at least one");
  if (number > maximum)
    throw Invalid_cells_error("there are 2^29 or more cells: use a coarser mesh");
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::check_extent(const internal::Extent<dimension>& extent) {
  if (!extent.is_measurable())
    throw Invalid_cells_error("the extent of the domain is not between 1e-30 and 1e30; scale "
                              "the points, so that volumes and qualities can be computed");
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::checked_barycenters(
    const std::vector<Point>& positions,
    const std::vector<std::array<size_type, corners>>& cells) const -> std::vector<Point> {
  std::vector<bool> is_used(positions.size(), false);
  std::vector<Point> barycenters;
  for (size_type t = 0; t < cells.size(); ++t) {
    Progress_scope::check();
    const auto& v = cells[t];
    Vector sum(CGAL::NULL_VECTOR);
    for (size_type i : v) {
      if (i >= positions.size())
        throw Invalid_cells_error("a cell refers to a point that does not exist: correct the index",
                                  {t}, {i});
      is_used[i] = true;
      sum = sum + (m_domain.nearest_image(positions[v[0]], positions[i]) - CGAL::ORIGIN);
    }
    barycenters.push_back(CGAL::ORIGIN + sum / corners);
    if (m_domain.orientation(*this, [&](int i) { return positions[v[i]]; }) != POSITIVE)
      throw Invalid_cells_error(dimension == 2
                                    ? "a triangle is flat or clockwise, possibly after rounding; "
                                      "give its vertices in counterclockwise order"
                                    : "a tetrahedron is flat or negatively oriented; give its "
                                      "vertices in positive orientation",
                                {t}, {v.begin(), v.end()});
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end())
    throw Invalid_cells_error("a point belongs to no cell; remove it", {},
                              {size_type(unused - is_used.begin())});
  return barycenters;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::assign(const std::vector<Point>& points,
                            const std::vector<std::array<size_type, corners>>& tetrahedra,
                            const std::vector<Label>& labels) -> std::vector<Vertex_handle> {
  if (labels.size() != tetrahedra.size())
    throw Invalid_cells_error("the number of labels differs from the number of cells: give "
                              "one label for each cell");
  check_number_of_cells(tetrahedra.size());

  Labeled_complex result(geom_traits(), m_quality_measure, m_domain);
  std::vector<Point> positions;
  for (const Point& p : points) {
    positions.push_back(m_domain.canonical(p));
    if (!has_finite_coordinates(positions.back()))
      throw Invalid_cells_error("coordinates are not finite: correct or remove the point", {},
                                {positions.size() - 1});
  }
  check_extent(internal::extent_of<dimension>(positions));
  const Progress_phase phase("assembling the mesh");
  const std::vector<Point> barycenters = checked_barycenters(positions, tetrahedra);
  const std::vector<size_type> vertex_order = internal::hilbert_order<Space>(positions);
  const std::vector<size_type> cell_order = internal::hilbert_order<Space>(barycenters);
  internal::prepare_for_cells<Space>(result.m_triangulation);
  std::vector<size_type> rank(points.size());
  std::vector<Vertex_handle> handles(
      1, result.m_numbers.add_vertex(result.m_triangulation.infinite_vertex()));
  for (size_type i = 0; i < vertex_order.size(); ++i) {
    rank[vertex_order[i]] = i + 1;
    handles.push_back(result.m_numbers.add_vertex(result.m_triangulation.tds().create_vertex()));
    handles.back()->set_point(positions[vertex_order[i]]);
  }
  std::vector<Cell_vertices> cells;
  for (size_type t : cell_order) {
    cells.emplace_back();
    for (int i = 0; i < corners; ++i)
      cells.back()[i] = rank[tetrahedra[t][i]];
  }
  try {
    if (Domain::has_outside)
      internal::append_infinite_cells(cells);
    const auto cell_handles = internal::create_cells<Space>(result.m_triangulation.tds(),
                                                            result.m_numbers, handles, cells);
    for (size_type i = 0; i < cell_order.size(); ++i)
      cell_handles[i]->set_subdomain_index(labels[cell_order[i]]);
    result.check_stars(handles);
    result.check_boundary();
  } catch (const Invalid_cells_error& e) {
    // Translates indices along the curve into indices of the caller.
    std::vector<size_type> where, who;
    for (size_type t : e.tetrahedra())
      if (t < cell_order.size())
        where.push_back(cell_order[t]);
    for (size_type v : e.vertices())
      if (v != 0)
        who.push_back(vertex_order[v - 1]);
    std::sort(where.begin(), where.end());
    throw Invalid_cells_error(e.what(), where, who);
  }
  if constexpr (Domain::has_outside)
    result.m_domain.classify_boundary(result);
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
auto CGAL_DSC_CLASS::state() const -> State {
  State result;
  result.periods = m_domain.template periods<dimension>();
  result.mean_interface_edge = m_mean_interface_edge;
  result.minimum_interface_edge = m_minimum_interface_edge;
  result.normalization_translation = coordinates_of<dimension>(m_normalization.translation);
  result.normalization_scale = m_normalization.scale;
  if (number_of_cells() == 0)
    return result;
  m_components.update(*this, m_totals);

  const std::vector<Cell_handle> cells = all_cells();
  std::vector<std::uint32_t> places(cell_id_bound());
  for (size_type i = 0; i < cells.size(); ++i)
    places[cells[i]->id()] = std::uint32_t(i);
  Vertex_numbers numbers(*this);
  std::uint32_t index = 0;
  numbers.set(m_triangulation.infinite_vertex(), index);
  if (Domain::has_outside)
    result.vertex_cells.push_back(places[m_triangulation.infinite_vertex()->cell()->id()]);
  for (Vertex_handle v : vertices()) {
    Progress_scope::check();
    numbers.set(v, ++index);
    result.vertex_cells.push_back(places[v->cell()->id()]);
    result.points.push_back(coordinates_of<dimension>(position(v)));
    result.boundary_classes.push_back(v->boundary_class());
    result.spacings.push_back(v->spacing());
  }
  for (Cell_handle c : cells) {
    Progress_scope::check();
    result.cells.emplace_back();
    for (int i = 0; i < corners; ++i)
      result.cells.back()[i] = numbers(c->vertex(i));
    result.cell_labels.push_back(c->subdomain_index());
    result.noted_qualities.push_back(c->noted_quality());
    result.failures.push_back(c->failures());
    result.cell_components.push_back(is_infinite(c) ? 0 : c->component());
  }
  return result;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::restore(const State& state) {
  if (!internal::is_consistent(state))
    throw Invalid_cells_error(
        "the sizes of the arrays of the state are inconsistent: use an unmodified state");
  rebuild(state);
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::rebuild(const State& state) {
  Labeled_complex result(geom_traits(), m_quality_measure, Domain::of(state));
  result.m_normalization = {vector_of<Labeled_complex>(state.normalization_translation),
                            state.normalization_scale};
  result.m_mean_interface_edge = state.mean_interface_edge;
  result.m_minimum_interface_edge = state.minimum_interface_edge;
  if (!state.cells.empty())
    result.create_items(state);
  if (!result.is_valid())
    throw Invalid_cells_error(
        "the state does not describe a valid complex: use an unmodified state");
  swap(result);
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::indices_of(const State& state) -> std::vector<Cell_vertices> {
  std::vector<Cell_vertices> result(state.cells.size());
  for (size_type c = 0; c < result.size(); ++c)
    std::copy(state.cells[c].begin(), state.cells[c].end(), result[c].begin());
  return result;
}

// Creates the vertices of a state. Returns the infinite vertex, followed by them.
CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::create_vertices(const State& state) -> std::vector<Vertex_handle> {
  internal::prepare_for_cells<Space>(m_triangulation);
  std::vector<Vertex_handle> vertices(1, m_numbers.add_vertex(m_triangulation.infinite_vertex()));
  for (size_type i = 0; i < state.points.size(); ++i) {
    Progress_scope::check();
    vertices.push_back(m_numbers.add_vertex(m_triangulation.tds().create_vertex()));
    vertices.back()->set_point(point_at<Labeled_complex>(state.points[i]));
    internal::Simplex_access::set_boundary_class(vertices.back(), state.boundary_classes[i]);
    internal::Simplex_access::set_spacing(vertices.back(), state.spacings[i]);
  }
  return vertices;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::create_items(const State& state) {
  const std::vector<Vertex_handle> vertices = create_vertices(state);
  const auto cells =
      internal::create_cells<Space>(m_triangulation.tds(), m_numbers, vertices, indices_of(state));
  for (size_type i = 0; i < cells.size(); ++i) {
    if (!is_infinite(cells[i]))
      cells[i]->set_subdomain_index(state.cell_labels[i]);
    internal::Simplex_access::set_failures(cells[i], state.failures[i]);
  }
  static constexpr size_type first = Domain::has_outside ? 0 : 1;
  for (size_type v = first; v < vertices.size(); ++v)
    vertices[v]->set_cell(cells[state.vertex_cells[v - first]]);
  check_stars(vertices);
  if (Domain::is_ball || !Domain::has_outside)
    check_boundary();
  initialize_caches();
  for (size_type i = 0; i < cells.size(); ++i)
    internal::Simplex_access::set_noted_quality(cells[i], state.noted_qualities[i]);
  if (!m_components.renumber(*this, cells, state.cell_components))
    throw Invalid_cells_error(
        "the component numbers of the state do not match its cells: use an unmodified state");
}

// Throws `Invalid_cells_error` if the cells around a vertex are not connected through facets. The
// domain would be pinched at such a vertex.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::check_stars(const std::vector<Vertex_handle>& vertices) const {
  std::vector<size_type> degrees(vertices.size(), 0);
  const Vertex_numbers numbers(*this, vertices);
  for (Cell_handle c : Space::all_cells(m_triangulation))
    for (int i = 0; i < corners; ++i)
      ++degrees[numbers(c->vertex(i))];
  std::vector<Cell_handle> cells;
  const auto is_connected = [&](size_type i) {
    star(vertices[i], cells);
    return cells.size() == degrees[i];
  };
  for (size_type i = 1; i < vertices.size(); ++i) {
    Progress_scope::check();
    if (degrees[i] == 0 || !is_connected(i))
      throw Invalid_cells_error(
          "the cells around a vertex are not connected through facets; give a mesh whose "
          "domain is a ball or a disk",
          {}, {i});
  }
  if (Domain::is_ball && !is_connected(0))
    throw Invalid_cells_error(
        "the boundary of the cells is not connected; give a mesh whose domain is a ball or a disk");
}

// Throws `Invalid_cells_error` if the cells do not fill the domain. If the domain has a boundary,
// the boundary, a connected manifold, must be a sphere. If it has none, the cells must not cover
// the domain more than once.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::check_boundary() const {
  if constexpr (!Domain::has_outside) {
    double sum = 0;
    for (Cell_handle c : finite_cells())
      sum += measure(c);
    if (!(sum < 1.5 * m_domain.measure()))
      throw Invalid_cells_error("the cells cover the torus more than once: give each cell once");
    return;
  }
  std::vector<Cell_handle> outside;
  star(m_triangulation.infinite_vertex(), outside);
  std::vector<size_type> vertices;
  for (Cell_handle c : outside)
    for (int i = 0; i < corners; ++i)
      if (!is_infinite(c->vertex(i)))
        vertices.push_back(c->vertex(i)->time_stamp());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  if (!Space::is_sphere(vertices.size(), outside.size()))
    throw Invalid_cells_error("the boundary of the cells is not a sphere, in the plane a circle: "
                              "give a mesh whose domain is a ball or a disk");
}

// Computes all data that follows from points, cells and labels.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::initialize_caches() {
  if constexpr (Domain::has_outside) {
    internal::Extent<dimension> box;
    for (Vertex_handle v : finite_vertices())
      box.add(position(v));
    m_totals = internal::Label_totals(box.measure());
  } else {
    m_totals = internal::Label_totals(m_domain.measure());
  }
  for (Cell_handle c : finite_cells()) {
    m_totals.add_cell(c->subdomain_index(), measure(c));
    set_quality(c, cell_quality(c));
    for (int i = 0; i < corners; ++i)
      if (c->neighbor(i)->subdomain_index() < c->subdomain_index() && is_interface(Facet(c, i)))
        count_interface_facet(Facet(c, i), 1);
  }
  m_components.reset(*this, m_totals);
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::measure_interface_edges() {
  double sum = 0, minimum = 0;
  size_type n = 0;
  for (const Facet& f : interface_facets()) {
    const auto v = facet_vertices(f);
    for (const auto& edge : Space::facet_edges) {
      const double length = std::sqrt(displacement(v[edge[1]], v[edge[0]]).squared_length());
      sum += length;
      minimum = n == 0 ? length : (std::min)(minimum, length);
      ++n;
    }
  }
  m_mean_interface_edge = n == 0 ? 0 : sum / double(n);
  m_minimum_interface_edge = minimum;
  for (Vertex_handle v : finite_vertices())
    internal::Simplex_access::set_spacing(v, float(interface_edge_length(v)));
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::report(bool ok, const char* what, bool verbose) const {
  if (!ok && verbose)
    std::cerr << "deformable simplicial complex: " << what << std::endl;
  return ok;
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_valid(bool verbose) const {
  if (m_triangulation.dimension() < dimension) // empty
    return report(number_of_cells() == 0, "there are cells in an empty triangulation", verbose);
  if (!report(is_sewn(verbose), "invalid data structure", verbose))
    return false;

  internal::Marks seen_vertices(vertex_id_bound()), seen_cells(cell_id_bound());
  bool are_numbered = seen_vertices.add(m_triangulation.infinite_vertex());
  for (Vertex_handle v : finite_vertices())
    are_numbered = are_numbered && v->id() < vertex_id_bound() && seen_vertices.add(v);
  for (Cell_handle c : Space::all_cells(m_triangulation))
    are_numbered = are_numbered && c->id() < cell_id_bound() && seen_cells.add(c);
  if (!report(are_numbered, "ids are too large or not unique", verbose))
    return false;

  auto totals = m_totals;
  for (const auto& t : m_totals.totals())
    totals.add_volume(t.label, -t.volume);
  size_type count = 0, flat = 0;
  for (Cell_handle c : finite_cells()) {
    Progress_scope::check();
    ++count;
    flat += c->quality() < quality_floor;
    totals.add_volume(c->subdomain_index(), totals.units(measure(c)));
    if (!report(is_positive(c), "a cell is not positively oriented", verbose) ||
        !report(c->quality() == cell_quality(c), "a cached quality is stale", verbose))
      return false;
  }
  if (!report(count == number_of_cells() && flat == m_number_of_flat_cells,
              "the number of cells is stale", verbose))
    return false;
  for (const auto& t : m_totals.totals()) {
    if (!report(totals.units_of(t.label) == t.volume, "the volume of a label is stale", verbose))
      return false;
  }

  if (!report(m_components.is_right(*this, m_totals),
              "a number or a volume of a component is stale", verbose))
    return false;

  std::vector<Cell_handle> cells;
  for (Vertex_handle v : finite_vertices()) {
    Progress_scope::check();
    star(v, cells);
    size_type twice_interface = 0;
    bool is_on_hull = false;
    for (Cell_handle c : cells) {
      is_on_hull = is_on_hull || is_infinite(c);
      for (int i = 0; i < corners; ++i)
        twice_interface += c->vertex(i) != v && is_interface(Facet(c, i)) ? 1 : 0;
    }
    if (!report(twice_interface == 2 * size_type(v->interface_degree()),
                "a number of facets of the interface is stale", verbose) ||
        !report(is_on_hull == is_boundary(v), "a boundary class is wrong", verbose))
      return false;
  }

  if constexpr (Domain::has_outside) {
    const Vertex_handle outside = m_triangulation.infinite_vertex();
    star(outside, cells);
    return std::all_of(cells.begin(), cells.end(), [&](Cell_handle c) {
      return report(m_domain.keeps_side(*this, Facet(c, c->index(outside))),
                    "a boundary facet lies on no side of the domain", verbose);
    });
  }
  return true;
}

// Returns whether the adjacency of vertices and cells is consistent. A domain that is no ball can
// have any topology.
CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_sewn(bool verbose) const {
  if (Domain::is_ball)
    return Space::is_sewn(m_triangulation.tds(), verbose);
  // The validity test of CGAL requires that some cell has the infinite vertex.
  for (Vertex_handle v : finite_vertices())
    if (v->cell() == Cell_handle() || !v->cell()->has_vertex(v))
      return false;
  for (Cell_handle c : finite_cells())
    for (int i = 0; i < corners; ++i) {
      int j;
      if (c->neighbor(i) == Cell_handle() || !c->neighbor(i)->has_neighbor(c, j) ||
          c->neighbor(i)->vertex(j) == c->vertex(i))
        return false;
      for (int k = 0; k < corners; ++k)
        if (k != i && !c->neighbor(i)->has_vertex(c->vertex(k)))
          return false;
    }
  return true;
}

} // namespace CGAL::Deformable_simplicial_complexes

#undef CGAL_DSC_TEMPLATE
#undef CGAL_DSC_CLASS

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_STORAGE_IMPL_H

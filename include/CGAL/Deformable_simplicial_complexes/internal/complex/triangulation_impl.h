// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_TRIANGULATION_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_TRIANGULATION_IMPL_H

// Member functions of `Labeled_complex`: copies, and triangulations that are moved in and out.

#include <CGAL/Deformable_simplicial_complexes/Labeled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/hilbert_order.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#define CGAL_DSC_TEMPLATE template <class Derived, class Space, class Quality, class Domain>
#define CGAL_DSC_CLASS Labeled_complex<Derived, Space, Quality, Domain>

namespace CGAL::Deformable_simplicial_complexes {

// The copy constructor of CGAL's triangulation is not used: since CGAL 6, copies have other time
// stamps.
CGAL_DSC_TEMPLATE
CGAL_DSC_CLASS::Labeled_complex(const Labeled_complex& other)
    : m_triangulation(other.geom_traits()), m_quality_measure(other.m_quality_measure),
      m_domain(other.m_domain) {
  if (other.number_of_cells() > 0) {
    copy_simplices(other, other.vertices(), other.all_cells(), true);
    m_numbers.continue_time_stamps(other.m_numbers);
  }
  copy_values(other);
  m_version = other.m_version;
}

// Copies everything but vertices and cells.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::copy_values(const Labeled_complex& other) {
  m_totals = other.m_totals;
  m_normalization = other.m_normalization;
  m_mean_interface_edge = other.m_mean_interface_edge;
  m_minimum_interface_edge = other.m_minimum_interface_edge;
  m_number_of_flat_cells = other.m_number_of_flat_cells;
  m_components = other.m_components;
}

// Copies the vertices and cells of another complex in given orders, with all data of their bases.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::copy_simplices(const Labeled_complex& other,
                                    const std::vector<Vertex_handle>& vertices,
                                    const std::vector<Cell_handle>& cells, bool keeps_time_stamps) {
  other.m_components.update(other, other.m_totals); // no cell handles are kept then
  internal::prepare_for_cells<Space>(m_triangulation);
  std::vector<Vertex_handle> vertex_of(other.vertex_id_bound()); // by the id of the original
  std::vector<Cell_handle> cell_of(other.cell_id_bound());
  const auto copy = [&](auto from, auto to) {
    const auto id = to->id();
    const size_type stamp = to->time_stamp();
    *to = *from;
    internal::Simplex_access::set_id(to, id);
    if (!keeps_time_stamps)
      to->set_time_stamp(stamp);
    return to;
  };
  const auto copy_vertex = [&](Vertex_handle from, Vertex_handle to) {
    vertex_of[from->id()] = copy(from, m_numbers.add_vertex(to));
  };
  auto& tds = m_triangulation.tds();
  copy_vertex(other.m_triangulation.infinite_vertex(), m_triangulation.infinite_vertex());
  for (Vertex_handle v : vertices) {
    Progress_scope::check();
    copy_vertex(v, tds.create_vertex());
  }
  for (Cell_handle c : cells) {
    Progress_scope::check();
    cell_of[c->id()] = copy(c, m_numbers.add_cell(Space::create_cell(tds)));
  }
  for (Cell_handle c : cells)
    for (int i = 0; i < corners; ++i) {
      cell_of[c->id()]->set_vertex(i, vertex_of[c->vertex(i)->id()]);
      cell_of[c->id()]->set_neighbor(i, cell_of[c->neighbor(i)->id()]);
    }
  for (Vertex_handle v : vertices)
    vertex_of[v->id()]->set_cell(cell_of[v->cell()->id()]);
  if (const Vertex_handle outside = other.m_triangulation.infinite_vertex(); Domain::has_outside)
    m_triangulation.infinite_vertex()->set_cell(cell_of[outside->cell()->id()]);
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::sort_storage() {
  if (number_of_cells() == 0)
    return;
  const std::vector<Vertex_handle> vertices = this->vertices();
  const std::vector<Cell_handle> cells = all_cells();
  std::vector<Point> positions, barycenters;
  for (Vertex_handle v : vertices)
    positions.push_back(position(v));
  for (Cell_handle c : cells) {
    Vector sum = CGAL::NULL_VECTOR;
    int finite = 0;
    Vertex_handle first;
    for (int i = 0; i < corners; ++i)
      if (const Vertex_handle v = c->vertex(i); !is_infinite(v)) {
        if (finite++ == 0)
          first = v;
        sum = sum + (position_near(position(first), v) - CGAL::ORIGIN);
      }
    barycenters.push_back(CGAL::ORIGIN + sum / finite);
  }
  const auto along_curve = [](const auto& items, const std::vector<Point>& points) {
    std::decay_t<decltype(items)> result;
    for (size_type i : internal::hilbert_order<Space>(points))
      result.push_back(items[i]);
    return result;
  };
  Labeled_complex result(geom_traits(), m_quality_measure, m_domain);
  result.copy_simplices(*this, along_curve(vertices, positions), along_curve(cells, barycenters),
                        false);
  result.copy_values(*this);
  result.m_components.take_events();
  result.m_components.take_lineage();
  swap(result);
}

CGAL_DSC_TEMPLATE
template <class D> void CGAL_DSC_CLASS::assign(Triangulation&& triangulation) {
  static_assert(D::has_outside, "a triangulation of CGAL fills no torus");
  Labeled_complex result(geom_traits(), m_quality_measure, m_domain);
  result.m_triangulation.swap(triangulation);
  try {
    result.join_simplices();
  } catch (...) {
    result.leave_simplices();
    result.m_triangulation.swap(triangulation);
    throw;
  }
  result.m_normalization = m_normalization;
  swap(result);
}

// Takes the vertices and cells of the triangulation into the complex.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::join_simplices() {
  if (m_triangulation.dimension() < dimension)
    throw Invalid_cells_error("the triangulation has no cells: give one of full dimension");
  const Progress_phase phase("assembling the mesh");
  std::vector<Vertex_handle> vertices = this->vertices();
  const std::vector<Cell_handle> cells = all_cells();
  vertices.insert(vertices.begin(), m_triangulation.infinite_vertex());
  internal::Extent<dimension> extent;
  for (Vertex_handle v : vertices) {
    m_numbers.add_vertex(v);
    if (is_infinite(v))
      continue;
    if (!has_finite_coordinates(position(v)))
      throw Invalid_cells_error("coordinates are not finite: correct or remove the point", {},
                                {size_type(v->id() - 1)});
    extent.add(position(v));
  }
  size_type finite = 0;
  for (Cell_handle c : cells) {
    m_numbers.add_cell(c);
    if (is_infinite(c))
      c->set_subdomain_index(0);
    else
      ++finite;
  }
  check_number_of_cells(finite);
  check_extent(extent);
  for (Cell_handle c : cells)
    if (!is_infinite(c) && !is_positive(c))
      throw Invalid_cells_error("a cell is not positively oriented: move its vertices", {c->id()});
  check_stars(vertices);
  check_boundary();
  if constexpr (Domain::has_outside)
    m_domain.classify_boundary(*this);
  initialize_caches();
  measure_interface_edges();
}

// Gives the data of CGAL's simplicial meshes to vertices and cells.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::leave_simplices() {
  using Patch = std::pair<Label, Label>;
  const auto patch_of = [](Cell_handle c, int i) {
    return Patch(std::minmax(c->subdomain_index(), c->neighbor(i)->subdomain_index()));
  };
  const std::vector<Vertex_handle> vertices = this->vertices();
  const std::vector<Cell_handle> cells = all_cells();
  std::vector<Patch> patches;
  for (Cell_handle c : cells)
    for (int i = 0; i < corners; ++i)
      if (const Patch patch = patch_of(c, i); patch.first != patch.second)
        patches.push_back(patch);
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());

  // The containers of CGAL count fewer creations than a complex does, and would give the same time
  // stamps again.
  m_triangulation.infinite_vertex()->set_time_stamp(0);
  for (size_type i = 0; i < vertices.size(); ++i)
    vertices[i]->set_time_stamp(i + 1);
  for (size_type i = 0; i < cells.size(); ++i)
    cells[i]->set_time_stamp(i);

  for (Vertex_handle v : m_triangulation.all_vertex_handles())
    internal::Simplex_access::leave(*v);
  for (Cell_handle c : cells) {
    std::array<int, 4> numbers = {0, 0, 0, 0};
    for (int i = 0; i < corners; ++i)
      if (const Patch patch = patch_of(c, i); patch.first != patch.second)
        numbers[i] =
            1 + int(std::lower_bound(patches.begin(), patches.end(), patch) - patches.begin());
    internal::Simplex_access::leave(*c, *c, numbers);
    if constexpr (dimension == 3)
      for (int i = 0; i < corners; ++i)
        for (int j = 0; j < corners; ++j)
          if (i != j)
            internal::Simplex_access::add_facet(*c->vertex(j), c->subdomain_index(), numbers[i]);
  }
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::release() -> Triangulation {
  leave_simplices();
  Triangulation result(geom_traits());
  result.swap(m_triangulation);
  clear();
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#undef CGAL_DSC_TEMPLATE
#undef CGAL_DSC_CLASS

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_TRIANGULATION_IMPL_H

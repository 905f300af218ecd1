// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_CHANGES_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_CHANGES_IMPL_H

// Member functions of `Labeled_complex`: motion and changes of the mesh.

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Labeled_complex.h>

#include <CGAL/assertions.h>

#include <new>
#include <optional>

#define CGAL_DSC_TEMPLATE template <class Derived, class Space, class Quality, class Domain>
#define CGAL_DSC_CLASS Labeled_complex<Derived, Space, Quality, Domain>

namespace CGAL::Deformable_simplicial_complexes {

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::cell_quality(Cell_handle c) const {
  return quality(c, [&](Vertex_handle v) { return position(v); });
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_positive(Cell_handle c) const {
  return is_positive(c, [](Vertex_handle v) -> const Point& { return v->point(); });
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_positive_star(Vertex_handle v, const std::vector<Cell_handle>& star,
                                      const Point& target) const {
  const Point q = canonical(target);
  const auto point_of = [&](Vertex_handle w) -> const Point& { return w == v ? q : w->point(); };
  return std::all_of(star.begin(), star.end(),
                     [&](Cell_handle c) { return is_infinite(c) || is_positive(c, point_of); });
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::is_admissible_star(Vertex_handle v, const std::vector<Cell_handle>& star,
                                        const Point& q, double floor) const {
  const auto position_of = [&](Vertex_handle w) -> const Point& {
    return w == v ? q : position(w);
  };
  return is_positive_star(v, star, q) && std::all_of(star.begin(), star.end(), [&](Cell_handle c) {
           return is_infinite(c) || keeps_quality(c->quality(), quality(c, position_of), floor);
         });
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::move_vertex(Vertex_handle v, const Point& destination, double margin,
                                   double floor) {
  const Point q = admissible_destination(v, destination);
  if (q == v->point())
    return 1;
  star(v, m_star);
  const auto move_to = [&](const Point& p) {
    place(v, m_star, p);
    for (Cell_handle c : m_star)
      note_motion(c);
  };
  if (is_admissible_star(v, m_star, q, floor)) {
    move_to(q);
    return 1;
  }

  // The volume of a cell is linear along the segment to the destination. `fraction` becomes the
  // smallest parameter at which a cell is flat.
  double fraction = 1;
  const Point from = position(v), to = m_domain.nearest_image(from, q);
  for (Cell_handle c : m_star) {
    if (is_infinite(c))
      continue;
    const int apex = c->index(v);
    std::array<Point, dimension> link;
    for (int i = 0; i < dimension; ++i)
      link[i] = position_near(from, c->vertex(Space::facet_vertices[apex][i]));
    const double here = Space::measure_of_cone(link, from),
                 there = Space::measure_of_cone(link, to);
    if (there < here)
      fraction = (std::min)(fraction, here / (here - there));
  }

  // Rounding and the quality floor can require a larger distance than the margin.
  static constexpr int maximum_number_of_halvings = 40;
  fraction *= 1 - margin;
  for (int i = 0; i < maximum_number_of_halvings && fraction > 0; ++i, fraction /= 2) {
    const Point p = canonical(from + fraction * (to - from));
    if (is_admissible_star(v, m_star, p, floor)) {
      if (p == v->point())
        return 0;
      move_to(p);
      return fraction;
    }
  }
  return 0;
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::set_point(Vertex_handle v, const std::vector<Cell_handle>& star,
                               const Point& p) {
  place(v, star, p);
  for (Cell_handle c : star)
    if (!is_infinite(c))
      internal::note_shape(c);
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::place(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& p) {
  ++m_version;
  for (Cell_handle c : star)
    if (!is_infinite(c))
      add_volume(c, -m_totals.units(measure(c)));
  v->set_point(canonical(p));
  for (Cell_handle c : star)
    if (!is_infinite(c)) {
      CGAL_assertion(is_positive(c));
      add_volume(c, m_totals.units(measure(c)));
      set_quality(c, cell_quality(c));
    }
}

// Clears the failures of a cell if its shape has changed.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::note_motion(Cell_handle c) {
  if (!is_infinite(c) && internal::note_shape(c))
    forget_failures(c);
}

// Clears the failures of a cell and of its neighbors with the same label.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::forget_failures(Cell_handle c) {
  internal::Simplex_access::set_failures(c, 0);
  for (int i = 0; i < corners; ++i)
    if (c->neighbor(i)->subdomain_index() == c->subdomain_index())
      internal::Simplex_access::set_failures(c->neighbor(i), 0);
}

CGAL_DSC_TEMPLATE
template <class ForEachIndex>
void CGAL_DSC_CLASS::set_points(const std::vector<Vertex_handle>& vertices,
                                const std::vector<Point>& points,
                                const std::vector<Cell_handle>& cells,
                                const std::vector<std::array<double, 2>>& measures,
                                const std::vector<double>& qualities,
                                const ForEachIndex& for_each_index) {
  static constexpr size_type block_size = 256; // cells; enough work for a thread
  static constexpr size_type worthwhile = 8;   // blocks from which threads are used
  const size_type number_of_blocks = (cells.size() + block_size - 1) / block_size;
  std::vector<std::int64_t> volume_changes(cells.size(), 0);
  std::vector<char> have_new_shapes(cells.size(), false);
  std::vector<std::ptrdiff_t> flat_changes(number_of_blocks, 0); // of the numbers of flat cells
  // No exception is thrown from here on.
  ++m_version;
  for_each_index(
      vertices.size(), [&](size_type i) { vertices[i]->set_point(canonical(points[i])); },
      worthwhile * block_size);
  for_each_index(
      number_of_blocks,
      [&](size_type block) {
        size_type first = block * block_size; // of a run of cells with one label and one component
        const size_type end = (std::min)(cells.size(), first + block_size);
        for (size_type i = first; i < end; ++i) {
          const Cell_handle c = cells[i];
          if (is_infinite(c))
            continue;
          CGAL_assertion(is_positive(c));
          CGAL_assertion(qualities[i] == cell_quality(c));
          CGAL_assertion(measures[i][1] == measure(c));
          if (c->subdomain_index() != cells[first]->subdomain_index() ||
              c->component() != cells[first]->component())
            first = i;
          volume_changes[first] += m_totals.units(measures[i][1]) - m_totals.units(measures[i][0]);
          flat_changes[block] += (qualities[i] < quality_floor) - (c->quality() < quality_floor);
          internal::Simplex_access::set_quality(c, qualities[i]);
          have_new_shapes[i] = internal::note_shape(c);
        }
      },
      worthwhile);
  for (std::ptrdiff_t change : flat_changes)
    m_number_of_flat_cells += size_type(change);
  for (size_type i = 0; i < cells.size(); ++i) {
    if (volume_changes[i] != 0)
      add_volume(cells[i], volume_changes[i]);
    if (have_new_shapes[i])
      forget_failures(cells[i]);
  }
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::relabel(Cell_handle c, Label label) {
  m_totals.make_room(label);
  m_components.prepare_relabeling(*this, c, label);
  // No exception is thrown from here on.
  ++m_version;
  const auto count_interface = [&](int number) {
    for (int i = 0; i < corners; ++i)
      if (is_interface(Facet(c, i)))
        count_interface_facet(Facet(c, i), number);
  };
  const double volume = measure(c);
  count_interface(-1);
  m_totals.remove_cell(c->subdomain_index(), volume);
  m_components.add_volume(c->component(), -m_totals.units(volume));
  m_totals.add_cell(label, volume);
  c->set_subdomain_index(label);
  count_interface(1);
  for (int i = 0; i < corners; ++i)
    if (c->neighbor(i)->subdomain_index() == label && !is_infinite(c->neighbor(i)))
      internal::Simplex_access::set_component(c, c->neighbor(i)->component());
  m_components.add_volume(c->component(), m_totals.units(volume));
  forget_failures(c);
}

// The new vertices and cells of a cavity. The destructor deletes them unless `keep()` was called.
CGAL_DSC_TEMPLATE
class CGAL_DSC_CLASS::Created_items
{
public:
  Created_items(Triangulation_data_structure& tds, Item_numbers& numbers, Cavity& cavity)
      : m_tds(tds), m_numbers(numbers), m_cavity(cavity) {}
  Created_items(const Created_items&) = delete;
  Created_items& operator=(const Created_items&) = delete;

  void create() {
    // Ids are taken back for removed items, or for created items that are not kept.
    m_numbers.make_room(m_cavity.vertices().size(), m_cavity.planned().size(),
                        m_cavity.removed().size());
    for (std::size_t i = 0; i < m_cavity.m_vertices.size(); ++i)
      if (m_cavity.m_vertices[i].handle == Vertex_handle()) {
        m_new_vertices.push_back(i);
        auto& v = m_cavity.m_vertices[i];
        v.handle = m_numbers.add_vertex(m_tds.create_vertex());
        v.handle->set_point(v.position);
        internal::Simplex_access::set_boundary_class(v.handle, v.boundary_class);
      }
    m_cavity.m_created.reserve(m_cavity.m_planned.size());
    while (m_cavity.m_created.size() < m_cavity.m_planned.size())
      m_cavity.m_created.push_back(m_numbers.add_cell(Space::create_cell(m_tds)));
  }

  void keep() { m_are_kept = true; }

  ~Created_items() {
    if (m_are_kept)
      return;
    for (Cell_handle c : m_cavity.m_created) {
      m_numbers.remove_cell(c);
      Space::delete_cell(m_tds, c);
    }
    m_cavity.m_created.clear();
    for (std::size_t i : m_new_vertices) {
      if (m_cavity.m_vertices[i].handle != Vertex_handle()) {
        m_numbers.remove_vertex(m_cavity.m_vertices[i].handle);
        m_tds.delete_vertex(m_cavity.m_vertices[i].handle);
      }
      m_cavity.m_vertices[i].handle = Vertex_handle();
    }
  }

private:
  Triangulation_data_structure& m_tds;
  Item_numbers& m_numbers;
  Cavity& m_cavity;
  std::vector<std::size_t> m_new_vertices; // by their indices in the cavity
  bool m_are_kept = false;
};

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::replace(Cavity& cavity) {
  if (cavity.version() != m_version)
    throw Stale_proposal_error();
  CGAL_precondition(cavity.is_positive());
  Triangulation_data_structure& tds = m_triangulation.tds();
  m_half_facets.clear();
  m_half_facets.reserve(corners * (cavity.removed().size() + cavity.planned().size()));
  const bool is_label_mixed = has_several_labels(cavity.removed());
  m_components.settle(*this);
  std::optional<internal::Connections<Labeled_complex>> connections;
  if (is_label_mixed && m_components.is_known())
    connections.emplace(*this, cavity.removed());
  Created_items items(tds, m_numbers, cavity);
  items.create();
  internal::Marks removed(cell_id_bound());
  items.keep();

  // No exception is thrown from here on.
  ++m_version;
  for (Cell_handle c : cavity.removed()) {
    removed.add(c);
    if (!is_infinite(c)) {
      const double volume = measure(c);
      m_totals.remove_cell(c->subdomain_index(), volume);
      m_components.add_volume(c->component(), -m_totals.units(volume));
      m_number_of_flat_cells -= c->quality() < quality_floor;
    }
  }
  if (is_label_mixed)
    count_removed_interface(cavity, removed);
  collect_surroundings(cavity, removed);

  for (auto& v : cavity.m_vertices)
    if (!is_infinite(v.handle) && !(v.handle->point() == v.position))
      v.handle->set_point(v.position);
  for (std::size_t k = 0; k < cavity.planned().size(); ++k) {
    const auto& plan = cavity.planned()[k];
    const Cell_handle c = cavity.created()[k];
    for (int i = 0; i < corners; ++i) {
      c->set_vertex(i, cavity.m_vertices[plan.vertices[i]].handle);
      c->vertex(i)->set_cell(c);
    }
    internal::Simplex_access::set_component(c, plan.parent->component());
    if (!is_infinite(c)) {
      c->set_subdomain_index(plan.parent->subdomain_index());
      set_quality(c, plan.quality);
      internal::Simplex_access::set_noted_quality(c, float(plan.quality));
      const double volume = measure(c);
      m_totals.add_cell(c->subdomain_index(), volume);
      m_components.add_volume(c->component(), m_totals.units(volume));
    }
  }
  sew(is_label_mixed);

  for (const auto& v : cavity.vertices())
    if (removed.has(v.handle->cell())) { // All its cells are removed.
      m_numbers.remove_vertex(v.handle);
      tds.delete_vertex(v.handle);
    }
  for (Cell_handle c : cavity.removed()) {
    m_numbers.remove_cell(c);
    Space::delete_cell(tds, c);
  }
  if (is_label_mixed && !(connections && are_kept(*connections, cavity.created())))
    m_components.invalidate();
}

CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::has_several_labels(const std::vector<Cell_handle>& cells) const {
  const auto is_finite = [&](Cell_handle c) { return !is_infinite(c); };
  const auto first = std::find_if(cells.begin(), cells.end(), is_finite);
  return std::any_of(first, cells.end(), [&](Cell_handle c) {
    return is_finite(c) && c->subdomain_index() != (*first)->subdomain_index();
  });
}

// Returns whether the new cells keep the connections of the cells that they replace. Returns false
// if memory is exhausted.
CGAL_DSC_TEMPLATE
bool CGAL_DSC_CLASS::are_kept(const internal::Connections<Labeled_complex>& connections,
                              const std::vector<Cell_handle>& created) const noexcept {
  try {
    return connections.are_kept_by(created);
  } catch (const std::bad_alloc&) {
    return false;
  }
}

// Subtracts the interface facets of the removed cells from the counts, each once. `removed` marks
// these cells.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::count_removed_interface(const Cavity& cavity, const internal::Marks& removed) {
  for (Cell_handle c : cavity.removed())
    for (int i = 0; i < corners; ++i) {
      const Cell_handle n = c->neighbor(i);
      const bool is_counted_from_other_side =
          removed.has(n) && n->subdomain_index() < c->subdomain_index();
      if (is_interface(Facet(c, i)) && !is_counted_from_other_side)
        count_interface_facet(Facet(c, i), -1);
    }
}

// Collects the facets to be made adjacent: the facets of the cells around the cavity and of the
// planned cells.
// \pre Removed cells are marked, and memory for the facets is reserved.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::collect_surroundings(const Cavity& cavity, const internal::Marks& removed) {
  const auto add = [&](Cell_handle c, int i, const auto& index_of) {
    Half_facet facet;
    for (int k = 1; k < corners; ++k)
      facet.vertices[k - 1] = index_of((i + k) % corners);
    std::sort(facet.vertices.begin(), facet.vertices.end());
    facet.cell = c;
    facet.index = i;
    m_half_facets.push_back(facet);
    return m_half_facets.size() - 1;
  };
  for (Cell_handle c : cavity.removed())
    for (int i = 0; i < corners; ++i) {
      const Cell_handle outside = c->neighbor(i);
      if (removed.has(outside))
        continue;
      const auto known = add(c, i, [&](int k) { return cavity.index_of(c->vertex(k)); });
      m_half_facets[known].cell = outside;
      m_half_facets[known].index = outside->index(c);
    }
  for (std::size_t k = 0; k < cavity.planned().size(); ++k)
    for (int i = 0; i < corners; ++i)
      add(cavity.created()[k], i, [&](int j) { return cavity.planned()[k].vertices[j]; });
}

// Sets the adjacency of cells with equal facets.
CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::sew(bool counts_interface) {
  std::sort(m_half_facets.begin(), m_half_facets.end(),
            [](const Half_facet& a, const Half_facet& b) { return a.vertices < b.vertices; });
  CGAL_assertion(m_half_facets.size() % 2 == 0);
  for (std::size_t i = 0; i + 1 < m_half_facets.size(); i += 2) {
    const Half_facet &a = m_half_facets[i], &b = m_half_facets[i + 1];
    CGAL_assertion(a.vertices == b.vertices);
    m_triangulation.tds().set_adjacency(a.cell, a.index, b.cell, b.index);
    if (counts_interface && is_interface(Facet(a.cell, a.index)))
      count_interface_facet(Facet(a.cell, a.index), 1);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes

#undef CGAL_DSC_TEMPLATE
#undef CGAL_DSC_CLASS

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_CHANGES_IMPL_H

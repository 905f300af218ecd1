// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_PATCH_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_PATCH_H

#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parts/assign_part.h>
#include <CGAL/Distributed_complexes/Distributed_report.h>
#include <CGAL/Distributed_complexes/Part_domain.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The type of a part of a complex.
template <class Complex> struct Part_of;
template <class Traits, class Tds, class Quality, class Domain>
struct Part_of<Deformable_simplicial_complex_3<Traits, Tds, Quality, Domain>>
{
  using Type = Deformable_simplicial_complex_3<Traits, Tds, Quality, Part_domain>;
};
template <class Traits, class Tds, class Domain>
struct Part_of<Deformable_simplicial_complex_2<Traits, Tds, Domain>>
{
  using Type = Deformable_simplicial_complex_2<Traits, Tds, Part_domain>;
};

using Patch_key = std::uint64_t; // greater than 0

// Returns the key of the cube that contains the barycenter of a cell. The patch of this cube
// improves the cell. `edge` is the mean edge of the interface. Cells with edges far above it have
// larger cubes. The leading bits of a key tell whether the coordinates of the cube are odd: cubes
// of one kind do not touch, so most of them can be improved in the same round.
template <class Complex>
Patch_key patch_key(const std::array<typename Complex::Point, Complex::corners>& p, double edge) {
  // Largest edge length of a cube, in mean interface edges; the smallest one is half of it. Smaller
  // cubes have relatively larger surroundings, and more of them overlap.
  static constexpr double edges = 32;
  static constexpr int d = Complex::dimension;
  double longest = 0;
  for (int i = 0; i <= d; ++i)
    for (int j = 0; j < i; ++j)
      longest = (std::max)(longest, (p[i] - p[j]).squared_length());
  // Few sizes of cubes, because cubes of different sizes overlap.
  static constexpr int step = 2; // ratio of the sizes, as an exponent of 2
  const int base = std::ilogb(edge) + 1;
  const int above = (std::max)(0, std::ilogb(std::sqrt(longest)) - base);
  const int level = base + (above + step - 1) / step * step;
  std::uint64_t key = mixed(std::uint64_t(level)), parities = 0;
  for (int axis = 0; axis < d; ++axis) {
    double sum = 0;
    for (const auto& corner : p)
      sum += corner[axis];
    const double place = std::floor(std::ldexp(2 * sum / ((d + 1) * edges), -level));
    const auto number = std::uint64_t(std::int64_t(place));
    parities = 2 * parities + (number & 1);
    key = mixed(key ^ number);
  }
  return (std::max)(parities << (64 - d) | key >> d, Patch_key(1));
}

// The place of a change of topology in a patch. The change is one of the components of the patch;
// whether components of the complex changed is found later.
template <int d> struct Topology_place
{
  Patch_key patch;
  std::int32_t label;
  std::uint32_t pass;
  std::array<double, d> where;
};

// A patch as a complex of its own. A treatment changes this complex. Vertices on the cut do not
// move.
template <class Complex> struct Treated_patch
{
  using Part = typename Part_of<Complex>::Type;

  // A vertex before the treatment.
  struct Vertex
  {
    typename Part::Vertex_handle handle;
    const Piece_vertex<Complex::dimension>& data;
    bool is_core; // of an active cell of the cube
  };

  Part& part;
  std::vector<Vertex> vertices;
  std::vector<typename Part::Cell_handle> core; // active cells of the cube
  // Set by the treatment:
  Distributed_counts counts;
  std::vector<Topology_event<Part>> events;
  std::function<double(typename Part::Vertex_handle)> target_length; // of a new vertex
};
template <class Complex> using Patch_treatment = std::function<void(Treated_patch<Complex>&)>;

/*
A part of a distributed complex that a rank takes, improves as if it were a complex of its own, and
puts back: the cells around the active cells of a cube of space. The result depends on these cells
only. Vertices on the cut do not move.
*/
template <class Complex> class Patch
{
public:
  static constexpr int d = Complex::dimension;
  static constexpr int corners = d + 1;
  using Mesh = Distributed_mesh<Complex>;
  using Part = typename Part_of<Complex>::Type;
  using Vertex = Piece_vertex<d>;
  using Cell = Sent_cell<d>;
  using Cell_ids = std::array<Global_id, corners>;

  // A vertex of the patch. All cells around inner vertices are in the patch.
  struct Patch_vertex
  {
    Vertex data;
    std::uint64_t is_inner;
  };

  explicit Patch(Patch_key key) : m_key(key) {}

  Patch_key key() const { return m_key; }

  void add(const std::vector<Patch_vertex>& vertices, const std::vector<Cell>& cells) {
    m_before.insert(m_before.end(), vertices.begin(), vertices.end());
    m_cells_before.insert(m_cells_before.end(), cells.begin(), cells.end());
  }

  // Treats the patch. New vertices get ids that increase from `provisional`.
  // Appends the places of changes of topology in the pass `pass`. Returns the numbers of
  // operations.
  Distributed_counts run(const Mesh& mesh, const Patch_treatment<Complex>& treat,
                         std::uint32_t pass, std::vector<Topology_place<d>>& places) {
    sort_input();
    find_core(mesh.mean_interface_edge);
    Part part(mesh.traits, mesh.quality_measure);
    Treated_patch<Complex> treated = {part, {}, {}, {}, {}, {}};
    const std::vector<typename Part::Vertex_handle> vertices = build(mesh, part);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      treated.vertices.push_back(
          {vertices[i], m_before[m_originals[i]].data,
           m_before[m_originals[i]].is_inner && m_is_core_vertex[m_originals[i]]});
    const std::vector<typename Part::Cell_handle> cells = part.cells();
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (m_is_core[c])
        treated.core.push_back(cells[c]);
    part.update_components();
    for (std::size_t c = 0; c < cells.size(); ++c)
      m_components_before.emplace_back(cells[c]->component(), m_cells_before[c].data.component);
    treat(treated);
    if (treated.counts.relabeled > 0 || !treated.events.empty())
      m_components_before.clear(); // the part may have new numbers
    for (const auto& event : treated.events)
      places.push_back({m_key, event.label, pass, coordinates_of<d>(event.where)});
    take_result(treated);
    find_owners(mesh.rank());
    find_components();
    treated.counts.vanished += number_of_vanished();
    ++treated.counts.patches;
    return treated.counts;
  }

  // The number of new vertices.
  std::size_t number_of_new() const { return m_number_of_new; }

  // Gives the new vertices their ids, which increase from `first`.
  void number(Global_id first) {
    const auto renumber = [&](Global_id& id) {
      if (id >= provisional)
        id = id - provisional + first;
    };
    for (Vertex& v : m_after)
      renumber(v.id);
    // New ids are the largest ones and keep their order, so the orders of vertices and cells stay.
    for (Cell& c : m_cells_after)
      for (Global_id& id : c.vertices)
        renumber(id);
  }

  // Vertices and cells before and after, ordered by id and by vertices.
  const std::vector<Patch_vertex>& vertices_before() const { return m_before; }
  const Vertex& before(Global_id id) const { return place(m_before, id)->data; }
  const Vertex& after(Global_id id) const { return *place(m_after, id); }
  const std::vector<Cell>& cells_before() const { return m_cells_before; }
  const std::vector<Cell>& cells_after() const { return m_cells_after; }

private:
  static constexpr Global_id provisional = Global_id(1) << 63;
  static constexpr std::size_t none = std::size_t(-1); // no cell

  static Global_id id_of(const Vertex& v) { return v.id; }
  static Global_id id_of(const Patch_vertex& v) { return v.data.id; }

  template <class List> static void sort_by_id(List& list) {
    std::sort(list.begin(), list.end(),
              [](const auto& a, const auto& b) { return id_of(a) < id_of(b); });
  }

  // Returns the place of an id in an ordered list of vertices.
  template <class List> static auto place(List& list, Global_id id) {
    return std::lower_bound(list.begin(), list.end(), id,
                            [](const auto& v, Global_id key) { return id_of(v) < key; });
  }

  std::size_t index_before(Global_id id) const {
    return std::size_t(place(m_before, id) - m_before.begin());
  }

  void sort_input() {
    sort_by_id(m_before);
    m_before.erase(std::unique(m_before.begin(), m_before.end(),
                               [](const Patch_vertex& a, const Patch_vertex& b) {
                                 return a.data.id == b.data.id;
                               }),
                   m_before.end());
    std::sort(m_cells_before.begin(), m_cells_before.end(), less_vertices<d>);
  }

  // Finds the cells of the core and their vertices.
  void find_core(double edge) {
    m_is_core.assign(m_cells_before.size(), false);
    m_is_core_vertex.assign(m_before.size(), false);
    for (std::size_t c = 0; c < m_cells_before.size(); ++c) {
      if (!m_cells_before[c].data.is_active)
        continue;
      std::array<typename Complex::Point, corners> p;
      for (int i = 0; i < corners; ++i)
        p[i] = point_at<Complex>(m_before[index_before(m_cells_before[c].vertices[i])].data.point);
      if (patch_key<Complex>(p, edge) != m_key)
        continue;
      m_is_core[c] = true;
      for (Global_id id : m_cells_before[c].vertices)
        m_is_core_vertex[index_before(id)] = true;
    }
  }

  // Builds the part. Returns its vertices, where the first ones are those of `m_before`, and
  // further ones are copies of vertices at which the part touches itself.
  std::vector<typename Part::Vertex_handle> build(const Mesh& mesh, Part& part) {
    std::vector<std::array<std::size_t, corners>> cells(m_cells_before.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (int i = 0; i < corners; ++i)
        cells[c][i] = index_before(m_cells_before[c].vertices[i]);
    m_originals = separate_touching_cells(m_before.size(), cells);
    State<d> state;
    for (std::size_t original : m_originals) {
      const Patch_vertex& v = m_before[original];
      state.points.push_back(v.data.point);
      state.spacings.push_back(v.data.spacing);
      state.boundary_classes.push_back(
          v.is_inner
              ? v.data.boundary_class
              : std::uint8_t(v.data.boundary_class | Part_domain::cut | Boundary_class::fixed));
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Piece_cell_data& data = m_cells_before[c].data;
      state.cells.emplace_back();
      for (int i = 0; i < corners; ++i)
        state.cells.back()[i] = std::uint32_t(cells[c][i] + 1);
      state.cell_labels.push_back(data.label);
      state.noted_qualities.push_back(data.noted_quality);
      state.failures.push_back(data.failures);
    }
    state.mean_interface_edge = mesh.mean_interface_edge;
    state.minimum_interface_edge = mesh.minimum_interface_edge;
    const std::vector<typename Part::Vertex_handle> vertices = internal::assign_part(part, state);
    for (auto v : vertices)
      m_time_stamps.push_back(v->time_stamp());
    return vertices;
  }

  void take_result(const Treated_patch<Complex>& treated) {
    const Part& part = treated.part;
    const std::vector<typename Part::Vertex_handle> vertices = part.vertices();
    const Vertex_numbers numbers(part, vertices);
    std::vector<Global_id> ids;
    for (auto v : vertices) {
      const auto stamp =
          std::lower_bound(m_time_stamps.begin(), m_time_stamps.end(), v->time_stamp());
      Vertex data = {};
      if (stamp != m_time_stamps.end() && *stamp == v->time_stamp()) {
        const std::size_t i = std::size_t(stamp - m_time_stamps.begin());
        const Patch_vertex& before = m_before[m_originals[i]];
        ids.push_back(before.data.id);
        if (i >= m_before.size()) // a copy
          continue;
        data = before.data;
      } else {
        data.id = provisional + m_number_of_new++;
        data.owner = -1;
        data.boundary_class = v->boundary_class();
        if (treated.target_length)
          data.target_length = treated.target_length(v);
        ids.push_back(data.id);
      }
      data.point = coordinates_of<d>(part.position(v));
      // Other patches of the round can share a vertex on the cut, so its data stays.
      if (!is_cut(v)) {
        data.spacing = v->spacing();
        data.work += 1;
      }
      data.is_open =
          data.is_open && data.point != data.destination && (part.is_interface(v) || is_cut(v));
      m_after.push_back(data);
    }
    sort_by_id(m_after);
    for (auto c : part.cells()) {
      Cell cell = {};
      for (int i = 0; i < corners; ++i)
        cell.vertices[i] = ids[numbers(c->vertex(i))];
      cell.vertices = canonical_cell(cell.vertices);
      cell.data.label = c->subdomain_index();
      cell.data.noted_quality = c->noted_quality();
      cell.data.failures = c->failures();
      cell.data.component = c->component(); // of the part; replaced by find_components()
      m_cells_after.push_back(cell);
    }
    std::sort(m_cells_after.begin(), m_cells_after.end(), less_vertices<d>);
    match_cells();
    // Active cells of other patches stay active.
    for (std::size_t k = 0; k < m_cells_after.size(); ++k)
      if (const std::size_t c = m_old_of_new[k]; c != none)
        m_cells_after[k].data.is_active = m_cells_before[c].data.is_active && !m_is_core[c];
  }

  // Finds the cells that are there before and after. Both lists are sorted.
  void match_cells() {
    m_old_of_new.assign(m_cells_after.size(), none);
    std::size_t c = 0;
    for (std::size_t k = 0; k < m_cells_after.size(); ++k) {
      while (c < m_cells_before.size() && less_vertices(m_cells_before[c], m_cells_after[k]))
        ++c;
      if (c < m_cells_before.size() && m_cells_before[c].vertices == m_cells_after[k].vertices)
        m_old_of_new[k] = c;
    }
  }

  static bool is_cut(typename Part::Vertex_handle v) { return Part_domain::is_constrained(*v); }

  // Gives each new vertex the owner of a neighbor. New vertices have the largest ids.
  void find_owners(int rank) {
    for (const Cell& c : m_cells_after) {
      Cell_ids sorted = c.vertices;
      std::sort(sorted.begin(), sorted.end());
      const int first = sorted[0] >= provisional ? -1 : after(sorted[0]).owner;
      for (Global_id id : sorted)
        if (id >= provisional && after(id).owner < 0)
          place(m_after, id)->owner = first;
    }
    for (Vertex& v : m_after)
      if (v.owner < 0)
        v.owner = rank;
  }

  // Replaces the components of the part by those of the complex. An unchanged cell keeps its
  // component. Another cell gets the least component among the unchanged cells of its component
  // of the part. If there are none, it gets the component before the treatment, or 0 if that is
  // unknown.
  void find_components() {
    const auto unchanged = [&](std::size_t k) -> const Cell* {
      const std::size_t c = m_old_of_new[k];
      return c != none && m_cells_before[c].data.label == m_cells_after[k].data.label
                 ? &m_cells_before[c]
                 : nullptr;
    };
    std::vector<std::pair<Global_id, Global_id>> known; // of the part, of the complex
    for (std::size_t k = 0; k < m_cells_after.size(); ++k)
      if (const Cell* old = unchanged(k))
        known.emplace_back(m_cells_after[k].data.component, old->data.component);
    std::sort(known.begin(), known.end());
    std::sort(m_components_before.begin(), m_components_before.end());
    const auto component_in = [](const auto& pairs, Global_id of_part) {
      const auto it =
          std::lower_bound(pairs.begin(), pairs.end(), std::make_pair(of_part, Global_id(0)));
      return it != pairs.end() && it->first == of_part ? it->second : Global_id(0);
    };
    for (std::size_t k = 0; k < m_cells_after.size(); ++k) {
      Global_id& component = m_cells_after[k].data.component;
      const Global_id of_part = component;
      const Cell* const old = unchanged(k);
      component = old != nullptr ? old->data.component : component_in(known, of_part);
      if (component == 0)
        component = component_in(m_components_before, of_part);
    }
  }

  // Returns the number of vertices with an open destination that were removed or left the
  // interface.
  std::int64_t number_of_vanished() {
    std::int64_t result = 0;
    for (std::size_t i = 0; i < m_before.size(); ++i) {
      const Vertex& before = m_before[i].data;
      if (!before.is_open)
        continue;
      const auto it = place(m_after, before.id);
      const bool is_there = it != m_after.end() && it->id == before.id;
      result += !is_there || (!it->is_open && it->point != it->destination);
    }
    return result;
  }

  Patch_key m_key;
  std::vector<Patch_vertex> m_before;
  std::vector<Cell> m_cells_before, m_cells_after;
  std::vector<Vertex> m_after;
  std::vector<bool> m_is_core, m_is_core_vertex;
  std::vector<std::size_t> m_originals, m_time_stamps; // of the vertices of the part
  std::vector<std::size_t> m_old_of_new; // cell before, for each cell after; none for a new cell
  // of the part, of the complex; empty if the numbers of the part have changed
  std::vector<std::pair<Global_id, Global_id>> m_components_before;
  std::size_t m_number_of_new = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_PATCH_H

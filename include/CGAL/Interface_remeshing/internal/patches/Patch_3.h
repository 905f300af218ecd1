// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_PATCH_3_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_PATCH_3_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/star_union.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A set of finite cells of a complex. Operations can change a copy of the patch before it replaces
// the cells. The boundary of the patch and the interface inside it do not change.
template <class Complex> class Patch_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // The cells must stay in the complex during the lifetime of the patch.
  Patch_3(const Complex& complex, const std::vector<Cell_handle>& cells) {
    add_by_components(complex, cells);
    m_origins = vertices_of(complex, m_replaced);
    const Vertex_numbers numbers(complex, m_origins);
    for (Vertex_handle v : m_origins)
      m_points.push_back(v->point());
    for (Cell_handle c : m_replaced)
      m_tetrahedra.push_back(corners_of(c, numbers));
  }

  // Makes `copy` a complex of the patch alone, with a separate label for each connected component
  // of equal label. Returns whether the patch is a ball; there is no copy otherwise.
  bool copy_to(Complex& copy) {
    try {
      m_copied = copy.assign(m_points, m_tetrahedra, m_components);
    } catch (const Invalid_cells_error&) {
      return false;
    }
    m_time_stamps.clear();
    for (Vertex_handle v : m_copied) {
      m_time_stamps.push_back(v->time_stamp());
      if (copy.is_boundary(v))
        v->set_boundary_class(Boundary_class::fixed);
    }
    return true;
  }

  // Replaces the content of the patch by the modified copy.
  void take(const Complex& copy) {
    std::vector<Vertex_handle> vertices, origins;
    for (std::size_t i = 0; i < m_copied.size(); ++i)
      if (copy.is_alive(m_copied[i], m_time_stamps[i])) {
        vertices.push_back(m_copied[i]);
        origins.push_back(m_origins[i]);
      }
    Vertex_numbers numbers(copy, vertices);
    for (Vertex_handle v : copy.vertices())
      numbers.add(v, vertices);
    origins.resize(vertices.size()); // null for new vertices
    m_origins = std::move(origins);
    m_points.clear();
    for (Vertex_handle v : vertices)
      m_points.push_back(v->point());
    m_tetrahedra.clear();
    m_components.clear();
    for (Cell_handle c : copy.cells()) {
      m_tetrahedra.push_back(corners_of(c, numbers));
      m_components.push_back(c->label());
    }
  }

  // Plans the replacement of the cells by the patch.
  void propose(Cavity<Complex>& cavity) const {
    cavity.begin(Proposal_kind::replacement);
    for (Cell_handle c : m_replaced)
      cavity.remove(c);
    std::vector<typename Cavity<Complex>::Index> indices;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      indices.push_back(m_origins[i] == Vertex_handle()
                            ? cavity.add(m_points[i], Boundary_class::inside)
                            : cavity.add(m_origins[i], m_points[i]));
    for (std::size_t t = 0; t < m_tetrahedra.size(); ++t) {
      const auto& v = m_tetrahedra[t];
      cavity.create({indices[v[0]], indices[v[1]], indices[v[2]], indices[v[3]]},
                    m_parents[m_components[t]]);
    }
  }

private:
  using Indices = std::array<std::size_t, 4>;

  static Indices corners_of(Cell_handle c, const Vertex_numbers& numbers) {
    const auto index = [&](int i) { return std::size_t(numbers(c->vertex(i))); };
    return {index(0), index(1), index(2), index(3)};
  }

  // Adds the cells, component by component. A component is a set of cells of one label that are
  // connected through facets. The first cell of a component becomes the parent of the new cells.
  void add_by_components(const Complex& complex, const std::vector<Cell_handle>& cells) {
    Marks unseen = cell_marks(complex);
    for (Cell_handle c : cells)
      unseen.add(c);
    for (Cell_handle seed : cells) {
      if (!unseen.has(seed))
        continue;
      const auto add = [&](Cell_handle c) {
        unseen.remove(c);
        m_replaced.push_back(c);
        m_components.push_back(typename Complex::Label(m_parents.size()));
      };
      std::size_t next = m_replaced.size();
      for (add(seed); next < m_replaced.size(); ++next)
        for (int i = 0; i < 4; ++i) {
          const Cell_handle n = m_replaced[next]->neighbor(i);
          if (unseen.has(n) && n->label() == seed->label())
            add(n);
        }
      m_parents.push_back(seed);
    }
  }

  std::vector<Cell_handle> m_replaced, m_parents;
  std::vector<Vertex_handle> m_origins; // origin of each vertex; null for a new vertex
  std::vector<typename Complex::Point_3> m_points;
  std::vector<Indices> m_tetrahedra;
  std::vector<typename Complex::Label> m_components; // component of each tetrahedron
  std::vector<Vertex_handle> m_copied;               // vertices of the last copy
  std::vector<std::size_t> m_time_stamps;            // time stamps of `m_copied`
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_PATCH_3_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_REMOVE_POINTS_ON_TRIANGLES_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_REMOVE_POINTS_ON_TRIANGLES_3_H

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Proposes to collapse an edge of the interface at a vertex, so that the interface keeps its shape
// up to rounding.
template <class Complex>
bool propose_removal_on_triangle(const Complex& dsc, typename Complex::Vertex_handle v,
                                 Cavity<Complex>& cavity) {
  static constexpr double rounding = 1e-9; // swept volume relative to the edges at the vertex
  std::vector<typename Complex::Cell_handle> star;
  dsc.star(v, star);
  const double length = dsc.interface_edge_length(v);
  std::vector<typename Complex::Vertex_handle> tried;
  for (auto c : star)
    for (int i = 0; i < Complex::corners; ++i) {
      const auto w = c->vertex(i);
      if (w == v || dsc.is_infinite(w) || !w->is_interface() ||
          std::find(tried.begin(), tried.end(), w) != tried.end())
        continue;
      tried.push_back(w);
      if (volume_swept_by_collapse(dsc, v, w) <= rounding * length * length * length &&
          propose_edge_collapse(dsc, c, c->index(v), i, 0, cavity))
        return true;
    }
  return false;
}

// Removes vertices that a tetrahedralizer added on triangles of the interface, where this is
// possible. Linear in the number of added vertices for each round; few rounds suffice.
// \param number the number of points that were not added
// \param handles the vertices of the points of the mesh
template <class Complex>
void remove_points_on_triangles(Complex& dsc, const Tetrahedralization_3& mesh, std::size_t number,
                                const std::vector<typename Complex::Vertex_handle>& handles) {
  std::set<std::size_t> added;
  for (const auto& facet : mesh.facets)
    std::copy_if(facet.begin(), facet.end(), std::inserter(added, added.end()),
                 [&](std::size_t i) { return i >= number; });
  std::vector<typename Complex::Vertex_handle> vertices;
  for (const std::size_t i : added)
    vertices.push_back(handles[i]);
  Cavity<Complex> cavity(dsc);
  Deformation_visitor<Complex> visitor;
  Improvement_report report;
  for (std::size_t before = 0; before != vertices.size();) {
    before = vertices.size();
    const auto is_removed = [&](auto v) {
      if (!v->is_interface() || !propose_removal_on_triangle(dsc, v, cavity))
        return false;
      commit_proposal(dsc, cavity, visitor, report);
      return true;
    };
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), is_removed), vertices.end());
  }
  if (report.collapsed > 0)
    dsc.measure_interface_edges();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_REMOVE_POINTS_ON_TRIANGLES_3_H

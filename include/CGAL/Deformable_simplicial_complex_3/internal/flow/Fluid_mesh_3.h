// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_FLUID_MESH_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_FLUID_MESH_3_H

#include <CGAL/Deformable_simplicial_complex_3/Fluid_properties_3.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

using Vectors_3 = std::vector<Eigen::Vector3d>;

template <class Point> Eigen::Vector3d eigen_vector(const Point& p) { return {p[0], p[1], p[2]}; }

// The liquid part of a complex, numbered: vertices carry velocities; each of them carries a
// pressure for each liquid around it, as pressures jump where liquids meet.
template <class Complex> struct Fluid_mesh_3
{
  using Vertex_handle = typename Complex::Vertex_handle;
  using Index = std::uint32_t;

  struct Cell
  {
    std::array<Index, 4> vertices;
    std::array<Index, 4> pressures;
    const Liquid* liquid;
    std::uint32_t component;
  };

  // Of the interface, with liquid on a side at least.
  struct Facet
  {
    std::array<Index, 3> vertices; // counterclockwise seen from the front
    double tension;                // energy of a unit of area
    bool is_free;                  // between liquid and void
  };

  std::vector<Vertex_handle> vertices; // by time stamp
  std::vector<Cell> cells;             // by time stamp
  std::vector<Facet> facets;           // in the order of interface_facets()
  std::vector<Index> vertex_of_pressure;
  std::vector<char> is_on_interface; // by vertex
  // Where the sides of the domain are, in the order of `Boundary_class`, if it is a box; not finite
  // otherwise.
  std::array<double, 6> sides;

  // n log n. \pre components are up to date
  Fluid_mesh_3(const Complex& complex, const Fluid_properties_3& properties) {
    const auto all_vertices = complex.vertices();
    const auto all_cells = complex.cells();
    static constexpr Index none = Index(-1);
    sides.fill(std::numeric_limits<double>::infinity());
    for (Vertex_handle v : all_vertices) {
      v->set_scratch_index(none);
      for (std::size_t side = 0; side < sides.size(); ++side)
        if (v->boundary_class() >> side & 1)
          sides[side] = complex.position(v)[int(side / 2)];
    }
    for (auto c : all_cells)
      if (properties.liquid(c->label()))
        for (int i = 0; i < 4; ++i)
          c->vertex(i)->set_scratch_index(0);
    for (Vertex_handle v : all_vertices)
      if (v->scratch_index() != none) {
        v->set_scratch_index(Index(vertices.size()));
        vertices.push_back(v);
        is_on_interface.push_back(v->is_interface());
      }
    add_cells(all_cells, properties);
    for (const auto& f : complex.interface_facets()) {
      const int behind = f.first->label(), in_front = f.first->neighbor(f.second)->label();
      const bool is_behind = properties.liquid(behind), is_in_front = properties.liquid(in_front);
      if (!is_behind && !is_in_front)
        continue;
      Facet facet{{}, properties.surface_tension(behind, in_front), is_behind != is_in_front};
      const auto corners = complex.facet_vertices(f);
      for (std::size_t i = 0; i < 3; ++i)
        facet.vertices[i] = corners[i]->scratch_index();
      facets.push_back(facet);
    }
  }

  Vectors_3 positions(const Complex& complex) const {
    Vectors_3 result;
    for (Vertex_handle v : vertices)
      result.push_back(eigen_vector(complex.position(v)));
    return result;
  }

  // The mass of a cell is that of its middle, which goes with the mean of its corners, for this
  // part, and of its corners for the rest: 0.8 is that of linear elements, which makes short waves
  // too fast, 0 makes them too slow (G. L. Goudreau and R. L. Taylor, "Evaluation of numerical
  // integration methods in elastodynamics", 1973). The part by which waves as long as eight edges
  // are least off, on regular meshes.
  static constexpr double part_at_middle = .7;

  // Of a cell, the mean of its corners.
  Eigen::Vector3d middle(std::size_t cell, const Vectors_3& vectors) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (Index v : cells[cell].vertices)
      result += vectors[v] / 4;
    return result;
  }

  // Velocities, or accelerations, without what would leave the sides of the domain.
  void keep_on_sides(Vectors_3& vectors) const {
    for (std::size_t v = 0; v < vectors.size(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (Boundary_class::fixes(vertices[v]->boundary_class(), axis))
          vectors[v][axis] = 0;
  }

private:
  template <class Cells> void add_cells(const Cells& all, const Fluid_properties_3& properties) {
    std::map<int, std::vector<Index>> pressures; // by label and vertex, plus one
    for (auto c : all) {
      const Liquid* liquid = properties.liquid(c->label());
      if (!liquid)
        continue;
      std::vector<Index>& of_label = pressures[c->label()];
      of_label.resize(vertices.size(), 0);
      Cell cell{{}, {}, liquid, c->component()};
      for (std::size_t i = 0; i < 4; ++i) {
        const Index v = cell.vertices[i] = c->vertex(int(i))->scratch_index();
        if (of_label[v] == 0) {
          vertex_of_pressure.push_back(v);
          of_label[v] = Index(vertex_of_pressure.size());
        }
        cell.pressures[i] = of_label[v] - 1;
      }
      cells.push_back(cell);
    }
  }
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_FLUID_MESH_3_H

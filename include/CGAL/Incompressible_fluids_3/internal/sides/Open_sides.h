// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_OPEN_SIDES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_OPEN_SIDES_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Incompressible_fluids_3/Side_behavior.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Mesh_support/Error.h>

#include <limits>
#include <string>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the outward normal of a side of the domain.
inline Eigen::Vector3d normal_of_side(std::size_t side) {
  return (side % 2 == 0 ? -1. : 1.) * Eigen::Vector3d::Unit(Eigen::Index(side / 2));
}

// Calls `f(cell, corner, side)` for each facet of a cell of a liquid on a side of the domain. The
// facet is opposite to the corner.
template <class Mesh, class Function>
void for_each_side_facet(const Mesh& mesh, const Function& f) {
  for (std::size_t k = 0; k < mesh.cells.size(); ++k)
    for (std::size_t corner = 0; corner < Mesh::corners; ++corner) {
      unsigned sides = ~unsigned(Boundary_class::fixed);
      for (std::size_t i = 0; i < Mesh::corners; ++i)
        if (i != corner)
          sides &= mesh.vertices[mesh.cells[k].vertices[i]]->boundary_class();
      for (std::size_t side = 0; sides != 0 && side < 6; ++side)
        if (sides >> side & 1)
          f(k, corner, side);
    }
}

// The open parts of the sides of the domain: the vertices at which liquid passes with a velocity
// that the equations determine, and the pressures outside.
class Open_sides
{
public:
  // Constructs the object without an open side.
  Open_sides() = default;

  // Finds the open vertices at a time, with the vertices at given positions.
  // \throws Error if a pressure is not finite
  template <class Mesh>
  Open_sides(const Mesh& mesh, const Side_behaviors& behaviors, const Vectors_3& positions,
             double time) {
    for (std::size_t side = 0; side < behaviors.size(); ++side) {
      if (!behaviors[side].pressure)
        continue;
      m_sides.resize(positions.size(), Boundary_class::inside);
      m_pressures[side].resize(positions.size());
      for (std::size_t v = 0; v < positions.size(); ++v) {
        if (!(mesh.vertices[v]->boundary_class() >> side & 1))
          continue;
        const Eigen::Vector3d& p = positions[v];
        const auto pressure = behaviors[side].pressure({p.x(), p.y(), p.z()}, time);
        if (!pressure)
          continue;
        if (!std::isfinite(*pressure))
          throw Error("the pressure outside of a side is not finite: return finite numbers");
        m_pressures[side][v] = pressure;
        m_sides[v] = Boundary_class::Bits(m_sides[v] | 1u << side);
      }
    }
  }

  // Returns whether no side has a function for the pressure.
  bool empty() const { return m_sides.empty(); }

  // Returns the open sides on which a vertex lies, as bits.
  Boundary_class::Bits sides(std::size_t v) const {
    return m_sides.empty() ? Boundary_class::inside : m_sides[v];
  }

  // Returns the forces of the pressures outside on vertices, with the vertices at given positions.
  // The pressure is linear in each facet. At a corner of the facet that is not open, it is the mean
  // of the pressures at the open corners. Walls bear the forces on these corners.
  template <class Mesh> Eigen::VectorXd forces(const Mesh& mesh, const Vectors_3& positions) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(3 * Eigen::Index(positions.size()));
    if (empty())
      return result;
    // The integral of the product of two basis functions over a facet is its area, divided by this
    // number, and twice as large if the functions are the same.
    static constexpr int products = Mesh::dimension * (Mesh::dimension + 1);
    for_each_side_facet(mesh, [&](std::size_t k, std::size_t corner, std::size_t side) {
      std::array<typename Mesh::Index, std::size_t(Mesh::dimension)> facet;
      for (std::size_t i = 0, n = 0; i < Mesh::corners; ++i)
        if (i != corner)
          facet[n++] = mesh.cells[k].vertices[i];
      double sum = 0;
      int open = 0;
      const auto& pressures = m_pressures[side];
      for (std::size_t v : facet)
        if (!pressures.empty() && pressures[v]) {
          sum += *pressures[v];
          ++open;
        }
      if (open == 0)
        return;
      const double mean = sum / open, whole = sum + (Mesh::dimension - open) * mean;
      const Eigen::Vector3d area =
          area_vector(mesh.corners_at(facet, positions)).norm() / products * normal_of_side(side);
      for (std::size_t v : facet)
        if (pressures[v])
          result.segment<3>(3 * Eigen::Index(v)) -= (whole + *pressures[v]) * area;
    });
    return result;
  }

  // Returns the forces of the surfaces beyond the open sides on the vertices where surfaces end. A
  // surface continues the facet at the side, with its tension. So the forces along a flat surface
  // are balanced. `tension_of(facet)` returns the energy of a unit of area of a facet.
  template <class Mesh, class Tension_of>
  Eigen::VectorXd forces_of_surfaces(const Mesh& mesh, const Vectors_3& positions,
                                     const Tension_of& tension_of) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(3 * Eigen::Index(positions.size()));
    static constexpr std::size_t n = Mesh::dimension;
    for (std::size_t f = 0; f < mesh.facets.size() && !empty(); ++f)
      for (std::size_t i = 0; i < n; ++i) {
        const auto& vertices = mesh.facets[f].vertices;
        unsigned common = ~0u; // open sides of the edge opposite to corner i, in the plane a vertex
        for (std::size_t k = 1; k < n; ++k)
          common &= sides(vertices[(i + k) % n]);
        if ((common & ~unsigned(mesh.vertices[vertices[i]]->boundary_class())) == 0)
          continue;
        const auto corners = mesh.corners_at(vertices, positions);
        const Eigen::Vector3d edge = corners[(i + n - 1) % n] - corners[(i + 1) % n];
        Eigen::Vector3d outward = corners[(i + 1) % n] - corners[i];
        double length = 1;
        if (n == 3) {
          length = edge.norm();
          outward -= outward.dot(edge) / edge.squaredNorm() * edge;
        }
        const Eigen::Vector3d share = tension_of(f) * length / double(n - 1) * outward.normalized();
        for (std::size_t k = 1; k < n && share.allFinite(); ++k)
          result.segment<3>(3 * Eigen::Index(vertices[(i + k) % n])) += share;
      }
    return result;
  }

private:
  std::vector<Boundary_class::Bits> m_sides;                     // by vertex
  std::array<std::vector<std::optional<double>>, 6> m_pressures; // by side and vertex
};

// Returns whether liquid may pass through a side.
inline bool have_openings(const Side_behaviors& behaviors) {
  return std::any_of(behaviors.begin(), behaviors.end(),
                     [](const Side_behavior& side) { return side.inflow || side.pressure; });
}

// Returns a mask for boundary classes. It clears the sides through which liquid may pass.
inline Boundary_class::Bits sides_without_openings(const Side_behaviors& behaviors) {
  unsigned result = (std::numeric_limits<Boundary_class::Bits>::max)();
  for (std::size_t side = 0; side < behaviors.size(); ++side)
    if (behaviors[side].inflow || behaviors[side].pressure)
      result &= ~(1u << side);
  return Boundary_class::Bits(result);
}

// Throws an exception if liquid cannot pass through an inlet or an open part of a side at a time,
// because the part contains points of the surface of the liquid but no vertex. Parts smaller than
// a tenth of an edge may remain undetected.
// \throws Error if there is such a part
template <class Mesh>
void require_vertices_in_openings(const Mesh& mesh, const Side_behaviors& behaviors,
                                  const Vectors_3& positions, double time) {
  static constexpr int parts = 10; // of an edge
  std::array<bool, 6> has_vertex = {}, has_point = {};
  const auto is_in = [&](std::size_t side, const Eigen::Vector3d& p) {
    const std::array<double, 3> at = {p.x(), p.y(), p.z()};
    return (behaviors[side].inflow && behaviors[side].inflow(at, time)) ||
           (behaviors[side].pressure && behaviors[side].pressure(at, time));
  };
  for (std::size_t side = 0; side < behaviors.size(); ++side) {
    if (!behaviors[side].inflow && !behaviors[side].pressure)
      continue;
    for (std::size_t v = 0; v < mesh.number_of_vertices() && !has_vertex[side]; ++v)
      has_vertex[side] =
          (mesh.vertices[v]->boundary_class() >> side & 1) != 0 && is_in(side, positions[v]);
  }
  for_each_side_facet(mesh, [&](std::size_t k, std::size_t corner, std::size_t side) {
    if (has_vertex[side] || has_point[side])
      return;
    std::array<Eigen::Vector3d, Mesh::dimension> corners;
    for (std::size_t i = 0, n = 0; i < Mesh::corners; ++i)
      if (i != corner)
        corners[n++] = positions[mesh.cells[k].vertices[i]];
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; j <= (Mesh::dimension == 3 ? parts - i : 0); ++j)
        has_point[side] = has_point[side] ||
                          is_in(side, corners[0] + double(i) / parts * (corners[1] - corners[0]) +
                                          double(j) / parts * (corners.back() - corners[0]));
  });
  for (std::size_t side = 0; side < behaviors.size(); ++side)
    if (has_point[side])
      throw Error("the opening in the side of " +
                  std::string(side % 2 == 0 ? "smallest " : "largest ") + "xyz"[side / 2] +
                  " contains no vertex of a liquid: use shorter edges or a larger opening");
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_OPEN_SIDES_H

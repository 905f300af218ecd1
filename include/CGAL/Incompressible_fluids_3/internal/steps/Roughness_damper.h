// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_ROUGHNESS_DAMPER_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_ROUGHNESS_DAMPER_H

#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

#include <Eigen/Dense>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
Damping of motions that no mesh resolves: single vertices that drift among their neighbors, in
particular along a surface, where only viscosity resists them. Neighbors exchange momentum. The
exchange depends on the part of their velocity difference that the mean velocity gradients at both
vertices do not explain. It is zero for linear velocities and small for smooth velocities.
Linear momentum is preserved. A. Jameson, W. Schmidt and E. Turkel, AIAA Paper 81-1259, use a
similar damping on grids.
*/
template <class Mesh> class Roughness_damper
{
public:
  // `positions` are the positions of vertices at the end of the step.
  Roughness_damper(const Mesh& mesh, const Vectors_3& positions) : m_mesh(mesh) {
    std::vector<double> tensions(positions.size(), 0);
    for (const auto& facet : mesh.facets)
      for (auto v : facet.vertices)
        tensions[v] = (std::max)(tensions[v], facet.tension);
    for (const auto& slip : mesh.slips)
      tensions[slip.second] = tensions[slip.first];
    for (const auto& cell : mesh.cells) {
      Part part;
      const auto corners = mesh.corners_at(cell.vertices, positions);
      part.edges.setIdentity(); // in the plane, the last column is the normal
      for (int i = 0; i < Mesh::dimension; ++i)
        part.edges.col(i) = corners[std::size_t(i) + 1] - corners[0];
      // The destinations can invert the cell, because they are not yet those of the mesh.
      part.volume = (std::max)(0., part.edges.determinant() / factorial);
      part.tension = 0;
      for (auto v : cell.vertices)
        part.tension = (std::max)(part.tension, tensions[v]);
      m_parts.push_back(part);
    }
  }

  // Returns the velocities after damping for a time. `masses` are the masses of vertices.
  Vectors_3 damped(const Vectors_3& velocities, const std::vector<double>& masses,
                   double time) const {
    const std::vector<Eigen::Matrix3d> gradients = mean_gradients(velocities);
    Vectors_3 momenta(velocities.size(), Eigen::Vector3d::Zero());
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
      const auto& cell = m_mesh.cells[k];
      const Part& part = m_parts[k];
      for (std::size_t i = 0; i < Mesh::corners; ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const auto v = cell.vertices[i], w = cell.vertices[j];
          const Eigen::Vector3d edge = part.corner(j) - part.corner(i);
          const Eigen::Vector3d excess =
              velocities[w] - velocities[v] -
              (gradients[cell.pressures[i]] + gradients[cell.pressures[j]]) / 2 * edge;
          // Each edge has a share of the mass of the cell, so that the edges at a vertex together
          // have the mass of the vertex.
          const Eigen::Vector3d exchanged =
              exchange(excess.norm(), edge.norm(), part.tension, cell.liquid->density, time) *
              cell.liquid->density * part.volume / (Mesh::dimension * Mesh::corners) * excess;
          momenta[v] += exchanged;
          momenta[w] -= exchanged;
        }
    }
    Vectors_3 result = velocities;
    for (std::size_t v = 0; v < velocities.size(); ++v)
      result[v] += momenta[v] / masses[v];
    return result;
  }

private:
  static constexpr int factorial = Mesh::dimension == 2 ? 2 : 6; // of the dimension

  struct Part
  {
    Eigen::Matrix3d edges; // from the first vertex
    double volume, tension;

    Eigen::Vector3d corner(std::size_t i) const {
      return i == 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                    : Eigen::Vector3d(edges.col(Eigen::Index(i) - 1));
    }
  };

  // Returns the part of an excess velocity that neighbors exchange in a time. The rate depends on
  // the time that a vertex takes to cross an edge, and on the period of a wave with the length of
  // an edge.
  static double exchange(double excess, double edge, double tension, double density, double time) {
    static constexpr double times = .25, most = .5; // with a larger part, vertices would overshoot
    const double rate = excess / edge + std::sqrt(tension / (density * edge * edge * edge));
    return most * (1 - std::exp(-times / most * rate * time));
  }

  // Returns the mean velocity gradient around each pressure. Gradients can be discontinuous between
  // liquids.
  std::vector<Eigen::Matrix3d> mean_gradients(const Vectors_3& velocities) const {
    std::vector<Eigen::Matrix3d> result(m_mesh.vertex_of_pressure.size(), Eigen::Matrix3d::Zero());
    std::vector<double> volumes(result.size(), 0);
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
      const auto& v = m_mesh.cells[k].vertices;
      Eigen::Matrix3d differences = Eigen::Matrix3d::Zero();
      for (int i = 0; i < Mesh::dimension; ++i)
        differences.col(i) = velocities[v[std::size_t(i) + 1]] - velocities[v[0]];
      // The adjugate is also finite if the volume is about 0.
      const Eigen::Matrix3d& e = m_parts[k].edges;
      Eigen::Matrix3d adjugate;
      adjugate.row(0) = e.col(1).cross(e.col(2));
      adjugate.row(1) = e.col(2).cross(e.col(0));
      adjugate.row(2) = e.col(0).cross(e.col(1));
      for (auto p : m_mesh.cells[k].pressures) {
        result[p] += differences * adjugate / factorial;
        volumes[p] += m_parts[k].volume;
      }
    }
    // Flat cells on a wall do not determine a gradient.
    for (std::size_t p = 0; p < result.size(); ++p)
      if (volumes[p] > 0)
        result[p] /= volumes[p];
      else
        result[p].setZero();
    return result;
  }

  const Mesh& m_mesh;
  std::vector<Part> m_parts; // by cell
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_ROUGHNESS_DAMPER_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FIELD_DIFFUSION_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FIELD_DIFFUSION_H

#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>

#include <Eigen/IterativeLinearSolvers>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
A step of length dt of the diffusion of a field c in liquids at rest, by linear finite elements and
the backward Euler method:

   (M + dt K) d = -dt K c

The field at the end is c + d. M is the diagonal matrix of the volumes of vertices (lumped masses).
K is the stiffness matrix, weighted by the diffusivity of each liquid. The columns of K have the sum
0, so the step preserves the integral of the field. A boundary without given values is insulated.

Where no cell has an obtuse dihedral angle, in the plane where the triangulation is Delaunay in each
liquid, K has no positive entry off the diagonal. Then no value at the end exceeds all values at the
beginning and the given ones (maximum principle). Cells that are too flat to have gradients conduct
nothing.
*/
template <class Complex> class Field_diffusion
{
public:
  using Mesh = Fluid_mesh<Complex>;

  Field_diffusion(const Mesh& mesh, const Vectors_3& positions, double dt)
      : m_mesh(mesh), m_masses(Vector::Zero(Eigen::Index(mesh.number_of_vertices()))) {
    for (const auto& cell : mesh.cells) {
      const auto corners = mesh.corners_at(cell.vertices, positions);
      const auto element = cell_element<Complex>(corners);
      const bool conducts = has_gradients<Complex>(element, corners);
      for (int i = 0; i < Mesh::corners; ++i) {
        m_masses(row(cell, i)) += element.lumped_mass();
        for (int j = 0; j < i && conducts; ++j)
          m_links.push_back({row(cell, i), row(cell, j),
                             -dt * cell.liquid->diffusivity * element.stiffness(i, j)});
      }
    }
  }

  // Changes a field, which is given by first occurrence of vertices, to the field at the end.
  // Vertices with `is_given[v]` keep their values.
  // \throws Convergence_error if the solver does not find the solution
  void diffuse(std::vector<double>& field, const std::vector<char>& is_given) const {
    // The error of the integral is not larger than the residual, so it is a rounding error.
    static constexpr double tolerance = 1e-14;
    Vector changes = Vector::Zero(m_masses.size()), diagonal = m_masses;
    std::vector<Eigen::Triplet<double>> entries;
    for (const Link& link : m_links) {
      const double gain =
          link.conductance * (field[std::size_t(link.j)] - field[std::size_t(link.i)]);
      for (const auto& [i, j, sign] :
           {std::make_tuple(link.i, link.j, 1), std::make_tuple(link.j, link.i, -1)}) {
        if (is_given[std::size_t(i)])
          continue;
        changes(i) += sign * gain;
        diagonal(i) += link.conductance;
        if (!is_given[std::size_t(j)])
          entries.emplace_back(i, j, -link.conductance);
      }
    }
    for (Eigen::Index i = 0; i < diagonal.size(); ++i)
      entries.emplace_back(i, i, diagonal(i));
    Eigen::SparseMatrix<double> matrix(diagonal.size(), diagonal.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(tolerance);
    const Vector solution = solver.compute(matrix).solve(changes);
    if (solver.info() != Eigen::Success || !solution.allFinite())
      throw Convergence_error("the equations of the diffusion of the field are not solved "
                              "accurately: cells may be too flat, or values too large",
                              solver.error(), tolerance);
    for (std::size_t v = 0; v < field.size(); ++v)
      field[v] += solution(Eigen::Index(v));
  }

private:
  using Vector = Eigen::VectorXd;

  // An edge of a cell. The vertex i gains the conductance times the difference of the field at j
  // and at i, and the vertex j loses this amount.
  struct Link
  {
    Eigen::Index i, j;
    double conductance;
  };

  Eigen::Index row(const typename Mesh::Cell& cell, int corner) const {
    return Eigen::Index(m_mesh.first(cell.vertices[std::size_t(corner)]));
  }

  const Mesh& m_mesh;
  Vector m_masses; // by first occurrence
  std::vector<Link> m_links;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FIELD_DIFFUSION_H

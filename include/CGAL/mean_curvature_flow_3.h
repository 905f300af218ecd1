// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MEAN_CURVATURE_FLOW_3_H
#define CGAL_MEAN_CURVATURE_FLOW_3_H

#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/geometry/cotangent_weights_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/interface_triangles_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/label_volumes_3.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Mean curvature flow, step by explicit step (section 4.1.2 of the paper): the velocity of a vertex is
the negative gradient of the area of the whole interface, by the cotangent formula, divided by the
mixed Voronoi area of the vertex. Its length is that of the sum of the principal curvatures. Where
several labels meet, all walls pull with the same force, so that they come to meet in angles of 120
degrees.

Stable only for steps of time below about half the area of the smallest triangles;
`Mean_curvature_flow_3` is free of that.

\cgalModels `InterfaceVelocity_3`
*/
struct Mean_curvature_velocity_3
{
  /// computes the velocities of vertices at positions, as `InterfaceVelocity_3` says. Linear in the
  /// size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot_3<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point_3>& positions, double /*t*/,
                  std::vector<typename Complex::Approximate_vector_3>& velocities) const {
    namespace internal = Deformable_simplicial_complexes::internal;
    using Vector = typename Complex::Approximate_vector_3;
    velocities.assign(positions.size(), Vector(0, 0, 0));
    std::vector<double> areas(positions.size(), 0);
    for (const auto& triangle : interface_.triangles) {
      const auto& v = triangle.vertices;
      const internal::Cotangent_weights_3 weights(internal::corners(triangle, positions));
      for (int i = 0; i < 3; ++i) {
        const std::size_t a = v[(i + 1) % 3], b = v[(i + 2) % 3];
        const Vector pull = weights.halved_cotangents[i] * (positions[b] - positions[a]);
        velocities[a] = velocities[a] + pull;
        velocities[b] = velocities[b] - pull;
        areas[v[i]] += weights.mixed_areas[i];
      }
    }
    for (std::size_t i = 0; i < velocities.size(); ++i)
      velocities[i] = areas[i] > 0 ? velocities[i] / areas[i] : Vector(0, 0, 0);
  }
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Mean curvature flow, semi-implicitly: the same forces as of `Mean_curvature_velocity_3`, but taken
where a step ends, with the weights of where it begins (M. Desbrun, M. Meyer, P. Schröder,
A. H. Barr, *Implicit fairing of irregular meshes using diffusion and curvature flow*, SIGGRAPH
1999). One such step and two of half the length are extrapolated. Stable for steps of any length, of
the second order in it.

\cgalModels `InterfaceStep_3`
*/
class Mean_curvature_flow_3
{
public:
  /// \param preserves_volumes whether every label keeps its volume, up to rounding for labels that
  /// do not reach the boundary of the domain. Each label then has the pressure that it takes, so
  /// that what is in equilibrium, such as a cluster of soap bubbles, stays where it is. Steps must
  /// then be shorter than the time in which a label would vanish without it.
  explicit Mean_curvature_flow_3(bool preserves_volumes = false)
      : m_preserves_volumes(preserves_volumes) {}

  /// computes where vertices go, as `InterfaceStep_3` says. Three sparse Cholesky factorizations,
  /// more where the interface ends on sides of the domain: about n log n in the size of the
  /// interface. Volumes take time in proportion to its size times the number of labels, and memory
  /// for each vertex and each label on the connected part of the interface that the vertex is on.
  /// \throws Deformable_simplicial_complexes::Error if dt is negative, or all facets of a vertex
  /// are without area.
  template <class Complex>
  void operator()(const Interface_snapshot_3<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point_3>& positions, double /*t*/,
                  double dt,
                  std::vector<typename Complex::Approximate_point_3>& destinations) const {
    if (!(dt >= 0))
      throw Deformable_simplicial_complexes::Error(
          "mean curvature flow cannot go back in time: use a time step of 0 or more");
    const auto whole = implicit_step(interface_, positions, dt);
    const auto half = implicit_step(interface_, positions, dt / 2);
    destinations = implicit_step(interface_, half, dt / 2);
    for (std::size_t i = 0; i < destinations.size(); ++i)
      destinations[i] = destinations[i] + (destinations[i] - whole[i]);
    if (m_preserves_volumes) {
      const Deformable_simplicial_complexes::internal::Volume_changer_3<Complex> changer(
          interface_);
      changer.change_by(changer.changes(destinations, positions), destinations);
    }
  }

private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  // One step of backward Euler with the weights of its beginning. Vertices on sides of the domain
  // stay on them.
  template <class Complex>
  std::vector<typename Complex::Approximate_point_3>
  implicit_step(const Interface_snapshot_3<Complex>& interface_,
                const std::vector<typename Complex::Approximate_point_3>& positions,
                double dt) const {
    namespace internal = Deformable_simplicial_complexes::internal;
    using Vector = typename Complex::Approximate_vector_3;
    const Eigen::Index n = Eigen::Index(positions.size());
    Entries stiffness; // its lower triangle
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(n);
    for (const auto& triangle : interface_.triangles) {
      const auto& v = triangle.vertices;
      const internal::Cotangent_weights_3 weights(internal::corners(triangle, positions));
      for (int i = 0; i < 3; ++i) {
        const auto a = Eigen::Index(v[(i + 1) % 3]), b = Eigen::Index(v[(i + 2) % 3]);
        const double weight = dt * weights.halved_cotangents[i];
        stiffness.emplace_back(a, a, weight);
        stiffness.emplace_back(b, b, weight);
        stiffness.emplace_back((std::max)(a, b), (std::min)(a, b), -weight);
        areas(Eigen::Index(v[i])) += weights.mixed_areas[i];
      }
    }
    // The forces of a pressure in each label, and where they take the vertices: nowhere on parts of
    // the interface that are not connected with the label.
    const internal::Volume_changer_3<Complex> changer(interface_);
    const auto labels = m_preserves_volumes ? changer.changes(positions, positions)
                                            : std::map<typename Complex::Label, double>();
    typename internal::Volume_changer_3<Complex>::Directions forces, responses(positions.size());
    if (m_preserves_volumes)
      forces = changer.gradients(labels, positions);

    Eigen::Matrix<double, Eigen::Dynamic, 3> solution(n, 3);
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
    std::vector<char> is_fixed, was_fixed;
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::VectorXd start(n);
      is_fixed.clear();
      for (std::size_t i = 0; i < positions.size(); ++i) {
        start(Eigen::Index(i)) = positions[i][axis];
        is_fixed.push_back(Boundary_class::fixes(interface_.vertices[i]->boundary_class(), axis));
      }
      if (axis == 0 || is_fixed != was_fixed)
        factorize(stiffness, areas, is_fixed, solver);
      solution.col(axis) = solver.solve(right_side(stiffness, areas, is_fixed, start));
      for (Eigen::Index label = 0; label < Eigen::Index(labels.size()); ++label) {
        Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
        for (std::size_t i = 0; i < forces.size(); ++i)
          if (const auto found = forces[i].find(label); found != forces[i].end())
            force(Eigen::Index(i)) = found->second[axis];
        const Eigen::VectorXd response = solver.solve(force);
        for (std::size_t i = 0; i < responses.size(); ++i)
          if (const double x = response(Eigen::Index(i)); x != 0) {
            auto& sum = responses[i].try_emplace(label, 0, 0, 0).first->second;
            sum = sum + Vector(axis == 0 ? x : 0, axis == 1 ? x : 0, axis == 2 ? x : 0);
          }
      }
      was_fixed = is_fixed;
    }
    std::vector<typename Complex::Approximate_point_3> result;
    for (Eigen::Index i = 0; i < n; ++i)
      result.emplace_back(solution(i, 0), solution(i, 1), solution(i, 2));
    if (m_preserves_volumes)
      changer.change_by(changer.changes(result, positions), responses, result);
    return result;
  }

  // Rows of fixed vertices are those of the identity.
  template <class Solver>
  static void factorize(const Entries& stiffness, const Eigen::VectorXd& areas,
                        const std::vector<char>& is_fixed, Solver& solver) {
    Entries entries;
    for (const auto& entry : stiffness)
      if (!is_fixed[std::size_t(entry.row())] && !is_fixed[std::size_t(entry.col())])
        entries.push_back(entry);
    for (Eigen::Index i = 0; i < areas.size(); ++i)
      entries.emplace_back(i, i, is_fixed[std::size_t(i)] ? 1 : areas(i));
    Eigen::SparseMatrix<double> matrix(areas.size(), areas.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver.compute(matrix);
    if (solver.info() != Eigen::Success)
      throw Deformable_simplicial_complexes::Error(
          "the step of mean curvature flow cannot be solved for: a vertex has only facets without "
          "area; improve the interface, or take shorter steps");
  }

  static Eigen::VectorXd right_side(const Entries& stiffness, const Eigen::VectorXd& areas,
                                    const std::vector<char>& is_fixed,
                                    const Eigen::VectorXd& start) {
    Eigen::VectorXd result = areas.cwiseProduct(start);
    for (const auto& entry : stiffness) {
      const auto i = entry.row(), j = entry.col();
      if (is_fixed[std::size_t(i)] && !is_fixed[std::size_t(j)])
        result(j) -= entry.value() * start(i);
      if (is_fixed[std::size_t(j)] && !is_fixed[std::size_t(i)])
        result(i) -= entry.value() * start(j);
    }
    for (Eigen::Index i = 0; i < result.size(); ++i)
      if (is_fixed[std::size_t(i)])
        result(i) = start(i);
    return result;
  }

  bool m_preserves_volumes;
};

} // namespace CGAL

#endif // CGAL_MEAN_CURVATURE_FLOW_3_H

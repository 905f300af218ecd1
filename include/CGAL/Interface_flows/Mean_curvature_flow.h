// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_MEAN_CURVATURE_FLOW_H
#define CGAL_INTERFACE_FLOWS_MEAN_CURVATURE_FLOW_H

#include <CGAL/license/Interface_flows.h>

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Facet_tension.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/Volume_changer.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/vertices_on_junctions.h>

#include <CGAL/Origin.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The surface tension of the facets of a snapshot: forces along the edges of the facets, and the mass
matrix of each vertex. Each vertex has a share of the area of its facets. At a vertex with two
labels, the mass matrix is this share times the identity. At a junction of more labels, for example
a line with angles of 120 degrees, a facet contributes to the mass along its normal only. A motion
within the plane of a facet changes the size of the facet only, so the facet does not resist it
(J. W. Barrett, H. Garcke, R. Nürnberg, *On the parametric finite element approximation of evolving
hypersurfaces in R^3*, Journal of Computational Physics 227, 2008).
*/
template <class Complex> class Tensions
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Approximate_point;
  using Matrix = Eigen::Matrix<double, d, d>;
  using Vector = Eigen::Matrix<double, d, 1>;

  // The force of an edge. The force on the vertex `from` is `weight` times `edge`, the vector from
  // `from` to `to`. The force on `to` is the opposite.
  struct Pull
  {
    std::size_t from, to;
    double weight;
    Vector edge;
  };

  Tensions(const Interface_snapshot<Complex>& interface_, const std::vector<Point>& positions)
      : m_are_junctions(vertices_on_junctions(interface_)), m_shares(positions.size(), 0),
        m_masses(positions.size(), Matrix::Zero()) {
    for (const auto& facet : interface_.facets()) {
      const auto& v = facet.vertices;
      std::array<Point, d> corners;
      for (int i = 0; i < d; ++i)
        corners[i] = interface_.domain.near(positions[v[0]], positions[v[i]]);
      const Facet_tension<d> tension(corners);
      for (std::size_t k = 0; k < tension.weights.size(); ++k) {
        const auto [i, j] = Complex::Space::facet_edges[k];
        m_pulls.push_back({v[i], v[j], tension.weights[k], vector(corners[j] - corners[i])});
      }
      const Vector normal = vector(Complex::Space::facet_normal(corners)).normalized();
      for (int i = 0; i < d; ++i) {
        m_shares[v[i]] += tension.shares[i];
        if (is_junction(v[i]))
          m_masses[v[i]] += tension.shares[i] * normal * normal.transpose();
      }
    }
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (!is_junction(v))
        m_masses[v] = m_shares[v] * Matrix::Identity();
      else if (m_shares[v] > 0)
        complete(m_masses[v], m_shares[v]);
  }

  const std::vector<Pull>& pulls() const { return m_pulls; }
  // Returns the mass matrix of a vertex. It is not zero if `share()` is not zero.
  const Matrix& mass(std::size_t v) const { return m_masses[v]; }
  double share(std::size_t v) const { return m_shares[v]; }
  // Returns whether more than two labels meet at a vertex. Its mass matrix then couples the axes.
  bool is_junction(std::size_t v) const { return m_are_junctions[v]; }
  bool has_junctions() const {
    return std::find(m_are_junctions.begin(), m_are_junctions.end(), true) != m_are_junctions.end();
  }

private:
  template <class V> static Vector vector(const V& v) {
    return Vector(coordinates_of<d>(v).data());
  }

  // Replaces eigenvalues that are near 0 by the share. They belong to directions in the planes of
  // all facets, for example along a line where several labels meet.
  static void complete(Matrix& mass, double share) {
    static constexpr double along = .1; // of the share; the others are 1/2 at lines, 1/3 at points
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(mass);
    Vector values = solver.eigenvalues();
    for (int i = 0; i < d; ++i)
      if (!(values[i] > along * share))
        values[i] = share;
    mass = solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
  }

  std::vector<char> m_are_junctions;
  std::vector<Pull> m_pulls;
  std::vector<double> m_shares;
  std::vector<Matrix> m_masses;
};

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

The explicit form of mean curvature flow (section 4.1.2 of the paper). In the plane, the flow is
called curve shortening flow. The velocity of a vertex is the negative gradient of the area of the
interface, by the cotangent formula, divided by the mixed Voronoi area of the vertex. In the plane,
it is the negative gradient of the length, divided by half of the length of the edges at the vertex.
The speed is the sum of the principal curvatures. The surface energy per area is the same between
any two labels, so three labels that meet along a line form angles of 120 degrees.

The explicit form is stable for short time steps only: about half of the area of the smallest
triangle, in the plane half of the square of the shortest edge. `Mean_curvature_flow` has no such
limit.

\cgalModels `InterfaceVelocity`
*/
struct Mean_curvature_velocity
{
  /// The flow decreases the measure of the interface: `advect_adaptively()` adapts it in each step.
  static constexpr bool contracts_interface = true;

  /// Computes the velocities of all vertices at the given positions, see `InterfaceVelocity`. The
  /// time is linear in the size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point>& positions, double /*t*/,
                  std::vector<typename Complex::Approximate_vector>& velocities) const {
    using Tensions = internal::Tensions<Complex>;
    const Tensions tensions(interface_, positions);
    std::vector<typename Tensions::Vector> forces(positions.size(), Tensions::Vector::Zero());
    for (const auto& pull : tensions.pulls()) {
      forces[pull.from] += pull.weight * pull.edge;
      forces[pull.to] -= pull.weight * pull.edge;
    }
    velocities.clear();
    for (std::size_t v = 0; v < positions.size(); ++v) {
      std::array<double, Complex::dimension> coordinates = {};
      if (tensions.share(v) > 0) {
        const typename Tensions::Vector velocity = tensions.mass(v).ldlt().solve(forces[v]);
        std::copy(velocity.data(), velocity.data() + velocity.size(), coordinates.begin());
      }
      velocities.push_back(vector_of<Complex>(coordinates));
    }
  }
};

/*!
\ingroup PkgInterfaceFlowsRef

The semi-implicit form of mean curvature flow, in the plane called curve shortening flow
(M. Desbrun, M. Meyer, P. Schröder, A. H. Barr, *Implicit fairing of irregular meshes using
diffusion and curvature flow*, SIGGRAPH 1999). The forces are those of `Mean_curvature_velocity`, at
the positions at the end of the step, with the weights of its beginning. One step and two steps of
half the length are computed, and both results are extrapolated. The method is stable for any time
step and of second order in time.

\cgalModels `InterfaceStep`
*/
class Mean_curvature_flow
{
public:
  /// The flow decreases the measure of the interface: `advect_adaptively()` adapts it in each step.
  static constexpr bool contracts_interface = true;

  /// \param preserves_volumes whether each label keeps its volume, in the plane its area. Each
  ///        label then has a pressure, so a cluster of soap bubbles in equilibrium stays at rest.
  ///        Volumes are preserved up to rounding for labels that do not touch the boundary of the
  ///        domain. The time step must be shorter than the time in which a label would vanish
  ///        without its pressure.
  explicit Mean_curvature_flow(bool preserves_volumes = false)
      : m_preserves_volumes(preserves_volumes) {}

  /// Returns whether each label keeps its volume. `advect_adaptively()` then restores the volumes
  /// after each adaptation.
  bool preserves_volumes() const { return m_preserves_volumes; }

  /// Computes the destinations of all vertices, see `InterfaceStep`. The flow solves three linear
  /// systems by sparse Cholesky factorizations, more if the interface ends on sides of the domain.
  /// The time is about n log n in the size n of the interface. The preservation of volumes takes
  /// additional time proportional to n times the number of labels. It takes memory for each pair of
  /// a vertex and a label on the same connected component of the interface.
  /// \throws Error if dt is negative, or if all facets of a vertex have area 0.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point>& positions, double /*t*/,
                  double dt, std::vector<typename Complex::Approximate_point>& destinations) const {
    if (!(dt >= 0))
      throw Error("mean curvature flow cannot go back in time: use a time step of 0 or more");
    destinations.clear();
    if (positions.empty())
      return;
    System<Complex> system(interface_);
    const auto whole = implicit_step(system, interface_, positions, dt);
    const auto half = implicit_step(system, interface_, positions, dt / 2);
    destinations = implicit_step(system, interface_, half, dt / 2);
    for (std::size_t i = 0; i < destinations.size(); ++i)
      destinations[i] = destinations[i] + (destinations[i] - whole[i]);
    if (m_preserves_volumes) {
      const Volume_changer<Complex> changer(interface_);
      changer.change_by(changer.changes(destinations, positions), destinations);
    }
  }

private:
  template <class Complex> class System;

  // Returns the positions after one backward Euler step with the weights of its beginning. Vertices
  // on sides of the domain stay on these sides.
  template <class Complex>
  std::vector<typename Complex::Approximate_point>
  implicit_step(System<Complex>& system, const Interface_snapshot<Complex>& interface_,
                const std::vector<typename Complex::Approximate_point>& positions,
                double dt) const {
    static constexpr int d = Complex::dimension;
    const internal::Tensions<Complex> tensions(interface_, positions);
    // The forces of a unit pressure in each label, and the responses of the vertices. A response is
    // zero on components of the interface that do not touch the label.
    const Volume_changer<Complex> changer(interface_);
    const auto labels = m_preserves_volumes ? changer.changes(positions, positions)
                                            : std::map<typename Complex::Label, double>();
    typename Volume_changer<Complex>::Directions forces, responses(positions.size());
    if (m_preserves_volumes)
      forces = changer.gradients(labels, positions);

    // Junctions couple the axes. Without junctions, the axes are solved one by one.
    const int together = tensions.has_junctions() ? d : 1;
    std::vector<std::array<double, d>> displacements(positions.size());
    system.set(tensions, dt);
    for (int axis = 0; axis < d; axis += together) {
      system.assemble(axis, axis + together);
      system.for_each_solved(
          system.pulls(), [&](std::size_t v, int along, double x) { displacements[v][along] = x; });
      for (Eigen::Index label = 0; label < Eigen::Index(labels.size()); ++label)
        system.for_each_solved(
            system.forces(forces, label), [&](std::size_t v, int along, double x) {
              if (x == 0)
                return;
              std::array<double, d> part = {};
              part[along] = x;
              auto& sum = responses[v].try_emplace(label, NULL_VECTOR).first->second;
              sum = sum + vector_of<Complex>(part);
            });
    }
    std::vector<typename Complex::Approximate_point> result;
    for (std::size_t v = 0; v < positions.size(); ++v)
      result.push_back(positions[v] + vector_of<Complex>(displacements[v]));
    if (m_preserves_volumes)
      changer.change_by(changer.changes(result, positions), responses, result);
    return result;
  }

  // The linear systems of the steps of an interface. A system has one row for each vertex and each
  // of some axes. All steps have the same pattern of entries. The pattern is analyzed again only if
  // other vertices are fixed.
  template <class Complex> class System
  {
  public:
    using Tensions = internal::Tensions<Complex>;

    explicit System(const Interface_snapshot<Complex>& interface_)
        : m_interface(interface_), m_size(interface_.vertices.size()) {}

    // Begins a new step. `tensions` must live until the step is solved.
    void set(const Tensions& tensions, double dt) {
      m_tensions = &tensions;
      m_dt = dt;
      m_is_factorized = false;
    }

    void assemble(int first_axis, int last_axis) {
      m_first_axis = first_axis;
      m_last_axis = last_axis;
      std::vector<char> is_fixed;
      for (int axis = first_axis; axis < last_axis; ++axis)
        for (const auto& v : m_interface.vertices)
          is_fixed.push_back(Boundary_class::fixes(v->boundary_class(), axis));
      const bool has_other_rows = is_fixed != m_is_fixed;
      m_is_fixed.swap(is_fixed);
      if (has_other_rows || !m_is_factorized)
        factorize(has_other_rows);
      m_is_factorized = true;
    }

    Eigen::VectorXd pulls() const {
      Eigen::VectorXd right = zero();
      for (const auto& pull : m_tensions->pulls())
        for (int axis = m_first_axis; axis < m_last_axis; ++axis) {
          right(row(pull.from, axis)) += m_dt * pull.weight * pull.edge[axis];
          right(row(pull.to, axis)) -= m_dt * pull.weight * pull.edge[axis];
        }
      return right;
    }

    template <class Directions>
    Eigen::VectorXd forces(const Directions& forces, Eigen::Index label) const {
      Eigen::VectorXd right = zero();
      for (std::size_t v = 0; v < forces.size(); ++v)
        if (const auto found = forces[v].find(label); found != forces[v].end())
          for (int axis = m_first_axis; axis < m_last_axis; ++axis)
            right(row(v, axis)) = found->second[axis];
      return right;
    }

    // Solves for a right-hand side, and calls f(vertex, axis, x) for each component of the
    // solution. Fixed components are 0.
    template <class Function> void for_each_solved(Eigen::VectorXd right, const Function& f) const {
      for (Eigen::Index i = 0; i < right.size(); ++i)
        if (m_is_fixed[std::size_t(i)])
          right(i) = 0;
      const Eigen::VectorXd solution = m_solver.solve(right);
      for (int axis = m_first_axis; axis < m_last_axis; ++axis)
        for (std::size_t v = 0; v < m_size; ++v)
          f(v, axis, solution(row(v, axis)));
    }

  private:
    Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(Eigen::Index(m_is_fixed.size())); }
    Eigen::Index row(std::size_t v, int axis) const {
      return Eigen::Index(std::size_t(axis - m_first_axis) * m_size + v);
    }

    // Factorizes the matrix. The rows of fixed vertices are rows of the identity.
    void factorize(bool has_other_rows) {
      std::vector<Eigen::Triplet<double>> entries; // of the lower triangle
      const auto add = [&](Eigen::Index i, Eigen::Index j, double x) {
        if (i >= j && !m_is_fixed[std::size_t(i)] && !m_is_fixed[std::size_t(j)])
          entries.emplace_back(i, j, x);
      };
      for (int axis = m_first_axis; axis < m_last_axis; ++axis) {
        for (const auto& pull : m_tensions->pulls()) {
          const Eigen::Index a = row(pull.from, axis), b = row(pull.to, axis);
          add(a, a, m_dt * pull.weight);
          add(b, b, m_dt * pull.weight);
          add((std::max)(a, b), (std::min)(a, b), -m_dt * pull.weight);
        }
        for (std::size_t v = 0; v < m_size; ++v)
          for (int other = m_first_axis; other <= axis; ++other)
            if (other == axis || m_tensions->is_junction(v))
              add(row(v, axis), row(v, other), m_tensions->mass(v)(axis, other));
      }
      for (std::size_t i = 0; i < m_is_fixed.size(); ++i)
        if (m_is_fixed[i])
          entries.emplace_back(Eigen::Index(i), Eigen::Index(i), 1);
      Eigen::SparseMatrix<double> matrix(Eigen::Index(m_is_fixed.size()),
                                         Eigen::Index(m_is_fixed.size()));
      matrix.setFromTriplets(entries.begin(), entries.end());
      if (has_other_rows)
        m_solver.analyzePattern(matrix);
      m_solver.factorize(matrix);
      if (m_solver.info() != Eigen::Success)
        throw Error("the step of mean curvature flow cannot be computed: all facets of a vertex "
                    "have area zero; improve the interface, or use a shorter time step");
    }

    const Interface_snapshot<Complex>& m_interface;
    std::size_t m_size;
    const Tensions* m_tensions = nullptr;
    double m_dt = 0;
    int m_first_axis = 0, m_last_axis = 0;
    std::vector<char> m_is_fixed; // one for each row
    bool m_is_factorized = false;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
  };

  bool m_preserves_volumes;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_MEAN_CURVATURE_FLOW_H

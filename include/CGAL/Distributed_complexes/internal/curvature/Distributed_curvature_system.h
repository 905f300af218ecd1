// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_CURVATURE_DISTRIBUTED_CURVATURE_SYSTEM_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_CURVATURE_DISTRIBUTED_CURVATURE_SYSTEM_H

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Interface_flows/internal/curvature/Interface_forces.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/internal/numbers/Conjugate_gradients.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The system of `Curvature_system` on several ranks: each rank has the rows of its own vertices.
// The conjugate gradient method with the diagonal as preconditioner solves it. Scalar products do
// not depend on the ranks, so the solution has the same bits for any number of ranks.
template <class Complex> class Distributed_curvature_system
{
public:
  static constexpr int d = Complex::dimension;
  using Distributed = Distributed_complex<Complex>;
  using Interface = typename Distributed::Interface;
  using Forces = Interface_forces<Complex>;
  using Vector = typename Forces::Vector;
  using Vectors = std::vector<Vector>; // one for each vertex of the interface here

  // \throws Error on all ranks if all facets of a vertex have area zero
  Distributed_curvature_system(const Distributed& dsc, const Interface& interface_,
                               const Forces& forces, double dt)
      : m_dsc(dsc), m_interface(interface_), m_forces(forces), m_dt(dt),
        m_diagonal(interface_.indices.size()) {
    bool is_flat = false;
    for (std::size_t v = 0; v < m_diagonal.size(); ++v) {
      m_diagonal[v] = forces.mass(v).diagonal();
      if (!dsc.mesh().is_own(interface_.indices[v]))
        continue;
      m_own.push_back(v);
      const auto* const constraint = forces.constraint(v);
      is_flat =
          is_flat || (!(forces.share(v) > 0) && !(constraint != nullptr && constraint->isZero(0)));
    }
    dsc.communicator().agree_on_error(
        is_flat ? "the step of mean curvature flow cannot be computed: all facets of a vertex have "
                  "area zero; use a shorter time step"
                : "");
    for (const auto& pull : forces.pulls())
      for (std::size_t v : {pull.from, pull.to})
        m_diagonal[v] += Vector::Constant(dt * pull.weight);
  }

  // Returns the solution for a right-hand side, also for ghosts.
  // \throws Error on all ranks if the method does not converge
  Vectors solve(Vectors right) const {
    static constexpr double tolerance = 1e-13, sufficient = 1e-9; // of the relative residual
    for (std::size_t v = 0; v < right.size(); ++v)
      right[v] = constrained(v, right[v]);
    const std::size_t most = 2 * d *
                             std::size_t(m_dsc.communicator().reduced(Communicator::Operation::sum,
                                                                      std::int64_t(m_own.size())));
    double size = 0, rest = 0; // squared norms of the right-hand side and of the residual
    std::size_t iterations = 0;
    Vectors solution = conjugate_gradients(
        *this, std::move(right), [&](const Vector& /* energy */, const Vectors& residuals) {
          rest = sum([&](std::size_t v) { return product(residuals[v], residuals[v]); })[0];
          if (iterations == 0)
            size = rest;
          return iterations++ < most && rest > tolerance * tolerance * size;
        });
    if (!(rest <= sufficient * sufficient * size)) // equal on all ranks
      throw Error(
          "the step of mean curvature flow cannot be computed: the linear system is too ill "
          "conditioned; use a shorter time step");
    m_dsc.share(m_interface, solution);
    return solution;
  }

  // The rows of own vertices for `conjugate_gradients()`.

  // The sides are the axes, which are coupled: all have the scalar product of the vectors.
  static Vector product(const Vector& x, const Vector& y) { return Vector::Constant(x.dot(y)); }
  static bool is_stuck(const Vector& curvature) { return !(curvature[0] > 0); }

  Vector preconditioned(std::size_t v, const Vector& x) const {
    return constrained(v, x.cwiseQuotient(m_diagonal[v]));
  }

  Vector apply(Vectors& directions, Vectors& products) const {
    m_dsc.communicator().check_progress();
    m_dsc.share(m_interface, directions);
    for (std::size_t v = 0; v < directions.size(); ++v)
      products[v] = m_forces.mass(v) * directions[v];
    for (const auto& pull : m_forces.pulls()) {
      const Vector difference = m_dt * pull.weight * (directions[pull.from] - directions[pull.to]);
      products[pull.from] += difference;
      products[pull.to] -= difference;
    }
    for_each_row([&](std::size_t v) { products[v] = constrained(v, products[v]); });
    return sum([&](std::size_t v) { return product(directions[v], products[v]); });
  }

  template <class Function> void for_each_row(const Function& f) const {
    for (std::size_t v : m_own)
      f(v);
  }

  template <class Function> Vector sum(const Function& f) const {
    std::vector<std::array<double, 1>> terms;
    for_each_row([&](std::size_t v) { terms.push_back({f(v)[0]}); });
    return Vector::Constant(Exact_sums<1>(m_dsc.communicator())(terms)[0]);
  }

private:
  Vector constrained(std::size_t v, const Vector& x) const {
    const auto* const constraint = m_forces.constraint(v);
    return constraint != nullptr ? (*constraint * x).eval() : x;
  }

  const Distributed& m_dsc;
  const Interface& m_interface;
  const Forces& m_forces;
  double m_dt;
  std::vector<std::size_t> m_own; // vertices of this rank
  Vectors m_diagonal;
};

// Returns the destinations of the vertices of the interface here after a step of mean curvature
// flow, as `Mean_curvature_flow` computes them.
template <class Complex>
std::vector<typename Complex::Approximate_point>
mean_curvature_destinations(const Distributed_complex<Complex>& dsc,
                            const typename Distributed_complex<Complex>::Interface& interface_,
                            const Interface_energy& energy, double dt) {
  using System = Distributed_curvature_system<Complex>;
  using Points = std::vector<typename Complex::Approximate_point>;
  std::vector<Boundary_class::Bits> sides;
  for (auto v : interface_.indices)
    sides.push_back(dsc.mesh().piece.vertex(v).boundary_class);
  const auto implicit_step = [&](const Points& positions, double time) {
    const Interface_forces<Complex> forces(interface_.snapshot, positions, energy, sides);
    const System system(dsc, interface_, forces, time);
    typename System::Vectors right;
    for (std::size_t v = 0; v < positions.size(); ++v)
      right.push_back(time * forces.force(v));
    const auto motion = system.solve(right);
    Points result;
    for (std::size_t v = 0; v < positions.size(); ++v)
      result.push_back(positions[v] + Interface_forces<Complex>::vector(motion[v]));
    return result;
  };
  const Points whole = implicit_step(interface_.positions, dt);
  Points result = implicit_step(implicit_step(interface_.positions, dt / 2), dt / 2);
  for (std::size_t v = 0; v < result.size(); ++v)
    result[v] = result[v] + (result[v] - whole[v]);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_CURVATURE_DISTRIBUTED_CURVATURE_SYSTEM_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_INTERFACE_FORCES_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_INTERFACE_FORCES_H

#include <CGAL/Deformable_simplicial_complexes/Facet_tension.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/vertices_on_junctions.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The forces by which the facets of a snapshot reduce the energy of the interface, and the mass matrix
of each vertex: the velocity of a vertex is its force divided by its mass. Each vertex has a share
of the area of its facets, divided by their mobilities. At a vertex with two labels, the mass matrix
is this share times the identity. At a junction of more labels, for example a line with angles of
120 degrees, a facet contributes to the mass along its normal only. A motion within the plane of a
facet changes the size of the facet only, so the facet does not resist it (J. W. Barrett, H. Garcke,
R. Nürnberg, *On the parametric finite element approximation of evolving hypersurfaces in R^3*,
Journal of Computational Physics 227, 2008). The vertices of facets with the mobility 0 are pinned.
*/
template <class Complex> class Interface_forces
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Approximate_point;
  using Matrix = Eigen::Matrix<double, d, d>;
  using Vector = Eigen::Matrix<double, d, 1>;

  // The tension of an edge. The force on the vertex `from` is `weight` times `edge`, the vector
  // from `from` to `to`. The force on `to` is the opposite.
  struct Pull
  {
    std::size_t from, to;
    double weight;
    Vector edge;
  };

  Interface_forces(const Interface_snapshot<Complex>& interface_,
                   const std::vector<Point>& positions, const Interface_energy& energy)
      : m_are_junctions(vertices_on_junctions(interface_)), m_are_pinned(positions.size(), false),
        m_shares(positions.size(), 0), m_masses(positions.size(), Matrix::Zero()),
        m_forces(positions.size(), Vector::Zero()) {
    for (const auto& facet : interface_.facets()) {
      std::array<Point, d> corners;
      for (int i = 0; i < d; ++i)
        corners[i] =
            interface_.domain.near(positions[facet.vertices[0]], positions[facet.vertices[i]]);
      add_forces(facet, corners, energy);
      add_masses(facet, corners, energy.mobility(facet.behind, facet.in_front));
    }
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (!is_junction(v))
        m_masses[v] = m_shares[v] * Matrix::Identity();
      else if (m_shares[v] > 0)
        complete(m_masses[v], m_shares[v]);
  }

  const std::vector<Pull>& pulls() const { return m_pulls; }
  // Returns the force on a vertex: the negative gradient of the energy.
  const Vector& force(std::size_t v) const { return m_forces[v]; }
  // Returns the mass matrix of a vertex. It is not zero if `share()` is not zero.
  const Matrix& mass(std::size_t v) const { return m_masses[v]; }
  double share(std::size_t v) const { return m_shares[v]; }
  // Returns whether more than two labels meet at a vertex. Its mass matrix then couples the axes.
  bool is_junction(std::size_t v) const { return m_are_junctions[v]; }
  // Returns whether a vertex does not move, because a facet has the mobility 0.
  bool is_pinned(std::size_t v) const { return m_are_pinned[v]; }

private:
  using Facet = typename Interface_vertices<Complex>::Facet;
  using Corners = std::array<Point, d>;

  template <class V> static Vector vector(const V& v) {
    return Vector(coordinates_of<d>(v).data());
  }

  void add_forces(const Facet& facet, const Corners& corners, const Interface_energy& energy) {
    const auto& v = facet.vertices;
    const Facet_tension<d> parts(corners);
    const double tension = energy.tension(facet.behind, facet.in_front);
    for (std::size_t k = 0; k < parts.weights.size(); ++k) {
      const auto [i, j] = Complex::Space::facet_edges[k];
      const Vector edge = vector(corners[j] - corners[i]);
      m_pulls.push_back({v[i], v[j], tension * parts.weights[k], edge});
      m_forces[v[i]] += m_pulls.back().weight * edge;
      m_forces[v[j]] -= m_pulls.back().weight * edge;
    }
    if (!energy.has_densities())
      return;
    const Vector area = vector(Complex::Space::facet_normal(corners)) / (d - 1);
    const double drive = energy.density(facet.in_front) - energy.density(facet.behind);
    for (std::size_t i : v)
      m_forces[i] += drive / d * area;
  }

  void add_masses(const Facet& facet, const Corners& corners, double mobility) {
    const auto& v = facet.vertices;
    if (mobility == 0) {
      for (std::size_t i : v)
        m_are_pinned[i] = true;
      return;
    }
    const Facet_tension<d> parts(corners);
    const Vector normal = vector(Complex::Space::facet_normal(corners)).normalized();
    for (int i = 0; i < d; ++i) {
      const double share = parts.shares[i] / mobility;
      m_shares[v[i]] += share;
      if (is_junction(v[i]))
        m_masses[v[i]] += share * normal * normal.transpose();
    }
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

  std::vector<char> m_are_junctions, m_are_pinned;
  std::vector<Pull> m_pulls;
  std::vector<double> m_shares;
  std::vector<Matrix> m_masses;
  std::vector<Vector> m_forces;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_INTERFACE_FORCES_H

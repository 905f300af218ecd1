// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_INTERFACE_FORCES_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_INTERFACE_FORCES_H

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/vertices_on_junctions.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Facet_tension.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <map>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The forces by which the facets of a snapshot reduce the energy of the interface, and the mass matrix
of each vertex: the velocity of a vertex is its force divided by its mass. Each vertex has a share
of the area of its facets, divided by their mobilities. In the plane, a vertex between two segments
has a smaller share, so that a curve loses area at the right rate, also at corners. At a vertex with
two labels, the mass matrix is this share times the identity. At a junction of more labels, for
example a line with angles of 120 degrees, a facet contributes to the mass along its normal only. A
motion within the plane of a facet changes the size of the facet only, so the facet does not resist
it (J. W. Barrett, H. Garcke, R. Nürnberg, *On the parametric finite element approximation of
evolving hypersurfaces in R^3*, Journal of Computational Physics 227, 2008).

Constraints: vertices on sides of the domain stay on them. Facets with the mobility 0 do not move
along their normals. A vertex with such facets only is pinned. Other vertices of such facets slide
along them, for example where a grain boundary ends at a particle. At a sharp edge of the particle,
a vertex moves along the edge. At a corner, it does not move.
*/
template <class Complex> class Interface_forces
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Point;
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
      : Interface_forces(interface_, positions, energy, boundary_classes(interface_)) {}

  // `sides` are the boundary classes of the vertices, whose handles are not used.
  Interface_forces(const Interface_snapshot<Complex>& interface_,
                   const std::vector<Point>& positions, const Interface_energy& energy,
                   const std::vector<Boundary_class::Bits>& sides)
      : m_are_junctions(vertices_on_junctions(interface_)), m_shares(positions.size(), 0),
        m_masses(positions.size(), Matrix::Zero()), m_forces(positions.size(), Vector::Zero()),
        m_tangents(d == 2 ? positions.size() : 0) {
    Obstacles obstacles;
    for (const auto& facet : interface_.facets()) {
      const auto corners = interface_.corners(facet, positions);
      add_forces(facet, corners, energy);
      const double mobility = energy.mobility(facet.behind, facet.in_front);
      if (mobility > 0)
        add_masses(facet, corners, mobility);
      else
        add_obstacle(facet, corners, obstacles);
    }
    m_has_obstacles = !obstacles.empty();
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (sides[v] != Boundary_class::inside)
        m_constraints.emplace(v, within(sides[v]));
    for (const auto& [v, normals] : obstacles)
      m_constraints.insert_or_assign(v, along(normals, v, sides[v]));
    if constexpr (d == 2)
      for (std::size_t v = 0; v < positions.size(); ++v)
        if (m_tangents[v].number == 2 && sides[v] == Boundary_class::inside)
          m_shares[v] *= mass_at_corner(m_tangents[v].sum.norm() / 2);
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (!is_junction(v))
        m_masses[v] = m_shares[v] * Matrix::Identity();
      else if (m_shares[v] > 0)
        complete(m_masses[v], m_shares[v]);
  }

  static Vector vector(const typename Complex::Vector& v) {
    return Vector(coordinates_of<d>(v).data());
  }
  static typename Complex::Vector vector(const Vector& v) {
    std::array<double, d> coordinates;
    std::copy_n(v.data(), d, coordinates.begin());
    return vector_of<Complex>(coordinates);
  }

  const std::vector<Pull>& pulls() const { return m_pulls; }
  // Returns the force on a vertex: the negative gradient of the energy.
  const Vector& force(std::size_t v) const { return m_forces[v]; }
  // Returns the mass matrix of a vertex. It is not zero if `share()` is not zero.
  const Matrix& mass(std::size_t v) const { return m_masses[v]; }
  double share(std::size_t v) const { return m_shares[v]; }
  // Returns whether more than two labels meet at a vertex. Its mass matrix then couples the axes.
  bool is_junction(std::size_t v) const { return m_are_junctions[v]; }
  // Returns the orthogonal projection to the directions in which a vertex may move; a null pointer
  // if it may move in all directions.
  const Matrix* constraint(std::size_t v) const {
    const auto found = m_constraints.find(v);
    return found == m_constraints.end() ? nullptr : &found->second;
  }
  // Returns the projections of all vertices that may not move in all directions.
  const std::map<std::size_t, Matrix>& constraints() const { return m_constraints; }
  // Returns whether there are facets with the mobility 0.
  bool has_obstacles() const { return m_has_obstacles; }

private:
  static std::vector<Boundary_class::Bits>
  boundary_classes(const Interface_snapshot<Complex>& interface_) {
    std::vector<Boundary_class::Bits> result;
    for (auto v : interface_.vertices)
      result.push_back(v->boundary_class());
    return result;
  }

  using Facet = typename Interface_vertices<Complex>::Facet;
  using Corners = std::array<Point, d>;
  using Obstacles = std::map<std::size_t, std::vector<Vector>>; // area vectors by vertex

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
      if constexpr (d == 2) {
        m_tangents[v[i]].add(edge.normalized());
        m_tangents[v[j]].add(-edge.normalized());
      }
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
    const Facet_tension<d> parts(corners);
    const Vector normal = vector(Complex::Space::facet_normal(corners)).normalized();
    for (int i = 0; i < d; ++i) {
      const double share = parts.shares[i] / mobility;
      m_shares[v[i]] += share;
      if (is_junction(v[i]))
        m_masses[v[i]] += share * normal * normal.transpose();
    }
  }

  // Returns the factor of the mass of a vertex between two segments, for half the length of the sum
  // of their unit tangents. The vertex has a turning angle a and sweeps area at the rate sin(a).
  // The rate of a smooth curve with this turning angle is a.
  static double mass_at_corner(double half_of_sum) {
    static constexpr double least = .1; // for a spike
    const double half_angle = std::asin((std::min)(1., half_of_sum));
    return half_angle > 0 ? (std::max)(least, std::sin(2 * half_angle) / (2 * half_angle)) : 1;
  }

  // Adds the area vector of a facet with the mobility 0 to its vertices.
  static void add_obstacle(const Facet& facet, const Corners& corners, Obstacles& obstacles) {
    const Vector area = vector(Complex::Space::facet_normal(corners));
    for (std::size_t v : facet.vertices)
      obstacles[v].push_back(area);
  }

  // Returns the projection to the sides of the domain.
  static Matrix within(Boundary_class::Bits sides) {
    Matrix result = Matrix::Identity();
    for (int axis = 0; axis < d; ++axis)
      if (Boundary_class::fixes(sides, axis))
        result(axis, axis) = 0;
    return result;
  }

  // Returns the projection to the directions in which a vertex may move along facets with given
  // area vectors, and along sides of the domain.
  Matrix along(const std::vector<Vector>& areas, std::size_t v, Boundary_class::Bits sides) const {
    if (!(m_shares[v] > 0))
      return Matrix::Zero();
    const Matrix side = within(sides);
    Matrix tensor = Matrix::Zero();
    for (const Vector& area : areas)
      if (const double norm = area.norm(); norm > 0)
        tensor += side * area * area.transpose() * side / norm;
    // Facets whose normals differ by less than 60 degrees are parts of one smooth surface.
    static constexpr double smooth =
        1. / 3; // tan(60 / 2)^2, ratio of the eigenvalues of two facets
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(tensor);
    const Vector values = solver.eigenvalues();
    Matrix result = side;
    for (int i = 0; i < d; ++i)
      if (values[i] > smooth * values[d - 1]) {
        Vector normal = side * solver.eigenvectors().col(i);
        if (i == d - 1 && !(values[d - 2] > smooth * values[d - 1])) {
          // The gradient of the volume on one side: the motion keeps this volume.
          Vector sum = Vector::Zero();
          for (const Vector& area : areas)
            sum += area.dot(normal) < 0 ? -area : area;
          normal = (side * sum).normalized();
        }
        result -= normal * normal.transpose();
      }
    return result;
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

  // Unit tangents of the segments at a vertex, in the plane.
  struct Tangents
  {
    Vector sum = Vector::Zero();
    int number = 0;

    void add(const Vector& tangent) {
      sum += tangent;
      ++number;
    }
  };

  std::vector<char> m_are_junctions;
  std::vector<Pull> m_pulls;
  std::vector<double> m_shares;
  std::vector<Matrix> m_masses;
  std::vector<Vector> m_forces;
  std::vector<Tangents> m_tangents;
  std::map<std::size_t, Matrix> m_constraints;
  bool m_has_obstacles = false;
};

// The symmetric positive definite system (M + dt K) u = f of a step of an interface, with the
// masses M and the tensions K. There is a row for each vertex and each axis. Vertices with a
// constraint move in its directions only. The conjugate gradient method solves the system: a
// factorization would fill up where junctions couple the axes.
template <class Complex> class Curvature_system
{
public:
  static constexpr int d = Complex::dimension;
  using Forces = Interface_forces<Complex>;
  using Vector = Eigen::VectorXd;

  // \throws Error if all facets of a vertex have area zero
  Curvature_system(const Interface_snapshot<Complex>& interface_, const Forces& forces, double dt)
      : m_forces(forces) {
    for (const auto& pull : forces.pulls()) {
      const double x = dt * pull.weight;
      add_scalar(pull.from, pull.from, x);
      add_scalar(pull.to, pull.to, x);
      add_scalar(pull.from, pull.to, -x);
      add_scalar(pull.to, pull.from, -x);
    }
    for (std::size_t v = 0; v < interface_.vertices.size(); ++v) {
      const Block* constraint = forces.constraint(v);
      if (!(forces.share(v) > 0) && !(constraint != nullptr && constraint->isZero(0)))
        throw Error("the step of mean curvature flow cannot be computed: all facets of a vertex "
                    "have area zero; improve the interface, or use a shorter time step");
      if (constraint != nullptr)
        add_block(v, v,
                  *constraint * forces.mass(v) * *constraint + Block::Identity() - *constraint);
      else if (forces.is_junction(v))
        add_block(v, v, forces.mass(v));
      else
        add_scalar(v, v, forces.share(v));
    }
    const auto size = d * Eigen::Index(interface_.vertices.size());
    m_matrix.resize(size, size);
    m_matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    m_entries = {};
    static constexpr double tolerance = 1e-13; // of the relative residual
    m_solver.setTolerance(tolerance);
    m_solver.compute(m_matrix);
  }

  static Eigen::Index row(std::size_t v, int axis) { return d * Eigen::Index(v) + axis; }

  // Returns the solution for a right-hand side. Its components that a constraint excludes are
  // ignored.
  // \throws Error if the method does not converge
  Vector solve(Vector right) const {
    // Rounding can prevent the tolerance if the time step is long. A solution with this residual
    // is accurate enough.
    static constexpr double sufficient = 1e-9;
    for (const auto& [v, constraint] : m_forces.constraints())
      right.template segment<d>(row(v, 0)) =
          (constraint * right.template segment<d>(row(v, 0))).eval();
    const Vector result = m_solver.solve(right);
    if (!(m_solver.error() <= sufficient) || !result.allFinite())
      throw Error(
          "the step of mean curvature flow cannot be computed: the linear system is too ill "
          "conditioned; improve the interface, or use a shorter time step");
    return result;
  }

private:
  using Block = typename Forces::Matrix;
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  // Adds x times the identity to the block of two vertices, within their constraints.
  void add_scalar(std::size_t v, std::size_t w, double x) {
    const Block *of_v = m_forces.constraint(v), *of_w = m_forces.constraint(w);
    if (of_v != nullptr && of_w != nullptr)
      add_block(v, w, x * *of_v * *of_w);
    else if (of_v != nullptr || of_w != nullptr)
      add_block(v, w, x * (of_v != nullptr ? *of_v : *of_w));
    else
      for (int axis = 0; axis < d; ++axis)
        m_entries.emplace_back(row(v, axis), row(w, axis), x);
  }
  void add_block(std::size_t v, std::size_t w, const Block& block) {
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j)
        if (block(i, j) != 0)
          m_entries.emplace_back(row(v, i), row(w, j), block(i, j));
  }

  const Forces& m_forces;
  std::vector<Eigen::Triplet<double>> m_entries;
  Matrix m_matrix;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> m_solver;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_INTERFACE_FORCES_H

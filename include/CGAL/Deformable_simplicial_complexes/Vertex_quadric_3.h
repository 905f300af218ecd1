// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_QUADRIC_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_QUADRIC_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// The squared distances from the planes of the facets around a vertex, each plane shifted by an
// offset: (X. Jiao, Face offsetting: A unified approach for explicit moving interfaces, Journal of
// Computational Physics 220, 2007). Eigenvectors of large eigenvalues span the primary space, along
// which the facets hold the vertex: 1 direction on a smooth surface, 2 on a ridge, 3 at a corner.
template <class Vector> class Vertex_quadric_3
{
public:
  // A facet with a unit normal, by which its plane is shifted.
  void add(const Vector& unit_normal, double weight, double offset = 0) {
    const Eigen::Vector3d n(unit_normal.x(), unit_normal.y(), unit_normal.z());
    m_matrix += weight * n * n.transpose();
    m_offset += weight * offset * n;
    m_sum_of_offsets += weight * std::abs(offset);
  }

  // Finds the spaces. Eigenvalues up to `threshold` times the largest one belong to the null space:
  // on an edge between two facets of the same weight, dihedral angles up to
  // 2 atan(sqrt(threshold)) count as smooth. The primary space has a minimum dimension if that is
  // known otherwise. To be called after all facets are added.
  void analyse(double threshold, int minimum_rank = 0) {
    static constexpr double rounding = 1e-10;
    threshold = (std::max)(threshold, rounding);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m_matrix);
    m_eigenvalues = solver.eigenvalues(); // increasing
    m_eigenvectors = solver.eigenvectors();
    m_rank = 0;
    for (int i = 0; i < 3; ++i)
      m_rank += m_eigenvalues(i) > threshold * m_eigenvalues(2);
    m_rank = (std::max)(m_rank, minimum_rank);
  }

  double sum_of_weights() const { return m_matrix.trace(); }

  // Dimension of the primary space; 0 if there is no facet.
  int rank() const { return m_rank; }

  // Where the shifted planes meet, relative to the vertex, as far as they define it.
  Vector displacement() const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int i = 3 - m_rank; i < 3; ++i) {
      const auto e = m_eigenvectors.col(i);
      result += e.dot(m_offset) / m_eigenvalues(i) * e;
    }
    return Vector(result(0), result(1), result(2));
  }

  // Where facets go that cancel each other in the displacement, as those of a thin sheet at its
  // rim: the direction of the sum of their offsets, of length 1, or 0 if that cancels, too.
  Vector mean_direction() const {
    static constexpr double negligible = 1e-6;
    const double length = m_offset.norm();
    if (!(length > negligible * m_sum_of_offsets))
      return Vector(0, 0, 0);
    return Vector(m_offset(0), m_offset(1), m_offset(2)) / length;
  }

  // The part of a vector in the null space: along the surface or the ridge.
  Vector project_on_null_space(const Vector& vector) const {
    const Eigen::Vector3d v(vector.x(), vector.y(), vector.z());
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3 - m_rank; ++i)
      result += m_eigenvectors.col(i).dot(v) * m_eigenvectors.col(i);
    return Vector(result(0), result(1), result(2));
  }

private:
  Eigen::Matrix3d m_matrix = Eigen::Matrix3d::Zero(), m_eigenvectors = Eigen::Matrix3d::Zero();
  Eigen::Vector3d m_offset = Eigen::Vector3d::Zero(), m_eigenvalues = Eigen::Vector3d::Zero();
  double m_sum_of_offsets = 0;
  int m_rank = 0;
};

inline void check_eigenvalue_threshold(double threshold) {
  if (!(threshold >= 0 && threshold < 1))
    throw Error("a threshold of eigenvalues is out of range: use 0 to less than 1");
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_QUADRIC_3_H

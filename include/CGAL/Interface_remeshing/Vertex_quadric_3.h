// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_VERTEX_QUADRIC_3_H
#define CGAL_INTERFACE_REMESHING_VERTEX_QUADRIC_3_H

#include <CGAL/Mesh_support/Error.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Quadric of a vertex in space: the weighted sum of the squared distances from the planes of its
facets. Each plane can be shifted by an offset. Eigenvectors of large eigenvalues span the primary
space, in which the facets determine the position of the vertex. Its dimension is 1 on a smooth
surface, 2 on a ridge and 3 at a corner. The other eigenvectors span the null space.

See \cgalCite{cgal:j-fouae-07}. Each function takes constant time, and no function throws.

\tparam Vector a vector in space with coordinates of type `double`
*/
template <class Vector> class Vertex_quadric_3
{
public:
  /// Adds the plane of a facet.
  /// \param unit_normal its normal, of length 1
  /// \param weight positive, for example the area of the facet or its angle at the vertex
  /// \param offset displacement of the plane along the normal, a length
  void add(const Vector& unit_normal, double weight, double offset = 0) {
    const Eigen::Vector3d n(unit_normal.x(), unit_normal.y(), unit_normal.z());
    m_matrix += weight * n * n.transpose();
    m_offset += weight * offset * n;
    m_sum_of_offsets += weight * std::abs(offset);
  }

  /// Computes the primary space and the null space. To be called after all facets are added, and
  /// before the functions below except `sum_of_weights()`.
  /// \param threshold eigenvalues up to `threshold` times the largest one belong to the null space,
  ///        in [0, 1). At an edge of two facets with equal weights, the surface counts as smooth if
  ///        the normals differ by at most 2 atan(sqrt(`threshold`)).
  /// \param minimum_rank lower bound on the dimension of the primary space, in [0, 3], for a vertex
  ///        on a known feature
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

  /// Returns the sum of the weights.
  double sum_of_weights() const { return m_matrix.trace(); }

  /// Returns the dimension of the primary space: 0 if there is no facet and `minimum_rank` is 0.
  int rank() const { return m_rank; }

  /// Returns the displacement in the primary space to the point with the least weighted sum of
  /// squared distances from the shifted planes. This is their common point if there is one.
  /// \pre `minimum_rank` was not greater than the rank of the planes; otherwise, the result has no
  ///      meaning.
  Vector displacement() const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int i = 3 - m_rank; i < 3; ++i) {
      const auto e = m_eigenvectors.col(i);
      result += e.dot(m_offset) / m_eigenvalues(i) * e;
    }
    return Vector(result(0), result(1), result(2));
  }

  /// Returns the direction of the weighted sum of the offset vectors, of length 1, or 0 if they
  /// cancel each other. It replaces the displacement where the facets cancel each other there, for
  /// example at the rim of a thin sheet.
  Vector mean_direction() const {
    static constexpr double negligible = 1e-6;
    const double length = m_offset.norm();
    if (!(length > negligible * m_sum_of_offsets))
      return Vector(0, 0, 0);
    return Vector(m_offset(0), m_offset(1), m_offset(2)) / length;
  }

  /// Returns the component of a vector in the null space: along the surface or the ridge.
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

/*!
\ingroup PkgInterfaceRemeshingRef

Checks a threshold of `Vertex_quadric_3::analyse()`.

\throws Error if the threshold is not in [0, 1)
*/
inline void check_eigenvalue_threshold(double threshold) {
  if (!(threshold >= 0 && threshold < 1))
    throw Error("the eigenvalue threshold is out of range: use at least 0 and less than 1");
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_VERTEX_QUADRIC_3_H

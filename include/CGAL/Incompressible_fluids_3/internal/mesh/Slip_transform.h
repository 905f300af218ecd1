// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_TRANSFORM_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_TRANSFORM_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The transformation of velocities at vertices at which two liquids slip along each other. The
// unknowns are the velocity v of the vertex and the relative velocity s of the liquids. With the
// share c of the second liquid in the mass of the vertex, the velocities of the two liquids are
// v + c s and v - (1 - c) s. The kinetic energy of the vertex is then the sum of two terms, of v
// and of s. Vectors and matrices have the unknown v at the place of the velocity of the first
// liquid, and s at the place of the second. All other velocities are unknowns themselves.
class Slip_transform
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Vector = Eigen::VectorXd;
  using Index = std::uint32_t;

  template <class Mesh>
  explicit Slip_transform(const Mesh& mesh) : m_size(Eigen::Index(mesh.vertices.size())) {
    for (const auto& slip : mesh.slips)
      m_pairs.push_back({slip.first, slip.second, slip.share});
  }

  // Returns the second place of a vertex with two velocities, given its first place.
  std::optional<Index> second(Index first) const {
    const auto found = std::lower_bound(m_pairs.begin(), m_pairs.end(), first,
                                        [](const Pair& a, Index b) { return a.first < b; });
    return found != m_pairs.end() && found->first == first ? std::optional<Index>(found->second)
                                                           : std::nullopt;
  }

  // Replaces velocities of liquids by unknowns.
  void to_unknowns(Vector& v) const {
    for (const Pair& pair : m_pairs) {
      auto [first, second] = at(v, pair);
      const Eigen::Vector3d relative = first - second;
      first -= pair.share * relative;
      second = relative;
    }
  }

  // Replaces unknowns by velocities of liquids.
  void to_velocities(Vector& v) const {
    for (const Pair& pair : m_pairs) {
      auto [first, second] = at(v, pair);
      const Eigen::Vector3d relative = second;
      second = first - (1 - pair.share) * relative;
      first += pair.share * relative;
    }
  }

  // Replaces forces on liquids by forces on unknowns.
  void transform_forces(Vector& f) const {
    for (const Pair& pair : m_pairs) {
      auto [first, second] = at(f, pair);
      const Eigen::Vector3d sum = first + second;
      second = pair.share * first - (1 - pair.share) * second;
      first = sum;
    }
  }

  // Returns T^t a T, where T maps unknowns to velocities, and `a` has blocks of `axes` rows and
  // columns for each velocity.
  template <int axes> Matrix symmetric(const Matrix& a) const {
    if (m_pairs.empty() || a.rows() == 0)
      return a;
    const Matrix t = matrix<axes>();
    const Matrix product = a * t, transposed = t.transpose();
    return transposed * product;
  }

  // Returns b T, where b has blocks of `axes` columns for each velocity.
  template <int axes> Matrix columns(const Matrix& b) const {
    return m_pairs.empty() ? b : Matrix(b * matrix<axes>());
  }

private:
  struct Pair
  {
    Index first, second;
    double share;
  };
  struct Ends
  {
    Eigen::Ref<Eigen::Vector3d> first, second;
  };

  static Ends at(Vector& v, const Pair& pair) {
    return {v.segment<3>(3 * Eigen::Index(pair.first)),
            v.segment<3>(3 * Eigen::Index(pair.second))};
  }

  // Returns the matrix that maps unknowns to velocities.
  template <int axes> Matrix matrix() const {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<char> is_second(std::size_t(m_size), false);
    const auto add = [&entries](Index row, Index column, double value) {
      for (int axis = 0; axis < axes; ++axis)
        entries.emplace_back(axes * int(row) + axis, axes * int(column) + axis, value);
    };
    for (const Pair& pair : m_pairs) {
      is_second[pair.second] = true;
      add(pair.second, pair.first, 1);
      add(pair.first, pair.second, pair.share);
      add(pair.second, pair.second, pair.share - 1);
    }
    for (Index v = 0; v < Index(m_size); ++v)
      if (!is_second[v])
        add(v, v, 1);
    Matrix result(axes * m_size, axes * m_size);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::Index m_size;       // number of velocities
  std::vector<Pair> m_pairs; // by first place
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_TRANSFORM_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_TRANSFORM_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_TRANSFORM_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A vertex of the interface of two liquids, and of no other medium. The vertex moves with the
// velocity (1 - share) * u + share * w, where u and w are the velocities of the two liquids, and
// `share` is the part of the second liquid in the mass of the vertex.
struct Slip
{
  std::uint32_t first, second; // the two occurrences of the vertex
  double share;
};

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

  // Prepares the transformation of the velocities of a mesh, which must outlive the object.
  template <class Mesh>
  explicit Slip_transform(const Mesh& mesh)
      : m_size(Eigen::Index(mesh.vertices.size())), m_slips(mesh.slips) {}

  // Returns the second place of a vertex with two velocities, given its first place.
  std::optional<Index> second(Index first) const {
    const auto found = std::lower_bound(m_slips.begin(), m_slips.end(), first,
                                        [](const Slip& a, Index b) { return a.first < b; });
    return found != m_slips.end() && found->first == first ? std::optional<Index>(found->second)
                                                           : std::nullopt;
  }

  // Replaces velocities of liquids by unknowns.
  void to_unknowns(Vector& v) const {
    for (const Slip& slip : m_slips) {
      auto [first, second] = at(v, slip);
      const Eigen::Vector3d relative = first - second;
      first -= slip.share * relative;
      second = relative;
    }
  }

  // Replaces unknowns by velocities of liquids.
  void to_velocities(Vector& v) const {
    for (const Slip& slip : m_slips) {
      auto [first, second] = at(v, slip);
      const Eigen::Vector3d relative = second;
      second = first - (1 - slip.share) * relative;
      first += slip.share * relative;
    }
  }

  // Replaces forces on liquids by forces on unknowns.
  void transform_forces(Vector& f) const {
    for (const Slip& slip : m_slips) {
      auto [first, second] = at(f, slip);
      const Eigen::Vector3d sum = first + second;
      second = slip.share * first - (1 - slip.share) * second;
      first = sum;
    }
  }

  // Returns T^t a T, where T maps unknowns to velocities, and `a` has blocks of `axes` rows and
  // columns for each velocity.
  template <int axes> Matrix symmetric(const Matrix& a) const {
    if (m_slips.empty() || a.rows() == 0)
      return a;
    const Matrix t = matrix<axes>();
    const Matrix product = a * t, transposed = t.transpose();
    return transposed * product;
  }

  // Returns b T, where b has blocks of `axes` columns for each velocity.
  template <int axes> Matrix columns(const Matrix& b) const {
    return m_slips.empty() ? b : Matrix(b * matrix<axes>());
  }

private:
  struct Ends
  {
    Eigen::Ref<Eigen::Vector3d> first, second;
  };

  static Ends at(Vector& v, const Slip& slip) {
    return {v.segment<3>(3 * Eigen::Index(slip.first)),
            v.segment<3>(3 * Eigen::Index(slip.second))};
  }

  // Returns the matrix that maps unknowns to velocities.
  template <int axes> Matrix matrix() const {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<char> is_second(std::size_t(m_size), false);
    const auto add = [&entries](Index row, Index column, double value) {
      for (int axis = 0; axis < axes; ++axis)
        entries.emplace_back(axes * int(row) + axis, axes * int(column) + axis, value);
    };
    for (const Slip& slip : m_slips) {
      is_second[slip.second] = true;
      add(slip.second, slip.first, 1);
      add(slip.first, slip.second, slip.share);
      add(slip.second, slip.second, slip.share - 1);
    }
    for (Index v = 0; v < Index(m_size); ++v)
      if (!is_second[v])
        add(v, v, 1);
    Matrix result(axes * m_size, axes * m_size);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::Index m_size; // number of velocities
  const std::vector<Slip>& m_slips;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_TRANSFORM_H

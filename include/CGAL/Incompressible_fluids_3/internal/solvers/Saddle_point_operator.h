// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_SADDLE_POINT_OPERATOR_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_SADDLE_POINT_OPERATOR_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Block_matrix.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/blocks_of_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/unit_of.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The units of velocities and pressures in which the entries of a system are near 1, and the factor
// of all equations. They are powers of two. So the digits of a solution are the same for all units
// of the user that differ by powers of two.
struct System_units
{
  double velocity = 1, pressure = 1, factor = 1;

  // Constructs the units for given largest diagonal entries of velocities and of pressures.
  static System_units of(double largest_of_velocities, double largest_of_pressures) {
    const auto exponent = [](double x) { return std::ilogb(unit_of(x)); };
    // Other units of the user change both exponents by even or both by odd numbers.
    const int odd = exponent(largest_of_velocities) & 1;
    const auto unit = [odd](int e) { return std::ldexp(1., -((e + odd) >> 1)); };
    return {unit(exponent(largest_of_velocities)), unit(exponent(largest_of_pressures)),
            odd ? 2. : 1.};
  }

  // The factors of the parts of the matrix.
  double of_nodal() const { return factor * velocity * velocity; }
  double of_b() const { return factor * velocity * pressure; }
  double of_c() const { return factor * pressure * pressure; }
};

// The matrix of a `Saddle_point_system`, without the projection and the closed sets.
template <class Scalar> class Saddle_point_operator
{
public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Index = Eigen::Index;

  Saddle_point_operator() = default;

  explicit Saddle_point_operator(const For_each_index& for_each,
                                 const Saddle_point_system& system) {
    for_each(
        4,
        [&](std::size_t k) {
          if (k == 0) {
            m_b = Block_matrix<Scalar, 1, 3>(system.b);
            m_bt = m_b.transpose(system.nodal.rows());
          } else if (k == 1)
            m_nodal = Block_matrix<Scalar, 1, 1>(system.nodal);
          else if (k == 2)
            m_coupling = Block_matrix<Scalar, 3, 3>(system.coupling);
          else
            m_c = Block_matrix<Scalar, 1, 1>(system.c);
        },
        2);
  }

  // Converts another scalar and other units.
  template <class Other>
  Saddle_point_operator(const For_each_index& for_each, const Saddle_point_operator<Other>& other,
                        const System_units& units) {
    for_each(
        5,
        [&](std::size_t k) {
          if (k == 0)
            m_b = {other.b(), units.of_b()};
          else if (k == 1)
            m_bt = {other.bt(), units.of_b()};
          else if (k == 2)
            m_nodal = {other.nodal(), units.of_nodal()};
          else if (k == 3)
            m_coupling = {other.coupling(), units.of_nodal()};
          else
            m_c = {other.c(), units.of_c()};
        },
        2);
  }

  // Computes the product y of the matrix and a vector x.
  void multiply(const For_each_index& for_each, const Vector& x, Vector& y) const {
    const Index n = m_nodal.rows(), m = m_c.rows();
    for_each_block(for_each, n + m, [&](Index begin, Index size) {
      for (Index i = begin; i < begin + size; ++i)
        if (i < n) {
          Eigen::Matrix<Scalar, 3, 1> sum = -m_bt.product(i, x, 3 * n);
          m_nodal.for_each_in_row(i, [&](Index j, const auto& value) {
            sum += value(0) * x.template segment<3>(3 * j);
          });
          if (m_coupling.rows() > 0)
            sum += m_coupling.product(i, x, 0);
          y.template segment<3>(3 * i) = sum;
        } else
          y(2 * n + i) = -m_b.product(i - n, x, 0)(0) - m_c.product(i - n, x, 3 * n)(0);
    });
  }

  const Block_matrix<Scalar, 1, 1>& nodal() const { return m_nodal; }
  const Block_matrix<Scalar, 3, 3>& coupling() const { return m_coupling; }
  const Block_matrix<Scalar, 1, 3>& b() const { return m_b; }
  const Block_matrix<Scalar, 3, 1>& bt() const { return m_bt; }
  const Block_matrix<Scalar, 1, 1>& c() const { return m_c; }

private:
  Block_matrix<Scalar, 1, 1> m_nodal;
  Block_matrix<Scalar, 3, 3> m_coupling;
  Block_matrix<Scalar, 1, 3> m_b;
  Block_matrix<Scalar, 3, 1> m_bt; // the transpose of b
  Block_matrix<Scalar, 1, 1> m_c;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_SADDLE_POINT_OPERATOR_H

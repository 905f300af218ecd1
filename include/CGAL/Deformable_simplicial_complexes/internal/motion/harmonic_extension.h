// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Less_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Linear_element.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>

#include <CGAL/Origin.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Free vertices near moving ones: those within a number of layers of edges, or all of them if much
// of the interface moves. Those on the boundary of the domain are free if their sides permit and
// one of these has a moving vertex, too: a line of contact takes its surroundings along.
template <class Complex>
std::vector<typename Complex::Vertex_handle>
free_vertices_near(const Complex& complex,
                   const std::vector<typename Complex::Vertex_handle>& moving, unsigned layers) {
  using Vertex_handle = typename Complex::Vertex_handle;
  static constexpr std::size_t much = 16;
  std::vector<Vertex_handle> found;
  unsigned moving_sides = 0;
  for (Vertex_handle v : moving)
    moving_sides |= v->boundary_class();
  const auto is_free = [&](Vertex_handle v) {
    if (v->is_interface() || complex.is_infinite(v))
      return false;
    return !complex.is_boundary(v) ||
           ((v->boundary_class() & moving_sides) != 0 &&
            !Boundary_class::fixes_all(v->boundary_class(), Complex::dimension));
  };
  if (moving.size() * much > complex.number_of_vertices()) {
    for (Vertex_handle v : complex.finite_vertices())
      if (is_free(v))
        found.push_back(v);
  } else {
    std::vector<Vertex_handle> front = moving, next;
    std::vector<typename Complex::Cell_handle> star;
    for (unsigned layer = 0; layer < layers; ++layer) {
      next.clear();
      for (Vertex_handle v : front) {
        complex.star(v, star);
        for (auto c : star)
          for (int i = 0; i < Complex::corners; ++i)
            if (is_free(c->vertex(i)) && !is_numbered(c->vertex(i), found)) {
              c->vertex(i)->set_scratch_index(std::uint32_t(found.size()));
              found.push_back(c->vertex(i));
              next.push_back(c->vertex(i));
            }
      }
      front.swap(next);
    }
  }
  std::sort(found.begin(), found.end(), Less_time_stamp());
  return found;
}

// Makes unknowns of a linear system zero, which keeps it symmetric.
template <class Matrix, class Vector, class IsHeld>
void hold(Matrix& matrix, Vector& right, const IsHeld& is_held) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    if (is_held(row))
      right[row] = 0;
    for (typename Matrix::InnerIterator entry(matrix, row); entry; ++entry)
      if (entry.col() != row && (is_held(row) || is_held(entry.col())))
        entry.valueRef() = 0;
  }
}

/*
Extends displacements from the interface into the space around: each component solves the Laplace
equation by linear finite elements. A rigid or affine motion of a closed interface is reproduced
inside, so that cells there keep their shape.

`displacement(v)` tells the displacement of a vertex that is not in `free`. It is asked once for
each that is next to them. Vertices on the boundary of the domain go within their sides.
*/
template <class Complex, class Displacement>
std::vector<typename Complex::Approximate_vector>
harmonic_extension(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& free,
                   const Displacement& displacement, const For_each_index& for_each_index) {
  using Vector = typename Complex::Approximate_vector;
  static constexpr int d = Complex::dimension;
  if (free.empty())
    return {};
  number_vertices(free);
  using Index = Eigen::Index;
  const Index n = Index(free.size());
  const auto cells = sorted_star_union(complex, free);
  auto vertices = free; // and behind them those next to them
  for (auto c : cells)
    for (int i = 0; i < Complex::corners; ++i)
      if (!is_numbered(c->vertex(i), vertices)) {
        c->vertex(i)->set_scratch_index(std::uint32_t(vertices.size()));
        vertices.push_back(c->vertex(i));
      }
  std::vector<Vector> known;
  for (auto v = vertices.begin() + n; v != vertices.end(); ++v)
    known.push_back(displacement(*v));
  number_vertices(vertices); // whoever was asked may have numbered others
  if (std::all_of(known.begin(), known.end(), [](const Vector& d) { return d == NULL_VECTOR; }))
    return std::vector<Vector>(free.size(), NULL_VECTOR);

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, d>;
  Columns right = Columns::Zero(n, d);
  for (auto c : cells) {
    const Linear_element<Complex> element(complex, c);
    if (!element.is_regular()) // it has no say
      continue;
    for (int i = 0; i < Complex::corners; ++i) {
      const Index row = Index(c->vertex(i)->scratch_index());
      if (row >= n)
        continue;
      for (int j = 0; j < Complex::corners; ++j) {
        const Index column = Index(c->vertex(j)->scratch_index());
        const double stiffness = element.stiffness(i, j);
        if (i == j) {
          diagonal[row] += stiffness;
        } else if (column < n) {
          entries.emplace_back(row, column, stiffness);
        } else {
          for (int axis = 0; axis < d; ++axis)
            right(row, axis) -= stiffness * known[std::size_t(column - n)][axis];
        }
      }
    }
  }
  for (Index i = 0; i < n; ++i)
    entries.emplace_back(i, i, diagonal[i]);
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());

  const bool has_held =
      std::any_of(free.begin(), free.end(), [&](auto v) { return complex.is_boundary(v); });

  // The extension only guides: what it proposes is checked, so that a rough solution will do.
  Columns solution(n, d);
  const std::size_t worthwhile = n < 100 ? 4 : 1;
  for_each_index(
      d,
      [&](std::size_t axis) {
        const auto is_held = [&](Index i) {
          return Boundary_class::fixes(free[std::size_t(i)]->boundary_class(), int(axis));
        };
        Matrix held;
        Eigen::VectorXd b = right.col(Index(axis));
        if (has_held) {
          held = matrix;
          hold(held, b, is_held);
        }
        Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver(has_held ? held
                                                                                      : matrix);
        solver.setTolerance(1e-2);
        solver.setMaxIterations(200);
        solution.col(Index(axis)) = solver.solve(b);
      },
      worthwhile);
  std::vector<Vector> result;
  for (Index i = 0; i < n; ++i) {
    std::array<double, d> coordinates;
    for (int axis = 0; axis < d; ++axis)
      coordinates[axis] = solution(i, axis);
    result.push_back(vector_of<Complex>(coordinates));
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Less_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Linear_element.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Affine_phases.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <boost/container/flat_map.hpp>

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
equation by linear finite elements, with a conductivity that is inverse to what a cell measures. So
all cells withstand a change of their shape alike, and small ones, where the interface is fine, keep
theirs at the cost of large ones. A rigid or affine motion of a closed interface is reproduced
inside: what is solved for is the deviation from the affine motion that fits best.

`displacement(v)` tells the displacement of a vertex that is not in `free`. It is asked once for
each that is next to them. Vertices on the boundary of the domain go within their sides.
*/
template <class Complex, class Displacement>
std::vector<typename Complex::Approximate_vector>
harmonic_extension(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& free,
                   const Displacement& displacement, const For_each_index& for_each_index) {
  static constexpr int d = Complex::dimension;
  using Phases = Affine_phases<d>;
  using Vector = typename Phases::Vector;
  using Index = Eigen::Index;
  if (free.empty())
    return {};
  number_vertices(free);
  auto vertices = free; // and behind them those next to them
  const auto handles = sorted_star_union(complex, free);
  std::vector<typename Phases::Cell> cells;
  boost::container::flat_map<typename Complex::Label, std::uint32_t> phases_of_labels;
  std::vector<std::uint32_t> phase_at(free.size());
  for (auto c : handles) {
    typename Phases::Cell cell;
    cell.phase =
        phases_of_labels.emplace(c->label(), std::uint32_t(phases_of_labels.size())).first->second;
    for (int i = 0; i < Complex::corners; ++i) {
      if (!is_numbered(c->vertex(i), vertices)) {
        c->vertex(i)->set_scratch_index(std::uint32_t(vertices.size()));
        vertices.push_back(c->vertex(i));
      }
      cell.vertices[i] = c->vertex(i)->scratch_index();
      if (cell.vertices[i] < free.size())
        phase_at[cell.vertices[i]] = cell.phase;
    }
    cells.push_back(cell);
  }
  const auto coordinates = [](const auto& p) { return Vector(coordinates_of<d>(p).data()); };
  typename Phases::Vertices places;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const bool is_free = i < free.size();
    places.positions.push_back(coordinates(complex.position(vertices[i])));
    places.are_held.push_back(is_free ? complex.is_boundary(vertices[i])
                                      : !vertices[i]->is_interface());
    if (!is_free)
      places.known.push_back(coordinates(displacement(vertices[i])));
  }

  const Phases phases(phases_of_labels.size(), cells, places);
  std::vector<Index> rows(vertices.size(), -1); // of free vertices in phases that deviate
  std::vector<std::size_t> unknown;             // these vertices
  for (std::size_t i = 0; i < free.size(); ++i)
    if (phases.deviates(phase_at[i])) {
      rows[i] = Index(unknown.size());
      unknown.push_back(i);
    }
  const Index n = Index(unknown.size());
  std::vector<Eigen::Triplet<double>> entries; // below the diagonal and on it
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, d>;
  Columns right = Columns::Zero(n, d);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& c = cells[k];
    if (!phases.deviates(c.phase))
      continue;
    const Linear_element<Complex> element(complex, handles[k]);
    if (!element.is_regular()) // it has no say
      continue;
    const double conductivity = element.conductivity();
    for (int i = 0; i < Complex::corners; ++i) {
      const Index row = rows[c.vertices[i]];
      if (row < 0)
        continue;
      for (int j = 0; j < Complex::corners; ++j) {
        const Index column = rows[c.vertices[j]];
        const double stiffness = conductivity * element.stiffness(i, j);
        if (i == j)
          diagonal[row] += stiffness;
        else if (column < 0)
          right.row(row) -= stiffness * phases.deviation(c.phase, c.vertices[j]).transpose();
        else if (column < row)
          entries.emplace_back(row, column, stiffness);
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
          return Boundary_class::fixes(free[unknown[std::size_t(i)]]->boundary_class(), int(axis));
        };
        Matrix held;
        Eigen::VectorXd b = right.col(Index(axis));
        if (has_held) {
          held = matrix;
          hold(held, b, is_held);
        }
        Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver(has_held ? held : matrix);
        solver.setTolerance(1e-2);
        solver.setMaxIterations(200);
        solution.col(Index(axis)) = solver.solve(b);
      },
      worthwhile);
  std::vector<typename Complex::Approximate_vector> result;
  for (std::size_t i = 0; i < free.size(); ++i) {
    Vector motion = phases.motion(phase_at[i], std::uint32_t(i));
    if (rows[i] >= 0)
      motion += solution.row(rows[i]).transpose();
    std::array<double, d> coordinates;
    std::copy(motion.data(), motion.data() + d, coordinates.begin());
    result.push_back(vector_of<Complex>(coordinates));
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

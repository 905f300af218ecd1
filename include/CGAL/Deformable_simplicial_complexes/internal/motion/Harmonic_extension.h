// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/accounts/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Less_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Linear_element.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Affine_phases.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>

#include <CGAL/Origin.h>

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
theirs at the cost of large ones. If all of the closed interface around a phase moves affinely, so
does the phase: what is solved for is the deviation from the affine motion that fits best.
*/
template <class Complex> class Harmonic_extension
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Displacement = typename Complex::Approximate_vector;
  static constexpr int d = Complex::dimension;

  // `free` are the vertices to which displacements are extended; `displacement(v)` tells those of
  // the others next to them, and is asked once for each.
  template <class Known>
  Harmonic_extension(const Complex& complex, const std::vector<Vertex_handle>& free,
                     const Known& displacement)
      : m_complex(complex), m_free(free) {
    const std::vector<Vertex_handle> vertices = number_cells();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      // On a torus, where no linear map but that to zero is, phases follow the mean motion.
      m_vertices.positions.push_back(Complex::Domain::has_outside
                                         ? coordinates(complex.position(vertices[i]))
                                         : Vector::Zero().eval());
      if (i < free.size()) {
        m_vertices.are_held.push_back(complex.is_boundary(vertices[i]));
      } else {
        m_vertices.are_held.push_back(!vertices[i]->is_interface());
        m_vertices.known.push_back(coordinates(displacement(vertices[i])));
      }
    }
  }

  // The displacements of the free vertices. Those on the boundary of the domain go within its
  // sides.
  std::vector<Displacement> solve(const For_each_index& for_each_index) const {
    const Phases phases(m_number_of_phases, m_cells, m_vertices);
    const Unknowns unknowns(phases, m_phases, m_vertices.positions.size());
    Columns right = Columns::Zero(unknowns.size(), d);
    const Matrix matrix = assemble(phases, unknowns, right);
    const Columns deviations = solve(matrix, right, unknowns, for_each_index);
    std::vector<Displacement> result;
    for (std::size_t i = 0; i < m_free.size(); ++i) {
      Vector motion = phases.motion(m_phases[i], std::uint32_t(i));
      if (unknowns.row[i] >= 0)
        motion += deviations.row(unknowns.row[i]).transpose();
      std::array<double, d> coordinates;
      std::copy(motion.data(), motion.data() + d, coordinates.begin());
      result.push_back(vector_of<Complex>(coordinates));
    }
    return result;
  }

private:
  using Cell_handle = typename Complex::Cell_handle;
  using Phases = Affine_phases<d>;
  using Vector = typename Phases::Vector;
  using Index = Eigen::Index;
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, d>;
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  // The free vertices in phases that deviate from their affine motion.
  struct Unknowns
  {
    Unknowns(const Phases& phases, const std::vector<std::uint32_t>& phase_of_free,
             std::size_t number_of_vertices)
        : row(number_of_vertices, -1) {
      for (std::size_t i = 0; i < phase_of_free.size(); ++i)
        if (phases.deviates(phase_of_free[i])) {
          row[i] = size();
          vertices.push_back(i);
        }
    }
    Index size() const { return Index(vertices.size()); }

    std::vector<Index> row; // of a vertex; -1 if it is none
    std::vector<std::size_t> vertices;
  };

  template <class Point> static Vector coordinates(const Point& p) {
    return Vector(coordinates_of<d>(p).data());
  }

  // Numbers the cells around free vertices, their vertices and their phases. Returns the vertices:
  // free ones first.
  std::vector<Vertex_handle> number_cells() {
    std::vector<Vertex_handle> vertices = m_free;
    Vertex_numbers numbers(m_complex, vertices);
    m_phases.resize(m_free.size());
    m_handles = sorted_star_union(m_complex, m_free);
    m_cells.reserve(m_handles.size());
    boost::container::flat_map<typename Complex::Label, std::uint32_t> phases;
    for (Cell_handle c : m_handles) {
      const auto phase = phases.emplace(c->label(), std::uint32_t(phases.size())).first;
      m_cells.push_back({{}, phase->second});
      for (int i = 0; i < Complex::corners; ++i) {
        const std::uint32_t number = numbers.add(c->vertex(i), vertices);
        m_cells.back().vertices[i] = number;
        if (number < m_free.size())
          m_phases[number] = phase->second;
      }
    }
    m_number_of_phases = phases.size();
    return vertices;
  }

  // Of a cell: from the list of positions where there is one, as cells are not in the order in
  // which they are stored.
  typename Linear_element<Complex>::Corners corners(std::size_t k) const {
    typename Linear_element<Complex>::Corners result;
    for (int i = 0; i < Complex::corners; ++i)
      if constexpr (Complex::Domain::has_outside) {
        std::array<double, d> coordinates = {};
        const Vector& p = m_vertices.positions[m_cells[k].vertices[i]];
        std::copy(p.data(), p.data() + d, coordinates.begin());
        result[i] = CGAL::ORIGIN + vector_of<Complex>(coordinates);
      } else {
        result[i] = m_complex.corner(m_handles[k], i);
      }
    return result;
  }

  // The stiffness of the unknowns below the diagonal and on it; what is known goes to the right.
  Matrix assemble(const Phases& phases, const Unknowns& unknowns, Columns& right) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(std::size_t(unknowns.size()) + (d * (d + 1) / 2) * m_cells.size());
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(unknowns.size());
    for (std::size_t k = 0; k < m_cells.size(); ++k) {
      const typename Phases::Cell& c = m_cells[k];
      if (!phases.deviates(c.phase))
        continue;
      const Linear_element<Complex> element(corners(k));
      const double conductivity = element.conductivity();
      if (conductivity == 0)
        continue;
      for (int i = 0; i < Complex::corners; ++i) {
        const Index row = unknowns.row[c.vertices[i]];
        if (row < 0) {
          const Vector deviation = phases.deviation(c.phase, c.vertices[i]);
          for (int j = 0; j < Complex::corners; ++j)
            if (unknowns.row[c.vertices[j]] >= 0)
              right.row(unknowns.row[c.vertices[j]]) -=
                  conductivity * element.stiffness(i, j) * deviation.transpose();
          continue;
        }
        diagonal[row] += conductivity * element.stiffness(i, i);
        for (int j = 0; j < i; ++j) {
          const Index column = unknowns.row[c.vertices[j]];
          if (column >= 0)
            entries.emplace_back((std::max)(row, column), (std::min)(row, column),
                                 conductivity * element.stiffness(i, j));
        }
      }
    }
    for (Index i = 0; i < unknowns.size(); ++i)
      entries.emplace_back(i, i, diagonal[i]);
    Matrix matrix(unknowns.size(), unknowns.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  // The extension only guides: what it proposes is checked, so that a rough solution will do.
  Columns solve(const Matrix& matrix, const Columns& right, const Unknowns& unknowns,
                const For_each_index& for_each_index) const {
    static constexpr double tolerance = 1e-2; // of the right side
    static constexpr int maximum_number_of_iterations = 200;
    const std::size_t worthwhile = unknowns.size() < 100 ? d + 1 : 1;
    const bool has_held =
        std::any_of(m_free.begin(), m_free.end(), [&](auto v) { return m_complex.is_boundary(v); });
    Columns result(unknowns.size(), d);
    for_each_index(
        d,
        [&](std::size_t axis) {
          Matrix held;
          Eigen::VectorXd b = right.col(Index(axis));
          if (has_held) {
            held = matrix;
            hold(held, b, [&](Index i) {
              const Vertex_handle v = m_free[unknowns.vertices[std::size_t(i)]];
              return Boundary_class::fixes(v->boundary_class(), int(axis));
            });
          }
          Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver(has_held ? held : matrix);
          solver.setTolerance(tolerance);
          solver.setMaxIterations(maximum_number_of_iterations);
          result.col(Index(axis)) = solver.solve(b);
        },
        worthwhile);
    return result;
  }

  const Complex& m_complex;
  const std::vector<Vertex_handle>& m_free;
  std::vector<Cell_handle> m_handles;
  std::vector<typename Phases::Cell> m_cells; // as many
  std::vector<std::uint32_t> m_phases;        // of free vertices
  std::size_t m_number_of_phases = 0;
  typename Phases::Vertices m_vertices;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

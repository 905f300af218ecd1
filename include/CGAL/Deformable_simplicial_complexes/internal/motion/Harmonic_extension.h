// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/Linear_element.h>
#include <CGAL/Deformable_simplicial_complexes/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Affine_phases.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Conjugate_gradients.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Row_blocks.h>

#include <Eigen/Core>

#include <boost/container/flat_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The harmonic extension of displacements from the interface to the surrounding space. Each component
of the displacement solves the Laplace equation, by linear finite elements. The conductivity of a
cell is the inverse of its measure. So all cells resist a change of their shape equally, and small
cells near a fine interface keep their shape at the cost of large ones. If the closed interface
around a phase moves affinely, the phase moves in the same way: the unknown is the deviation from
the affine motion that fits best.
*/
template <class Complex> class Harmonic_extension
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Displacement = typename Complex::Approximate_vector;
  static constexpr int d = Complex::dimension;

  // `free` are the vertices to which displacements are extended. `displacement(v)` returns the
  // displacement of each other vertex next to them, and is called once for each.
  template <class Known>
  Harmonic_extension(const Complex& complex, const std::vector<Vertex_handle>& free,
                     const Known& displacement, const For_each_index& for_each_index)
      : m_complex(complex), m_free(free), m_for_each_index(for_each_index), m_labels(free.size()),
        m_neighbors(free.size(), neighbors(), for_each_index), m_numbers(complex, free) {
    number_phases();
    const std::vector<Vertex_handle> vertices = number_vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex_handle v = vertices[i];
      // On a torus, no linear map except zero is well defined, so phases follow the mean
      // displacement.
      m_vertices.positions.push_back(Complex::Domain::has_outside ? coordinates(complex.position(v))
                                                                  : Vector::Zero().eval());
      m_vertices.are_constrained.push_back(i < free.size() ? complex.is_boundary(v)
                                                           : !v->is_interface());
      if (i >= free.size())
        m_vertices.known.push_back(coordinates(displacement(v)));
    }
  }

  // Returns the displacements of the free vertices. Vertices on the boundary of the domain move
  // within their sides.
  std::vector<Displacement> solve() const {
    const Phases phases(m_number_of_phases, m_phases, m_around, m_vertices);
    const Unknowns unknowns(phases, m_phases);
    const std::vector<Vector> deviations = deviations_of(phases, unknowns);
    std::vector<Displacement> result;
    for (std::size_t i = 0; i < m_free.size(); ++i) {
      Vector motion = phases.motion(m_phases[i], std::uint32_t(i));
      if (unknowns.row[i] != Unknowns::none)
        motion += deviations[unknowns.row[i]];
      std::array<double, d> coordinates;
      std::copy(motion.data(), motion.data() + d, coordinates.begin());
      result.push_back(vector_of<Complex>(coordinates));
    }
    return result;
  }

private:
  using Phases = Affine_phases<d>;
  using Vector = typename Phases::Vector;
  using Solver = Conjugate_gradients<d>;

  struct Neighbor
  {
    Vertex_handle vertex;
    double weight;
  };

  // The free vertices in phases that deviate from their affine motion.
  struct Unknowns
  {
    static constexpr std::uint32_t none = std::uint32_t(-1);

    Unknowns(const Phases& phases, const std::vector<std::uint32_t>& phase_of_free)
        : row(phase_of_free.size(), none) {
      for (std::uint32_t i = 0; i < phase_of_free.size(); ++i)
        if (phases.deviates(phase_of_free[i])) {
          row[i] = std::uint32_t(vertices.size());
          vertices.push_back(i);
        }
    }

    std::vector<std::uint32_t> row; // row of each free vertex
    std::vector<std::uint32_t> vertices;
  };

  template <class Point> static Vector coordinates(const Point& p) {
    return Vector(coordinates_of<d>(p).data());
  }

  // Returns a function that computes the neighbors of a free vertex from its star, and stores the
  // label around the vertex.
  auto neighbors() {
    using Cell_handle = typename Complex::Cell_handle;
    return [this, star = std::vector<Cell_handle>(), found = std::vector<Vertex_handle>(),
            positions = std::vector<typename Complex::Approximate_point>(),
            weights = std::vector<double>()](std::size_t i, std::vector<Neighbor>& result) mutable {
      const Vertex_handle v = m_free[i];
      m_complex.star(v, star);
      Vertex_numbers numbers(m_complex);
      found.assign(1, v);
      positions.assign(1, m_complex.position(v));
      weights.assign(1, 0.);
      for (Cell_handle c : star) {
        if (m_complex.is_infinite(c))
          continue;
        m_labels[i] = c->label();
        std::array<std::uint32_t, Complex::corners> number;
        typename Linear_element<Complex>::Corners corners;
        int own = 0;
        for (int j = 0; j < Complex::corners; ++j) {
          const Vertex_handle w = c->vertex(j);
          number[j] = w == v ? 0 : numbers.add(w, found);
          if (w == v)
            own = j;
          if (number[j] == positions.size()) {
            positions.push_back(m_complex.position_near(positions.front(), w));
            weights.push_back(0);
          }
          // On a torus, the position of a cell must not depend on the row, so that all rows compute
          // the same values.
          corners[j] = Complex::Domain::has_outside ? positions[number[j]] : m_complex.corner(c, j);
        }
        const auto stiffness = Linear_element<Complex>(corners).evened_stiffness(own);
        for (int j = 0; j < Complex::corners; ++j)
          weights[number[j]] -= stiffness[j];
      }
      for (std::size_t k = 1; k < found.size(); ++k)
        result.push_back({found[k], weights[k]});
    };
  }

  void number_phases() {
    boost::container::flat_map<typename Complex::Label, std::uint32_t> numbers;
    for (const auto& label : m_labels)
      m_phases.push_back(numbers.emplace(label, std::uint32_t(numbers.size())).first->second);
    m_number_of_phases = numbers.size();
  }

  // Numbers the vertices, free vertices first. Records which of the other vertices are at which
  // phases.
  std::vector<Vertex_handle> number_vertices() {
    std::vector<Vertex_handle> vertices = m_free;
    std::vector<std::uint32_t> last_phase; // the last phase of each vertex that is not free
    for (std::uint32_t i = 0; i < m_free.size(); ++i)
      for (const Neighbor& n : m_neighbors.row(i)) {
        const std::uint32_t number = m_numbers.add(n.vertex, vertices);
        if (number < m_free.size())
          continue;
        last_phase.resize(vertices.size() - m_free.size(), Unknowns::none);
        if (last_phase[number - m_free.size()] != m_phases[i])
          m_around.emplace_back(m_phases[i], number);
        last_phase[number - m_free.size()] = m_phases[i];
      }
    return vertices;
  }

  // Computes the deviations. A low accuracy is sufficient, because each proposed motion is checked
  // later.
  std::vector<Vector> deviations_of(const Phases& phases, const Unknowns& unknowns) const {
    static constexpr double part = 5e-3; // relative reduction of the residuals
    static constexpr int maximum_number_of_iterations = 200;
    using Entry = typename Solver::Entry;
    std::vector<Vector> right(unknowns.vertices.size(), Vector::Zero());
    std::vector<double> diagonal(right.size(), 0);
    const Row_blocks<Entry> matrix(
        right.size(),
        [&](std::size_t row, std::vector<Entry>& entries) {
          const std::uint32_t i = unknowns.vertices[row];
          for (const Neighbor& n : m_neighbors.row(i)) {
            const std::uint32_t number = m_numbers(n.vertex);
            diagonal[row] += n.weight;
            if (number < m_free.size())
              entries.push_back({unknowns.row[number], -n.weight});
            else
              right[row] += n.weight * phases.deviation(m_phases[i], number);
          }
        },
        m_for_each_index);
    return Solver(matrix, diagonal, m_for_each_index)
        .solve(
            std::move(right),
            [&](std::size_t row, int axis) {
              return Boundary_class::fixes(m_free[unknowns.vertices[row]]->boundary_class(), axis);
            },
            part, maximum_number_of_iterations);
  }

  // The order of the members is the order of their construction.
  const Complex& m_complex;
  const std::vector<Vertex_handle>& m_free;
  const For_each_index& m_for_each_index;
  std::vector<typename Complex::Label> m_labels; // labels around free vertices
  Row_blocks<Neighbor> m_neighbors;
  Vertex_numbers m_numbers;
  std::vector<std::uint32_t> m_phases; // phases of free vertices
  std::size_t m_number_of_phases = 0;
  std::vector<typename Phases::Around> m_around;
  typename Phases::Vertices m_vertices;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Moving_region.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Conjugate_gradients.h>
#include <CGAL/Mesh_support/internal/threads/Borrowed_table.h>

#include <Eigen/Eigenvalues>

#include <boost/container/flat_map.hpp>

#include <algorithm>
#include <numeric>

namespace CGAL::Deformable_simplicial_complexes::internal {

// For each phase, the affine motion that fits the motion of the surrounding interface best. A phase
// with other constraints, such as the boundary of the domain, has no affine motion.
template <int d> class Affine_phases
{
public:
  using Vector = Eigen::Matrix<double, d, 1>;

  // The number of a phase, and the number of a vertex at the phase that is not free.
  using Around = std::pair<std::uint32_t, std::uint32_t>;

  // The vertices by their numbers. `known` has the displacements of vertices that are not free.
  // `are_constrained` marks vertices that constrain their phase: free vertices that cannot move in
  // all directions, and other vertices that are not on the interface.
  struct Vertices
  {
    std::vector<Vector> positions, known;
    std::vector<char> are_constrained;
  };

  // `phases` has the phase of each free vertex. A vertex may occur several times at a phase; its
  // weight is the number of occurrences.
  Affine_phases(std::size_t number_of_phases, const std::vector<std::uint32_t>& free,
                const std::vector<std::uint32_t>& phases, const std::vector<Around>& around,
                const Vertices& vertices)
      : m_vertices(vertices), m_phases(number_of_phases) {
    for (std::uint32_t v : free)
      if (vertices.are_constrained[v])
        m_phases[phases[v]].is_constrained = true;
    for (const auto& [i, v] : around) {
      m_phases[i].is_constrained = m_phases[i].is_constrained || vertices.are_constrained[v];
      m_phases[i].longest = (std::max)(m_phases[i].longest, known(v).squaredNorm());
    }
    find_motions(around);
  }

  // Returns the displacement of a vertex by the affine motion of a phase.
  Vector motion(std::uint32_t phase, std::uint32_t v) const { return motion(m_phases[phase], v); }

  // Returns the difference between the displacement of a vertex that is not free and the affine
  // motion of the phase.
  Vector deviation(std::uint32_t phase, std::uint32_t v) const {
    return deviation(m_phases[phase], v);
  }

  // Returns whether a vertex next to the free vertices of the phase deviates from the affine
  // motion.
  bool deviates(std::uint32_t phase) const { return m_phases[phase].deviates; }

private:
  using Matrix = Eigen::Matrix<double, d, d>;

  struct Phase
  {
    double longest = 0; // squared length of the longest displacement at the phase
    bool is_constrained = false, deviates = false;
    double weight = 0;
    Vector center = Vector::Zero(), mean = Vector::Zero();
    Matrix linear = Matrix::Zero();

    bool has_motion() const { return !is_constrained && longest > 0; }
  };

  const Vector& position(std::uint32_t v) const { return m_vertices.positions[v]; }
  const Vector& known(std::uint32_t v) const { return m_vertices.known[v]; }

  // Fits the affine motions by least squares.
  void find_motions(const std::vector<Around>& around) {
    for (const auto& [i, v] : around) {
      m_phases[i].weight += 1;
      m_phases[i].center += position(v);
      m_phases[i].mean += known(v);
    }
    for (Phase& phase : m_phases)
      if (phase.has_motion()) {
        phase.center /= phase.weight;
        phase.mean /= phase.weight;
      }
    std::vector<Matrix> extents(m_phases.size(), Matrix::Zero());
    for (const auto& [i, v] : around) {
      const Vector p = position(v) - m_phases[i].center;
      extents[i] += p * p.transpose();
      m_phases[i].linear += (known(v) - m_phases[i].mean) * p.transpose();
    }
    for (std::size_t i = 0; i < m_phases.size(); ++i)
      if (m_phases[i].has_motion())
        m_phases[i].linear *= inverse(extents[i]);
      else
        m_phases[i].deviates = m_phases[i].longest > 0;
    for (const auto& [i, v] : around)
      m_phases[i].deviates = m_phases[i].deviates || !deviation(m_phases[i], v).isZero(0);
  }

  // Returns the pseudoinverse of a symmetric matrix. Positions that lie in a plane determine no
  // motion in the normal direction.
  static Matrix inverse(const Matrix& matrix) {
    static constexpr double negligible = 1e-14;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
    Vector inverses = Vector::Zero();
    for (int i = 0; i < d; ++i)
      if (solver.eigenvalues()[i] > negligible * solver.eigenvalues()[d - 1])
        inverses[i] = 1 / solver.eigenvalues()[i];
    return solver.eigenvectors() * inverses.asDiagonal() * solver.eigenvectors().transpose();
  }

  Vector motion(const Phase& phase, std::uint32_t v) const {
    if (!phase.has_motion())
      return Vector::Zero();
    return phase.mean + phase.linear * (position(v) - phase.center);
  }

  Vector deviation(const Phase& phase, std::uint32_t v) const {
    static constexpr double negligible = 1e-6; // relative to the longest displacement
    const Vector result = known(v) - motion(phase, v);
    if (result.squaredNorm() > negligible * negligible * phase.longest)
      return result;
    return Vector::Zero();
  }

  const Vertices& m_vertices;
  std::vector<Phase> m_phases;
};

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
  using Region = Moving_region<Complex>;
  using Number = typename Region::Number;
  using Displacement = typename Complex::Vector;
  static constexpr int d = Complex::dimension;

  // `free` are the vertices to which displacements are extended, movable vertices of a region.
  // `displacement(v)` returns the displacement of any other vertex of the region by its number.
  template <class Known>
  Harmonic_extension(const Region& region, const std::vector<Number>& free,
                     const Known& displacement, const For_each_index& for_each_index)
      : m_region(region), m_free(free), m_for_each_index(for_each_index),
        m_are_free(region.size(), false), m_phases(region.size(), Region::none) {
    const Complex& complex = region.complex();
    for (Number v : free)
      m_are_free[v] = true;
    find_phases();
    m_vertices.positions.resize(region.size(), Vector::Zero());
    m_vertices.are_constrained.resize(region.size());
    for_each_index(region.size(), [&](std::size_t v) {
      // On a torus, no linear map except zero is well defined, so phases follow the mean
      // displacement.
      if (Complex::Domain::has_outside)
        m_vertices.positions[v] = coordinates(region.positions()[v]);
      m_vertices.are_constrained[v] = m_are_free[v] ? complex.is_boundary(region.vertices()[v])
                                                    : !region.vertices()[v]->is_interface();
    });
    m_vertices.known.resize(region.size(), Vector::Zero());
    for (Number v = 0; v < region.size(); ++v) // in this thread, because users define flows
      if (!m_are_free[v] && m_phases[v] != Region::none)
        m_vertices.known[v] = coordinates(displacement(v));
  }

  // Returns the displacements of the free vertices. Vertices on the boundary of the domain move
  // within their sides.
  std::vector<Displacement> solve() const {
    const Phases phases(m_number_of_phases, m_free, m_phases, m_around, m_vertices);
    const Unknowns unknowns(phases, m_free, m_phases);
    const std::vector<Vector> deviations = deviations_of(phases, unknowns);
    std::vector<Displacement> result(m_free.size());
    m_for_each_index(m_free.size(), [&](std::size_t i) {
      const Number v = m_free[i];
      Vector motion = phases.motion(m_phases[v], v);
      if (unknowns.rows[v] != Region::none)
        motion += deviations[unknowns.rows[v]];
      std::array<double, d> coordinates;
      std::copy(motion.data(), motion.data() + d, coordinates.begin());
      result[i] = vector_of<Complex>(coordinates);
    });
    return result;
  }

private:
  using Phases = Affine_phases<d>;
  using Vector = typename Phases::Vector;
  using Solver = Conjugate_gradients<d>;
  using Element = Linear_element<Complex>;
  using Entry = typename Solver::Entry;

  // The free vertices in phases that deviate from their affine motion.
  struct Unknowns
  {
    Unknowns(const Phases& phases, const std::vector<Number>& free,
             const std::vector<Number>& phase_of)
        : rows(phase_of.size(), Region::none) {
      for (Number v : free)
        if (phases.deviates(phase_of[v])) {
          rows[v] = Number(vertices.size());
          vertices.push_back(v);
        }
    }

    std::vector<Number> rows; // the row of each vertex, or none
    std::vector<Number> vertices;
  };

  // The cells around each unknown vertex, in their order.
  class Incidences
  {
  public:
    Incidences(const Region& region, const Unknowns& unknowns)
        : m_ends(unknowns.vertices.size() + 1, 0) {
      const auto for_each = [&](const auto& f) {
        for (std::size_t c = 0; c < region.cells().size(); ++c)
          for (int i = 0; i < Complex::corners; ++i)
            if (const Number row = unknowns.rows[region.corners(c)[i]]; row != Region::none)
              f(row, Number(c * Complex::corners + i));
      };
      for_each([&](Number row, Number) { ++m_ends[row + 1]; });
      std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
      m_list.resize(m_ends.back());
      std::vector<std::size_t> next(m_ends.begin(), m_ends.end() - 1);
      for_each([&](Number row, Number corner) { m_list[next[row]++] = corner; });
    }

    // Calls f(c, i) for each cell around a vertex, where i is the corner at the vertex.
    template <class Function> void for_each(std::size_t row, const Function& f) const {
      for (std::size_t k = m_ends[row]; k < m_ends[row + 1]; ++k)
        f(m_list[k] / Complex::corners, int(m_list[k] % Complex::corners));
    }

  private:
    std::vector<std::size_t> m_ends;
    std::vector<Number> m_list;
  };

  template <class Point> static Vector coordinates(const Point& p) {
    return Vector(coordinates_of<d>(p).data());
  }

  // Numbers the labels around free vertices, and finds the phase of each free vertex and which
  // other vertices are at which phases. A free vertex is not on the interface, so all cells around
  // it have the same label.
  void find_phases() {
    boost::container::flat_map<typename Complex::Label, Number> numbers;
    for (std::size_t c = 0; c < m_region.cells().size(); ++c) {
      const auto& corners = m_region.corners(c);
      if (std::none_of(corners.begin(), corners.end(), [&](Number v) { return m_are_free[v]; }))
        continue;
      const Number phase = numbers.emplace(m_region.label(c), Number(numbers.size())).first->second;
      for (Number v : corners)
        if (std::exchange(m_phases[v], phase) != phase && !m_are_free[v])
          m_around.emplace_back(phase, v);
    }
    m_number_of_phases = numbers.size();
  }

  // Returns the stiffness of the edges of each cell at an unknown vertex.
  auto stiffness_of_cells(const Unknowns& unknowns) const {
    std::vector<std::array<double, Element::edges>> result(m_region.cells().size());
    m_for_each_index(result.size(), [&](std::size_t c) {
      const auto& corners = m_region.corners(c);
      if (std::all_of(corners.begin(), corners.end(),
                      [&](Number v) { return unknowns.rows[v] == Region::none; }))
        return;
      typename Element::Corners points;
      for (int i = 0; i < Complex::corners; ++i)
        points[i] = m_region.complex().domain().nearest_image(m_region.positions()[corners[0]],
                                                              m_region.positions()[corners[i]]);
      result[c] = Element(points).evened_stiffness();
    });
    return result;
  }

  // Computes the deviations. A low accuracy is sufficient, because each proposed motion is checked
  // later.
  std::vector<Vector> deviations_of(const Phases& phases, const Unknowns& unknowns) const {
    static constexpr double part = 5e-3; // relative reduction of the residuals
    static constexpr int maximum_number_of_iterations = 200;
    std::vector<Vector> right(unknowns.vertices.size(), Vector::Zero());
    if (right.empty())
      return right;
    std::vector<double> diagonal(right.size(), 0);
    const auto stiffness = stiffness_of_cells(unknowns);
    const Incidences incidences(m_region, unknowns);
    const Row_blocks<Entry> matrix(
        right.size(),
        [&, found = std::vector<Entry>()](std::size_t row, std::vector<Entry>& entries) mutable {
          found.clear(); // columns are numbers of vertices
          Borrowed_table<Numbered> places(m_region.size());
          incidences.for_each(row, [&](std::size_t c, int own) {
            for (int i = 0; i < Complex::corners; ++i) {
              if (i == own)
                continue;
              const Number v = m_region.corners(c)[i];
              if (places[v].epoch != places.epoch()) {
                places[v] = {places.epoch(), Number(found.size())};
                found.push_back({v, 0});
              }
              found[places[v].number].value += stiffness[c][Element::edge(own, i)];
            }
          });
          for (const Entry& e : found) {
            diagonal[row] -= e.value;
            if (!m_are_free[e.column])
              right[row] -= e.value * phases.deviation(m_phases[unknowns.vertices[row]], e.column);
            else
              entries.push_back({unknowns.rows[e.column], e.value});
          }
        },
        m_for_each_index);
    return Solver(matrix, diagonal, m_for_each_index)
        .solve(
            std::move(right),
            [&](std::size_t row, int axis) {
              const auto v = m_region.vertices()[unknowns.vertices[row]];
              return Boundary_class::fixes(v->boundary_class(), axis);
            },
            part, maximum_number_of_iterations);
  }

  const Region& m_region;
  const std::vector<Number>& m_free;
  const For_each_index& m_for_each_index;
  std::vector<char> m_are_free; // by number
  std::vector<Number> m_phases; // the phase of each free vertex, and one of those at other vertices
  std::size_t m_number_of_phases = 0;
  std::vector<typename Phases::Around> m_around;
  typename Phases::Vertices m_vertices;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

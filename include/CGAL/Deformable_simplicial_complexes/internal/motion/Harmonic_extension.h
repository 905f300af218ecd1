// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Conjugate_gradients.h>

#include <Eigen/Eigenvalues>

#include <boost/container/flat_map.hpp>

namespace CGAL::Deformable_simplicial_complexes::internal {

// For each phase, the affine motion that fits the motion of the surrounding interface best. A phase
// with other constraints, such as the boundary of the domain, has no affine motion.
template <int d> class Affine_phases
{
public:
  using Vector = Eigen::Matrix<double, d, 1>;

  // The number of a phase, and the number of a vertex at the phase that is not free.
  using Around = std::pair<std::uint32_t, std::uint32_t>;

  // The free vertices, followed by the vertices around them. `positions` and `are_constrained` have
  // an entry for each vertex, `known` has the displacement of each vertex that is not free.
  // `are_constrained` marks vertices that constrain their phase: free vertices that cannot move in
  // all directions, and other vertices that are not on the interface.
  struct Vertices
  {
    std::vector<Vector> positions, known;
    std::vector<char> are_constrained;
  };

  // A vertex may occur several times at a phase; its weight is the number of occurrences.
  Affine_phases(std::size_t number_of_phases, const std::vector<std::uint32_t>& phase_of_free,
                const std::vector<Around>& around, const Vertices& vertices)
      : m_vertices(vertices), m_number_of_free(phase_of_free.size()), m_phases(number_of_phases) {
    for (std::size_t i = 0; i < phase_of_free.size(); ++i)
      if (vertices.are_constrained[i])
        m_phases[phase_of_free[i]].is_constrained = true;
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
  const Vector& known(std::uint32_t v) const { return m_vertices.known[v - m_number_of_free]; }

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
  std::size_t m_number_of_free;
  std::vector<Phase> m_phases;
};

// Returns the other vertices of the stars of given vertices, by increasing time stamp. If there are
// many vertices, returns all other vertices of the complex, which is faster.
template <class Complex>
std::vector<typename Complex::Vertex_handle>
vertices_around(const Complex& complex,
                const std::vector<typename Complex::Vertex_handle>& vertices) {
  Marks seen = vertex_marks(complex);
  for (auto v : vertices)
    seen.add(v);
  std::vector<typename Complex::Vertex_handle> result;
  if (are_many(complex, vertices.size())) {
    for (typename Complex::Vertex_handle v : complex.finite_vertices())
      seen.add(v, result);
  } else {
    for (auto c : stars_of(complex, vertices))
      for (int i = 0; i < Complex::corners; ++i)
        seen.add(c->vertex(i), result);
  }
  sort_by_time_stamp(result);
  return result;
}

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
  using Displacement = typename Complex::Vector;
  static constexpr int d = Complex::dimension;

  // `free` are the vertices to which displacements are extended. `displacement(v)` returns the
  // displacement of any other vertex.
  template <class Known>
  Harmonic_extension(const Complex& complex, const std::vector<Vertex_handle>& free,
                     const Known& displacement, const For_each_index& for_each_index)
      : m_complex(complex), m_free(free), m_for_each_index(for_each_index),
        m_others(vertices_around(complex, free)), m_numbers(complex, free), m_labels(free.size()),
        m_neighbors(free.size(), neighbors(), for_each_index) {
    number_phases();
    find_vertices_around_phases();
    const std::size_t size = free.size() + m_others.size();
    m_vertices.positions.resize(size, Vector::Zero());
    m_vertices.are_constrained.resize(size);
    for_each_index(size, [&](std::size_t i) {
      const Vertex_handle v = i < free.size() ? free[i] : m_others[i - free.size()];
      // On a torus, no linear map except zero is well defined, so phases follow the mean
      // displacement.
      if (Complex::Domain::has_outside)
        m_vertices.positions[i] = coordinates(complex.position(v));
      m_vertices.are_constrained[i] = i < free.size() ? complex.is_boundary(v) : !v->is_interface();
    });
    m_vertices.known.reserve(m_others.size());
    for (Vertex_handle v : m_others) // in this thread, because users define flows
      m_vertices.known.push_back(coordinates(displacement(v)));
  }

  // Returns the displacements of the free vertices. Vertices on the boundary of the domain move
  // within their sides.
  std::vector<Displacement> solve() const {
    const Phases phases(m_number_of_phases, m_phases, m_around, m_vertices);
    const Unknowns unknowns(phases, m_phases);
    const std::vector<Vector> deviations = deviations_of(phases, unknowns);
    std::vector<Displacement> result(m_free.size());
    m_for_each_index(m_free.size(), [&](std::size_t i) {
      Vector motion = phases.motion(m_phases[i], std::uint32_t(i));
      if (unknowns.row[i] != Unknowns::none)
        motion += deviations[unknowns.row[i]];
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

  struct Neighbor
  {
    std::uint32_t vertex; // number
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
    for (std::size_t i = 0; i < m_others.size(); ++i)
      m_numbers.set(m_others[i], std::uint32_t(m_free.size() + i));
    return [this, star = std::vector<Cell_handle>(), found = std::vector<Vertex_handle>(),
            positions = std::vector<typename Complex::Point>(),
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
        m_labels[i] = c->subdomain_index();
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
        result.push_back({m_numbers(found[k]), weights[k]});
    };
  }

  // A free vertex is not on the interface, so all cells around it have the same label.
  void number_phases() {
    boost::container::flat_map<typename Complex::Label, std::uint32_t> numbers;
    for (const auto& label : m_labels)
      m_phases.push_back(numbers.emplace(label, std::uint32_t(numbers.size())).first->second);
    m_number_of_phases = numbers.size();
  }

  // Finds which of the other vertices are at which phases.
  void find_vertices_around_phases() {
    std::vector<std::uint32_t> last_phase(m_others.size(), Unknowns::none);
    for (std::uint32_t i = 0; i < m_free.size(); ++i)
      for (const Neighbor& n : m_neighbors.row(i))
        if (!is_free(n.vertex) &&
            std::exchange(last_phase[n.vertex - m_free.size()], m_phases[i]) != m_phases[i])
          m_around.emplace_back(m_phases[i], n.vertex);
  }

  bool is_free(std::uint32_t vertex) const { return vertex < m_free.size(); }

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
            diagonal[row] += n.weight;
            if (is_free(n.vertex))
              entries.push_back({unknowns.row[n.vertex], -n.weight});
            else
              right[row] += n.weight * phases.deviation(m_phases[i], n.vertex);
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
  std::vector<Vertex_handle> m_others;           // vertices with known displacements
  Vertex_numbers m_numbers;                      // free vertices first
  std::vector<typename Complex::Label> m_labels; // labels around free vertices
  Row_blocks<Neighbor> m_neighbors;
  std::vector<std::uint32_t> m_phases; // phases of free vertices
  std::size_t m_number_of_phases = 0;
  std::vector<typename Phases::Around> m_around;
  typename Phases::Vertices m_vertices;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_HARMONIC_EXTENSION_H

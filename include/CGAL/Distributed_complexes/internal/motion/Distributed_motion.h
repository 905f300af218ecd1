// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_MOTION_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_MOTION_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Distributed_complexes/internal/motion/Distributed_extension.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Exact_sums.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Origin.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The simultaneous motion of Algorithm 1 on a distributed complex. Vertices of the interface move
towards their destinations, and free vertices follow the given flow and the harmonic extension of
the deviation from it. Where a cell would be inverted or fall below the quality floor, the
displacements of its vertices are halved, and the displacements around them are reduced as
`Displacement_reduction` does. The reduction has a unique result, which does not depend on the
ranks. Patches later move the vertices with a remaining displacement.
*/
template <class Complex> class Distributed_motion
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;
  using Position = typename Complex::Point;
  using Vector = std::array<double, d>;
  using Flow = std::function<std::vector<Position>(const std::vector<Position>&)>;

  explicit Distributed_motion(Mesh& mesh) : m_mesh(mesh) {}

  // Moves the vertices. `flow` gives destinations of points of space; it may be empty. Afterwards,
  // `moved()` tells which vertices moved.
  void run(const Flow& flow) {
    m_is_interface = m_mesh.interface_flags();
    m_has_moved.assign(m_mesh.piece.vertex_bound(), 0);
    if (!find_free_vertices())
      return;
    find_displacements(flow);
    reduce_displacements();
    commit();
  }

  const std::vector<std::uint8_t>& moved() const { return m_has_moved; }

private:
  using Operation = Communicator::Operation;

  bool is_moving(Index v) const { return m_is_interface[v] && m_mesh.piece.vertex(v).is_open; }

  Vector remaining(Index v) const {
    Vector result;
    for (int k = 0; k < d; ++k)
      result[k] = m_mesh.piece.vertex(v).destination[k] - m_mesh.piece.vertex(v).point[k];
    return result;
  }

  static double length(const Vector& x) {
    double sum = 0;
    for (double coordinate : x)
      sum += coordinate * coordinate;
    return std::sqrt(sum);
  }

  // Finds the free vertices near the moving ones, as `free_vertices_near()` does. Returns whether
  // any vertex moves.
  bool find_free_vertices() {
    static constexpr double most = 6; // layers
    static constexpr std::int64_t much = 16;
    double layers = 0;
    std::vector<std::int64_t> numbers(2, 0); // of moving vertices, of vertices
    unsigned moving_sides = 0;
    m_longest = 0;
    for (Index v : m_mesh.own_vertices()) {
      ++numbers[1];
      if (!is_moving(v))
        continue;
      ++numbers[0];
      moving_sides |= m_mesh.piece.vertex(v).boundary_class;
      const double distance = length(remaining(v));
      m_longest = (std::max)(m_longest, distance);
      const double edge = m_mesh.piece.vertex(v).spacing > 0 ? m_mesh.piece.vertex(v).spacing
                                                             : m_mesh.mean_interface_edge;
      layers = (std::max)(layers, (std::min)(most, 1 + std::ceil(2 * distance / edge)));
    }
    m_mesh.communicator->reduce(Operation::sum, numbers);
    if (numbers[0] == 0)
      return false;
    m_longest = maximum_of_ranks(*m_mesh.communicator, m_longest);
    layers = maximum_of_ranks(*m_mesh.communicator, layers);
    std::vector<std::int64_t> sides;
    for (int side = 0; side < 2 * d; ++side)
      sides.push_back(moving_sides >> side & 1);
    m_mesh.communicator->reduce(Operation::maximum, sides);
    moving_sides = 0;
    for (int side = 0; side < 2 * d; ++side)
      moving_sides |= unsigned(sides[side]) << side;

    const auto can_be_free = [&](Index v) {
      const auto boundary = m_mesh.piece.vertex(v).boundary_class;
      return !m_is_interface[v] &&
             (boundary == Boundary_class::inside ||
              ((boundary & moving_sides) != 0 && !Boundary_class::fixes_all(boundary, d)));
    };
    m_is_free.assign(m_mesh.piece.vertex_bound(), 0);
    if (numbers[0] * much > numbers[1]) {
      for (Index v = 0; v < m_mesh.piece.vertex_bound(); ++v)
        m_is_free[v] = m_mesh.piece.has_vertex(v) && can_be_free(v);
      return true;
    }
    std::vector<std::uint8_t> layer(m_mesh.piece.vertex_bound(), 0); // plus 1
    std::vector<Index> front, next;
    for (Index v : m_mesh.piece.vertices())
      if (is_moving(v)) {
        layer[v] = 1;
        front.push_back(v);
      }
    for (int k = 0; k < int(layers); ++k) {
      next.clear();
      for (Index v : front)
        m_mesh.for_each_neighbor(v, [&](Index w) {
          if (layer[w] == 0 && can_be_free(w)) {
            layer[w] = std::uint8_t(k + 2);
            next.push_back(w);
          }
        });
      // The owner of a ghost knows all its neighbors.
      m_mesh.ghosts.update(layer, [&](Index v) { next.push_back(v); });
      front.swap(next);
    }
    for (Index v = 0; v < m_mesh.piece.vertex_bound(); ++v)
      m_is_free[v] = layer[v] > 1;
    return true;
  }

  // Sets the displacements of moving and free vertices, and their targets.
  void find_displacements(const Flow& flow) {
    static constexpr double distant = 100; // in lengths of the longest displacement
    static constexpr double part = 1e-6;
    const Index n = m_mesh.piece.vertex_bound();
    std::vector<Vector> flows(flow ? n : 0, Vector{}); // where the flow is known
    std::vector<std::uint8_t> is_known(n, 0);
    if (flow) {
      std::vector<Index> vertices;
      std::vector<Position> positions;
      for (Index v : m_mesh.piece.vertices()) {
        vertices.push_back(v);
        positions.push_back(m_mesh.position(v));
      }
      std::vector<Position> destinations;
      m_mesh.communicator->call_together([&] {
        destinations = flow(positions);
        if (destinations.size() != positions.size())
          throw Error("the number of destinations of the flow differs from the number of points: "
                      "give one destination for each point");
      });
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (int k = 0; k < d; ++k)
          flows[vertices[i]][k] = destinations[i][k] - positions[i][k];
        is_known[vertices[i]] = length(flows[vertices[i]]) < distant * m_longest;
      }
    }
    // Free vertices at which the flow is unknown follow it by 0.
    m_displacements.assign(n, Vector{});
    for (Index v : m_mesh.piece.vertices()) {
      if (m_is_free[v])
        continue;
      Vector deviation = is_moving(v) ? remaining(v) : Vector{};
      if (is_known[v])
        for (int k = 0; k < d; ++k)
          deviation[k] -= flows[v][k];
      if (length(deviation) > part * m_longest)
        m_displacements[v] = deviation;
    }
    Distributed_extension<Complex>(m_mesh, m_is_free).extend(m_displacements);
    for (Index v : m_mesh.piece.vertices()) {
      if (m_is_free[v]) {
        for (int k = 0; k < d; ++k) {
          if (is_known[v])
            m_displacements[v][k] += flows[v][k];
          if (Boundary_class::fixes(m_mesh.piece.vertex(v).boundary_class, k))
            m_displacements[v][k] = 0;
        }
        if (!has_finite_coordinates(m_displacements[v]))
          m_displacements[v] = Vector{};
      } else {
        m_displacements[v] = is_moving(v) ? remaining(v) : Vector{};
      }
    }
  }

  // Returns the proposed position of a vertex.
  Vector target(Index v) const {
    const auto& vertex = m_mesh.piece.vertex(v);
    if (m_fractions[v] == 1 && is_moving(v))
      return vertex.destination;
    Vector result = vertex.point;
    for (int k = 0; k < d; ++k)
      result[k] += m_fractions[v] * m_displacements[v][k];
    return result;
  }

  Position target_position(Index v) const { return point_at<Complex>(target(v)); }

  static constexpr double smallest_fraction = 1. / 16; // smaller fractions are set to 0
  static constexpr double lead = .25; // of the edge length: maximum difference along an edge

  // Reduces displacements until no cell is inverted or degraded.
  void reduce_displacements() {
    m_fractions.assign(m_mesh.piece.vertex_bound(), 0);
    for (Index v : m_mesh.piece.vertices())
      if (m_displacements[v] != Vector{})
        m_fractions[v] = 1;
    std::vector<Index> suspects;
    for (Index c : m_mesh.piece.cells())
      if (moves(c))
        suspects.push_back(c);
    for (;;) {
      std::vector<Index> reduced;
      for (Index c : suspects)
        if (is_bad(c))
          for (Index v : m_mesh.piece.cell(c).vertices)
            if (m_mesh.is_own(v) && m_fractions[v] > 0)
              reduced.push_back(v);
      std::sort(reduced.begin(), reduced.end());
      reduced.erase(std::unique(reduced.begin(), reduced.end()), reduced.end());
      if (m_mesh.communicator->reduced(Operation::maximum, !reduced.empty()) == 0)
        return;
      for (Index v : reduced)
        set_fraction(v, m_fractions[v] / 2);
      const std::vector<Index> changed = propagate(reduced);
      suspects.clear();
      for (Index v : changed)
        suspects.insert(suspects.end(), m_mesh.piece.star(v).begin(), m_mesh.piece.star(v).end());
      std::sort(suspects.begin(), suspects.end());
      suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    }
  }

  // Bounds the fractions around reduced vertices of this rank. Returns all vertices with a reduced
  // fraction, including ghosts.
  std::vector<Index> propagate(const std::vector<Index>& reduced) {
    std::vector<Index> front = reduced, changed = reduced, next;
    for (;;) {
      m_mesh.ghosts.update(m_fractions, [&](Index v) {
        front.push_back(v);
        changed.push_back(v);
      });
      if (m_mesh.communicator->reduced(Operation::maximum, !front.empty()) == 0)
        return changed;
      while (!front.empty()) {
        next.clear();
        for (Index v : front)
          m_mesh.for_each_neighbor(v, [&](Index w) {
            if (m_mesh.is_own(w) && m_fractions[w] > 0 && follow(w, v)) {
              next.push_back(w);
              changed.push_back(w);
            }
          });
        front.swap(next);
      }
    }
  }

  // Bounds the fraction of a vertex by the fraction of its neighbor. Returns whether it was
  // reduced.
  bool follow(Index v, Index neighbor) {
    Vector edge;
    for (int k = 0; k < d; ++k)
      edge[k] = m_mesh.piece.vertex(neighbor).point[k] - m_mesh.piece.vertex(v).point[k];
    if (neighbor_stays(neighbor))
      return false;
    const double bound = m_fractions[neighbor] + lead * length(edge) / length(m_displacements[v]);
    if (!(m_fractions[v] > bound))
      return false;
    set_fraction(v, bound);
    return true;
  }

  // A vertex without a displacement does not hold its neighbors back.
  bool neighbor_stays(Index v) const { return m_displacements[v] == Vector{}; }

  void set_fraction(Index v, double fraction) {
    m_fractions[v] = fraction < smallest_fraction ? 0 : fraction;
  }

  bool moves(Index c) const {
    const auto& vertices = m_mesh.piece.cell(c).vertices;
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](Index v) { return m_fractions[v] > 0; });
  }

  bool is_bad(Index c) const {
    const auto proposed = [this](Index v) { return target_position(v); };
    return moves(c) && !(m_mesh.is_positive(c, proposed) &&
                         Complex::keeps_quality(m_mesh.quality(c), m_mesh.quality(c, proposed)));
  }

  void commit() {
    std::vector<Vector> targets(m_mesh.piece.vertex_bound());
    for (Index v : m_mesh.piece.vertices())
      targets[v] = target(v);
    for (Index v : m_mesh.piece.vertices()) {
      auto& vertex = m_mesh.piece.vertex(v);
      m_has_moved[v] = targets[v] != vertex.point;
      vertex.point = targets[v];
      vertex.is_open = is_moving(v) && vertex.point != vertex.destination;
    }
    for (Index c : m_mesh.piece.cells()) {
      auto& cell = m_mesh.piece.cell(c);
      if (std::none_of(cell.vertices.begin(), cell.vertices.end(),
                       [&](Index v) { return m_has_moved[v]; }))
        continue;
      const double quality = m_mesh.quality(c);
      if (is_essential_change(cell.data.noted_quality, quality)) {
        cell.data.noted_quality = float(quality);
        cell.data.failures = 0;
      }
    }
  }

  Mesh& m_mesh;
  std::vector<std::uint8_t> m_is_interface, m_is_free, m_has_moved;
  std::vector<Vector> m_displacements;
  std::vector<double> m_fractions; // of the displacement of each vertex
  double m_longest = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_MOTION_H

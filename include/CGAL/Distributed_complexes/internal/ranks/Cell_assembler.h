// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_CELL_ASSEMBLER_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_CELL_ASSEMBLER_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Distributed_complexes/Distributed_graph.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_components.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Exact_sums.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/Placement.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Builds a distributed complex from cells that all ranks contribute.
template <class Complex> class Cell_assembler
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;

  explicit Cell_assembler(Mesh& mesh) : m_mesh(mesh) {}

  // Sends the cells of this rank to the ranks that hold them.
  template <class Cells> void place(const Cells& cells) {
    static constexpr Global_id bound = Global_id(1) << 62;
    Communicator& communicator = *m_mesh.communicator;
    m_mesh.clear();
    communicator.call_together([&] {
      if (cells.points.size() != cells.ids.size() || cells.labels.size() != cells.cells.size())
        throw Error("the numbers of ids and points, or of cells and labels, differ");
      for (std::size_t v = 0; v < cells.ids.size(); ++v)
        if (cells.ids[v] >= bound || !has_finite_coordinates(cells.points[v]))
          throw Error("an id is too large, or a coordinate is not finite");
      for (const auto& cell : cells.cells)
        for (std::size_t v : cell)
          if (v >= cells.ids.size())
            throw Error("a cell refers to a vertex that does not exist");
    });
    Distributed_graph<d> graph;
    m_box = extent_of_ranks(communicator, extent_of<d>(cells.points));
    for (const auto& p : cells.points) {
      graph.weights.push_back(1);
      graph.positions.push_back(m_box.in_unit_cube(p));
    }
    // The owner of a vertex follows from its position, so all ranks find the same one.
    const std::vector<int> owners = Curve_partitioner()(communicator, graph);
    std::vector<Piece_vertex<d>> vertices(cells.ids.size());
    std::int64_t next = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      vertices[v] = Piece_vertex<d>{};
      vertices[v].id = cells.ids[v];
      vertices[v].owner = owners[v];
      vertices[v].point = coordinates_of<d>(cells.points[v]);
      vertices[v].boundary_class = m_box.sides(vertices[v].point);
      next = (std::max)(next, std::int64_t(cells.ids[v]) + 1);
    }
    m_mesh.next_id = Global_id(communicator.reduced(Communicator::Operation::maximum, next));
    std::vector<Sent_cell<d>> sent;
    for (std::size_t c = 0; c < cells.cells.size(); ++c) {
      sent.push_back(Sent_cell<d>{});
      for (int i = 0; i <= d; ++i)
        sent.back().vertices[i] = cells.ids[cells.cells[c][i]];
      sent.back().vertices = canonical_cell(sent.back().vertices);
      sent.back().data.label = cells.labels[c];
    }
    Placement<d> placement;
    communicator.call_together([&] { placement.add(vertices, sent); });
    placement.send(communicator, m_mesh.piece);
    m_mesh.find_ghosts();
  }

  // Checks the cells, and computes everything that follows from them.
  void complete() {
    m_mesh.domain_measure = m_box.measure();
    m_mesh.normalization = {};
    m_mesh.communicator->call_together([&] { check_cells(); });
    check_volume();
    measure_edges();
    Distributed_components<Complex>(m_mesh).update();
    m_mesh.are_components_known = true;
  }

private:
  // Checks the cells around the vertices of this rank.
  void check_cells() const {
    const auto& piece = m_mesh.piece;
    for (Index c = 0; c < piece.cell_bound(); ++c) {
      if (!m_mesh.is_positive(c, [&](Index v) { return m_mesh.position(v); }))
        throw Error("a cell is flat or negatively oriented: give its vertices in positive "
                    "orientation");
      const auto& vertices = piece.cell(c).vertices;
      for (int i = 0; i <= d; ++i) {
        unsigned sides = Boundary_class::fixed - 1;
        Index own = Piece<d>::none;
        for (int k = 0; k <= d; ++k)
          if (k != i) {
            sides &= piece.vertex(vertices[k]).boundary_class;
            if (m_mesh.is_own(vertices[k]))
              own = vertices[k];
          }
        if (own == Piece<d>::none)
          continue; // the rank does not hold all cells of the facet
        const int number = number_of_cells(own, vertices, i);
        if (number > 2)
          throw Error("more than two cells share a facet: give each cell once");
        if (number == 1 && sides == 0)
          throw Error("a facet inside the box has one cell: give cells that fill a box");
      }
    }
  }

  // Returns the number of cells with all of the vertices except the vertex `except`.
  int number_of_cells(Index v, const std::array<Index, d + 1>& vertices, int except) const {
    const auto& star = m_mesh.piece.star(v);
    return int(std::count_if(star.begin(), star.end(),
                             [&](Index c) { return m_mesh.piece.has_facet(c, vertices, except); }));
  }

  // Throws on all ranks unless the cells have the volume of the box.
  void check_volume() const {
    static constexpr double rounding = 1e-6;
    const Label_totals totals(m_mesh.domain_measure);
    std::int64_t units = 0;
    for (Index c : m_mesh.own_cells())
      units += totals.units(m_mesh.measure(c));
    units = m_mesh.communicator->reduced(Communicator::Operation::sum, units);
    if (!(std::abs(totals.volume_of(units) - m_mesh.domain_measure) <=
          rounding * m_mesh.domain_measure))
      throw Error("the cells do not fill a box, or they overlap: give cells that fill a box");
  }

  // Measures the qualities of cells, and the edges of the interface.
  void measure_edges() {
    auto& piece = m_mesh.piece;
    for (Index c = 0; c < piece.cell_bound(); ++c)
      piece.cell(c).data.noted_quality = float(m_mesh.quality(c));
    std::vector<std::array<double, 2>> sums; // lengths and numbers of edges of own facets
    double shortest = std::numeric_limits<double>::infinity();
    std::vector<float> spacings(piece.vertex_bound(), 0);
    for (Index v : m_mesh.own_vertices()) {
      if (!piece.has_several_labels(v))
        continue;
      double sum = 0;
      int number = 0;
      for (Index c : piece.star(v))
        for (int i = 0; i <= d; ++i) {
          const auto& vertices = piece.cell(c).vertices;
          if (vertices[i] == v || !is_interface(c, v, i))
            continue;
          for (int k = 0; k <= d; ++k)
            if (k != i && vertices[k] != v) {
              const double length =
                  std::sqrt((m_mesh.position(vertices[k]) - m_mesh.position(v)).squared_length());
              sum += length;
              ++number;
              shortest = (std::min)(shortest, length);
            }
        }
      if (number > 0) {
        spacings[v] = float(sum / number);
        sums.push_back({sum, double(number)});
      }
    }
    m_mesh.ghosts.update(spacings);
    for (Index v = 0; v < piece.vertex_bound(); ++v)
      piece.vertex(v).spacing = spacings[v];
    const auto all = Exact_sums<2>(*m_mesh.communicator)(sums);
    m_mesh.mean_interface_edge = all[1] > 0 ? all[0] / all[1] : 0;
    // The largest inverse belongs to the shortest edge.
    const double inverse =
        maximum_of_ranks(*m_mesh.communicator, std::isfinite(shortest) ? 1 / shortest : 0);
    m_mesh.minimum_interface_edge = inverse > 0 ? 1 / inverse : 0;
  }

  // Returns whether the facet opposite to a vertex of a cell around v has another label behind it.
  bool is_interface(Index cell, Index v, int opposite) const {
    const auto& piece = m_mesh.piece;
    const auto& star = piece.star(v);
    return std::any_of(star.begin(), star.end(), [&](Index c) {
      return piece.cell(c).data.label != piece.cell(cell).data.label &&
             piece.has_facet(c, piece.cell(cell).vertices, opposite);
    });
  }

  Mesh& m_mesh;
  Extent<d> m_box; // around all points
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_CELL_ASSEMBLER_H

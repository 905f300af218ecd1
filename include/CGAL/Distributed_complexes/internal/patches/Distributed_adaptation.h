// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_DISTRIBUTED_ADAPTATION_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_DISTRIBUTED_ADAPTATION_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch_rounds.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_components.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/Interface_adaptation.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/internal/interface/Curvature_lengths.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The cells of a patch that a treatment changes or tries to change: its active cells, and new cells
// away from the cut. Edges that end on the cut are not treated.
template <class Complex> class Treated_cells
{
public:
  using Cell_handle = typename Treated_patch<Complex>::Part::Cell_handle;

  // Must be constructed before the treatment.
  explicit Treated_cells(const Treated_patch<Complex>& patch) : m_patch(patch) {
    for (Cell_handle c : patch.part.finite_cells())
      m_last = (std::max)(m_last, c->time_stamp());
    for (Cell_handle c : patch.core)
      m_core.push(c);
  }

  // Calls f(c) for each cell that is there after the treatment.
  template <class Function> void for_each(const Function& f) const {
    for (const auto& item : m_core)
      if (m_patch.part.is_alive(item.cell, item.time_stamp))
        f(item.cell);
    for (Cell_handle c : m_patch.part.finite_cells())
      if (c->time_stamp() > m_last && !m_patch.part.is_constrained(c))
        f(c);
  }

private:
  const Treated_patch<Complex>& m_patch;
  Work_list<Cell_handle> m_core;
  std::size_t m_last = 0; // time stamp before the treatment
};

// Attempts that cells remember besides those of one complex.
inline constexpr Attempt to_control_detail = Attempt(4);
inline constexpr Attempt to_adapt_interface = Attempt(8);

// Changes the edges of cells in patches, without a motion. Calls mark_cells(), which sets
// `is_active` of the cells with an edge to be changed, and treats these cells in patches, apart
// from cells for which the attempt has failed. A patch cannot change an edge that ends on its cut,
// so this is repeated. Returns the numbers of operations of all ranks.
template <class Complex, class Mark>
Improvement_report remesh_in_patches(Distributed_mesh<Complex>& mesh, Attempt attempt,
                                     const Mark& mark_cells,
                                     const Patch_treatment<Complex>& treat) {
  static constexpr int most = 4; // repetitions; each leaves only edges on the cuts of its patches
  // If a motion ended with an exception, the next motion reports its events.
  const bool are_known = mesh.are_components_known;
  mesh.are_components_known = false;
  for (typename Piece<Complex::dimension>::Index v = 0; v < mesh.piece.vertex_bound(); ++v)
    mesh.piece.vertex(v).end_motion();
  Distributed_counts result;
  for (int i = 0; i < most; ++i) {
    mark_cells();
    for (typename Piece<Complex::dimension>::Index c = 0; c < mesh.piece.cell_bound(); ++c)
      if ((mesh.piece.cell(c).data.failures & attempt) != 0)
        mesh.piece.cell(c).data.is_active = false;
    std::vector<Topology_place<Complex::dimension>> places; // none, because no label changes
    const Distributed_counts counts = Patch_rounds<Complex>(mesh, treat, 0, places).run();
    if (counts.patches == 0)
      break;
    result += counts;
  }
  if (are_known && result.patches > 0) // measures the new volumes
    Distributed_components<Complex>(mesh).update();
  mesh.are_components_known = are_known;
  return {std::size_t(result.split), std::size_t(result.collapsed), std::size_t(result.flipped),
          std::size_t(result.smoothed), std::size_t(result.inserted)};
}

// The adaptation of `Interface_adaptation` on several ranks. The target edge length of a vertex is
// bitwise identical on all ranks that hold the vertex.
template <class Complex> class Distributed_adaptation
{
public:
  static constexpr int d = Complex::dimension;
  using Distributed = Distributed_complex<Complex>;
  using Interface = typename Distributed::Interface;
  using Part = typename Distributed::Part;
  using Position = typename Complex::Point;

  Distributed_adaptation(Distributed& dsc, const Interface& interface_,
                         const Adaptation_options& options)
      : m_dsc(dsc), m_interface(interface_), m_options(options), m_edge(dsc.mean_interface_edge()),
        m_lengths(interface_.snapshot, interface_.positions, smooth_normals(),
                  options.tolerance * m_edge, Rule::shortest * m_edge),
        m_sizes(sizes(Rule::longest)) {}

  // Returns the target edge lengths of the vertices of the interface here.
  const std::vector<double>& target_lengths() const { return m_sizes; }

  // Returns whether the interface is worn, see `Interface_adaptation::is_worn()`.
  bool is_worn() const {
    const std::vector<double> sizes_if_flat = sizes(Rule::longest_if_flat * Rule::longest);
    std::vector<typename Interface_vertices<Complex>::Facet> facets;
    for (const auto& facet : m_interface.snapshot.facets())
      if (m_dsc.owns(m_interface, facet))
        facets.push_back(facet);
    Interface_wear<d> wear;
    for_each_edge_of(facets, [&](std::size_t a, std::size_t b) {
      wear.add(std::sqrt((m_interface.positions[b] - m_interface.positions[a]).squared_length()),
               (std::min)(m_sizes[a], m_sizes[b]), (std::min)(sizes_if_flat[a], sizes_if_flat[b]));
    });
    std::vector<std::int64_t> numbers = {wear.edges, wear.short_ones, wear.long_ones};
    m_dsc.communicator().reduce(Communicator::Operation::sum, numbers);
    wear.edges = numbers[0];
    wear.short_ones = numbers[1];
    wear.long_ones = numbers[2];
    return wear.is_large();
  }

  // Splits long edges and collapses short edges, see `Interface_adaptation::apply()`. Returns the
  // numbers of operations of all ranks.
  Improvement_report apply() {
    auto& piece = m_dsc.mesh().piece;
    for (Index v = 0; v < piece.vertex_bound(); ++v)
      piece.vertex(v).target_length = 0;
    for (std::size_t i = 0; i < m_sizes.size(); ++i)
      piece.vertex(m_interface.indices[i]).target_length = m_sizes[i];
    for (Index c = 0; c < piece.cell_bound(); ++c)
      piece.cell(c).data.failures &= std::uint8_t(~to_adapt_interface);
    return remesh_in_patches<Complex>(
        m_dsc.mesh(), to_adapt_interface, [this] { mark_cells(); },
        [this](Treated_patch<Complex>& patch) { treat(patch); });
  }

private:
  using Rule = Adaptation_rule<d>;
  using Index = typename Piece<d>::Index;

  Smooth_normals<Complex> smooth_normals() const {
    Smooth_normals<Complex> result(m_interface.snapshot, m_interface.positions,
                                   m_options.feature_angle);
    m_dsc.share(m_interface, result.normals);
    m_dsc.share(m_interface, result.is_smooth);
    return result;
  }

  // Returns the target edge lengths of the vertices. `longest` is in mean edges. A reduced length
  // of a ghost can reduce the lengths of its neighbors. The length at a vertex is a minimum over
  // all paths from other vertices, so it does not depend on the order of the reductions.
  std::vector<double> sizes(double longest) const {
    std::vector<double> result = m_lengths.graded(longest * m_edge, Rule::gradation);
    for (bool is_changing = true; is_changing;) {
      m_dsc.share(m_interface, result);
      const std::vector<double> before = result;
      m_lengths.grade(result, Rule::gradation);
      bool has_changed = false;
      for (std::size_t v = 0; v < result.size(); ++v)
        has_changed =
            has_changed || (result[v] != before[v] && m_dsc.mesh().is_own(m_interface.indices[v]));
      is_changing =
          m_dsc.communicator().reduced(Communicator::Operation::maximum, has_changed) != 0;
    }
    return result;
  }

  // Returns whether an edge between two vertices is too long or too short, if it is on the
  // interface.
  bool is_too_long_or_short(Index v, Index w) const {
    const auto &a = m_dsc.mesh().piece.vertex(v), &b = m_dsc.mesh().piece.vertex(w);
    if (!(a.target_length > 0 && b.target_length > 0))
      return false;
    const double length =
        std::sqrt((m_dsc.mesh().position(w) - m_dsc.mesh().position(v)).squared_length());
    const double target = (std::min)(a.target_length, b.target_length);
    return length > Rule::split * target || length < Rule::collapse * target;
  }

  // Marks the cells with an edge of the interface that is too long or too short.
  void mark_cells() {
    auto& mesh = m_dsc.mesh();
    const auto has_such_edge = mesh.vertices_with_edge([&](Index v, Index w) {
      return is_too_long_or_short(v, w) && mesh.piece.has_several_labels(v, w);
    });
    mesh.activate_cells_with_edge([&](Index v, Index w) {
      return has_such_edge[v] && has_such_edge[w] && is_too_long_or_short(v, w);
    });
  }

  void treat(Treated_patch<Complex>& patch) const {
    const Treated_cells<Complex> cells(patch);
    std::vector<Position> points;
    std::vector<double> lengths;
    Global_id last = 0;
    for (const auto& v : patch.vertices) {
      // The vertices are ordered by their ids, followed by copies.
      if (v.data.target_length > 0 && (points.empty() || v.data.id > last)) {
        points.push_back(patch.part.position(v.handle));
        lengths.push_back(v.data.target_length);
        last = v.data.id;
      }
    }
    const Curvature_sizing_field<d> field(points, lengths, Rule::longest * m_edge);
    patch.counts += remesh_interface(patch.part, remeshing_options<Part>(field, m_options));
    cells.for_each([](auto c) { set_exhausted(c, to_adapt_interface); });
    patch.target_length = [part = &patch.part, field](typename Part::Vertex_handle v) {
      return v->is_interface() ? field(part->position(v)) : 0;
    };
  }

  Distributed& m_dsc;
  const Interface& m_interface;
  Adaptation_options m_options;
  double m_edge;
  Curvature_lengths<Complex> m_lengths;
  std::vector<double> m_sizes;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_DISTRIBUTED_ADAPTATION_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_INTERFACE_DEFORMER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_INTERFACE_DEFORMER_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/Deformation_remesher.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Contacts.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Moving_region.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Proposed_motion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/collision_order.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/displacement_extension.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/simultaneous_motion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/swept_volume.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Trapped_cells.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Domain_box.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A clock that measures wall-clock time in seconds, from lap to lap.
class Stopwatch
{
public:
  // Adds the seconds since the last lap, or since construction.
  void lap(double& seconds) {
    const Clock::time_point now = Clock::now();
    seconds += std::chrono::duration<double>(now - m_start).count();
    m_start = now;
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point m_start = Clock::now();
};

// A vertex of the interface with a destination in a motion that began earlier.
template <class Complex> struct Moved_vertex
{
  typename Complex::Vertex_handle vertex;
  typename Complex::Point before, destination; // `before` the motion
  bool is_open;                                // whether the destination can still be reached
};

// The steps of Algorithm 1. `do_passes()` performs them in their order.
template <class Complex> class Interface_deformer
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Complex::Point;
  using Report = Deformation_report<Complex>;

  Interface_deformer(Complex& complex, Deformation_visitor<Complex>& visitor,
                     const Deformation_options<Complex>& options,
                     const For_each_index& for_each_index)
      : m_complex(complex), m_visitor(visitor), m_options(options), m_destinations(complex),
        m_rigid_components(complex, m_destinations), m_contacts(complex, m_destinations),
        m_mesh(complex, visitor, m_destinations, m_rigid_components, options, for_each_index),
        m_trapped_cells(complex, visitor, m_destinations, m_contacts, m_rigid_components,
                        m_options),
        m_for_each_index(for_each_index) {}

  Interface_deformer(const Interface_deformer&) = delete;
  Interface_deformer& operator=(const Interface_deformer&) = delete;

  // Sets the destinations of the interface vertices. A destination outside the box of the domain is
  // replaced by the nearest point of the box, where the interface stops. Throws
  // `Invalid_destination_error` if a destination is not finite or not permitted by the rule of the
  // domain; nothing is changed then.
  void set_destinations(const std::vector<Vertex_handle>& vertices,
                        const std::vector<typename Complex::Point>& destinations) {
    require_finite(destinations, "a destination");
    const Domain_box<Complex> box(m_complex);
    if (m_options.domain_rule != Domain_rule::stop)
      if (const auto leaving = box.leaving(vertices, destinations); !leaving.empty())
        throw Invalid_destination_error("the interface would leave the domain: use a larger box, "
                                        "let it grow, or let the interface stop at its sides",
                                        leaving);
    m_trapped_cells.log().begin();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      Point destination = m_complex.admissible_destination(vertices[i], destinations[i]);
      m_stopped_at_boundary += box.clamp(destination);
      m_destinations.add(vertices[i], destination);
    }
    record_swept_volumes();
  }

  // Continues a motion that began elsewhere: the complex is a part of another complex, in which the
  // vertices have moved together. The vertices are given by increasing time stamp. The given cells
  // are improved.
  void resume(const std::vector<Moved_vertex<Complex>>& vertices,
              const std::vector<Cell_handle>& cells) {
    m_trapped_cells.log().begin();
    for (const Moved_vertex<Complex>& moved : vertices)
      m_destinations.resume(moved.vertex, moved.before, moved.destination, moved.is_open);
    for (Cell_handle c : cells)
      m_touched.push(c);
  }

  // Adds the wall-clock time since the last call to one of the times of the report.
  void lap(double Report::Seconds::*part) { m_stopwatch.lap(m_seconds.*part); }

  bool is_complete() const { return unfinished().empty(); }

  // Returns whether vertices still approach their destinations. Returns false after two successive
  // passes that could remove interface facets but reduced the remaining distance by less than 1 %
  // each.
  bool is_progressing() const { return m_idle_passes < 2; }

  // Returns whether all vertices follow the flow in a pass.
  bool is_moving_all(unsigned pass) const {
    return pass == 1 && m_options.flow && m_options.flow_moves_all;
  }

  // Returns whether a pass has something to do: vertices to move, or cells to improve.
  bool has_work(unsigned pass) const {
    return !is_complete() || is_moving_all(pass) || (pass == 1 && !m_touched.empty());
  }

  // Prepares the mesh for a pass.
  void begin_pass(unsigned pass) { m_mesh.begin_pass(pass); }

  // Moves interface vertices and free vertices simultaneously, which completes the largest part of
  // most motions. In the first pass, free vertices follow the flow of the space if it is given.
  void move_together(unsigned pass) {
    // In lengths of the longest displacement. Larger displacements by the flow are ignored, except
    // if all vertices follow the flow.
    static constexpr double distant = 100;
    const bool moves_all = is_moving_all(pass);
    if (is_complete() && !moves_all)
      return;
    const std::vector<Vertex_handle>& vertices = unfinished();
    std::vector<Vertex_handle> free;
    double longest = 0;
    if (!vertices.empty()) {
      const std::size_t farthest = m_destinations.farthest();
      longest = m_destinations.remaining_distance(farthest);
      free = free_vertices_near(m_complex, vertices, number_of_layers(vertices[farthest], longest));
    }
    const typename Flow_displacements<Complex>::Flow no_flow;
    Flow_displacements<Complex> flow(m_complex, pass > 1 ? no_flow : m_options.flow,
                                     moves_all ? std::numeric_limits<double>::infinity()
                                               : distant * longest);
    if (moves_all)
      free = with_vertices_of_flow(free, flow);
    const auto remaining = [&](Vertex_handle v) {
      return m_complex.displacement(v, m_destinations.final_position(v));
    };
    std::vector<Vertex_handle> movable = free;
    movable.insert(movable.end(), vertices.begin(), vertices.end());
    const Moving_region<Complex> region(m_complex, movable, m_for_each_index);
    lap(&Report::Seconds::motion);
    const auto displacements =
        displacement_extension(region, free, remaining, flow, longest, m_for_each_index);
    lap(&Report::Seconds::extension);
    std::vector<Point> targets;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const Point target = m_complex.position(free[i]) + displacements[i];
      targets.push_back(has_finite_coordinates(target)
                            ? m_complex.admissible_destination(free[i], target)
                            : m_complex.position(free[i]));
    }
    for (std::size_t k = 0; k < vertices.size(); ++k)
      targets.push_back(m_destinations.destination(k));
    Proposed_motion<Complex> motion(m_complex, region, targets, m_for_each_index);
    m_obstructing.clear();
    for (Cell_handle c : move_simultaneously(motion, [&](const std::vector<Cell_handle>& bad) {
           return is_rigid(motion.cells(), bad);
         }))
      m_obstructing.push(c);
    m_obstructing.sort();
    for (Cell_handle c : motion.cells())
      touch(c);
    update_destinations();
  }

  // Moves the remaining vertices one at a time (Algorithm 2). Does nothing if all vertices have
  // moved by the same fraction of a rigid motion. A vertex of a cell flat enough to be relabeled
  // moves only if it reaches its destination, since a partial move would gain nothing.
  void move_one_by_one() {
    // fraction of the distance to a flat cell that is left, so that the cell can still be improved
    static constexpr double margin = .25;
    if (!m_obstructing.empty())
      return;
    std::vector<Vertex_handle> vertices = unfinished();
    if (m_options.collision_order)
      sort_by_first_collision(m_complex, m_destinations, vertices);
    for (Vertex_handle v : vertices) {
      Progress_scope::check();
      m_complex.star(v, m_star);
      const bool is_at_contact = std::any_of(m_star.begin(), m_star.end(), [&](Cell_handle c) {
        return !m_complex.is_infinite(c) && c->quality() < m_options.relabeling_threshold;
      });
      if (is_at_contact && !m_complex.is_positive_star(v, m_star, m_destinations[v]))
        continue;
      m_complex.move_vertex(v, m_destinations[v], margin, Complex::quality_floor);
      for (Cell_handle c : m_star)
        if (!m_complex.is_infinite(c))
          touch(c);
    }
    update_destinations();
  }

  // Relabels cells that were flattened between two regions of the interface. The topology changes
  // here.
  void relabel_degenerate_cells(unsigned pass) {
    m_touched.sort();
    relabel(m_touched, m_options.relabeling_threshold);
    find_events(pass);
    update_destinations();
  }

  // Removes obstacles that keep vertices from their destinations:
  // - cells that the interface is about to sweep over;
  // - small angles and short edges where the interface folds;
  // - free vertices trapped by the interface.
  //
  // Regions that move rigidly keep their facets. If there is no bound on facet angles, interface
  // facets are removed only after the second pass, because the other operations often suffice.
  void remove_obstacles(unsigned pass) {
    m_may_remove_facets = m_options.minimum_facet_angle > 0 || pass > 2;
    static constexpr double swept = .3; // quality below which an obstructing cell may be relabeled
    Work_list<Cell_handle> cells;
    for (Vertex_handle v : unfinished()) {
      m_complex.star(v, m_star);
      for (Cell_handle c : m_star)
        if (!m_complex.is_infinite(c))
          cells.push(c);
    }
    cells.sort();
    relabel(cells, swept);
    m_trapped_cells.remove_vanishing_components(handles(cells));
    find_events(pass);
    update_destinations();
    for (const auto& item : m_obstructing)
      if (!is_complete() && m_complex.is_alive(item.cell, item.time_stamp) &&
          m_rigid_components.moves_rigidly(item.cell))
        m_mesh.improver().open_obstructing_cell(item.cell, m_touched);
    for (const auto& item : cells) {
      Progress_scope::check();
      if (m_complex.is_alive(item.cell, item.time_stamp))
        m_mesh.remove_obstacle(item.cell,
                               m_may_remove_facets && !m_rigid_components.moves_rigidly(item.cell),
                               m_touched);
    }
  }

  // Removes interface facets that got small angles by the motion.
  void remove_degenerating_facets() { m_mesh.remove_degenerating_facets(m_touched); }

  // Reconnects, smooths, collapses and splits cells around the moved vertices.
  void improve() {
    static constexpr unsigned rounds = 3;
    m_mesh.improver().improve(std::move(m_touched), rounds);
    m_touched.clear();
    update_destinations();
    const double distance = m_destinations.remaining_distance();
    static constexpr double same = .99; // maximum ratio of distances that counts as progress
    const bool is_idle = m_may_remove_facets && distance > same * m_last_distance;
    m_idle_passes = is_idle ? m_idle_passes + 1 : 0;
    m_last_distance = distance;
  }

  // Exchanges neighbors in 2D, where regions have separated and others have met.
  void exchange_neighbors() {
    m_mesh.exchange_neighbors(m_destinations.moved(), m_trapped_cells.log());
    update_destinations();
  }

  // Removes small angles that remain after the passes, except in regions that moved rigidly.
  void remove_small_angles(unsigned pass) {
    static constexpr double any_quality = 2;
    const Work_list<Cell_handle> cells = m_mesh.cells_with_small_angles();
    if (cells.empty())
      return;
    if (m_options.relabeling_threshold > 0)
      m_trapped_cells.relabel(handles(cells), any_quality, any_quality);
    find_events(pass);
    m_mesh.remove_small_angles([&](Cell_handle c, typename Complex::Label label) {
      return m_trapped_cells.relabel_if_topology_stays(c, label);
    });
    update_destinations();
  }

  // Measures the interface edges at vertices that have joined the interface since it was built.
  void measure_new_spacings() {
    for (Vertex_handle v : m_complex.finite_vertices())
      if (v->is_interface() && !(v->spacing() > 0))
        Simplex_access::set_spacing(v, float(m_complex.interface_edge_length(v)));
  }

  Report report(unsigned passes) {
    Report report;
    report.passes = passes;
    for (std::size_t k = 0; k < unfinished().size(); ++k)
      report.unfinished.push_back({unfinished()[k], m_destinations.remaining_distance(k)});
    for (Cell_handle c : m_complex.flat_cells())
      report.flat.push_back({c, c->quality()});
    report.vanished = m_vanished;
    report.merged = m_merged;
    report.stopped_at_boundary = m_stopped_at_boundary;
    report += m_mesh.report();
    report.relocated = m_mesh.number_of_relocated();
    report.exchanges = m_mesh.exchanges();
    report.relabeled = m_trapped_cells.number_of_relabeled();
    m_trapped_cells.log().report(passes, report);
    report.complete =
        report.unfinished.empty() && m_stopped_at_boundary == 0 && report.is_balanced();
    lap(&Report::Seconds::rest);
    report.seconds = m_seconds;
    return report;
  }

private:
  void record_swept_volumes() {
    const auto is_at_interface = [](Cell_handle c) {
      for (int i = 0; i < Complex::corners; ++i)
        if (c->neighbor(i)->subdomain_index() < c->subdomain_index())
          return true;
      return false;
    };
    std::vector<Cell_handle> cells =
        star_union_if(m_complex, unfinished(), is_at_interface, m_for_each_index);
    sort_by_time_stamp(cells);
    add_swept_volumes(
        m_complex, cells, [&](Vertex_handle v) { return m_destinations.final_position(v); },
        [&](typename Complex::Label label, double volume) {
          m_trapped_cells.log().record_swept(label, volume);
        });
  }

  void find_events(unsigned pass) { m_trapped_cells.log().find_events(pass, m_visitor); }

  const std::vector<Vertex_handle>& unfinished() const { return m_destinations.unfinished(); }
  void update_destinations() {
    const auto lost = m_destinations.update();
    m_vanished += lost.removed;
    m_merged += lost.merged;
  }

  // Relabels trapped cells below a quality that the motion closes.
  void relabel(const Work_list<Cell_handle>& cells, double threshold) {
    if (m_options.relabeling_threshold > 0)
      m_trapped_cells.relabel(handles(cells), threshold, m_options.relabeling_threshold);
  }

  // Returns whether the motion keeps the facets of the interface among cells, and no parts of the
  // interface that move differently meet in the bad ones.
  bool is_rigid(const std::vector<Cell_handle>& cells, const std::vector<Cell_handle>& bad) const {
    return std::none_of(bad.begin(), bad.end(),
                        [&](Cell_handle c) { return m_rigid_components.is_distorted(c); }) &&
           std::all_of(cells.begin(), cells.end(), [&](Cell_handle c) {
             for (int i = 0; i < Complex::corners; ++i)
               if (const Cell_handle n = c->neighbor(i);
                   n->subdomain_index() < c->subdomain_index() && !m_complex.is_infinite(n) &&
                   !m_rigid_components.keeps_facet(c, i))
                 return false;
             return true;
           });
  }

  // Returns the number of layers of free vertices around a vertex that follow its displacement. A
  // longer displacement needs more layers, because more space must give way.
  unsigned number_of_layers(Vertex_handle v, double displacement) const {
    static constexpr double most = 6;
    return unsigned(
        (std::min)(most, 1 + std::ceil(2 * displacement / local_edge_length(m_complex, v))));
  }

  // Adds all free vertices whose displacement by the flow is known to a list of free vertices.
  std::vector<Vertex_handle> with_vertices_of_flow(const std::vector<Vertex_handle>& nearby,
                                                   Flow_displacements<Complex>& flow) const {
    std::vector<Vertex_handle> all;
    for (Vertex_handle v : m_complex.finite_vertices())
      if (!v->is_interface() && !Boundary_class::fixes_all(v->boundary_class(), Complex::dimension))
        all.push_back(v);
    flow.find(all);
    std::vector<Vertex_handle> result = nearby;
    std::copy_if(all.begin(), all.end(), std::back_inserter(result), [&](Vertex_handle v) {
      return flow(v) && !std::binary_search(nearby.begin(), nearby.end(), v, Less_time_stamp());
    });
    sort_by_time_stamp(result);
    return result;
  }

  static std::vector<Cell_handle> handles(const Work_list<Cell_handle>& cells) {
    std::vector<Cell_handle> result;
    for (const auto& item : cells)
      result.push_back(item.cell);
    return result;
  }

  void touch(Cell_handle c) {
    if (m_mesh.improver().is_bad(c) || c->quality() < m_options.relabeling_threshold)
      m_touched.push(c);
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  Deformation_options<Complex> m_options;
  Destinations<Complex> m_destinations;
  Rigid_components<Complex> m_rigid_components;
  Contacts<Complex> m_contacts;
  Deformation_remesher<Complex> m_mesh;
  Trapped_cells<Complex> m_trapped_cells;
  const For_each_index& m_for_each_index;
  Work_list<Cell_handle> m_touched;
  std::vector<Cell_handle> m_star;
  Stopwatch m_stopwatch;
  typename Report::Seconds m_seconds;
  double m_last_distance = std::numeric_limits<double>::infinity();
  unsigned m_idle_passes = 0;
  bool m_may_remove_facets = true;
  Work_list<Cell_handle> m_obstructing; // cells that keep a rigid motion from being completed
  std::size_t m_vanished = 0, m_merged = 0, m_stopped_at_boundary = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_INTERFACE_DEFORMER_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_DEFORMER_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_DEFORMER_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Distributed_complexes/Distributed_report.h>
#include <CGAL/Distributed_complexes/internal/motion/Distributed_motion.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch_rounds.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_components.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Exact_sums.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Algorithm 1 on a distributed complex.
template <class Complex> class Distributed_deformer
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;
  using Position = typename Complex::Point;
  using Part = typename Part_of<Complex>::Type;
  using Options = Deformation_options<Part>;
  using Flow = typename Distributed_motion<Complex>::Flow;
  using Report = Distributed_report<Complex>;

  Distributed_deformer(Mesh& mesh, const Options& options)
      : m_mesh(mesh), m_options(options), m_most_passes(options.maximum_number_of_passes) {
    mesh.communicator->call_together([&] { options.check(); });
    m_options.maximum_number_of_passes =
        (std::min)(passes_of_patch, options.maximum_number_of_passes);
    m_options.flow = nullptr;
  }

  // Sets the destinations of vertices. The owner of a ghost gives its destination.
  // Throws Error on all ranks if a destination is not finite; nothing changes then.
  void set_destinations(const std::vector<Index>& vertices,
                        const std::vector<Position>& destinations) {
    std::string error;
    if (destinations.size() != vertices.size())
      error = "the number of destinations differs from the number of interface vertices: give one "
              "destination for each vertex";
    for (std::size_t i = 0; i < vertices.size() && error.empty(); ++i)
      if (m_mesh.is_own(vertices[i]) && !has_finite_coordinates(destinations[i]))
        error = "a destination is not finite: correct the velocity or the destination";
    m_mesh.communicator->agree_on_error(error);
    find_box();
    std::vector<std::array<double, d>> targets(m_mesh.piece.vertex_bound());
    std::vector<std::uint8_t> has_motion(m_mesh.piece.vertex_bound(), 0);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (m_mesh.is_own(vertices[i])) {
        targets[vertices[i]] = admissible(vertices[i], coordinates_of<d>(destinations[i]));
        has_motion[vertices[i]] = targets[vertices[i]] != m_mesh.piece.vertex(vertices[i]).point;
      }
    m_mesh.ghosts.update(targets);
    m_mesh.ghosts.update(has_motion);
    for (Index v = 0; v < m_mesh.piece.vertex_bound(); ++v) {
      auto& vertex = m_mesh.piece.vertex(v);
      vertex.has_motion = vertex.is_open = has_motion[v];
      vertex.before = has_motion[v] ? vertex.point : std::array<double, d>{};
      vertex.destination = has_motion[v] ? targets[v] : std::array<double, d>{};
      vertex.work *= forgetting;
    }
  }

  // Moves the vertices. Returns the report.
  Report run(const Flow& flow) {
    static constexpr double same = .99; // maximum ratio of distances that counts as progress
    static constexpr unsigned most_idle = 2;
    Report report;
    begin_labels(report);
    if (!m_mesh.are_components_known) // the events of a motion that ended with an exception
      find_events(report);
    m_mesh.are_components_known = false;
    double last = std::numeric_limits<double>::infinity();
    unsigned idle = 0;
    measure_remaining(report);
    while (report.unfinished > 0 && idle < most_idle && report.passes < m_most_passes) {
      ++report.passes;
      Distributed_motion<Complex> motion(m_mesh);
      motion.run(report.passes == 1 ? flow : Flow());
      activate(motion.moved());
      report += Patch_rounds<Complex>(
                    m_mesh, [this](auto& patch) { treat(patch); }, report.passes, m_places)
                    .run();
      measure_remaining(report);
      idle = m_remaining > same * last ? idle + 1 : 0;
      last = m_remaining;
    }
    report.complete = report.unfinished == 0;
    if (report.patches > 0)
      find_events(report); // measures volumes, too
    else
      find_volumes();
    m_mesh.are_components_known = true;
    end_labels(report);
    std::vector<std::int64_t> numbers = {0, m_stopped_at_boundary};
    for (Index c : m_mesh.own_cells())
      numbers[0] += m_mesh.quality(c) < Complex::quality_floor;
    m_mesh.communicator->reduce(Communicator::Operation::sum, numbers);
    report.flat = numbers[0];
    report.stopped_at_boundary = numbers[1];
    return report;
  }

private:
  using Operation = Communicator::Operation;

  static constexpr float forgetting = .5;        // of the work of earlier motions
  static constexpr unsigned passes_of_patch = 3; // more passes follow after the next motion

  // Finds the box that is the domain.
  void find_box() {
    std::vector<std::int64_t> is_box(1, 1);
    for (Index v : m_mesh.own_vertices())
      if ((m_mesh.piece.vertex(v).boundary_class & Boundary_class::fixed) != 0)
        is_box[0] = 0;
    m_box = m_mesh.extent();
    m_mesh.communicator->reduce(Operation::minimum, is_box);
    m_is_box = is_box[0] != 0;
  }

  std::array<double, d> admissible(Index v, std::array<double, d> p) {
    const auto& vertex = m_mesh.piece.vertex(v);
    bool is_stopped = false;
    for (int k = 0; k < d; ++k) {
      if (Boundary_class::fixes(vertex.boundary_class, k))
        p[k] = vertex.point[k];
      const double x = p[k];
      if (m_is_box)
        p[k] = std::clamp(x, m_box.lower(k), m_box.upper(k));
      is_stopped = is_stopped || p[k] != x;
    }
    m_stopped_at_boundary += is_stopped;
    return p;
  }

  // Marks the cells to be improved: moved cells of low quality, and cells around vertices that did
  // not arrive.
  void activate(const std::vector<std::uint8_t>& has_moved) {
    for (Index c : m_mesh.piece.cells()) {
      auto& cell = m_mesh.piece.cell(c);
      bool is_moved = false, is_open = false;
      for (Index v : cell.vertices) {
        is_moved = is_moved || has_moved[v];
        is_open = is_open || m_mesh.piece.vertex(v).is_open;
      }
      cell.data.is_active = is_open || (is_moved && is_to_be_improved(c));
    }
  }

  bool is_to_be_improved(Index c) const {
    const double quality = m_mesh.quality(c);
    const std::uint8_t failures = m_mesh.piece.cell(c).data.failures;
    if (quality < m_options.relabeling_threshold)
      return true;
    return quality < m_options.quality_threshold &&
           ((failures & to_improve_quality) == 0 ||
            ((failures & to_remove_small_angles) == 0 && has_small_angle(c)));
  }

  bool has_small_angle(Index c) const {
    if constexpr (d == 3) {
      return apply_to_corners<d + 1>(
                 Minimum_sine_3(),
                 [&](int i) { return m_mesh.position(m_mesh.piece.cell(c).vertices[i]); }) *
                 sine_of_regular <
             std::sin(m_options.minimum_angle * CGAL_PI / 180);
    } else {
      return m_options.minimum_angle > 0;
    }
  }

  // Continues the motion in a patch. Only vertices of active cells may still move.
  void treat(Treated_patch<Complex>& patch) const {
    std::vector<Moved_vertex<Part>> moved;
    for (const auto& v : patch.vertices)
      if (v.data.has_motion)
        moved.push_back({v.handle, point_at<Part>(v.data.before),
                         point_at<Part>(v.data.destination),
                         v.data.is_open && v.is_core && patch.part.is_interface(v.handle)});
    Deformation_visitor<Part> no_visitor;
    Deformation_visitor<Part>& visitor = m_options.visitor ? *m_options.visitor : no_visitor;
    const For_each_index for_each_index(m_options.number_of_threads);
    Interface_deformer<Part> deformer(patch.part, visitor, m_options, for_each_index);
    deformer.resume(moved, patch.core);
    Deformation_report<Part> report =
        do_passes(deformer, visitor, m_options.maximum_number_of_passes);
    patch.counts += report;
    patch.counts.relocated += std::int64_t(report.relocated);
    patch.counts.relabeled += std::int64_t(report.relabeled);
    patch.events = std::move(report.events);
  }

  // Clears `is_open` of vertices that left the interface. Finds the number of the remaining
  // vertices and their remaining displacements.
  void measure_remaining(Report& report) {
    const std::vector<std::uint8_t> is_interface = m_mesh.interface_flags();
    std::int64_t unfinished = 0, vanished = 0;
    double longest = 0;
    std::vector<std::array<double, 1>> distances;
    for (Index v : m_mesh.piece.vertices()) {
      auto& vertex = m_mesh.piece.vertex(v);
      if (vertex.is_open && !is_interface[v]) {
        vertex.is_open = false;
        vanished += m_mesh.is_own(v);
      }
      if (!vertex.is_open || !m_mesh.is_own(v))
        continue;
      ++unfinished;
      double sum = 0;
      for (int k = 0; k < d; ++k)
        sum +=
            (vertex.destination[k] - vertex.point[k]) * (vertex.destination[k] - vertex.point[k]);
      distances.push_back({std::sqrt(sum)});
      longest = (std::max)(longest, distances.back()[0]);
    }
    report.unfinished = m_mesh.communicator->reduced(Operation::sum, unfinished);
    report.vanished += m_mesh.communicator->reduced(Operation::sum, vanished);
    report.longest_remaining = maximum_of_ranks(*m_mesh.communicator, longest);
    m_remaining = Exact_sums<1>(*m_mesh.communicator)(distances)[0];
  }

  // Finds the changes of components, and their places: where a patch changed the topology of the
  // label.
  void find_events(Report& report) {
    std::vector<Topology_place<d>> places = gather_items(*m_mesh.communicator, m_places);
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
      return std::tie(a.pass, a.patch, a.label, a.where) <
             std::tie(b.pass, b.patch, b.label, b.where);
    });
    for (const Component_event& event : Distributed_components<Complex>(m_mesh).update()) {
      const auto place = std::find_if(places.begin(), places.end(), [&](const auto& candidate) {
        return candidate.label == event.label;
      });
      if (place != places.end())
        report.events.push_back({event, point_at<Complex>(place->where), place->pass});
      else
        report.events.push_back({event, CGAL::ORIGIN, report.passes});
    }
  }

  // Calls f(change, component) for each known component.
  template <class Function> void for_each_component(Report& report, const Function& f) const {
    for (const auto& [number, component] : m_mesh.components)
      f(change_of_label(report.labels, component.label), component);
  }

  void begin_labels(Report& report) const {
    for_each_component(report, [](auto& change, const auto&) { ++change.before; });
    for (auto& change : report.labels)
      change.volume_before = volume(change.label);
  }

  void end_labels(Report& report) {
    for_each_component(report, [](auto& change, const auto&) { ++change.after; });
    for (const Component_event& event : report.events)
      count_event(event, report.labels);
    for (auto& change : report.labels)
      change.volume_after = volume(change.label);
  }

  // Returns the volume of the components of a label.
  double volume(int label) const {
    std::int64_t units = 0;
    for (const auto& [number, component] : m_mesh.components)
      if (component.label == label)
        units += component.volume;
    return Label_totals(m_mesh.domain_measure).volume_of(units);
  }

  // Measures the volumes of all components.
  void find_volumes() {
    const Label_totals totals(m_mesh.domain_measure);
    std::vector<std::int64_t> units(m_mesh.components.size(), 0);
    std::map<std::uint32_t, std::size_t> places;
    for (const auto& [number, component] : m_mesh.components)
      places.emplace(number, places.size());
    for (Index c : m_mesh.own_cells())
      units[places.at(std::uint32_t(m_mesh.piece.cell(c).data.component))] +=
          totals.units(m_mesh.measure(c));
    m_mesh.communicator->reduce(Operation::sum, units);
    for (auto& [number, component] : m_mesh.components)
      component.volume = units[places.at(number)];
  }

  Mesh& m_mesh;
  Options m_options; // of the patches
  unsigned m_most_passes;
  Extent<d> m_box; // around the domain
  bool m_is_box = false;
  std::int64_t m_stopped_at_boundary = 0;
  double m_remaining = 0;                  // sum of the remaining distances
  std::vector<Topology_place<d>> m_places; // of changes of topology on this rank
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_DEFORMER_H

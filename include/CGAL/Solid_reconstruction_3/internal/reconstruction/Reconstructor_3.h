// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCTOR_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCTOR_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>
#include <CGAL/Solid_reconstruction_3/Reconstruction_report_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_approach_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_facets_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Crease_planes_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Least_squares_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Misplaced_balls_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Small_handles_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The steps of a reconstruction. They move the interface of a complex from its initial position to
// the surface that a cloud samples, and divide facets that do not fit.
template <class Complex> class Reconstructor_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  // \param edge the largest target edge length at the beginning
  // \param tolerance the tolerance of the fit, in spacings
  Reconstructor_3(Complex& complex, const Sampled_surface_3& surface, double edge, double tolerance,
                  unsigned number_of_threads)
      : m_complex(complex), m_surface(surface), m_sizes(surface, edge, tolerance),
        m_tolerance(tolerance * surface.cloud().spacing()), m_threads(number_of_threads) {}

  // Performs steps until the interface comes to rest, or until the observer returns `false`. It
  // must be called only once.
  // The observer can be empty.
  Reconstruction_report_3<Complex>
  run(unsigned steps, const std::function<bool(const Complex&, std::size_t)>& observer) {
    bool goes_on = !observer || observer(m_complex, m_report.number_of_steps);
    while (goes_on && !m_report.is_complete && m_report.number_of_steps < steps) {
      m_report.is_complete = !advance();
      if (m_report.is_complete)
        finish();
      ++m_report.number_of_steps;
      goes_on = !observer || observer(m_complex, m_report.number_of_steps);
    }
    m_complex.measure_interface_edges();
    m_complex.take_component_events();
    const Front front(m_complex, m_surface);
    measure(front);
    if (m_report.is_complete)
      certify(front);
    return m_report;
  }

private:
  // Performs one step. While many facets are free, vertices move by `Cloud_approach_3`. Afterwards
  // they move by `Least_squares_3`. Returns whether the interface has not come to rest.
  bool advance() {
    static constexpr double many = .1;                 // of the facets
    static constexpr std::size_t steps_to_coarsen = 5; // number of steps between two coarsenings
    const Front front(m_complex, m_surface);
    const Cloud_planes_3 planes(m_surface, front.triangles);
    Cloud_approach_3 approach(m_surface, front.facets(), front.positions, front.triangles, planes);
    std::vector<Vector>& displacements = approach.displacements;
    calm(front.snapshot, displacements);
    const auto free = std::count(approach.is_free.begin(), approach.is_free.end(), 1);
    const bool fits = double(free) < many * double(front.triangles.size());
    if (fits) {
      const std::vector<Vector> best = fit(front).displacements();
      for (std::size_t v = 0; v < displacements.size(); ++v)
        if (approach.is_at_free[v] == 0)
          displacements[v] = best[v];
    }
    refine(front, planes, displacements, fits);
    deform(front.snapshot, front.positions, displacements);
    improve();
    if (m_report.number_of_steps % steps_to_coarsen == 0)
      control_detail(m_complex);
    if (fits) {
      m_residuals.push_back(front.triangles.residual(m_surface.cloud()));
      m_free.push_back(std::size_t(free));
    }
    return !has_settled();
  }

  // Moves the vertices to their final positions after the last step, and sharpens creases.
  void finish() {
    static constexpr int fits = 2;   // number of fits until vertices are at rest
    static constexpr int rounds = 4; // enough for fins of a few edges
    for (int i = 0; i < fits + rounds; ++i) {
      const Front front(m_complex, m_surface);
      const auto best = fit(front);
      deform(front.snapshot, front.positions,
             i < fits ? best.displacements() : best.displacements_of_loose());
    }
    sharpen();
  }

  // Moves vertices near creases onto them, and splits edges that cut across creases.
  void sharpen() {
    static constexpr int rounds = 8;      // each round halves the edges that cut across
    static constexpr double shortest = 1; // in spacings; shorter halves have no points
    // In degrees: 0 keeps small facets at sharp corners. Their removal would cut off the corner
    // again.
    static constexpr double smallest_angle = 0;
    // In spacings: with more noise, fitted planes do not meet in the edges.
    static constexpr double noisiest = .1;
    if (m_surface.noise() > noisiest * m_surface.cloud().spacing())
      return;
    const Crease_planes_3 planes(m_surface);
    std::map<typename Complex::Vertex_handle, Point> destinations; // of new vertices
    for (int i = 0; i < rounds; ++i) {
      const Snapshot front(m_complex);
      const std::vector<Point> positions = cloud_points(front.positions(m_complex));
      std::vector<Vector> displacements(positions.size());
      m_surface.cloud().for_each()(displacements.size(), [&](std::size_t v) {
        Progress_scope::check();
        const auto found = destinations.find(front.vertices[v]);
        displacements[v] = found == destinations.end() ? planes.to_crease(positions[v])
                                                       : found->second - positions[v];
      });
      const bool moves =
          std::any_of(displacements.begin(), displacements.end(),
                      [](const Vector& displacement) { return displacement != NULL_VECTOR; });
      if (moves)
        deform(front, positions, displacements, smallest_angle);
      const Snapshot moved(m_complex);
      const auto splits = edges_across_creases(
          planes, moved.facets(), cloud_points(moved.positions(m_complex)),
          shortest * m_surface.cloud().spacing(), m_surface.cloud().for_each());
      destinations.clear();
      for (const Crease_split_3& s : splits)
        if (const auto v = split(moved.vertices[s.edge[0]], moved.vertices[s.edge[1]]))
          destinations[*v] = s.destination;
      if (!moves && splits.empty())
        return;
    }
  }

  // Splits an edge. Returns the new vertex, or nothing if the edge cannot be split.
  std::optional<typename Complex::Vertex_handle> split(typename Complex::Vertex_handle v,
                                                       typename Complex::Vertex_handle w) {
    typename Complex::Cell_handle c;
    int i, j;
    Cavity<Complex> cavity(m_complex);
    if (!m_complex.triangulation().is_edge(v, w, c, i, j) ||
        !propose_edge_split(m_complex, c, i, j, .5, cavity))
      return std::nullopt;
    Deformation_visitor<Complex> nobody;
    commit_split(m_complex, cavity, v, w, nobody, m_report.changes);
    return cavity.vertices().back().handle;
  }

  using Snapshot = Interface_snapshot<Complex>;

  struct Front
  {
    Snapshot snapshot;
    std::vector<Point> positions;
    Cloud_triangles_3 triangles;

    Front(const Complex& complex, const Sampled_surface_3& surface)
        : snapshot(complex), positions(cloud_points(snapshot.positions(complex))),
          triangles(surface.cloud(), triangles_at(positions)) {
      if (positions.empty())
        throw Invalid_points_error(
            Invalid_points_error::Reason::open,
            "no solid remains: it is too thin for the distances of its points");
    }

    const auto& facets() const { return snapshot.facets(); }

    std::vector<Cloud_triangles_3::Triangle> triangles_at(const std::vector<Point>& points) const {
      std::vector<Cloud_triangles_3::Triangle> result;
      for (const auto& f : facets())
        result.emplace_back(points[f.vertices[0]], points[f.vertices[1]], points[f.vertices[2]]);
      return result;
    }
  };

  auto fit(const Front& front) const {
    return Least_squares_3(m_surface, front.facets(), front.positions, front.triangles);
  }

  // The displacement that the facets gave to a vertex in the last step.
  struct Motion
  {
    Vector displacement;
    double part; // part of the displacement that was used
  };

  // Halves the displacement of a vertex whose direction is reversed. Short displacements become
  // null.
  void calm(const Snapshot& front, std::vector<Vector>& displacements) {
    static constexpr double half = .5, more = 1.2;
    static constexpr double rest = .01; // in spacings
    std::map<std::size_t, Motion> motions;
    for (std::size_t v = 0; v < displacements.size(); ++v) {
      const std::size_t time_stamp = front.vertices[v]->time_stamp();
      const auto last = m_motions.find(time_stamp);
      Motion motion{displacements[v], 1};
      if (last != m_motions.end())
        motion.part = last->second.displacement * displacements[v] < 0
                          ? half * last->second.part
                          : (std::min)(1., more * last->second.part);
      displacements[v] = motion.part * displacements[v];
      if (std::sqrt(displacements[v].squared_length()) < rest * m_surface.cloud().spacing())
        displacements[v] = NULL_VECTOR;
      motions[time_stamp] = motion;
    }
    m_motions.swap(motions);
  }

  void refine(const Front& front, const Cloud_planes_3& planes,
              const std::vector<Vector>& displacements, bool fits) {
    static constexpr double rest = .1; // in edges
    std::vector<char> rests;
    for (std::size_t f = 0; f < front.triangles.size(); ++f) {
      double edge = 0, displacement = 0; // squared lengths
      for (int k = 0; k < 3; ++k) {
        const auto& t = front.triangles[f];
        edge = (std::max)(edge, (t[k] - t[k + 1]).squared_length());
        displacement =
            (std::max)(displacement,
                       displacements[front.facets()[f].vertices[std::size_t(k)]].squared_length());
      }
      rests.push_back(displacement <= rest * rest * edge);
    }
    m_sizes.refine(front.triangles, planes, rests, fits);
  }

  void deform(const Snapshot& front, const std::vector<Point>& positions,
              const std::vector<Vector>& displacements,
              double minimum_angle = Deformation_options<Complex>().minimum_angle) {
    std::vector<typename Complex::Point> destinations;
    for (std::size_t v = 0; v < displacements.size(); ++v) {
      const Point q = positions[v] + displacements[v];
      destinations.emplace_back(q.x(), q.y(), q.z());
    }
    static constexpr unsigned passes = 3; // remaining displacements follow in the next step
    Deformation_options<Complex> options;
    options.manifold_interface = true;
    options.maximum_number_of_passes = passes;
    options.number_of_threads = m_threads;
    options.minimum_angle = options.minimum_facet_angle = minimum_angle;
    const Deformation_report<Complex> report =
        deform_interface_to(m_complex, front, destinations, options);
    m_report.changes += report;
    m_report.relabeled += report.relabeled;
    m_report.topology_changes += report.events.size();
    m_report.held_back += report.unfinished.size();
  }

  void improve() {
    static constexpr double longest = 1.5, shortest = .4; // in target edge lengths
    static constexpr double crease = 40;                  // in degrees
    Interface_improvement_options<Complex> options;
    options.sizing_field = std::cref(m_sizes);
    options.interface_split_length = longest;
    options.interface_collapse_length = shortest;
    options.feature_angle = crease;
    m_report.changes = m_report.changes + improve_interface(m_complex, options);
  }

  // Returns whether the distances of points have stopped decreasing, or are much smaller than the
  // tolerance.
  bool has_settled() const {
    static constexpr std::size_t steps = 5;
    static constexpr double part = .9;   // of the value before these steps
    static constexpr double enough = .2; // of the tolerance
    const std::size_t n = m_residuals.size();
    // Narrow tunnels have few points, so their free facets must also have stopped decreasing in
    // number.
    if (n <= steps || double(m_free[n - 1]) < part * double(m_free[n - 1 - steps]))
      return false;
    return (m_residuals[n - 1] >= part * m_residuals[n - 1 - steps] ||
            m_residuals[n - 1] <= enough * m_tolerance);
  }

  // Verifies the interface by the sides of the points, which were determined independently of it.
  void certify(const Front& front) {
    static constexpr double radius = 2; // in known depths; two tunnels are wider
    const auto tell = [&](const Point& p) {
      m_report.doubtful_places.emplace_back(p.x(), p.y(), p.z());
    };
    for (const Point& p : misplaced_balls(m_surface, front.triangles.all()))
      tell(p);
    std::vector<double> radii;
    for (const Point& p : front.positions)
      radii.push_back(radius * Sampled_surface_3::known_depth *
                      m_surface.cloud().reach(m_surface.cloud().nearest(p)));
    for (std::size_t v : Small_handles_3(front.facets(), front.positions).find(radii))
      tell(front.positions[v]);
    m_report.is_complete = m_report.doubtful_places.empty();
  }

  void measure(const Front& front) {
    static constexpr double unfit = 4; // in noises
    Reconstruction_report_3<Complex>& report = m_report;
    const Point_cloud_3& cloud = m_surface.cloud();
    report.number_of_points = cloud.size();
    report.number_of_duplicates = cloud.number_of_duplicates();
    report.number_of_outliers = cloud.number_of_outliers();
    report.spacing = cloud.spacing();
    report.noise = m_surface.noise();
    report.root_mean_square = front.triangles.residual(m_surface.cloud());
    const double bound = (std::max)(report.spacing, unfit * report.noise);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      Progress_scope::check();
      const double distance =
          std::sqrt((front.triangles.foot(i) - cloud.points()[i]).squared_length());
      report.maximum_distance = (std::max)(report.maximum_distance, distance);
      if (distance > bound)
        report.unfit_points.push_back(cloud.index(i));
    }
    std::sort(report.unfit_points.begin(), report.unfit_points.end());
    const Cloud_planes_3 planes(m_surface, front.triangles);
    const auto facets = m_complex.interface_facets(); // same order as in `front`
    for (std::size_t f = 0; f < facets.size(); ++f)
      if (!planes[f].is_near)
        report.facets_without_points.push_back(facets[f]);
  }

  Complex& m_complex;
  const Sampled_surface_3& m_surface;
  Cloud_sizes_3 m_sizes;
  double m_tolerance;
  unsigned m_threads;
  Reconstruction_report_3<Complex> m_report;
  std::map<std::size_t, Motion> m_motions; // by the time stamps of vertices
  // One value for each step after the approach:
  std::vector<double> m_residuals; // residual of the points
  std::vector<std::size_t> m_free; // number of free facets
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCTOR_3_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_GEODESIC_FRONT_2_H
#define CGAL_CUT_LOCI_2_GEODESIC_FRONT_2_H

#include <CGAL/Complex_construction/fill_torus.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/control_detail.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgCutLoci2Ref

The front of all geodesics from a point of a Riemannian 2-manifold, in its chart, a flat torus
(section 4.2 of the paper). The front moves with unit speed and stops where it meets itself. It is
the interface of a complex in the chart. Label 1 is the region that the front has passed. Until the
front meets itself, this region is the distance ball of its radius. Label 0 is the rest.

Each vertex of the front stores a geodesic, given by its angle at the point. The geodesic is
integrated up to rounding. Where edges of the front become long, a new geodesic is started at the
point, with the angle between the two neighbors.

\tparam Metric model of `RiemannianMetric_2`
*/
template <class Metric> class Geodesic_front_2
{
public:
  /// the torus of the chart
  using Domain = Torus_domain<2>;
  /// the type of the complex in the chart
  using Complex = Deformable_simplicial_complex_2<Epick, Default, Domain>;
  using Point_2 = typename Complex::Point_2;             ///< a point of the chart
  using Vertex_handle = typename Complex::Vertex_handle; ///< a vertex of the complex
  using State = internal::Geodesic_state;                ///< u, v, u', v' of a geodesic

  /// The geodesic of a vertex of the front.
  struct Ray
  {
    double angle;          ///< at the point, from the direction along u, in radians
    double length;         ///< length of the geodesic up to `state`
    State state;           ///< end of the geodesic; the vertex is there, or behind it
    bool is_stopped;       ///< whether the front has met itself at the vertex
    unsigned steps_behind; ///< number of steps since the vertex was at `state`
  };

  /*!
  Builds the front of a small radius.

  \param metric the metric of the manifold. It has the periods of the torus.
  \param domain the torus of the chart
  \param point the source, in the chart
  \param spacing the approximate length of the edges of the mesh and of the front, in the chart. The
         range is (0, p / 20], where p is the smaller period.
  \throws Error if the metric is not positive definite at the point, the point is not finite, the
          spacing is out of range, or geodesics of three spacings would go around the torus.
  */
  Geodesic_front_2(const Metric& metric, const Domain& domain, const Point_2& point, double spacing)
      : Geodesic_front_2(Geodesics(metric, domain, point), domain, spacing) {}

  /*!
  Builds the front of a small radius, for a metric with its own chart and source.

  \tparam Surface an instance of `Sphere_like_surface_2`, the same as `Metric`
  \param surface the surface and its source
  \param spacing the approximate length of the edges of the mesh and of the front, in the chart. The
         range is (0, w / 20], where w is the width of the chart.
  \throws Error if the metric is not positive definite at the source, or the spacing is out of
          range.
  */
  template <class Surface>
  Geodesic_front_2(const Surface& surface, double spacing)
      : Geodesic_front_2(Geodesics(surface), surface.domain(), spacing) {}

  /*!
  Moves the front by a length, in equal steps of at most `longest_step()`. Returns whether a part of
  the front has not stopped.

  \param length the length on the manifold, positive

  \throws Error if the length is not positive, does not change the radius by rounding, or needs more
          than a million steps. Also throws if a geodesic cannot be integrated; the front is then in
          the state after the last complete step.
  */
  bool advance(double length) {
    static constexpr double most = 1e6;
    if (!(length > 0 && m_radius + length > m_radius && length <= most * longest_step()))
      throw Error(
          "the step of the front is out of range: use a positive length, about half the spacing");
    const int number = int(std::ceil(length / longest_step()));
    for (int i = 0; i < number && is_going(); ++i)
      step_by(length / number);
    return is_going();
  }

  /// Returns the length of the spacing on the manifold, in the direction in which it is shortest.
  /// It is measured at the source, on a `Sphere_like_surface_2` opposite to the source.
  double longest_step() const { return m_geodesics.shortest(m_spacing); }

  /// Returns the length of the geodesics that have not stopped.
  double radius() const { return m_radius; }
  /// Returns the complex in the chart. Label 1 is the region that the front has passed.
  const Complex& complex() const { return m_complex; }
  /// Returns the geodesic of a vertex of the front. \pre The vertex is on the interface.
  const Ray& ray(Vertex_handle v) const { return m_rays.at(v->time_stamp()); }
  /// Returns the largest step until now.
  double step() const { return m_step; }
  /// Returns the length of the spacing on the manifold, in the direction in which it is longest. It
  /// is measured at the same point as `longest_step()`.
  double length_of_spacing() const { return m_geodesics.longest(m_spacing); }
  /// Returns the approximate length of the edges, in the chart.
  double spacing() const { return m_spacing; }
  /// Returns the state of the geodesic with an angle at the source after a length. \pre On a
  /// `Sphere_like_surface_2`, the length is not 0.
  State shoot(double angle, double length) const { return m_geodesics.shoot(angle, length); }
  /// Returns the state of a geodesic after a further length.
  State continue_ray(const State& state, double length) const {
    return m_geodesics.advance(state, length);
  }
  /// Returns the angle and the length of the geodesic to a point, for the constant metric of the
  /// source.
  auto departure(const Point_2& p) const { return m_geodesics.departure(p); }
  /// Returns whether the chart contains a state.
  bool is_in_chart(const State& state) const { return m_geodesics.is_in_chart(state); }

private:
  using Cell_handle = typename Complex::Cell_handle;
  using Geodesics = internal::Geodesics_2<Metric>;

  Geodesic_front_2(const Geodesics& geodesics, const Domain& domain, double spacing)
      : m_geodesics(geodesics), m_spacing(spacing), m_complex(domain) {
    static constexpr double coarsest = 1. / 20; // of the period
    const double period = (std::min)(domain.periods()[0], domain.periods()[1]);
    if (!(spacing > 0 && spacing <= coarsest * period))
      throw Error(
          "the spacing of the front is out of range: use at most a twentieth of the periods");
    m_radius = m_geodesics.first_radius(spacing);
    m_complex = fill_torus<Complex>(
        domain, spacing,
        [&](const Point_2& q) { return m_geodesics.departure(q).length < m_radius ? 1 : 0; },
        Deformation_options<Complex>());
    for (Vertex_handle v : m_complex.interface_vertices()) {
      const double angle = m_geodesics.departure(m_complex.position(v)).angle;
      m_rays[v->time_stamp()] = {angle, m_radius, m_geodesics.shoot(angle, m_radius), false, 0};
    }
    move();
  }

  bool is_going() const {
    return std::any_of(m_rays.begin(), m_rays.end(),
                       [](const auto& item) { return !item.second.is_stopped; });
  }

  void step_by(double length) {
    std::vector<State> states;
    for (const auto& [time_stamp, ray] : m_rays)
      states.push_back(ray.is_stopped ? ray.state : m_geodesics.advance(ray.state, length));
    m_radius += length;
    m_step = (std::max)(m_step, length);
    auto state = states.begin();
    for (auto& [time_stamp, ray] : m_rays) {
      ray.state = *state++;
      if (!ray.is_stopped)
        ray.length = m_radius;
    }
    move();
    refine();
  }

  static Point_2 point(const State& state) { return Point_2(state[0], state[1]); }

  // Moves the vertices to the ends of their geodesics, as far as possible.
  void move() {
    const auto destination = [&](Vertex_handle v) {
      const Ray& ray = m_rays.at(v->time_stamp());
      return ray.is_stopped ? v->point() : point(ray.state);
    };
    // Relabeling would close the folds of the front, so it is turned off. Flat facets are kept, and
    // there are two passes only, so that the front keeps its edges.
    Deformation_options<Complex> motion;
    motion.maximum_number_of_passes = 2;
    motion.relabeling_threshold = motion.minimum_facet_angle = 0;
    const auto report = deform_interface(m_complex, destination, motion);
    // Splits long edges and collapses short ones, so that parts of the front can meet everywhere.
    static constexpr double shortest = .5; // in spacings
    Detail_options<Complex> detail;
    detail.sizing_field = [this](const auto&) { return m_spacing; };
    detail.split_length = 2;
    detail.collapse_length = shortest;
    control_detail(m_complex, detail);
    adopt();
    for (auto& [time_stamp, ray] : m_rays)
      ray.steps_behind = ray.is_stopped ? 0 : ray.steps_behind + 1;
    std::map<std::size_t, bool> is_behind;
    for (const auto& item : report.unfinished)
      is_behind[item.vertex->time_stamp()] = true;
    static constexpr unsigned patience = 10; // in steps
    for (Vertex_handle v : m_complex.interface_vertices()) {
      Ray& ray = m_rays.at(v->time_stamp());
      if (is_behind.count(v->time_stamp()) == 0)
        ray.steps_behind = 0;
      else if (!ray.is_stopped && (touches_front(v) || ray.steps_behind > patience))
        ray.is_stopped = true;
    }
  }

  // Removes the rays of vertices that do not exist any more. A vertex that is new on the interface
  // stops, with the ray of a neighbor.
  void adopt() {
    std::map<std::size_t, Ray> rays;
    std::vector<Cell_handle> star;
    std::vector<Vertex_handle> strangers;
    for (Vertex_handle v : m_complex.interface_vertices())
      if (const auto known = m_rays.find(v->time_stamp()); known != m_rays.end())
        rays.insert(*known);
      else
        strangers.push_back(v);
    for (Vertex_handle v : strangers) {
      Ray ray = {
          0, m_radius, {m_complex.position(v).x(), m_complex.position(v).y(), 0, 0}, true, 0};
      m_complex.star(v, star);
      for (Cell_handle c : star)
        for (int i = 0; i < 3; ++i)
          if (const auto known = m_rays.find(c->vertex(i)->time_stamp()); known != m_rays.end())
            ray = known->second;
      ray.is_stopped = true;
      rays.insert({v->time_stamp(), ray});
    }
    m_rays.swap(rays);
  }

  // Returns whether a vertex faces another part of the front across a cell of label 0 that two
  // steps would close.
  bool touches_front(Vertex_handle v) const {
    std::vector<Cell_handle> star;
    m_complex.star(v, star);
    const State& state = m_rays.at(v->time_stamp()).state;
    const double step = m_step * std::hypot(state[2], state[3]);
    return std::any_of(star.begin(), star.end(), [&](Cell_handle c) {
      int sides = 0, corners = 0;
      double longest = 0;
      for (int i = 0; i < 3; ++i) {
        longest = (std::max)(longest, m_complex.measure(typename Complex::Facet(c, i)));
        sides += m_complex.is_interface(typename Complex::Facet(c, i));
        corners += c->vertex(i)->is_interface();
      }
      return c->subdomain_index() == 0 && corners == 3 && sides < 2 &&
             2 * m_complex.measure(c) / longest < 2 * step;
    });
  }

  // Splits long edges of the front, unless both ends have stopped.
  void refine() {
    static constexpr double longest = 1.5; // in spacings
    static constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
      bool has_changed = false;
      std::vector<std::pair<typename Complex::Facet, std::size_t>> facets; // and time stamps
      for (const auto& facet : m_complex.interface_facets())
        facets.emplace_back(facet, facet.first->time_stamp());
      for (const auto& [facet, time_stamp] : facets)
        if (m_complex.is_alive(facet.first, time_stamp))
          has_changed = refine(facet, longest * m_spacing) || has_changed;
      if (!has_changed)
        return;
    }
  }

  bool refine(const typename Complex::Facet& facet, double longest) {
    const auto [c, k] = facet;
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Vertex_handle a = c->vertex(i), b = c->vertex(j);
    const auto edge = m_complex.displacement(a, b);
    const Ray &from = m_rays.at(a->time_stamp()), &to = m_rays.at(b->time_stamp());
    if (edge.squared_length() < longest * longest || (from.is_stopped && to.is_stopped))
      return false;
    const double pi = std::acos(-1.);
    const double angle = from.angle + std::remainder(to.angle - from.angle, 2 * pi) / 2;
    const Point_2 middle = m_complex.position(a) + edge / 2;
    Deformable_simplicial_complexes::Cavity<Complex> cavity(m_complex);
    // Next to a stopped vertex, the front may be behind the full length.
    for (double part : {1., .5, 0.}) {
      const double length = part * (std::max)(from.length, to.length) +
                            (1 - part) * (std::min)(from.length, to.length);
      const State state = m_geodesics.shoot(angle, length);
      const Point_2 p = m_complex.domain().nearest_image(middle, point(state));
      if (!((p - middle).squared_length() < edge.squared_length()) ||
          !propose_edge_split(m_complex, c, i, j, p, cavity))
        continue;
      Improvement_report report;
      Deformation_visitor<Complex> nobody;
      commit_split(m_complex, cavity, a, b, nobody, report);
      m_rays[cavity.vertices().back().handle->time_stamp()] = {angle, length, state,
                                                               length < m_radius, 0};
      return true;
    }
    return false;
  }

  Geodesics m_geodesics;
  double m_spacing, m_radius = 0, m_step = 0;
  Complex m_complex;
  std::map<std::size_t, Ray> m_rays; // by the time stamps of vertices
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_CUT_LOCI_2_GEODESIC_FRONT_2_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_PARTICLE_SURFACES_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_PARTICLE_SURFACES_H

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <Eigen/Dense>

#include <limits>
#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the point of a simplex that is closest to p. If the projection of p onto the plane of the
// simplex is outside, the closest point is on a face opposite to a corner with a negative
// barycentric coordinate.
template <class Complex, std::size_t n>
typename Complex::Point closest_point(const typename Complex::Point& p,
                                      const std::array<typename Complex::Point, n>& corners) {
  if constexpr (n == 1)
    return corners[0];
  else {
    constexpr int edges = int(n) - 1;
    Eigen::Matrix<double, edges, edges> products;
    Eigen::Matrix<double, edges, 1> right;
    for (int i = 0; i < edges; ++i) {
      const auto edge = corners[std::size_t(i) + 1] - corners[0];
      right(i) = edge * (p - corners[0]);
      for (int j = 0; j < edges; ++j)
        products(i, j) = edge * (corners[std::size_t(j) + 1] - corners[0]);
    }
    const Eigen::Matrix<double, edges, 1> x = products.ldlt().solve(right);
    std::array<double, n> coordinates;
    coordinates[0] = 1 - x.sum();
    for (int i = 0; i < edges; ++i)
      coordinates[std::size_t(i) + 1] = x(i);
    auto inside = corners[0];
    bool is_inside = true;
    for (std::size_t i = 0; i < n; ++i) {
      is_inside = is_inside && coordinates[i] >= 0; // false for NaN of a flat simplex
      if (i > 0)
        inside = inside + coordinates[i] * (corners[i] - corners[0]);
    }
    if (is_inside)
      return inside;
    auto result = corners[0];
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t left_out = 0; left_out < n; ++left_out) {
      if (coordinates[left_out] >= 0)
        continue;
      std::array<typename Complex::Point, n - 1> face;
      for (std::size_t i = 0, j = 0; i < n; ++i)
        if (i != left_out)
          face[j++] = corners[i];
      const auto q = closest_point<Complex>(p, face);
      if (const double other = (q - p).squared_length(); other < distance) {
        distance = other;
        result = q;
      }
    }
    return result;
  }
}

// The surfaces of the particles of a complex: labels whose interfaces all have the mobility 0. The
// vertices where grain boundaries end slide along them. Without the surfaces, small changes of the
// shape of particles in each step would add up. A projection compares each vertex with each facet.
template <class Complex> class Particle_surfaces
{
public:
  using Label = typename Complex::Label;
  using Point = typename Complex::Point;
  using Points = std::vector<Point>;

  Particle_surfaces(const Complex& complex, const Interface_energy& energy) : m_energy(energy) {
    if (!energy.has_mobilities())
      return;
    const Interface_snapshot<Complex> interface_(complex);
    std::set<Label> others;
    for (const auto& facet : interface_.facets()) {
      const bool moves = energy.mobility(facet.behind, facet.in_front) > 0;
      for (const Label label : {facet.behind, facet.in_front})
        (moves ? others : m_particles).insert(label);
    }
    for (const Label label : others)
      m_particles.erase(label);
    const Points positions = interface_.positions(complex);
    for (const auto& facet : interface_.facets())
      if (is_on_particle(facet))
        add(interface_.domain, facet.vertices, positions);
  }

  // Moves the destinations of vertices of particles to the nearest points of the surfaces. Vertices
  // on sides of the domain stay on them.
  void project(const Interface_snapshot<Complex>& interface_, Points& destinations) const {
    if (m_facets.empty())
      return;
    std::vector<char> are_on_particles(destinations.size(), false);
    for (const auto& facet : interface_.facets())
      if (is_on_particle(facet))
        for (std::size_t v : facet.vertices)
          are_on_particles[v] = true;
    for (std::size_t v = 0; v < destinations.size(); ++v) {
      if (!are_on_particles[v])
        continue;
      const Point nearest = closest(interface_.domain, destinations[v]);
      auto coordinates = coordinates_of<d>(nearest);
      for (int axis = 0; axis < d; ++axis)
        if (Boundary_class::fixes(interface_.vertices[v]->boundary_class(), axis))
          coordinates[axis] = destinations[v][axis];
      destinations[v] = point_at<Complex>(coordinates);
    }
  }

private:
  static constexpr int d = Complex::dimension;

  // A facet in a ball around its first corner.
  struct Facet
  {
    std::array<Point, d> corners;
    double radius;
  };

  // Returns whether a facet is on a particle. A label that is a particle at first may meet others
  // across a mobile interface later.
  template <class Snapshot_facet> bool is_on_particle(const Snapshot_facet& facet) const {
    return (m_particles.count(facet.behind) > 0 || m_particles.count(facet.in_front) > 0) &&
           m_energy.mobility(facet.behind, facet.in_front) == 0;
  }

  void add(const typename Complex::Domain& domain, const std::array<std::size_t, d>& vertices,
           const Points& positions) {
    Facet facet;
    facet.radius = 0;
    for (int i = 0; i < d; ++i) {
      facet.corners[i] = domain.nearest_image(positions[vertices[0]], positions[vertices[i]]);
      facet.radius = (std::max)(facet.radius,
                                std::sqrt((facet.corners[i] - facet.corners[0]).squared_length()));
    }
    m_facets.push_back(facet);
  }

  // Returns the point of the surfaces that is closest to p.
  Point closest(const typename Complex::Domain& domain, const Point& p) const {
    Point result = p;
    double distance = std::numeric_limits<double>::infinity();
    for (const Facet& facet : m_facets) {
      const Point first = domain.nearest_image(p, facet.corners[0]);
      if (std::sqrt((first - p).squared_length()) - facet.radius >= distance)
        continue;
      std::array<Point, d> corners;
      for (int i = 0; i < d; ++i)
        corners[i] = first + (facet.corners[i] - facet.corners[0]);
      const Point q = closest_point<Complex>(p, corners);
      if (const double other = std::sqrt((q - p).squared_length()); other < distance) {
        distance = other;
        result = q;
      }
    }
    return result;
  }

  Interface_energy m_energy;
  std::set<Label> m_particles;
  std::vector<Facet> m_facets;
};

// The flow of an energy, with vertices of particles on the surfaces of the particles. Model of
// `InterfaceStep`.
template <class Flow, class Complex> class Flow_along_particles
{
public:
  static constexpr bool contracts_interface = Flow::contracts_interface;

  Flow_along_particles(const Flow& flow, const Particle_surfaces<Complex>& surfaces)
      : m_flow(flow), m_surfaces(surfaces) {}

  const Interface_energy& energy() const { return m_flow.energy(); }
  bool preserves_volumes() const { return m_flow.preserves_volumes(); }

  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Point>& positions, double t, double dt,
                  std::vector<typename Complex::Point>& destinations) const {
    m_flow(interface_, positions, t, dt, destinations);
    m_surfaces.project(interface_, destinations);
  }

private:
  const Flow& m_flow;
  const Particle_surfaces<Complex>& m_surfaces;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_PARTICLE_SURFACES_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_FITTING_MISSED_VOLUMES_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_FITTING_MISSED_VOLUMES_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Domain_box.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Origin.h>

#include <map>
#include <tuple>
#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Complex, class LabelAt>
inline constexpr bool labels_each_point =
    std::is_invocable_r_v<typename Complex::Label, const LabelAt&, typename Complex::Point>;

// Whether a function gives labels of points: of one point, or else of a vector of points. A generic
// function of a point need not compile for a vector.
template <class Complex, class LabelAt>
inline constexpr bool labels_points =
    std::disjunction_v<std::bool_constant<labels_each_point<Complex, LabelAt>>,
                       std::is_invocable_r<std::vector<typename Complex::Label>, const LabelAt&,
                                           const std::vector<typename Complex::Point>&>>;

// Returns the labels at points, given by a function of a point or of a vector of points. On a
// torus, the function is called with points of the box.
template <class Complex, class LabelAt>
std::vector<typename Complex::Label> labels_at(const Complex& complex, const LabelAt& label_at,
                                               std::vector<typename Complex::Point> points) {
  static_assert(labels_points<Complex, LabelAt>,
                "the function of labels: int operator()(Point) const, or a function of a vector of "
                "points");
  for (auto& p : points)
    p = complex.domain().canonical(p);
  std::vector<typename Complex::Label> result;
  if constexpr (labels_each_point<Complex, LabelAt>) {
    for (const auto& p : points) {
      Progress_scope::check();
      result.push_back(label_at(p));
    }
  } else if (!points.empty()) {
    result = label_at(points);
    if (result.size() != points.size())
      throw Error("the number of labels differs from the number of points: give one label for each "
                  "point");
  }
  return result;
}

// A point of a rule of integration over a facet: its barycentric coordinates and its weight.
template <int d> struct Facet_sample
{
  std::array<double, d> coordinates;
  double weight;
};

// Gauss's rule with three points, exact for polynomials of degree 5.
inline std::array<Facet_sample<2>, 3> samples(const std::array<double, 2>& /*of a segment*/) {
  const double nearby = .5 - std::sqrt(.15), distant = .5 + std::sqrt(.15);
  return {{{{nearby, distant}, 5. / 18}, {{.5, .5}, 8. / 18}, {{distant, nearby}, 5. / 18}}};
}

// Rule with six points, exact for polynomials of degree 4. D. A. Dunavant, High degree efficient
// symmetrical Gaussian quadrature rules for the triangle, 1985.
inline std::array<Facet_sample<3>, 6> samples(const std::array<double, 3>& /*of a triangle*/) {
  static constexpr double a = .445948490915965, wa = .223381589678011, b = .091576213509771,
                          wb = .109951743655322;
  return {{{{a, a, 1 - 2 * a}, wa},
           {{a, 1 - 2 * a, a}, wa},
           {{1 - 2 * a, a, a}, wa},
           {{b, b, 1 - 2 * b}, wb},
           {{b, 1 - 2 * b, b}, wb},
           {{1 - 2 * b, b, b}, wb}}};
}

// The volumes between the facets of an interface and the places where the label given by a function
// changes. The vertices of a facet may all be at such places, and the facet still cuts off a part
// of a round phase.
//
// The places are searched from the points of a rule of integration, along directions that are
// linear on each facet and agree at common vertices, so that the space near the interface is
// covered once.
template <class Complex> class Missed_volumes
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;
  using Facet = typename Interface_vertices<Complex>::Facet;

  template <class LabelAt>
  Missed_volumes(const Complex& complex, const LabelAt& label_at,
                 const Interface_snapshot<Complex>& interface_)
      : m_complex(complex), m_interface(interface_), m_box(complex),
        m_positions(interface_.positions(complex)) {
    for (const Facet& facet : m_interface.facets()) {
      const Vector normal = normal_of(facet, 0);
      for (std::size_t v : facet.vertices) {
        Vector& direction = m_normals.try_emplace(key(facet, v), NULL_VECTOR).first->second;
        direction = direction + normal;
      }
    }
    for (auto& [key, normal] : m_normals)
      if (const double length = Complex::Space::length(normal); length > 0)
        normal = normal / length;
    find_places(label_at);
    find_destinations();
  }

  // Returns destinations of the vertices. Each facet gives the volume that it misses to its
  // vertices. They move along their normals until the facets have swept these volumes, to the first
  // order.
  const std::vector<Point>& destinations() const { return m_destinations; }

  double longest_displacement() const {
    double result = 0;
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      result = (std::max)(result, Complex::Space::length(m_destinations[v] - m_positions[v]));
    return result;
  }

private:
  // A vertex, and the labels behind and in front of facets: at a junction, each sheet has its own
  // normal.
  using Key = std::tuple<std::size_t, typename Complex::Label, typename Complex::Label>;

  static Key key(const Facet& facet, std::size_t v) { return {v, facet.behind, facet.in_front}; }
  static auto rule() { return samples(std::array<double, d>()); }

  const Vector& direction_at(const Facet& facet, std::size_t v) const {
    return m_normals.at(key(facet, v));
  }

  Vector direction_at(const Facet& facet, const Facet_sample<d>& sample) const {
    Vector result(NULL_VECTOR);
    for (int k = 0; k < d; ++k)
      result = result + sample.coordinates[k] * direction_at(facet, facet.vertices[k]);
    return result;
  }

  // Returns the corners of a facet after a motion by a distance along the normals.
  std::array<Point, d> moved(const Facet& facet, double distance) const {
    auto result = m_interface.corners(facet, m_positions);
    if (distance != 0)
      for (int k = 0; k < d; ++k)
        result[k] = result[k] + distance * direction_at(facet, facet.vertices[k]);
    return result;
  }

  // Returns the normal towards the front; its length is the measure of the facet.
  Vector normal_of(const Facet& facet, double distance) const {
    return Complex::Space::facet_normal(moved(facet, distance)) / (d - 1);
  }

  // Returns the volume that a facet would sweep if it moved as far as it has to move at a sample.
  // The integrand is a polynomial of degree 2 at most.
  double swept(const Facet& facet, const Facet_sample<d>& sample, double distance) const {
    if (distance == 0)
      return 0;
    return distance / 6 * direction_at(facet, sample) *
           (normal_of(facet, 0) + 4 * normal_of(facet, distance / 2) + normal_of(facet, distance));
  }

  void find_destinations() {
    std::map<Key, double> missed, areas;
    std::size_t i = 0;
    for (const Facet& facet : m_interface.facets()) {
      const Vector normal = normal_of(facet, 0);
      for (const auto& sample : rule()) {
        const double volume = sample.weight * swept(facet, sample, m_distances[i++]);
        for (int k = 0; k < d; ++k)
          missed[key(facet, facet.vertices[k])] += sample.coordinates[k] * volume;
      }
      // Where sheets fold back, their directions oppose the normals: the displacement stays
      // bounded.
      static constexpr double least_share = .25;
      const double length = Complex::Space::length(normal);
      for (std::size_t v : facet.vertices)
        areas[key(facet, v)] +=
            (std::max)(normal * direction_at(facet, v), least_share * length) / d;
    }
    m_destinations = m_positions;
    for (const auto& [key, volume] : missed)
      if (const double area = areas.at(key); area > 0) {
        Point& p = m_destinations[std::get<0>(key)];
        p = p + volume / area * m_normals.at(key);
        m_box.clamp(p);
      }
  }

  // A line through a sample on which the place is searched: behind `low`, in front of `high`.
  struct Line
  {
    Point origin;
    Vector direction;
    typename Complex::Label behind, in_front;
    double reach, low, high;
    bool is_inside; // whether both ends are in the domain
  };

  std::vector<Line> lines() const {
    std::vector<Line> result;
    for (const Facet& facet : m_interface.facets()) {
      const auto corners = m_interface.corners(facet, m_positions);
      double longest = 0;
      for (int i = 0; i < d; ++i)
        for (int j = 0; j < i; ++j)
          longest = (std::max)(longest, Complex::Space::length(corners[i] - corners[j]));
      for (const auto& sample : rule()) {
        Vector offset(NULL_VECTOR);
        for (int k = 1; k < d; ++k)
          offset = offset + sample.coordinates[k] * (corners[k] - corners[0]);
        // A place farther away belongs to another facet.
        result.push_back({corners[0] + offset, direction_at(facet, sample), facet.behind,
                          facet.in_front, longest / 2, 0, 0, false});
      }
    }
    return result;
  }

  // Finds the distances of the places from the samples. A sample without a place near it has the
  // distance 0.
  template <class LabelAt> void find_places(const LabelAt& label_at) {
    std::vector<Line> lines = this->lines();
    m_distances.assign(lines.size(), 0);
    std::vector<std::size_t> open(lines.size()); // lines without an interval around the place
    for (std::size_t i = 0; i < lines.size(); ++i)
      open[i] = i;
    std::vector<std::size_t> found;
    static constexpr int attempts = 4; // with an interval of half the length each
    for (int k = 0; k < attempts && !open.empty(); ++k) {
      // The function is defined in the domain only.
      std::vector<Point> behind, in_front;
      for (std::size_t i : open) {
        behind.push_back(lines[i].origin - lines[i].reach * lines[i].direction);
        in_front.push_back(lines[i].origin + lines[i].reach * lines[i].direction);
        lines[i].is_inside = !m_box.clamp(behind.back()) && !m_box.clamp(in_front.back());
      }
      const auto labels_behind = labels_at(m_complex, label_at, behind),
                 labels_in_front = labels_at(m_complex, label_at, in_front);
      std::vector<std::size_t> rest;
      for (std::size_t j = 0; j < open.size(); ++j) {
        Line& line = lines[open[j]];
        if (line.is_inside && labels_behind[j] == line.behind &&
            labels_in_front[j] == line.in_front) {
          line.low = -line.reach;
          line.high = line.reach;
          found.push_back(open[j]);
        } else {
          line.reach /= 2;
          rest.push_back(open[j]);
        }
      }
      open = rest;
    }
    static constexpr int halvings = 14; // the error is less than a ten thousandth of an edge
    for (int k = 0; k < halvings; ++k) {
      std::vector<Point> middle;
      for (std::size_t i : found)
        middle.push_back(lines[i].origin + (lines[i].low + lines[i].high) / 2 * lines[i].direction);
      const auto labels = labels_at(m_complex, label_at, middle);
      for (std::size_t j = 0; j < found.size(); ++j) {
        Line& line = lines[found[j]];
        (labels[j] == line.behind ? line.low : line.high) = (line.low + line.high) / 2;
      }
    }
    for (std::size_t i : found)
      m_distances[i] = (lines[i].low + lines[i].high) / 2;
  }

  const Complex& m_complex;
  const Interface_snapshot<Complex>& m_interface;
  Domain_box<Complex> m_box;
  std::vector<Point> m_positions, m_destinations;
  std::map<Key, Vector> m_normals;
  std::vector<double> m_distances; // from the samples of all facets, along their directions
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_FITTING_MISSED_VOLUMES_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BALANCE_INTERFACE_TOLERANCE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BALANCE_INTERFACE_TOLERANCE_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/star_union.h>

#include <boost/container/flat_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The volume that a mesh operation may move from one label to another. It is a part of the volumes
// that the labels have in the cells around the operation. The part is smaller where the edges of
// the interface are long compared with the local thickness of a label. So a thin phase under large
// facets keeps its volume, whatever the shape of its cells.
template <class Complex> class Interface_tolerance
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Facet = typename Complex::Facet;
  using Label = typename Complex::Label;
  using Position = typename Complex::Approximate_point;
  using Vector = typename Complex::Approximate_vector;

  // If there are destinations, volumes are those with the vertices at their destinations. What the
  // motion brings together may then be joined.
  explicit Interface_tolerance(const Complex& complex,
                               const Destinations<Complex>* destinations = nullptr)
      : m_complex(&complex), m_destinations(destinations) {}

  // Returns whether a proposed replacement moves a volume that is small enough. It is a collapse of
  // a vertex of the interface, or a flip of an edge of the interface; other proposals move nothing.
  // The bound is multiplied by `factor`.
  bool allows(const Cavity<Complex>& cavity, double factor = 1) const {
    if (cavity.kind() == Proposal_kind::collapse)
      return allows_motion(cavity.vanishing_vertex(), cavity.removed(),
                           final_position(cavity.kept_vertex()), factor);
    if constexpr (Complex::dimension == 3)
      if (cavity.kind() == Proposal_kind::flip)
        return allows_flip(cavity.removed(), factor);
    return true;
  }

  // Returns whether the vertex of a star may move to a position.
  bool allows_motion(Vertex_handle v, const std::vector<Cell_handle>& star, const Position& to,
                     double factor = 1) const {
    if (!v->is_interface())
      return true;
    const Position from = final_position(v);
    const Vector step = m_complex->domain().near(from, to) - from;
    std::vector<Facet> facets;
    double swept = 0;
    for (Cell_handle c : star)
      for (int i = 0; i < Complex::corners; ++i)
        if (const Facet facet(c, i); c->vertex(i) != v && is_first_side(facet)) {
          facets.push_back(facet);
          swept += std::abs(step * Complex::Space::facet_normal(corners(facet))) / factorial;
        }
    return is_small(swept, facets, star, factor);
  }

  // Returns whether a cell may get the label behind one of its facets.
  bool allows_relabeling(const Facet& facet) const {
    return is_small(m_complex->measure(facet.first), {facet}, {facet.first}, 1);
  }

private:
  static constexpr double factorial = Complex::dimension == 3 ? 6 : 2; // d!

  // Returns whether the edge that is common to all removed cells may be flipped. The interface
  // sweeps the tetrahedron of its two facets.
  bool allows_flip(const std::vector<Cell_handle>& removed, double factor) const {
    std::vector<Facet> facets;
    for (Cell_handle c : removed)
      for (int i = 0; i < Complex::corners; ++i)
        if (is_first_side(Facet(c, i)) &&
            std::find(removed.begin(), removed.end(), c->neighbor(i)) != removed.end())
          facets.push_back(Facet(c, i));
    if (facets.size() != 2)
      return true; // the edge is not on the interface
    const auto v = m_complex->facet_vertices(facets[0]), w = m_complex->facet_vertices(facets[1]);
    const auto opposite = std::find_if(w.begin(), w.end(), [&](Vertex_handle u) {
      return std::find(v.begin(), v.end(), u) == v.end();
    });
    const auto base = corners(facets[0]);
    const Vector height = m_complex->domain().near(base[0], final_position(*opposite)) - base[0];
    return is_small(std::abs(height * Complex::Space::facet_normal(base)) / factorial, facets,
                    removed, factor);
  }

  // The cells of a label around an operation.
  struct Surroundings
  {
    double volume = 0, area = 0; // area of their facets of the interface
  };

  // Returns whether a swept volume is small enough for the labels on both sides of the facets that
  // move. The cells are those that the operation changes.
  bool is_small(double swept, const std::vector<Facet>& facets,
                const std::vector<Cell_handle>& cells, double factor) const {
    static constexpr double part = .03; // of the volume of a label around a well-resolved interface
    static constexpr double rounding = 1e-12; // relative to the cube of an edge
    double edge = 0;
    boost::container::flat_map<Label, Surroundings> labels;
    for (const Facet& facet : facets) {
      edge = (std::max)(edge, longest_edge(corners(facet)));
      labels[facet.first->label()];
      labels[facet.first->neighbor(facet.second)->label()];
    }
    if (swept <= rounding * std::pow(edge, Complex::dimension))
      return true;
    for (Cell_handle c : stars_of(*m_complex, finite_vertices_of(cells)))
      if (const auto found = labels.find(c->label()); found != labels.end()) {
        found->second.volume += m_complex->measure(c);
        for (int i = 0; i < Complex::corners; ++i)
          if (m_complex->is_interface(Facet(c, i)))
            found->second.area += m_complex->measure(Facet(c, i));
      }
    return std::all_of(labels.begin(), labels.end(), [&](const auto& item) {
      const Surroundings& around = item.second;
      // of a sheet between two parallel facets: its thickness
      const double thickness = 2 * around.volume / around.area;
      const double resolution = (std::min)(1., thickness / edge);
      return swept <= factor * part * resolution * std::sqrt(resolution) * around.volume;
    });
  }

  // Returns whether the facet is on the interface and its cell has the larger label.
  bool is_first_side(const Facet& facet) const {
    const Cell_handle c = facet.first, n = c->neighbor(facet.second);
    return !m_complex->is_infinite(c) && !m_complex->is_infinite(n) && n->label() < c->label();
  }

  std::vector<Vertex_handle> finite_vertices_of(const std::vector<Cell_handle>& cells) const {
    std::vector<Vertex_handle> result = vertices_of(*m_complex, cells);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [&](Vertex_handle v) { return m_complex->is_infinite(v); }),
                 result.end());
    return result;
  }

  using Corners = std::array<Position, Complex::dimension>;

  // Returns the corners of a facet at their destinations.
  Corners corners(const Facet& facet) const {
    Corners result;
    for (int k = 0; k < Complex::dimension; ++k) {
      const Position p =
          final_position(facet.first->vertex(Complex::Space::facet_vertices[facet.second][k]));
      result[k] = k == 0 ? p : m_complex->domain().near(result[0], p);
    }
    return result;
  }

  static double longest_edge(const Corners& corners) {
    double squared = 0;
    for (int i = 0; i < Complex::dimension; ++i)
      for (int j = 0; j < i; ++j)
        squared = (std::max)(squared, (corners[i] - corners[j]).squared_length());
    return std::sqrt(squared);
  }

  Position final_position(Vertex_handle v) const {
    return m_destinations ? m_destinations->final_position(v) : m_complex->position(v);
  }

  const Complex* m_complex;
  const Destinations<Complex>* m_destinations;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BALANCE_INTERFACE_TOLERANCE_H

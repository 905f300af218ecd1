// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_INTERFACE_TOLERANCE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_INTERFACE_TOLERANCE_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Contacts.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>

#include <boost/container/flat_map.hpp>

#include <unordered_map>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The volume that a mesh operation may move from one label to another. It is a part of the volumes
// that the labels have in the cells around the operation, or of the changes of these volumes by the
// motion. The part is smaller where the edges of the interface are long compared with the local
// thickness of a label. So a thin phase under large facets keeps its volume, whatever the shape of
// its cells. All operations together must not move more than a small part of a label in one
// direction.
template <class Complex> class Interface_tolerance
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Facet = typename Complex::Facet;
  using Label = typename Complex::Label;
  using Position = typename Complex::Point;
  using Vector = typename Complex::Vector;

  // If there are destinations, volumes are those with the vertices at their destinations. What the
  // motion brings together may then be joined. If `keeps_volumes`, a single operation also
  // obeys the bound for all operations together. In a coarse mesh, it could otherwise exceed it.
  explicit Interface_tolerance(const Complex& complex,
                               const Destinations<Complex>* destinations = nullptr,
                               bool keeps_volumes = false)
      : m_complex(&complex), m_destinations(destinations), m_keeps_volumes(keeps_volumes) {}

  // Returns whether a proposed replacement moves a volume that is small enough. It is a collapse of
  // a vertex of the interface, or a flip of an edge of the interface; other proposals move nothing.
  // The bound is multiplied by `factor`.
  bool allows(const Cavity<Complex>& cavity, double factor = 1) {
    forget();
    if (cavity.kind() == Proposal_kind::collapse)
      return allows_motion(cavity.vanishing_vertex(), cavity.removed(),
                           final_position(cavity.kept_vertex()), factor);
    if constexpr (Complex::dimension == 3)
      if (cavity.kind() == Proposal_kind::flip)
        return allows_flip(cavity.removed(), factor);
    return true;
  }

  // Records that the last operation that was allowed is done.
  void record() {
    for (const auto& [label, gain] : m_proposed)
      m_gains[label] += gain;
    forget();
  }

  // Forgets that an operation was allowed.
  void forget() { m_proposed.clear(); }

  // Returns whether the vertex of a star may move to a position.
  bool allows_motion(Vertex_handle v, const std::vector<Cell_handle>& star, const Position& to,
                     double factor = 1) {
    forget();
    if (!v->is_interface())
      return true;
    const Position from = final_position(v);
    const Vector step = m_complex->domain().nearest_image(from, to) - from;
    std::vector<Swept_facet> facets;
    for (Cell_handle c : star)
      for (int i = 0; i < Complex::corners; ++i)
        if (const Facet facet(c, i); c->vertex(i) != v && is_first_side(facet))
          facets.push_back(
              {facet, step * Complex::Space::facet_normal(corners(facet)) / factorial});
    return is_small(facets, star, factor);
  }

  // Returns whether a cell may get the label behind one of its facets.
  bool allows_relabeling(const Facet& facet) {
    forget();
    return is_small({{facet, -m_complex->measure(facet.first)}}, {facet.first}, 1);
  }

private:
  static constexpr double factorial = Complex::dimension == 3 ? 6 : 2; // d!

  // A facet, and the volume by which it enlarges the label of its cell.
  struct Swept_facet
  {
    Facet facet;
    double volume;
  };

  // Returns whether the edge that is common to all removed cells may be flipped. The interface
  // sweeps the tetrahedron of its two facets.
  bool allows_flip(const std::vector<Cell_handle>& removed, double factor) {
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
    const Vector height =
        m_complex->domain().nearest_image(base[0], final_position(*opposite)) - base[0];
    return is_small(
        {{facets[0], height * Complex::Space::facet_normal(base) / factorial}, {facets[1], 0}},
        removed, factor);
  }

  // The cells of a label around an operation.
  struct Surroundings
  {
    double volume = 0, area = 0; // area of their facets of the interface
    double gain = 0;             // of the label by the operation
    double change = 0;           // of the volume by the motion
  };

  // Returns whether the swept volumes are small enough for the labels on both sides of the facets
  // that move. The cells are those that the operation changes.
  bool is_small(const std::vector<Swept_facet>& facets, const std::vector<Cell_handle>& cells,
                double factor) {
    // of a label in all operations together, a third of a change that would be reported
    static constexpr double part_in_all = 3e-4;
    static constexpr double part = .03; // of the volume of a label around a well-resolved interface
    static constexpr double rounding = 1e-12;     // relative to the cube of an edge
    static constexpr double part_of_motion = .03; // of the change of this volume by the motion
    double edge = 0, swept = 0;
    boost::container::flat_map<Label, Surroundings> labels;
    for (const auto& [facet, volume] : facets) {
      edge = (std::max)(edge, longest_edge(corners(facet)));
      swept += std::abs(volume);
      labels[facet.first->subdomain_index()].gain += volume;
      labels[facet.first->neighbor(facet.second)->subdomain_index()].gain -= volume;
    }
    if (swept <= rounding * std::pow(edge, Complex::dimension))
      return true;
    for (Cell_handle c : stars_of(*m_complex, finite_vertices_of(cells)))
      if (const auto found = labels.find(c->subdomain_index()); found != labels.end()) {
        found->second.volume += m_complex->measure(c);
        found->second.change += change_by_motion(c);
        for (int i = 0; i < Complex::corners; ++i)
          if (m_complex->is_interface(Facet(c, i)))
            found->second.area += m_complex->measure(Facet(c, i));
      }
    for (const auto& [label, around] : labels) {
      // of a sheet between two parallel facets: its thickness
      const double thickness = 2 * around.volume / around.area;
      const double resolution = (std::min)(1., thickness / edge);
      const double most = (std::max)(part * resolution * std::sqrt(resolution) * around.volume,
                                     part_of_motion * std::abs(around.change));
      const double most_in_all =
          (std::max)(m_keeps_volumes ? 0 : most, part_in_all * m_complex->measure(label));
      const auto before = m_gains.find(label);
      const double gain = around.gain + (before == m_gains.end() ? 0 : before->second);
      if (!(swept <= factor * most && std::abs(gain) <= most_in_all))
        return false;
    }
    for (const auto& [label, around] : labels)
      m_proposed.emplace_back(label, around.gain);
    return true;
  }

  // Returns whether the facet is on the interface and its cell has the larger label.
  bool is_first_side(const Facet& facet) const {
    const Cell_handle c = facet.first, n = c->neighbor(facet.second);
    return !m_complex->is_infinite(c) && !m_complex->is_infinite(n) &&
           n->subdomain_index() < c->subdomain_index();
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
      result[k] = k == 0 ? p : m_complex->domain().nearest_image(result[0], p);
    }
    return result;
  }

  double change_by_motion(Cell_handle c) const {
    if (!m_destinations)
      return 0;
    const Contacts<Complex> contacts(*m_complex, *m_destinations);
    return contacts.final_volume(c) - contacts.initial_volume(c);
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
  bool m_keeps_volumes;
  std::unordered_map<Label, double> m_gains;        // of labels, by all recorded operations
  std::vector<std::pair<Label, double>> m_proposed; // gains by the last one that was allowed
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_INTERFACE_TOLERANCE_H

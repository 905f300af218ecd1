// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_RELABELING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_RELABELING_H

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The outward normals of the facets of a cell. The length of a normal is d - 1 times the measure of
// its facet.
template <class Complex> class Facet_normals
{
public:
  using Vector = typename Complex::Vector;

  Facet_normals(const Complex& complex, typename Complex::Cell_handle cell) {
    using Space = typename Complex::Space;
    for (int i = 0; i < Complex::corners; ++i) {
      std::array<typename Complex::Point, Complex::dimension> points;
      for (int k = 0; k < Complex::dimension; ++k)
        points[k] = complex.corner(cell, Space::facet_vertices[i][k]);
      m_normals[i] = Space::facet_normal(points);
      if (m_normals[i].squared_length() > m_normals[m_largest].squared_length())
        m_largest = i;
    }
  }

  const Vector& operator[](int i) const { return m_normals[i]; }

  int largest() const { return m_largest; }

  // Returns a barycentric coordinate of the projection of the opposite vertex onto a facet: the one
  // for vertex i of the cell. The sum of all normals is zero, so the coordinates sum up to 1.
  double coordinate_of_projection(int facet, int i) const {
    return -(m_normals[i] * m_normals[facet]) / m_normals[facet].squared_length();
  }

private:
  std::array<Vector, Complex::corners> m_normals;
  int m_largest = 0;
};

// Returns the largest facet of a cell if it lies on the interface and the opposite vertex touches
// it; -1 otherwise. The opposite vertex is on the interface or on the boundary of the domain.
// Between two parts of the interface with the same triangulation, vertices project to vertices, and
// two facets are equally large. Tolerances prevent rounding from deciding these cases.
template <class Complex>
int contact_facet(const Complex& complex, typename Complex::Cell_handle cell,
                  const Facet_normals<Complex>& normals) {
  static constexpr double outside = .01; // tolerance of a barycentric coordinate of the projection
  // as a fraction of the largest facet
  static constexpr double least = 1 - (Complex::dimension - 1) * outside;
  int result = -1;
  double largest = least * least * normals[normals.largest()].squared_length();
  for (int i = 0; i < Complex::corners; ++i) {
    const double size = normals[i].squared_length();
    bool touches = size > largest && complex.is_interface(std::make_pair(cell, i)) &&
                   (cell->vertex(i)->is_interface() || complex.is_boundary(cell->vertex(i)));
    for (int k = 0; k < Complex::corners && touches; ++k)
      touches = k == i || normals.coordinate_of_projection(i, k) >= -outside;
    if (touches) {
      result = i;
      largest = size;
    }
  }
  return result;
}

// Returns whether the phase of a cell wets the interface between the phase behind a facet and one
// at the opposite vertex: whether two interfaces with the phase have less energy than one without
// it.
template <class Complex>
bool wets(const Complex& complex, typename Complex::Cell_handle cell, int facet,
          const Interface_energy& energy) {
  if (!energy.has_tensions())
    return false;
  const auto own = cell->subdomain_index(), behind = cell->neighbor(facet)->subdomain_index();
  std::vector<typename Complex::Cell_handle> star;
  complex.star(cell->vertex(facet), star);
  return std::any_of(star.begin(), star.end(), [&](auto c) {
    const auto other = c->subdomain_index();
    return !complex.is_infinite(c) && other != own && other != behind &&
           energy.tension(other, behind) > energy.tension(other, own) + energy.tension(own, behind);
  });
}

} // namespace internal

template <class Complex>
bool propose_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                        double threshold, typename Complex::Label& label,
                        const Interface_energy& energy = {}) {
  if (!(cell->quality() < threshold))
    return false;
  const internal::Facet_normals<Complex> normals(complex, cell);
  const auto energy_as = [&](typename Complex::Label other) { // up to a constant factor
    double result = 0;
    for (int i = 0; i < Complex::corners; ++i)
      if (!complex.is_infinite(cell->neighbor(i)) && cell->neighbor(i)->subdomain_index() != other)
        result += energy.tension(cell->neighbor(i)->subdomain_index(), other) *
                  std::sqrt(normals[i].squared_length());
    return result;
  };
  if (const int facet = internal::contact_facet(complex, cell, normals); facet >= 0) {
    label = cell->neighbor(facet)->subdomain_index();
    return !internal::wets(complex, cell, facet, energy);
  }

  if (!(cell->quality() < threshold / 2))
    return false;
  double best = energy_as(cell->subdomain_index());
  bool is_found = false;
  for (int candidate = 0; candidate < Complex::corners; ++candidate) {
    if (!complex.is_interface(std::make_pair(cell, candidate)))
      continue;
    const auto other = cell->neighbor(candidate)->subdomain_index();
    if (const double changed = energy_as(other); changed < best) {
      best = changed;
      label = other;
      is_found = true;
    }
  }
  return is_found;
}

namespace internal {

// Faces that a cell shares with a set of other cells. A face is given by the set of its vertices,
// as bits.
template <int corners> class Trace_on_cell
{
public:
  static constexpr unsigned whole = (1u << corners) - 1; // the cell itself

  void add(unsigned vertices) { m_has[vertices] = true; }

  void add(const Trace_on_cell& other) {
    for (unsigned s = 1; s < whole; ++s)
      m_has[s] = m_has[s] || other.m_has[s];
  }

  // Returns whether the trace, completed with the faces of its simplices, is contractible. The test
  // is that it is connected and has the Euler characteristic 1. On a sphere, this excludes loops
  // and the whole sphere.
  bool is_contractible() const {
    std::array<bool, whole> has = m_has;
    for (unsigned s = whole - 1; s > 0; --s)
      for (unsigned t = s + 1; t < whole; ++t)
        has[s] = has[s] || (has[t] && (s & t) == s);
    int characteristic = 0;
    std::array<unsigned, corners> component; // vertices connected with each vertex
    unsigned vertices = 0;
    for (int i = 0; i < corners; ++i) {
      component[i] = 1u << i;
      vertices |= has[1u << i] ? 1u << i : 0u;
    }
    for (unsigned s = 1; s < whole; ++s)
      if (has[s]) {
        characteristic += dimension(s) % 2 == 1 ? -1 : 1;
        unsigned joined = 0;
        for (int i = 0; i < corners; ++i)
          joined |= (s >> i & 1) != 0 ? component[i] : 0;
        for (int i = 0; i < corners; ++i)
          if ((joined >> i & 1) != 0)
            component[i] = joined;
      }
    if (characteristic != 1)
      return false;
    for (int i = 0; i < corners; ++i)
      if ((vertices >> i & 1) != 0 && component[i] != vertices)
        return false;
    return true;
  }

private:
  static int dimension(unsigned vertices) {
    int result = -1;
    for (int i = 0; i < corners; ++i)
      result += int(vertices >> i & 1);
    return result;
  }

  std::array<bool, whole> m_has = {}; // for each proper face of the cell
};

// Returns whether relabeling a cell keeps the topology, see relabeling_keeps_topology(), with
// labels given by a function.
template <class Complex, class LabelOf>
bool keeps_topology(const Complex& complex, typename Complex::Cell_handle cell,
                    typename Complex::Label label, const LabelOf& label_of) {
  enum { of_old, of_new, of_all_but_old, of_all_but_new };
  std::array<Trace_on_cell<Complex::corners>, 4> traces;
  Trace_on_cell<Complex::corners> outside;
  std::vector<typename Complex::Cell_handle> star;
  for (int i = 0; i < Complex::corners; ++i) {
    complex.star(cell->vertex(i), star);
    for (auto c : star) {
      if (c == cell)
        continue;
      unsigned common = 0;
      for (int j = 0; j < Complex::corners; ++j)
        common |= c->has_vertex(cell->vertex(j)) ? 1u << j : 0;
      if (complex.is_infinite(c)) {
        outside.add(common);
        continue;
      }
      traces[label_of(c) == label_of(cell) ? of_old : of_all_but_old].add(common);
      traces[label_of(c) == label ? of_new : of_all_but_new].add(common);
    }
  }
  return std::all_of(traces.begin(), traces.end(), [&](auto& trace) {
    if (!trace.is_contractible())
      return false;
    trace.add(outside);
    return trace.is_contractible();
  });
}

} // namespace internal

template <class Complex>
bool relabeling_keeps_topology(const Complex& complex, typename Complex::Cell_handle cell,
                               typename Complex::Label label) {
  return internal::keeps_topology(
      complex, cell, label, [](typename Complex::Cell_handle c) { return c->subdomain_index(); });
}

template <class Complex>
bool relabeling_keeps_topology(const Complex& complex,
                               std::vector<typename Complex::Cell_handle> cells,
                               typename Complex::Label label) {
  using Cell_handle = typename Complex::Cell_handle;
  for (auto next = cells.begin(); next != cells.end(); ++next) {
    const auto label_of = [&](Cell_handle c) {
      return std::find(cells.begin(), next, c) != next ? label : c->subdomain_index();
    };
    const auto keeping = std::find_if(next, cells.end(), [&](Cell_handle c) {
      return internal::keeps_topology(complex, c, label, label_of);
    });
    if (keeping == cells.end())
      return false;
    std::iter_swap(next, keeping);
  }
  return true;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_RELABELING_H

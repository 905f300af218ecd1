// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DISPLACEMENT_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DISPLACEMENT_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Harmonic_extension.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Moving_region.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <CGAL/Origin.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The displacements of vertices by a flow of space. The flow is asked for many vertices at once,
// and for each vertex at most once.
template <class Complex> class Flow_displacements
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;
  using Flow = std::function<std::vector<Point>(const std::vector<Vertex_handle>&)>;

  // Displacements that are not shorter than `limit` are ignored. The flow may be empty. The complex
  // and the flow must outlive the object.
  Flow_displacements(const Complex& complex, const Flow& flow, double limit)
      : m_complex(complex), m_flow(flow), m_limit(limit), m_numbers(complex) {}

  // Returns whether there is a flow.
  bool is_given() const { return bool(m_flow); }

  // Finds the displacements of vertices.
  // Throws Error if the flow does not give a destination for each vertex.
  void find(const std::vector<Vertex_handle>& vertices) {
    if (!is_given())
      return;
    std::vector<Vertex_handle> unknown;
    for (Vertex_handle v : vertices)
      if (!m_numbers.has(v)) {
        m_numbers.set(v, std::uint32_t(m_displacements.size() + unknown.size()));
        unknown.push_back(v);
      }
    const std::vector<Point> destinations =
        unknown.empty() ? std::vector<Point>() : m_flow(unknown);
    if (destinations.size() != unknown.size())
      throw Error("the number of destinations of the flow differs from the number of vertices: "
                  "give one destination for each vertex");
    for (std::size_t i = 0; i < unknown.size(); ++i)
      m_displacements.push_back(m_complex.displacement(unknown[i], destinations[i]));
  }

  // Returns the displacement of a vertex; none if there is no flow, or the displacement is ignored
  // or not finite. If there is a flow, it must have been found.
  std::optional<Vector> operator()(Vertex_handle v) const {
    if (!is_given())
      return {};
    const Vector& displacement = m_displacements[m_numbers(v)];
    if (displacement.squared_length() < m_limit * m_limit)
      return displacement;
    return {};
  }

private:
  const Complex& m_complex;
  const Flow& m_flow;
  double m_limit;
  Vertex_numbers m_numbers; // places in the list below
  std::vector<Vector> m_displacements;
};

/*
Computes the displacements of all free vertices if the whole interface follows a flow that is known
everywhere: the free vertices follow the flow, too.

If the flow would move the boundary of the domain, a box, the displacement is scaled down to zero
towards the boundary. The scaling begins at half of the smallest distance between the interface and
the boundary. Returns `nullopt` if the flow is not known everywhere, the interface deviates from the
flow, the boundary is fixed, some inner vertices are not free, or the distance between interface and
boundary is too small for the longest displacement.

`displacement(v)` is the remaining displacement of an interface vertex. `flow` gives the
displacements of vertices by the flow. `longest` is the length of the longest displacement.
Differences up to `negligible` are ignored.
*/
template <class Complex, class Displacement>
std::optional<std::vector<typename Complex::Vector>>
motion_by_flow(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& free,
               const Displacement& displacement, Flow_displacements<Complex>& flow, double longest,
               double negligible) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Vector;
  static constexpr double fading = .5; // of the distance: cells at the interface keep their shape
  static constexpr double steepest = .125; // longest displacement relative to the fading distance
  const auto is_negligible = [&](const Vector& d) {
    return d.squared_length() <= negligible * negligible;
  };
  if (!flow.is_given())
    return {};
  std::vector<Vertex_handle> boundary, interface_;
  std::size_t number_of_inner = 0;
  for (Vertex_handle v : complex.finite_vertices()) {
    number_of_inner += !v->is_interface() && !complex.is_boundary(v);
    if (complex.is_boundary(v))
      boundary.push_back(v);
    if (v->is_interface())
      interface_.push_back(v);
  }
  if (free.size() != number_of_inner)
    return {};
  Extent<Complex::dimension> box;
  bool fades = false;
  flow.find(boundary);
  for (Vertex_handle v : boundary) {
    box.add(complex.position(v));
    const std::optional<Vector> known = flow(v);
    if (!known || (v->boundary_class() & Boundary_class::fixed) != 0)
      return {};
    fades = fades || !is_negligible(*known);
  }
  const auto distance = [&](Vertex_handle v) {
    double result = std::numeric_limits<double>::infinity();
    const auto p = complex.position(v);
    for (int axis = 0; fades && axis < Complex::dimension; ++axis)
      result = (std::min)({result, p[axis] - box.lower(axis), box.upper(axis) - p[axis]});
    return result;
  };
  double room = std::numeric_limits<double>::infinity();
  flow.find(interface_);
  for (Vertex_handle v : interface_) {
    const std::optional<Vector> known = flow(v);
    if (!known || !is_negligible(displacement(v) - *known))
      return {};
    room = (std::min)(room, distance(v));
    if (longest > steepest * fading * room)
      return {};
  }
  std::vector<Vector> result;
  result.reserve(free.size());
  flow.find(free);
  for (Vertex_handle v : free) {
    const std::optional<Vector> known = flow(v);
    if (!known)
      return {};
    const double reach = distance(v), full = fading * room;
    result.push_back(reach < full ? reach / full * *known : *known);
  }
  return result;
}

// Returns the free vertices near moving vertices, by increasing time stamp: the vertices within a
// number of layers of edges, or all free vertices if many vertices move. A vertex on the boundary
// of the domain is free if it can move within its sides and one of these sides has a moving vertex:
// a contact line moves the boundary vertices around it.
template <class Complex>
std::vector<typename Complex::Vertex_handle>
free_vertices_near(const Complex& complex,
                   const std::vector<typename Complex::Vertex_handle>& moving, unsigned layers) {
  using Vertex_handle = typename Complex::Vertex_handle;
  static constexpr std::size_t much = 16;
  std::vector<Vertex_handle> found;
  unsigned moving_sides = 0;
  for (Vertex_handle v : moving)
    moving_sides |= v->boundary_class();
  const auto is_free = [&](Vertex_handle v) {
    if (v->is_interface() || complex.is_infinite(v))
      return false;
    return !complex.is_boundary(v) ||
           ((v->boundary_class() & moving_sides) != 0 &&
            !Boundary_class::fixes_all(v->boundary_class(), Complex::dimension));
  };
  if (moving.size() * much > complex.number_of_vertices()) {
    for (Vertex_handle v : complex.finite_vertices())
      if (is_free(v))
        found.push_back(v);
  } else {
    std::vector<Vertex_handle> front = moving, next;
    std::vector<typename Complex::Cell_handle> star;
    Marks seen = vertex_marks(complex);
    for (unsigned layer = 0; layer < layers; ++layer) {
      next.clear();
      for (Vertex_handle v : front) {
        complex.star(v, star);
        for (auto c : star)
          for (int i = 0; i < Complex::corners; ++i)
            if (is_free(c->vertex(i)) && seen.add(c->vertex(i))) {
              found.push_back(c->vertex(i));
              next.push_back(c->vertex(i));
            }
      }
      front.swap(next);
    }
  }
  sort_by_time_stamp(found);
  return found;
}

/*
Computes the displacements of free vertices from the displacement of the interface.

Free vertices at which the flow is known follow the flow; their deviation from it is the harmonic
extension of the deviation of the interface and the boundary. The other free vertices get the
harmonic extension of the displacements around them.

`free` are the first vertices of the region. `displacement(v)` is the remaining displacement of an
interface vertex, and zero for boundary vertices. `flow` gives the displacements of vertices by the
flow, where it is known. `longest` is the length of the longest displacement.
*/
template <class Complex, class Displacement>
std::vector<typename Complex::Vector>
displacement_extension(const Moving_region<Complex>& region,
                       const std::vector<typename Complex::Vertex_handle>& free,
                       const Displacement& displacement, Flow_displacements<Complex>& flow,
                       double longest, const For_each_index& for_each_index) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Vector;
  using Number = typename Moving_region<Complex>::Number;
  static constexpr double part = 1e-6; // relative to the longest displacement
  const double negligible = part * longest;
  if (auto followed =
          motion_by_flow(region.complex(), free, displacement, flow, longest, negligible))
    return *std::move(followed);
  std::vector<Number> guided, others;
  flow.find(region.vertices());
  std::vector<Vector> result(free.size(), CGAL::NULL_VECTOR);
  for (Number i = 0; i < free.size(); ++i)
    if (const std::optional<Vector> known = flow(free[i])) {
      guided.push_back(i);
      result[i] = *known;
    } else {
      others.push_back(i);
    }
  const auto add_extension = [&](const std::vector<Number>& list, const auto& known) {
    if (list.empty())
      return;
    const Harmonic_extension<Complex> extension(region, list, known, for_each_index);
    const std::vector<Vector> motions = extension.solve();
    for (std::size_t k = 0; k < list.size(); ++k)
      result[list[k]] = result[list[k]] + motions[k];
  };
  add_extension(others, [&](Number i) {
    return i < free.size() ? *flow(free[i]) : displacement(region.vertices()[i]);
  });
  add_extension(guided, [&](Number i) {
    const Vertex_handle v = region.vertices()[i];
    const std::optional<Vector> known = flow(v);
    const Vector d = known ? displacement(v) - *known : Vector(CGAL::NULL_VECTOR);
    return d.squared_length() < negligible * negligible ? Vector(CGAL::NULL_VECTOR) : d;
  });
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DISPLACEMENT_EXTENSION_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FLOW_DISPLACEMENTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FLOW_DISPLACEMENTS_H

#include <CGAL/Deformable_simplicial_complexes/Vertex_numbers.h>
#include <CGAL/Mesh_support/Error.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The displacements of vertices by a flow of space. The flow is asked for many vertices at once,
// and for each vertex at most once.
template <class Complex> class Flow_displacements
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Approximate_point;
  using Vector = typename Complex::Approximate_vector;
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FLOW_DISPLACEMENTS_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_NUMBERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_NUMBERS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Borrowed_table.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

struct Numbered
{
  std::uint32_t epoch = 0, number = 0;
};

// Numbers that some vertices of a complex have: none at first, then those of their places in a
// list. Several threads may ask for them. To be used as long as no vertex is created or removed.
class Vertex_numbers
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  template <class Complex>
  explicit Vertex_numbers(const Complex& complex) : m_table(complex.vertex_id_bound()) {}

  template <class Complex>
  Vertex_numbers(const Complex& complex,
                 const std::vector<typename Complex::Vertex_handle>& vertices)
      : Vertex_numbers(complex) {
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
      set(vertices[i], i);
  }

  template <class Vertex_handle> bool has(Vertex_handle v) const {
    return m_table[v->id()].epoch == m_table.epoch();
  }

  template <class Vertex_handle> std::uint32_t operator()(Vertex_handle v) const {
    const Numbered& entry = m_table[v->id()];
    return entry.epoch == m_table.epoch() ? entry.number : none;
  }

  template <class Vertex_handle> void set(Vertex_handle v, std::uint32_t number) {
    m_table[v->id()] = {m_table.epoch(), number};
  }

  // A vertex without a number comes to the end of the list and gets its place. Returns its number.
  template <class Vertex_handle>
  std::uint32_t add(Vertex_handle v, std::vector<Vertex_handle>& vertices) {
    if (has(v))
      return m_table[v->id()].number;
    set(v, std::uint32_t(vertices.size()));
    vertices.push_back(v);
    return std::uint32_t(vertices.size() - 1);
  }

private:
  internal::Borrowed_table<Numbered> m_table;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_NUMBERS_H

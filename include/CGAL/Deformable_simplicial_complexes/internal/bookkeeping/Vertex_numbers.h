// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_VERTEX_NUMBERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_VERTEX_NUMBERS_H

#include <CGAL/Mesh_support/internal/threads/Borrowed_table.h>

namespace CGAL::Deformable_simplicial_complexes {

// An entry of `Vertex_numbers`. It is valid if its epoch is the current one.
struct Numbered
{
  std::uint32_t epoch = 0, // when the number was set
      number = 0;          // the number
};

// Map from vertices of a complex to numbers, for example to their places in a list. The table is
// borrowed from the current thread, so the complex does not change, and emptying it takes no time.
// Each function takes constant time.
//
// The map is valid until a vertex is created or removed. Any number of threads can call `const`
// functions at once. While one thread calls `set()` or `add()`, no other thread can use the object.
// Each thread can have maps of its own on the same complex.
class Vertex_numbers
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1); // no number

  // Constructs an empty map. Constant time, except when the table of the thread has to grow to the
  // number of vertices.
  // Throws std::bad_alloc if there is no memory
  template <class Complex>
  explicit Vertex_numbers(const Complex& complex) : m_table(complex.vertex_id_bound()) {}

  // Constructs a map from vertices to their places in a list. Linear in the list.
  // Precondition: The vertices are vertices of `complex`, and each one is in the list at most once.
  template <class Complex>
  Vertex_numbers(const Complex& complex,
                 const std::vector<typename Complex::Vertex_handle>& vertices)
      : Vertex_numbers(complex) {
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
      set(vertices[i], i);
  }

  // Returns whether a vertex has a number.
  template <class Vertex_handle> bool has(Vertex_handle v) const {
    return m_table[v->id()].epoch == m_table.epoch();
  }

  // Returns the number of a vertex, or `none`.
  template <class Vertex_handle> std::uint32_t operator()(Vertex_handle v) const {
    const Numbered& entry = m_table[v->id()];
    return entry.epoch == m_table.epoch() ? entry.number : none;
  }

  // Sets the number of a vertex.
  template <class Vertex_handle> void set(Vertex_handle v, std::uint32_t number) {
    m_table[v->id()] = {m_table.epoch(), number};
  }

  // Returns the number of a vertex. A vertex without a number is first appended to a list, and its
  // place in the list becomes its number.
  // Throws std::bad_alloc if there is no memory. The object must then not be used any more.
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_VERTEX_NUMBERS_H

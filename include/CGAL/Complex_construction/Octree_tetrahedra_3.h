// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_OCTREE_TETRAHEDRA_3_H
#define CGAL_COMPLEX_CONSTRUCTION_OCTREE_TETRAHEDRA_3_H

#include <CGAL/Complex_construction/Octree_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/threads/stoppable_sort.h>

#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

Conforming tetrahedralization of an octree. Each tetrahedron lies in one leaf. A leaf that shares no
face or edge with a smaller leaf is divided into six tetrahedra around a diagonal (Kuhn's
subdivision). Any other leaf is divided as a cone: its center is joined to the triangles of its
surface.
*/
class Octree_tetrahedra_3
{
public:
  using Point = Octree_3::Place; ///< coordinates in units of the octree

  /// Constructs the tetrahedra. n log n in their number. The order of points and tetrahedra is
  /// deterministic.
  /// \param octree the octree; not used after the construction
  /// \param label_of function object `int label_of(unsigned level, Point block)`, called for each
  ///        leaf, whose tetrahedra get this label
  /// \pre `octree.complete()` was called.
  /// \throws Interrupted_error if a `Progress_scope` stops the construction. An exception of
  ///         `label_of` passes through.
  template <class LabelOf>
  Octree_tetrahedra_3(const Octree_3& octree, const LabelOf& label_of) : m_octree(octree) {
    std::vector<std::array<std::uint64_t, 4>> corners;
    octree.for_each_leaf([&](unsigned level, const Point& block) {
      add_leaf(level, block, corners);
      labels.resize(corners.size(), label_of(level, block));
    });
    std::vector<std::uint64_t> keys;
    keys.reserve(4 * corners.size());
    for (const auto& t : corners)
      keys.insert(keys.end(), t.begin(), t.end());
    sort_and_unify(keys);
    for (const std::uint64_t k : keys)
      points.push_back(grid_place(k));
    for (const auto& t : corners) {
      Progress_scope::check();
      auto& tetrahedron = tetrahedra.emplace_back();
      for (int i = 0; i < 4; ++i)
        tetrahedron[i] =
            std::size_t(std::lower_bound(keys.begin(), keys.end(), t[i]) - keys.begin());
    }
  }

  /// Removes the tetrahedra of a label, and the points that belong to no other tetrahedron. The
  /// other tetrahedra keep their order; the points get new indices. Linear in the number of
  /// tetrahedra.
  /// \throws std::bad_alloc if there is no memory. The members are then not consistent.
  void remove(int label) {
    static constexpr std::size_t unused = -1;
    std::vector<std::size_t> numbers(points.size(), unused);
    std::vector<Point> kept_points;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
      if (labels[t] == label)
        continue;
      for (std::size_t& v : tetrahedra[t]) {
        if (numbers[v] == unused) {
          numbers[v] = kept_points.size();
          kept_points.push_back(points[v]);
        }
        v = numbers[v];
      }
      tetrahedra[kept] = tetrahedra[t];
      labels[kept++] = labels[t];
    }
    tetrahedra.resize(kept);
    labels.resize(kept);
    points.swap(kept_points);
  }

  std::vector<Point> points; ///< the points, each once
  /// Indices of the corners of each tetrahedron in `points`; all tetrahedra are positively
  /// oriented.
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels; ///< the label of each tetrahedron

private:
  using Triangle = std::array<Point, 3>;

  void add_leaf(unsigned level, const Point& block,
                std::vector<std::array<std::uint64_t, 4>>& corners) {
    const std::uint32_t side = 1u << level;
    const Point origin = {block[0] << level, block[1] << level, block[2] << level};
    if (level > 0) {
      m_surface.clear();
      for (int axis = 0; axis < 3; ++axis)
        for (const bool is_upper : {false, true})
          add_face(level, block, axis, is_upper);
      static constexpr std::size_t triangles_of_cube = 12;
      if (m_surface.size() > triangles_of_cube) {
        const Point center = {origin[0] + side / 2, origin[1] + side / 2, origin[2] + side / 2};
        for (const Triangle& t : m_surface) // counterclockwise seen from outside
          corners.push_back({grid_key(t[0]), grid_key(t[2]), grid_key(t[1]), grid_key(center)});
        return;
      }
    }
    for (int first = 0; first < 3; ++first)
      for (const int step : {1, 2}) {
        Point p = origin, q;
        p[first] += side;
        q = p;
        q[(first + step) % 3] += side;
        const Point last = {origin[0] + side, origin[1] + side, origin[2] + side};
        if (step == 1)
          corners.push_back({grid_key(origin), grid_key(p), grid_key(q), grid_key(last)});
        else
          corners.push_back({grid_key(origin), grid_key(q), grid_key(p), grid_key(last)});
      }
  }

  // Adds the triangles of a face of a leaf, counterclockwise seen from outside. They depend only on
  // the face, so the leaves on both sides have the same triangles.
  void add_face(unsigned level, Point block, int axis, bool is_upper) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Point neighbor = block;
    neighbor[axis] += is_upper ? 1 : -1; // wraps around outside the root
    block[axis] += is_upper;             // this block has the face as its lower face
    const std::uint32_t side = 1u << level, half = side / 2;
    const auto corner = [&](std::uint32_t i, std::uint32_t j) { // in half sides
      Point p = {block[0] << level, block[1] << level, block[2] << level};
      p[u] += i * half;
      p[v] += j * half;
      return p;
    };
    const auto add = [&](const Point& a, const Point& b, const Point& c) {
      m_surface.push_back(is_upper ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    const auto add_square = [&](std::uint32_t i, std::uint32_t j, std::uint32_t n) {
      add(corner(i, j), corner(i + n, j), corner(i + n, j + n));
      add(corner(i, j), corner(i + n, j + n), corner(i, j + n));
    };
    if (m_octree.is_split(level, neighbor)) {
      for (const std::uint32_t i : {0, 1})
        for (const std::uint32_t j : {0, 1})
          add_square(i, j, 1);
      return;
    }
    const std::array<Point, 4> ring = {corner(0, 0), corner(2, 0), corner(2, 2), corner(0, 2)};
    Point right = block, above = block;
    ++right[u];
    ++above[v];
    const std::array<bool, 4> has_middle = {
        is_edge_split(level, block, u), is_edge_split(level, right, v),
        is_edge_split(level, above, u), is_edge_split(level, block, v)};
    if (std::none_of(has_middle.begin(), has_middle.end(), [](bool b) { return b; })) {
      add_square(0, 0, 2);
      return;
    }
    const std::array<Point, 4> middles = {corner(1, 0), corner(2, 1), corner(1, 2), corner(0, 1)};
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % 4];
      if (has_middle[i]) {
        add(corner(1, 1), a, middles[i]);
        add(corner(1, 1), middles[i], b);
      } else
        add(corner(1, 1), a, b);
    }
  }

  // Returns whether one of the four blocks around an edge is split. The edge is parallel to `axis`
  // and starts at the lower corner of `block`.
  bool is_edge_split(unsigned level, const Point& block, int axis) const {
    for (const unsigned i : {0u, 1u})
      for (const unsigned j : {0u, 1u}) {
        Point p = block;
        p[(axis + 1) % 3] -= i;
        p[(axis + 2) % 3] -= j;
        if (m_octree.is_split(level, p))
          return true;
      }
    return false;
  }

  const Octree_3& m_octree;
  std::vector<Triangle> m_surface; // triangles of the current leaf
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_OCTREE_TETRAHEDRA_3_H

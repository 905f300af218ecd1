// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_PYRAMID_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_PYRAMID_3_H

#include <CGAL/Complex_construction/internal/conversion/Voxel_components_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A neighborhood of 27 voxels, stored as bits, with x as the fastest index. Voxel 13 is in the
// middle.
class Voxel_neighborhood_3
{
public:
  using Voxels = std::uint32_t;
  static constexpr int middle = 13, number = 27;

  // Returns whether the voxel in the middle is simple. Its neighbors are divided into two sets: the
  // voxels of `in`, and all others. The middle may move from one set to the other if the topology
  // of both sets and of their common boundary does not change. This holds if each set has exactly
  // one component at the middle, with connections through faces as well as through vertices (see
  // Bertrand and Malandain, "A new characterization of three-dimensional simple points", 1994).
  static bool is_simple(Voxels in) {
    const Voxels all = (Voxels(1) << number) - 1, center = Voxels(1) << middle;
    const Neighborhoods& n = neighborhoods();
    for (const Voxels set : {in & ~center, all & ~in & ~center}) {
      const Voxels beside = set & n.faces[middle];
      if (beside == 0 || (beside & ~reached(beside, set & n.edges, n.faces)) != 0 ||
          reached(set, set, n.vertices) != set)
        return false;
    }
    return true;
  }

private:
  struct Neighborhoods
  {
    std::array<Voxels, number> faces, vertices; // neighbors of a voxel through faces or vertices
    Voxels edges = 0;                           // neighbors of the middle through faces or edges
  };

  static const Neighborhoods& neighborhoods() {
    static const Neighborhoods result = [] {
      Neighborhoods n;
      for (int a = 0; a < number; ++a) {
        n.faces[a] = n.vertices[a] = 0;
        for (int b = 0; b < number; ++b) {
          int sum = 0, largest = 0; // sum and maximum of distances along the axes
          for (int divisor : {1, 3, 9}) {
            const int distance = (a / divisor % 3 > b / divisor % 3)
                                     ? a / divisor % 3 - b / divisor % 3
                                     : b / divisor % 3 - a / divisor % 3;
            sum += distance;
            largest = distance > largest ? distance : largest;
          }
          if (sum == 1)
            n.faces[a] |= Voxels(1) << b;
          if (largest == 1)
            n.vertices[a] |= Voxels(1) << b;
          if (a == middle && largest == 1 && sum <= 2)
            n.edges |= Voxels(1) << b;
        }
      }
      return n;
    }();
    return result;
  }

  // Returns the voxels that can be reached from the first voxel of `from` within `set`.
  static Voxels reached(Voxels from, Voxels set, const std::array<Voxels, number>& neighbors) {
    Voxels result = from & (~from + 1), front = result;
    while (front != 0) {
      Voxels next = 0;
      for (int v = 0; v < number; ++v)
        if ((front >> v & 1) != 0)
          next |= neighbors[v];
      front = next & set & ~result;
      result |= front;
    }
    return result;
  }
};

// A row of voxels, with copies of its first and its last voxel so that large blocks can fill it.
// The copies and the voxel itself together have the length of a voxel.
struct Padded_row
{
  std::size_t number;                // of voxels
  std::size_t before = 0, after = 0; // numbers of copies
  std::size_t block = 1;             // power of two that divides the number of voxels and copies

  // A row is padded if voxels fill the domain. Otherwise, the space around them has cells, too.
  Padded_row(std::size_t number_of_voxels, bool is_padded) : number(number_of_voxels) {
    static constexpr std::size_t most_copies = 8; // more would flatten cells at the interface
    const auto copies = [&](std::size_t b) { return (b - number % b) % b; };
    for (std::size_t b = 1; is_padded && b < 2 * number; b *= 2)
      if (copies(b) <= (std::min)(most_copies, number / 4))
        block = b;
    before = copies(block) / 2;
    after = copies(block) - before;
  }

  std::size_t size() const { return before + number + after; }

  // Returns the index of the voxel at a place, counted from the first copy. Places outside have the
  // nearest voxel.
  std::size_t voxel(std::ptrdiff_t place) const {
    return std::size_t(
        std::clamp(place - std::ptrdiff_t(before), std::ptrdiff_t(0), std::ptrdiff_t(number) - 1));
  }

  // Returns a coordinate in voxels from the first voxel, for a coordinate from the first copy.
  double coordinate(double x) const {
    const double u = x - double(before), last = double(number) - 1;
    return u < 1      ? 1 + (u - 1) / double(before + 1)
           : u > last ? last + (u - last) / double(after + 1)
                      : u;
  }
};

// The components of voxels in blocks with sides of 2^l voxels, for levels l from 0. A block has a
// component if its eight sub-blocks have the same one. It also has a component if sub-blocks can be
// changed to the most frequent one, one at a time, without a change of topology. Otherwise the
// block is mixed.
class Voxel_pyramid_3
{
public:
  using Place = std::array<std::size_t, 3>;
  static constexpr int mixed = -1;

  // Builds all levels whose blocks have sides of at most `edge` voxels and fit into the box of
  // labels. Level 0 always exists.
  Voxel_pyramid_3(const Voxel_components_3& components, double edge) : m_components(components) {
    for (const std::size_t n : components.size())
      m_rows.emplace_back(n, components.fill_domain());
    std::size_t smallest = components.size()[0];
    for (const std::size_t n : components.size())
      smallest = (std::min)(smallest, n);
    while (double(std::size_t(2) << m_last) <= edge && (std::size_t(2) << m_last) <= smallest)
      ++m_last;
    m_levels.resize(m_last + 1);
    set_voxels();
    for (unsigned level = 1; level <= m_last; ++level)
      set_blocks(level);
  }

  unsigned last_level() const { return m_last; }
  // Returns the number of further voxels around the box of labels, which is the side of a block of
  // the last level. If voxels fill the domain, they are copies of the outermost voxels.
  std::size_t margin() const { return std::size_t(1) << m_last; }
  // Returns the voxels along an axis.
  const Padded_row& row(int axis) const { return m_rows[axis]; }
  // Returns whether there are no cells outside the voxels.
  bool fills_domain() const { return m_components.fill_domain(); }
  const Place& size(unsigned level) const { return m_levels[level].size; }

  int operator()(unsigned level, const Place& block) const {
    return m_levels[level].components[m_levels[level].index(block)];
  }

  // Returns the component of the largest block that contains the given block and is not mixed, or
  // `mixed` if there is none.
  int component(unsigned level, Place block) const {
    int result = mixed;
    for (unsigned l = m_last + 1; l-- > level && result == mixed;)
      result =
          (*this)(l, {block[0] >> (l - level), block[1] >> (l - level), block[2] >> (l - level)});
    return result;
  }

  // Calls `visit(place)` for all places less than `size`.
  template <class Visit> static void for_each_place(const Place& size, const Visit& visit) {
    Place p;
    for (p[2] = 0; p[2] < size[2]; ++p[2])
      for (p[1] = 0; p[1] < size[1]; ++p[1]) {
        Progress_scope::check();
        for (p[0] = 0; p[0] < size[0]; ++p[0])
          visit(p);
      }
  }

private:
  struct Level
  {
    Place size;
    std::vector<int> components;

    std::size_t index(const Place& p) const { return (p[2] * size[1] + p[1]) * size[0] + p[0]; }
  };

  void set_voxels() {
    Level& voxels = m_levels[0];
    const std::size_t margin = this->margin();
    for (int axis = 0; axis < 3; ++axis)
      voxels.size[axis] = (m_rows[axis].size() + 3 * margin - 1) / margin * margin;
    voxels.components.assign(voxels.size[0] * voxels.size[1] * voxels.size[2], 0);
    for_each_place(voxels.size, [&](const Place& p) {
      Place voxel;
      bool is_inside = true;
      for (int axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t place = std::ptrdiff_t(p[axis]) - std::ptrdiff_t(margin);
        voxel[axis] = m_rows[axis].voxel(place);
        is_inside = is_inside && std::size_t(place) < m_rows[axis].size();
      }
      if (is_inside || fills_domain())
        voxels.components[voxels.index(p)] = m_components(voxel);
    });
  }

  void set_blocks(unsigned level) {
    Level &parts = m_levels[level - 1], &blocks = m_levels[level];
    for (int axis = 0; axis < 3; ++axis)
      blocks.size[axis] = parts.size[axis] / 2;
    blocks.components.resize(blocks.size[0] * blocks.size[1] * blocks.size[2]);
    for_each_place(blocks.size, [&](const Place& p) {
      bool is_inner = true; // otherwise, its neighbors are not known
      for (int axis = 0; axis < 3; ++axis)
        is_inner = is_inner && p[axis] > 0 && p[axis] + 1 < blocks.size[axis];
      blocks.components[blocks.index(p)] =
          make_uniform(parts, {2 * p[0], 2 * p[1], 2 * p[2]}, level, is_inner);
    });
  }

  // Returns the component of a block. Changes its sub-blocks if they have several components but
  // can be made uniform.
  int make_uniform(Level& parts, const Place& first, unsigned level, bool can_change) const {
    std::array<std::size_t, 8> at;
    std::array<int, 8> before;
    for (std::size_t i = 0; i < 8; ++i) {
      at[i] = parts.index({first[0] + (i & 1), first[1] + (i >> 1 & 1), first[2] + (i >> 2)});
      before[i] = parts.components[at[i]];
    }
    if (std::all_of(before.begin(), before.end(), [&](int c) { return c == before[0]; }))
      return before[0];
    if (!can_change ||
        !std::all_of(before.begin(), before.end(), [&](int c) { return is_large(c, level); }))
      return mixed;
    const int most = most_frequent(before);
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t i = 0; i < 8; ++i)
        if (parts.components[at[i]] != most && is_simple(parts, at[i], most)) {
          parts.components[at[i]] = most;
          is_changed = true;
        }
    }
    if (std::all_of(at.begin(), at.end(),
                    [&](std::size_t a) { return parts.components[a] == most; }))
      return most;
    for (std::size_t i = 0; i < 8; ++i)
      parts.components[at[i]] = before[i];
    return mixed;
  }

  // Returns whether a component has at least the volume of eight blocks. Smaller components keep
  // their voxels.
  bool is_large(int component, unsigned level) const {
    static constexpr std::size_t blocks = 8;
    return component == 0 ||
           (component != mixed && m_components.number_of_voxels(component) >= blocks << 3 * level);
  }

  static int most_frequent(std::array<int, 8> components) {
    std::sort(components.begin(), components.end());
    int result = components[0];
    std::ptrdiff_t most = 0;
    for (auto first = components.begin(); first != components.end();) {
      const auto last = std::upper_bound(first, components.end(), *first);
      if (last - first > most) {
        most = last - first;
        result = *first;
      }
      first = last;
    }
    return result;
  }

  // Returns whether a sub-block may change to another component: the sub-blocks around it have no
  // third component, and the topology does not change.
  static bool is_simple(const Level& parts, std::size_t at, int component) {
    Voxel_neighborhood_3::Voxels in = 0;
    const std::size_t row = parts.size[0], layer = parts.size[0] * parts.size[1];
    for (int i = 0; i < Voxel_neighborhood_3::number; ++i) {
      const std::size_t x = std::size_t(i % 3), y = std::size_t(i / 3 % 3), z = std::size_t(i / 9);
      const int there = parts.components[at + x + y * row + z * layer - 1 - row - layer];
      if (there == component)
        in |= Voxel_neighborhood_3::Voxels(1) << i;
      else if (there != parts.components[at])
        return false;
    }
    return Voxel_neighborhood_3::is_simple(in);
  }

  const Voxel_components_3& m_components;
  std::vector<Padded_row> m_rows; // along each axis
  unsigned m_last = 0;
  std::vector<Level> m_levels;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_PYRAMID_3_H

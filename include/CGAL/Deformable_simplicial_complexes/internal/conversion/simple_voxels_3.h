// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_SIMPLE_VOXELS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_SIMPLE_VOXELS_3_H

#include <array>
#include <cstdint>

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_SIMPLE_VOXELS_3_H

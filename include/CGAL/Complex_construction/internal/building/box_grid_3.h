// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOX_GRID_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOX_GRID_3_H

#include <CGAL/Complex_construction/internal/building/torus_grid.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns a grid of a box: the tetrahedra of a body-centered cubic lattice. On the boundary of the
// box, each square face and the center next to it form a pyramid, which is split into two
// tetrahedra. Throws `Error` if the grid is too large.
inline Grid<3> box_grid(const Bbox_3& box, double edge) {
  using Place = std::array<std::size_t, 3>;
  Place n;
  for (int axis = 0; axis < 3; ++axis)
    n[axis] = edges_in_period(box.max(axis) - box.min(axis), edge, 2);
  check_number_of_boxes(double(n[0]) * double(n[1]) * double(n[2]));
  Grid<3> grid;
  const std::size_t centers = (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
  const auto corner = [&](const Place& p) {
    return (p[0] * (n[1] + 1) + p[1]) * (n[2] + 1) + p[2];
  };
  const auto center = [&](const Place& p) { return centers + (p[0] * n[1] + p[1]) * n[2] + p[2]; };
  const auto for_each = [](const Place& size, const auto& visit) {
    for (Place p = {}; p[0] < size[0]; ++p[0])
      for (p[1] = 0; p[1] < size[1]; ++p[1])
        for (p[2] = 0; p[2] < size[2]; ++p[2]) {
          Progress_scope::check();
          visit(p);
        }
  };
  const auto add_point = [&](const Place& p, double shift) {
    std::array<double, 3> x;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box.min(axis), high = box.max(axis);
      x[axis] = p[axis] == n[axis]
                    ? high
                    : low + (high - low) * ((double(p[axis]) + shift) / double(n[axis]));
    }
    grid.points.push_back(x);
  };
  for_each({n[0] + 1, n[1] + 1, n[2] + 1}, [&](const Place& p) { add_point(p, 0); });
  for_each(n, [&](const Place& p) { add_point(p, .5); });
  for (int axis = 0; axis < 3; ++axis) {
    Place faces = n;
    ++faces[axis];
    for_each(faces, [&](const Place& p) { // the face below the cube `p`
      std::array<std::size_t, 4> face;    // counterclockwise, seen from that cube
      for (int k = 0; k < 4; ++k) {
        Place at = p;
        at[(axis + 1) % 3] += k == 1 || k == 2;
        at[(axis + 2) % 3] += k >= 2;
        face[k] = corner(at);
      }
      Place below = p;
      --below[axis];
      if (p[axis] == 0) {
        for (int k : {0, 2})
          grid.cells.push_back({face[k], face[k + 1], face[(k + 2) % 4], center(p)});
      } else if (p[axis] == n[axis]) {
        for (int k : {0, 2})
          grid.cells.push_back({face[k], face[(k + 2) % 4], face[k + 1], center(below)});
      } else {
        for (int k = 0; k < 4; ++k)
          grid.cells.push_back({center(below), center(p), face[k], face[(k + 1) % 4]});
      }
    });
  }
  return grid;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOX_GRID_3_H

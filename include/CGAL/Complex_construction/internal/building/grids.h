// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_GRIDS_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_GRIDS_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Points, and cells of nearly equal shape that fill a flat torus or a box.
template <int d> struct Grid
{
  std::vector<std::array<double, d>> points;
  std::vector<std::array<std::size_t, d + 1>> cells;
};

// Returns the number of edges in a period, rounded, and at least `least`. Throws `Error` if this
// number exceeds 2^20, or if a length is not positive and finite.
inline std::size_t edges_in_period(double period, double edge, std::size_t least) {
  static constexpr double most = 1 << 20;
  if (!(edge > 0) || !std::isfinite(edge))
    throw Error("the target edge length is not positive and finite: use more than 0");
  if (!(period > 0) || !std::isfinite(period))
    throw Error("the box is empty or not finite: use a finite box with positive sides");
  const double number = std::round(period / edge);
  if (!(number <= most))
    throw Error("the target edge length is too short for the domain: use more than a millionth of "
                "its extent");
  return (std::max)(least, std::size_t(number));
}

// Throws `Error` if a grid would have more than 2^30 boxes.
inline void check_number_of_boxes(double number) {
  static constexpr double most = 1 << 30;
  if (!(number <= most))
    throw Error("the target edge length is too short for the domain: use a length that gives at "
                "most 2^30 cells");
}

// Returns a grid of a flat torus: rows of nearly regular triangles, where every second row is
// shifted by half an edge. Throws `Error` if the grid is too large.
inline Grid<2> torus_grid(const std::array<double, 2>& periods, double edge) {
  const double height = std::sqrt(3.) / 2;
  const std::size_t columns = edges_in_period(periods[0], edge, 3),
                    rows = 2 * edges_in_period(periods[1] / 2, edge * height, 2);
  check_number_of_boxes(double(columns) * double(rows));
  Grid<2> grid;
  const auto index = [&](std::size_t i, std::size_t j) { return j % rows * columns + i % columns; };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      Progress_scope::check();
      const std::size_t shift = j % 2;
      grid.points.push_back({periods[0] * (double(i) + .5 * double(shift)) / double(columns),
                             periods[1] * double(j) / double(rows)});
      grid.cells.push_back({index(i, j), index(i + 1, j), index(i + shift, j + 1)});
      grid.cells.push_back({index(i + 1 - shift, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return grid;
}

// Calls `visit(p)` for all places of a grid of a size.
template <class Visit>
void for_each_place(const std::array<std::size_t, 3>& size, const Visit& visit) {
  for (std::array<std::size_t, 3> p = {}; p[0] < size[0]; ++p[0])
    for (p[1] = 0; p[1] < size[1]; ++p[1])
      for (p[2] = 0; p[2] < size[2]; ++p[2]) {
        Progress_scope::check();
        visit(p);
      }
}

// Returns the corners of the face below a cube, counterclockwise seen from the cube.
template <class Corner>
std::array<std::size_t, 4> face_below(const std::array<std::size_t, 3>& cube, int axis,
                                      const Corner& corner) {
  std::array<std::size_t, 4> result;
  for (int k = 0; k < 4; ++k) {
    auto at = cube;
    at[(axis + 1) % 3] += k == 1 || k == 2;
    at[(axis + 2) % 3] += k >= 2;
    result[k] = corner(at);
  }
  return result;
}

// Returns the Delaunay tetrahedra of a body-centered cubic lattice on a flat torus. Four tetrahedra
// surround each edge between the centers of two adjacent cubes. Each of them contains one edge of
// the common face of the two cubes. Throws `Error` if the grid is too large.
inline Grid<3> torus_grid(const std::array<double, 3>& periods, double edge) {
  std::array<std::size_t, 3> n;
  for (int axis = 0; axis < 3; ++axis)
    n[axis] = edges_in_period(periods[axis], edge, 3);
  check_number_of_boxes(double(n[0]) * double(n[1]) * double(n[2]));
  Grid<3> grid;
  const std::size_t boxes = n[0] * n[1] * n[2];
  grid.points.resize(2 * boxes);
  const auto corner = [&](const std::array<std::size_t, 3>& box) {
    return (box[0] % n[0] * n[1] + box[1] % n[1]) * n[2] + box[2] % n[2];
  };
  for_each_place(n, [&](const std::array<std::size_t, 3>& box) {
    for (int axis = 0; axis < 3; ++axis) {
      const double step = periods[axis] / double(n[axis]);
      grid.points[corner(box)][axis] = double(box[axis]) * step;
      grid.points[boxes + corner(box)][axis] = (double(box[axis]) + .5) * step;
    }
    for (int axis = 0; axis < 3; ++axis) {
      auto next = box;
      ++next[axis];
      const auto face = face_below(next, axis, corner);
      for (int k = 0; k < 4; ++k)
        grid.cells.push_back(
            {boxes + corner(box), boxes + corner(next), face[k], face[(k + 1) % 4]});
    }
  });
  return grid;
}

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
  for_each_place({n[0] + 1, n[1] + 1, n[2] + 1}, [&](const Place& p) { add_point(p, 0); });
  for_each_place(n, [&](const Place& p) { add_point(p, .5); });
  for (int axis = 0; axis < 3; ++axis) {
    Place faces = n;
    ++faces[axis];
    for_each_place(faces, [&](const Place& p) {
      const auto face = face_below(p, axis, corner);
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

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_GRIDS_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOX_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOX_2_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/internal/building/Curve_soup_2.h>
#include <CGAL/Complex_construction/internal/building/grids.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the default enclosing box: a square centered at the barycenter of the points. Its half
// side is 2.5 times the largest distance of a point from the barycenter, as in 3D.
inline Bbox_2 default_box(const std::vector<Planar_kernel::Point_2>& points) {
  static constexpr double margin = 2.5;
  double x = 0, y = 0, radius = 0;
  for (const auto& p : points) {
    x += p.x() / double(points.size());
    y += p.y() / double(points.size());
  }
  for (const auto& p : points)
    radius = (std::max)(radius, std::hypot(p.x() - x, p.y() - y));
  return {x - margin * radius, y - margin * radius, x + margin * radius, y + margin * radius};
}

// Throws `Error` if the extent of the curves or of the box is not between 1e-30 and 1e30. Throws
// `Invalid_surface_error` if a curve is not strictly inside the box.
inline void check_enclosed(const Curve_soup_2& soup, const Bbox_2& box) {
  const auto is_measurable = [](const std::vector<std::array<double, 2>>& points) {
    return std::all_of(points.begin(), points.end(),
                       has_finite_coordinates<std::array<double, 2>>) &&
           extent_of<2>(points).is_measurable();
  };
  std::vector<std::array<double, 2>> points;
  for (const auto& p : soup.points)
    points.push_back({p.x(), p.y()});
  if (!is_measurable(points) ||
      !is_measurable({{box.xmin(), box.ymin()}, {box.xmax(), box.ymax()}}))
    throw Error(
        "the size of the curves or of the enclosing box is not between 1e-30 and 1e30: scale "
        "the curves, or give another box");
  const auto is_inside = [&](const Planar_kernel::Point_2& p) {
    return box.xmin() < p.x() && p.x() < box.xmax() && box.ymin() < p.y() && p.y() < box.ymax();
  };
  for (std::size_t w = 0; w < soup.walls.size(); ++w)
    for (std::size_t v : soup.walls[w].vertices)
      if (!is_inside(soup.points[v]))
        refuse_curve(Invalid_surface_error::Reason::outside_enclosing_box,
                     "is not strictly inside the enclosing box: give a larger box",
                     soup.walls[w].surface, soup.walls[w].surface, {soup.segments[w]});
}

// Returns the box of the options, or else the default box. Throws like `check_enclosed()`.
inline Bbox_2 enclosing_box(const Curve_soup_2& soup, const Construction_options<2>& options) {
  const Bbox_2 box = options.enclosing_box ? *options.enclosing_box : default_box(soup.points);
  check_enclosed(soup, box);
  return box;
}

// Returns the box of a flat torus, centered at the bounding box of the curves. Throws like
// `check_enclosed()`.
inline Bbox_2 box_of_torus(const Curve_soup_2& soup, const std::array<double, 2>& periods) {
  Bbox_2 extent = soup.points.front().bbox();
  for (const auto& p : soup.points)
    extent += p.bbox();
  const double x = (extent.xmin() + extent.xmax() - periods[0]) / 2,
               y = (extent.ymin() + extent.ymax() - periods[1]) / 2;
  const Bbox_2 box(x, y, x + periods[0], y + periods[1]);
  check_enclosed(soup, box);
  return box;
}

// Identifies opposite sides of a filled box.
// \pre Opposite sides have corresponding points.
inline void join_sides(const Bbox_2& box, std::vector<Planar_kernel::Point_2>& points,
                       std::vector<std::array<std::size_t, 3>>& triangles) {
  const auto image = [&](const Planar_kernel::Point_2& p) {
    return std::array<double, 2>{p.x() == box.xmax() ? box.xmin() : p.x(),
                                 p.y() == box.ymax() ? box.ymin() : p.y()};
  };
  std::map<std::array<double, 2>, std::size_t> places;
  std::vector<std::size_t> joined(points.size());
  std::vector<Planar_kernel::Point_2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [place, is_new] = places.emplace(image(points[i]), kept.size());
    joined[i] = place->second;
    if (is_new)
      kept.emplace_back(place->first[0], place->first[1]);
  }
  points.swap(kept);
  for (auto& t : triangles)
    for (std::size_t& v : t)
      v = joined[v];
}

// Returns a grid of a box: rows of nearly regular triangles, where every second row is shifted by
// half an edge and clipped at the sides of the box. Throws `Error` if the grid is too large.
inline Grid<2> box_grid(const Bbox_2& box, double edge) {
  const double height = std::sqrt(3.) / 2, width = box.xmax() - box.xmin(),
               total = box.ymax() - box.ymin();
  const std::size_t columns = edges_in_period(width, edge, 2),
                    rows = edges_in_period(total, edge * height, 2);
  check_number_of_boxes(double(columns) * double(rows));
  Grid<2> grid;
  const auto at = [](double low, double high, double i, double n) {
    return i == n ? high : low + (high - low) * (i / n);
  };
  std::size_t below = 0; // the first point of the previous row
  for (std::size_t j = 0; j <= rows; ++j) {
    const bool is_shifted = j % 2 == 1;
    const std::size_t here = grid.points.size(), n = columns + 1 + is_shifted;
    for (std::size_t i = 0; i < n; ++i) {
      const double column =
          (std::min)(double(columns), (std::max)(0., double(i) - .5 * is_shifted));
      grid.points.push_back({at(box.xmin(), box.xmax(), column, double(columns)),
                             at(box.ymin(), box.ymax(), double(j), double(rows))});
    }
    // The triangles lie between an unshifted row and a shifted one; either may be the upper one.
    const std::size_t even = is_shifted ? below : here, odd = is_shifted ? here : below;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (is_shifted)
        grid.cells.push_back({a, b, c});
      else
        grid.cells.push_back({b, a, c});
    };
    for (std::size_t i = 0; j > 0 && i <= columns; ++i) {
      add(even + i, odd + i + 1, odd + i);
      if (i < columns)
        add(even + i, even + i + 1, odd + i + 1);
    }
    below = here;
  }
  return grid;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOX_2_H

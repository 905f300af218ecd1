// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_holes.h"
#include "fluids/fluid_shapes.h"

namespace dsc {
namespace {

using Place = std::array<int, 3>; // in a grid

/// The grid of all faces of boxes, divided further by the target edge length. In the plane, it has
/// a single layer.
class Grid_of_boxes
{
public:
  Grid_of_boxes(const std::vector<Labeled_box>& boxes, double edge);

  std::set<int> labels() const;

  std::array<double, 3> point(const Place& at) const {
    return {m_points[0][std::size_t(at[0])], m_points[1][std::size_t(at[1])],
            m_points[2][std::size_t(at[2])]};
  }

  /// Calls f(axis, at) for each facet of the boundary of a label: the facet perpendicular to an
  /// axis whose corner with the least coordinates is at a place.
  template <class Function> void for_each_facet(int label, const Function& f) const;

private:
  bool is_flat(std::size_t axis) const { return m_lines[axis].size() == 1; }
  int number_of_cells(std::size_t axis) const {
    return is_flat(axis) ? 1 : int(m_points[axis].size()) - 1;
  }
  bool has_label(const Place& cell, int label) const;
  bool covers(const Labeled_box& labeled, const Place& cell) const;
  bool is_displaced(const Labeled_box& hole, const Place& cell) const;
  void require_few_facets(double edge) const;

  const std::vector<Labeled_box>& m_boxes;
  std::array<std::set<double>, 3> m_lines;     // coordinates of the faces
  std::array<std::vector<double>, 3> m_points; // coordinates of all layers
};

Grid_of_boxes::Grid_of_boxes(const std::vector<Labeled_box>& boxes, double edge) : m_boxes(boxes) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const Labeled_box& labeled : boxes) {
      m_lines[axis].insert(labeled.box.from[axis]);
      m_lines[axis].insert(labeled.box.to[axis]);
    }
  require_few_facets(edge);
  for (std::size_t axis = 0; axis < 3; ++axis)
    m_points[axis] = divided_lines(m_lines[axis], edge);
}

/// Throws Input_error if there would be too many facets.
void Grid_of_boxes::require_few_facets(double edge) const {
  std::array<double, 3> cells;
  for (std::size_t axis = 0; axis < 3; ++axis)
    cells[axis] = (std::max)(1., (*m_lines[axis].rbegin() - *m_lines[axis].begin()) / edge);
  number_of_parts(cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0]);
}

std::set<int> Grid_of_boxes::labels() const {
  std::set<int> result;
  for (const Labeled_box& labeled : m_boxes)
    result.insert(labeled.label);
  return result;
}

/// Returns whether a box contains a cell of the grid, which may be outside the grid.
bool Grid_of_boxes::covers(const Labeled_box& labeled, const Place& cell) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_flat(axis))
      continue;
    const auto i = std::size_t(cell[axis]);
    if (cell[axis] < 0 || i + 1 >= m_points[axis].size() ||
        m_points[axis][i] < labeled.box.from[axis] || m_points[axis][i + 1] > labeled.box.to[axis])
      return false;
  }
  return true;
}

/// Returns whether a cell in a hole is in a liquid.
bool Grid_of_boxes::is_displaced(const Labeled_box& hole, const Place& cell) const {
  std::array<double, 3> middle = {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!is_flat(axis)) {
      const auto i = std::size_t(cell[axis]);
      middle[axis] = (m_points[axis][i] + m_points[axis][i + 1]) / 2;
    }
  const auto& boxes = hole.boxes_around;
  const auto last = std::find_if(boxes.rbegin(), boxes.rend(), [&](const auto& around) {
    return is_about(around.first, middle, is_flat(2) ? 2 : 3);
  });
  return last == boxes.rend() ? hole.is_in_liquid : last->second;
}

/// Returns whether a cell of the grid, which may be outside the grid, has a label.
bool Grid_of_boxes::has_label(const Place& cell, int label) const {
  const auto last = std::find_if(m_boxes.rbegin(), m_boxes.rend(), [&](const Labeled_box& labeled) {
    return covers(labeled, cell) && (!labeled.is_hole || is_displaced(labeled, cell));
  });
  return last != m_boxes.rend() && last->label == label;
}

template <class Function> void Grid_of_boxes::for_each_facet(int label, const Function& f) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_flat(axis))
      continue;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (double line : m_lines[axis]) {
      Place at;
      at[axis] = int(std::lower_bound(m_points[axis].begin(), m_points[axis].end(), line) -
                     m_points[axis].begin());
      for (at[u] = 0; at[u] < number_of_cells(u); ++at[u])
        for (at[v] = 0; at[v] < number_of_cells(v); ++at[v]) {
          Place before = at;
          --before[axis];
          if (has_label(before, label) != has_label(at, label))
            f(axis, at);
        }
    }
  }
}

/// Numbers the points of a grid in the order of their first use.
template <class Point> class Numbered_points
{
public:
  Numbered_points(const Grid_of_boxes& grid, std::vector<Point>& points)
      : m_grid(grid), m_points(points) {}

  std::size_t operator()(const Place& at) {
    const auto [place, is_new] = m_known.emplace(at, m_points.size());
    if (is_new)
      m_points.push_back(from_coordinates<Point>(m_grid.point(at)));
    return place->second;
  }

private:
  const Grid_of_boxes& m_grid;
  std::vector<Point>& m_points;
  std::map<Place, std::size_t> m_known;
};

/// Returns a place moved by one along an axis.
Place next(Place at, std::size_t axis) {
  ++at[axis];
  return at;
}

/// Returns whether two boxes must be in the same group: whether their boundaries have a common
/// point, or a box is strictly inside a hole.
bool are_joined(const Labeled_box& first, const Labeled_box& second, std::size_t dimension) {
  const Box_shape &a = first.box, &b = second.box;
  bool meet = true, has_a_inside = true, has_b_inside = true; // strictly inside the other box
  for (std::size_t i = 0; i < dimension; ++i) {
    meet = meet && a.from[i] <= b.to[i] && b.from[i] <= a.to[i];
    has_a_inside = has_a_inside && b.from[i] < a.from[i] && a.to[i] < b.to[i];
    has_b_inside = has_b_inside && a.from[i] < b.from[i] && b.to[i] < a.to[i];
  }
  return meet && (!has_a_inside || second.is_hole) && (!has_b_inside || first.is_hole);
}

/// Returns a hole with the boxes that it meets. If only boxes of liquids are around it, the hole is
/// cut to their bounding box. Returns nothing if it meets no liquid.
std::optional<Labeled_box> hole_in_boxes(const Fluid_scene& scene, const Box_hole& hole,
                                         const std::vector<Labeled_box>& boxes) {
  Labeled_box result{label_of_holes(scene), hole.box, true, {}, hole.is_in_liquid};
  std::optional<Box_shape> bounds; // of liquids
  for (const Labeled_box& other : boxes) {
    if (!boxes_overlap(hole.box, other.box, scene.dimension))
      continue;
    result.boxes_around.emplace_back(other.box, is_liquid(scene, other.label));
    if (!is_liquid(scene, other.label))
      continue;
    if (!bounds)
      bounds = other.box;
    for (std::size_t i = 0; i < 3; ++i) {
      bounds->from[i] = (std::min)(bounds->from[i], other.box.from[i]);
      bounds->to[i] = (std::max)(bounds->to[i], other.box.to[i]);
    }
  }
  if (hole.is_in_liquid)
    return result;
  if (!bounds)
    return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    result.box.from[i] = (std::max)(result.box.from[i], bounds->from[i]);
    result.box.to[i] = (std::min)(result.box.to[i], bounds->to[i]);
  }
  return result;
}

/// Returns the boundary of the region of each label in boxes. `add(number, boundary, axis, at)`
/// adds the facet at a place, perpendicular to an axis. `number(place)` is the number of a point.
template <class Boundary, class Add>
std::vector<Boundary> boundaries_of_boxes(const std::vector<Labeled_box>& boxes, double edge,
                                          const Add& add) {
  const Grid_of_boxes grid(boxes, edge);
  std::vector<Boundary> result;
  for (int label : grid.labels()) {
    Boundary boundary;
    boundary.label = label;
    Numbered_points number(grid, boundary.points);
    grid.for_each_facet(
        label, [&](std::size_t axis, const Place& at) { add(number, boundary, axis, at); });
    if (!boundary.points.empty())
      result.push_back(std::move(boundary));
  }
  return result;
}

} // namespace

std::vector<std::vector<Labeled_box>> groups_of_boxes(const Fluid_scene& scene,
                                                      const std::vector<Box_hole>& holes) {
  std::vector<Labeled_box> boxes, in_boxes;
  for (const auto& [label, shape] : shapes_of(scene))
    if (const auto* box = std::get_if<Box_shape>(shape))
      boxes.push_back({label, *box});
  for (const Box_hole& hole : holes)
    if (auto in = hole_in_boxes(scene, hole, boxes))
      in_boxes.push_back(std::move(*in));
  boxes.insert(boxes.end(), in_boxes.begin(), in_boxes.end());
  std::vector<std::size_t> group(boxes.size()); // the number of the first box of each group
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    group[i] = i;
    for (std::size_t j = 0; j < i; ++j)
      if (are_joined(boxes[i], boxes[j], std::size_t(scene.dimension))) {
        const auto [least, largest] = std::minmax({group[i], group[j]});
        std::replace(group.begin(), group.begin() + std::ptrdiff_t(i) + 1, largest, least);
      }
  }
  std::map<std::size_t, std::vector<Labeled_box>> by_group;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    by_group[group[i]].push_back(boxes[i]);
  std::vector<std::vector<Labeled_box>> result;
  for (auto& entry : by_group)
    result.push_back(std::move(entry.second));
  return result;
}

std::vector<Surface> surfaces_of_boxes(const std::vector<Labeled_box>& boxes, double edge) {
  return boundaries_of_boxes<Surface>(
      boxes, edge, [](auto& number, Surface& surface, std::size_t axis, const Place& at) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const std::size_t a = number(at), b = number(next(at, u)), c = number(next(next(at, u), v)),
                          d = number(next(at, v));
        // Alternating diagonals, so that no direction is preferred.
        if ((at[u] + at[v]) % 2 == 0) {
          surface.triangles.push_back({a, b, c});
          surface.triangles.push_back({a, c, d});
        } else {
          surface.triangles.push_back({a, b, d});
          surface.triangles.push_back({b, c, d});
        }
      });
}

std::vector<Curve> curves_of_boxes(const std::vector<Labeled_box>& boxes, double edge) {
  return boundaries_of_boxes<Curve>(
      boxes, edge, [](auto& number, Curve& curve, std::size_t axis, const Place& at) {
        const std::size_t a = number(at), b = number(next(at, 1 - axis));
        curve.segments.push_back({a, b});
      });
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESIC_FAN_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESIC_FAN_2_H

#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_equations_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <map>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The fan of geodesics from the source in all directions. All rays grow in equal steps. A ray ends
when a shorter geodesic leads to its end. New rays are inserted between rays that are far from each
other. In each step, two neighboring rays bound a cell. The cells cover the surface once, and a
little more where rays end. A point is therefore in cells of all shortest geodesics to it.
*/
template <class Metric> class Geodesic_fan_2
{
public:
  using Equations = Geodesic_equations_2<Metric>;
  using Point = typename Equations::Point;

  // A direction, and the first shorter geodesic that was found to a point of its ray. There is none
  // if the ray has the longest distance, leaves the chart, or was ended because both neighbors had
  // ended.
  struct Direction
  {
    double angle;
    double length; // length of the ray up to this point
    std::optional<Geodesic_2> shorter;
  };

  // Grows the fan until all rays have ended, or up to the longest distance.
  Geodesic_fan_2(const Equations& equations, double longest_distance)
      : m_equations(equations), m_step(equations.step()),
        m_first_length(equations.geodesics().shortest_length(equations.step())) {
    const auto& periods = equations.domain().periods();
    for (int axis = 0; axis < 2; ++axis)
      m_numbers[axis] = (std::max)(
          1, (std::min)(most_squares, int(periods[axis] / (square_size * equations.spacing()))));
    begin();
    for (; is_going() && length(m_level) < longest_distance; ++m_level) {
      refine();
      advance();
    }
    m_is_complete = !is_going();
  }

  // Returns whether all rays have ended before the longest distance.
  bool is_complete() const { return m_is_complete; }

  // Returns the directions, sorted by angle.
  std::vector<Direction> directions() const {
    std::vector<Direction> result;
    for (const auto& [angle, ray] : m_rays)
      result.push_back({angle, ray.cut_length, ray.shorter});
    return result;
  }

  // Returns approximations of geodesics to a point. All shortest geodesics are among them.
  std::vector<Geodesic_2> candidates(const Point& p) const {
    std::vector<Geodesic_2> result;
    const auto it = m_squares.find(square(p));
    if (it != m_squares.end())
      for (std::uint32_t i : it->second)
        if (const auto g = locate(m_cells[i], p))
          result.push_back(*g);
    return result;
  }

private:
  using State = Geodesic_state;
  using Square = std::array<int, 2>;

  static constexpr int first_rays = 32;       // number of directions at the beginning
  static constexpr double farthest = 2;       // in steps, between neighboring rays
  static constexpr double narrowest = 1e-10;  // in radians, between neighboring rays
  static constexpr unsigned overlap = 3;      // number of steps of a ray beyond its end
  static constexpr double square_size = 2;    // in spacings; squares give access to cells
  static constexpr int most_squares = 1 << 9; // along an axis
  static constexpr std::size_t most_cells = 1 << 23;

  struct Ray
  {
    State state;                       // at the current level, or at the end
    unsigned left = overlap;           // number of steps until the ray stops
    double cut_length = 0;             // `length` of the `Direction`
    std::optional<Geodesic_2> shorter; // `shorter` of the `Direction`
  };

  // The cell between two rays and between two levels.
  struct Cell
  {
    std::array<Point, 4> corners; // unwrapped: right, left, far left, far right
    double right, angle;          // of the right ray; from it to the left ray
    std::uint32_t level;
  };

  double length(unsigned level) const { return m_first_length + level * m_step; }

  void begin() {
    const int number =
        (std::max)(first_rays, int(std::ceil(full_turn() * m_first_length / m_step)));
    static constexpr double first = .6180339887498949; // part of an angle: no direction is special
    for (int i = 0; i < number; ++i)
      add_ray(full_turn() * (i + first) / number);
  }

  void add_ray(double angle) {
    m_rays[angle].state = m_equations.geodesics().shoot(angle, length(m_level));
  }

  bool is_going() const {
    return std::any_of(m_rays.begin(), m_rays.end(),
                       [](const auto& item) { return item.second.left > 0; });
  }

  using Ray_iterator = typename std::map<double, Ray>::iterator;

  Ray_iterator next(Ray_iterator it) { return ++it == m_rays.end() ? m_rays.begin() : it; }
  Ray_iterator previous(Ray_iterator it) {
    return --(it == m_rays.begin() ? it = m_rays.end() : it);
  }

  // Inserts a ray between neighboring rays that are far from each other and have not stopped.
  void refine() {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      std::vector<double> angles;
      for (auto it = m_rays.begin(); it != m_rays.end(); ++it) {
        const auto left = next(it);
        const double angle = gap_between(it->first, left->first);
        if (it->second.left > 0 && left->second.left > 0 && angle > narrowest &&
            distance(it->second.state, left->second.state) > farthest * m_step)
          angles.push_back(canonical_angle(it->first + angle / 2));
      }
      for (double angle : angles)
        if (m_rays.count(angle) == 0) {
          add_ray(angle);
          has_changed = true;
        }
    }
  }

  double distance(const State& a, const State& b) const {
    const Point p = Equations::point(a),
                q = m_equations.domain().nearest_image(p, Equations::point(b));
    return m_equations.geodesics().length(p, q.x() - p.x(), q.y() - p.y());
  }

  // Extends all rays by one step.
  void advance() {
    std::vector<Ray_iterator> going;
    std::vector<State> before;
    for (auto it = m_rays.begin(); it != m_rays.end(); ++it)
      if (it->second.left > 0) {
        going.push_back(it);
        before.push_back(it->second.state);
        it->second.state = m_equations.geodesics().advance(it->second.state, m_step);
      }
    for (std::size_t i = 0; i < going.size(); ++i) {
      const std::size_t j = (i + 1) % going.size();
      if (next(going[i]) == going[j] && i != j)
        add_cell(*going[i], before[i], *going[j], before[j]);
    }
    for (Ray_iterator it : going)
      if (!it->second.shorter)
        look_for_shorter(it->first, it->second);
    // A ray that has ended still grows until its neighbors have ended, so that cells cover all
    // ends.
    for (Ray_iterator it : going) {
      Ray& ray = it->second;
      const Ray &left = next(it)->second, &right = previous(it)->second;
      const bool is_alone = !ray.shorter && left.left == 0 && right.left == 0;
      if (is_alone || !m_equations.geodesics().is_in_chart(ray.state))
        ray.left = 0;
      else if (ray.shorter && left.shorter && right.shorter)
        --ray.left;
    }
  }

  void add_cell(const std::pair<const double, Ray>& right, const State& right_before,
                const std::pair<const double, Ray>& left, const State& left_before) {
    if (m_cells.size() >= most_cells)
      throw Error("the cut locus needs too many geodesics: use a larger spacing and step");
    Cell cell;
    const Point origin = m_equations.domain().canonical(Equations::point(right_before));
    const auto put = [&](int i, const State& s) {
      cell.corners[i] = m_equations.domain().nearest_image(i == 0 ? origin : cell.corners[0],
                                                           Equations::point(s));
    };
    put(0, right_before);
    put(1, left_before);
    put(2, left.second.state);
    put(3, right.second.state);
    cell.right = right.first;
    cell.angle = gap_between(right.first, left.first);
    cell.level = m_level;
    std::array<double, 2> low = {cell.corners[0].x(), cell.corners[0].y()}, high = low;
    for (const Point& p : cell.corners)
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = (std::min)(low[axis], p[axis]);
        high[axis] = (std::max)(high[axis], p[axis]);
      }
    std::array<int, 2> first, last;
    for (int axis = 0; axis < 2; ++axis) {
      const double size = m_equations.domain().periods()[axis] / m_numbers[axis];
      const double margin = outside * (high[axis] - low[axis]);
      first[axis] = int(std::floor((low[axis] - margin) / size));
      last[axis] = (std::min)(int(std::floor((high[axis] + margin) / size)),
                              first[axis] + m_numbers[axis] - 1);
    }
    for (int i = first[0]; i <= last[0]; ++i)
      for (int j = first[1]; j <= last[1]; ++j)
        m_squares[{wrapped(i, 0), wrapped(j, 1)}].push_back(std::uint32_t(m_cells.size()));
    m_cells.push_back(cell);
  }

  int wrapped(int i, int axis) const {
    const int n = m_numbers[axis];
    return ((i % n) + n) % n;
  }

  Square square(const Point& p) const {
    const Point q = m_equations.domain().canonical(p);
    Square result;
    for (int axis = 0; axis < 2; ++axis)
      result[axis] = wrapped(
          int(std::floor(q[axis] / m_equations.domain().periods()[axis] * m_numbers[axis])), axis);
    return result;
  }

  static constexpr double outside = .25; // of a cell; its map is bilinear

  // Returns an approximate geodesic of a cell to a point, if the point is in the cell.
  std::optional<Geodesic_2> locate(const Cell& cell, const Point& point) const {
    static constexpr int iterations = 8;
    const auto& c = cell.corners;
    const Point p = m_equations.domain().nearest_image(c[0], point);
    double s = .5, t = .5; // coordinates in the cell: across, along
    for (int i = 0; i < iterations; ++i) {
      const auto across = (1 - t) * (c[1] - c[0]) + t * (c[2] - c[3]),
                 along = (1 - s) * (c[3] - c[0]) + s * (c[2] - c[1]);
      const auto miss = p - (c[0] + s * (1 - t) * (c[1] - c[0]) + s * t * (c[2] - c[0]) +
                             (1 - s) * t * (c[3] - c[0]));
      const double determinant = across.x() * along.y() - across.y() * along.x();
      if (determinant == 0)
        return std::nullopt;
      s += (miss.x() * along.y() - miss.y() * along.x()) / determinant;
      t += (across.x() * miss.y() - across.y() * miss.x()) / determinant;
      static constexpr double distant = 3; // widths of the cell
      if (!(std::abs(s) < distant && std::abs(t) < distant))
        return std::nullopt;
    }
    if (!(s >= -outside && s <= 1 + outside && t >= -outside && t <= 1 + outside))
      return std::nullopt;
    return Geodesic_2{cell.right + s * cell.angle, length(cell.level) + t * m_step};
  }

  // Searches for a geodesic to the end of a ray that is shorter than the ray.
  void look_for_shorter(double angle, Ray& ray) {
    static constexpr double similar = 1e-6; // in radians
    static constexpr double shorter = 1e-6; // in steps
    Progress_scope::check();
    const double here = length(m_level + 1);
    const Point p = Equations::point(ray.state);
    for (const Geodesic_2& c : candidates(p)) {
      if (std::abs(turn(c.angle, angle)) < 1e-9 || c.length > here + m_step / 2)
        continue;
      const auto g = m_equations.geodesic_to(p, c);
      if (g && std::abs(turn(g->angle, angle)) > similar && g->length < here - shorter * m_step &&
          (!ray.shorter || g->length < ray.shorter->length))
        ray.shorter = g;
    }
    ray.cut_length = here;
  }

  const Equations& m_equations;
  double m_step, m_first_length;
  unsigned m_level = 0;
  bool m_is_complete;
  std::map<double, Ray> m_rays; // by angle, in [0, 2 pi)
  std::vector<Cell> m_cells;
  std::array<int, 2> m_numbers; // number of squares along the axes
  std::map<Square, std::vector<std::uint32_t>> m_squares;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESIC_FAN_2_H

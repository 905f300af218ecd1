// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_PIXEL_POLYLINE_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_PIXEL_POLYLINE_2_H

#include <CGAL/Complex_construction/Labeled_image_2.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A path along edges between pixels of two labels. It ends at the border of the image, or where
// other edges between labels meet it. If the path is a loop, its last corner equals its first
// corner.
struct Pixel_chain_2
{
  using Corner = std::array<int, 2>;

  std::vector<Corner> corners;
  int left, right; // labels
  bool is_loop;
};

// The decomposition of the edges between pixels of different labels into chains. It uses two bits
// of memory for each pixel.
class Pixel_chains_2
{
public:
  using Corner = Pixel_chain_2::Corner;

  // Prepares the decomposition. `is_surrounded` tells whether pixels of label 0 surround the image.
  // \pre There is at least one pixel, and each pixel has a label.
  Pixel_chains_2(const Labeled_image_2& image, bool is_surrounded)
      : m_image(image), m_low(is_surrounded ? -1 : 0), m_right(int(image.width) - m_low),
        m_top(int(image.height) - m_low) {}

  // Returns the number of edges between pixels of different labels.
  std::size_t number_of_edges() const {
    std::size_t result = 0;
    for_each_corner([&](const Corner& c) { result += is_edge(c, 0) + is_edge(c, 1); });
    return result;
  }

  // Calls `f(chain)` for each chain. Chains with ends come first, in the order of their first ends.
  template <class Function> void for_each(const Function& f) const {
    std::vector<bool> is_done(2 * index({m_right, m_top}) + 2, false);
    for (const bool loops : {false, true})
      for_each_corner([&](const Corner& c) {
        if (loops || number_of_edges_at(c) != 2)
          for (int direction = 0; direction < 4; ++direction)
            if (is_edge(c, direction) && !is_done[number_of_edge(c, direction)])
              f(chain(c, direction, loops, is_done));
      });
  }

private:
  // Pixel k at a corner lies between the edges in the directions k and k + 1. The directions are
  // right, up, left and down.
  static constexpr int pixel_x[4] = {0, -1, -1, 0}, pixel_y[4] = {0, 0, -1, -1};
  static constexpr int step_x[4] = {1, 0, -1, 0}, step_y[4] = {0, 1, 0, -1};

  static Corner next(const Corner& c, int direction) {
    return {c[0] + step_x[direction], c[1] + step_y[direction]};
  }

  template <class Function> void for_each_corner(const Function& f) const {
    for (int y = m_low; y <= m_top; ++y) {
      Progress_scope::check();
      for (int x = m_low; x <= m_right; ++x)
        f(Corner{x, y});
    }
  }

  int label(int x, int y) const {
    const int width = int(m_image.width), height = int(m_image.height);
    if (x < 0 || y < 0 || x >= width || y >= height)
      return 0;
    return m_image.labels[std::size_t(height - 1 - y) * m_image.width + std::size_t(x)];
  }
  int label_at(const Corner& c, int pixel) const {
    return label(c[0] + pixel_x[pixel & 3], c[1] + pixel_y[pixel & 3]);
  }
  bool has_pixel(const Corner& c, int pixel) const {
    const int x = c[0] + pixel_x[pixel & 3], y = c[1] + pixel_y[pixel & 3];
    return x >= m_low && y >= m_low && x < m_right && y < m_top;
  }

  bool is_edge(const Corner& c, int direction) const {
    return label_at(c, direction) != label_at(c, direction + 3) && has_pixel(c, direction) &&
           has_pixel(c, direction + 3);
  }
  int number_of_edges_at(const Corner& c) const {
    return is_edge(c, 0) + is_edge(c, 1) + is_edge(c, 2) + is_edge(c, 3);
  }

  std::size_t index(const Corner& c) const {
    return std::size_t(c[1] - m_low) * std::size_t(m_right - m_low + 1) + std::size_t(c[0] - m_low);
  }
  std::size_t number_of_edge(const Corner& c, int direction) const {
    return 2 * index(direction < 2 ? c : next(c, direction)) + std::size_t(direction % 2);
  }

  Pixel_chain_2 chain(Corner c, int direction, bool is_loop, std::vector<bool>& is_done) const {
    Pixel_chain_2 result{{c}, label_at(c, direction), label_at(c, direction + 3), is_loop};
    for (;;) {
      is_done[number_of_edge(c, direction)] = true;
      c = next(c, direction);
      result.corners.push_back(c);
      if (is_loop ? c == result.corners.front() : number_of_edges_at(c) != 2)
        return result;
      const int back = (direction + 2) % 4;
      direction = 0;
      while (direction == back || !is_edge(c, direction))
        ++direction;
    }
  }

  const Labeled_image_2& m_image;
  int m_low, m_right, m_top; // of the pixels, including pixels around the image
};

// A smooth polyline with the same area as a chain of pixels. A gate is the segment between the
// centers of the two pixels at an edge of the chain. The polyline passes through all gates in
// order. The centers of all pixels therefore keep their labels. Between two gates, the polyline
// lies in the square around a corner of the chain. Polylines of different chains therefore meet
// only in common ends.
class Pixel_polyline_2
{
public:
  using Point = std::array<double, 2>;

  // Computes the polyline. `edge` is the target length of the segments, in pixels.
  Pixel_polyline_2(const Pixel_chain_2& chain, double edge)
      : m_chain(chain), m_steps(chain.corners.size() - 1) {
    begin(edge);
    for (int round = 0; round < most_rounds; ++round) {
      Progress_scope::check();
      if (refine())
        continue;
      if (!keep_area())
        break;
      if (passes_gates())
        return;
    }
    follow_edges(edge);
  }

  // Returns the points of the polyline. The first point of a loop is not repeated at the end.
  std::vector<Point> points() const {
    std::vector<Point> result;
    for (const Vertex& v : m_vertices)
      result.push_back(v.point);
    return result;
  }

private:
  struct Vertex
  {
    std::size_t index; // of the corner whose square contains the vertex
    Point point;
    bool is_free; // whether the vertex may leave the corner
  };

  // maximum number of halvings of segments, sufficient for any chain
  static constexpr int most_rounds = 40;
  // number of corners on each side that are averaged for a vertex
  static constexpr std::size_t window = 6;
  // maximum coordinate distance of vertices from corners, and of crossings from the middles of
  // gates; it separates polylines
  static constexpr double reach = .45;
  static constexpr double exactness = 1e-10; // tolerance of areas, in pixels

  Point corner(std::size_t i) const {
    const auto& c = m_chain.corners[m_chain.is_loop ? i % m_steps : i];
    return {double(c[0]), double(c[1])};
  }

  // Returns the mean of the corners around corner i, within `reach` of corner i.
  Vertex smooth(std::size_t i) const {
    const std::size_t n = m_steps,
                      w = (std::min)(window, m_chain.is_loop ? n / 8 : (std::min)(i, n - i));
    const Point c = corner(i);
    Point mean = {};
    for (std::size_t k = i + n - w; k <= i + n + w; ++k)
      for (int axis = 0; axis < 2; ++axis)
        mean[axis] += (corner(m_chain.is_loop ? k : k - n)[axis] - c[axis]) / double(2 * w + 1);
    return {i, within_reach(c, {c[0] + mean[0], c[1] + mean[1]}), w > 0};
  }

  static Point within_reach(const Point& c, const Point& p) {
    const auto clamp = [](double x, double center) {
      return (std::min)((std::max)(x, center - reach), center + reach);
    };
    return {clamp(p[0], c[0]), clamp(p[1], c[1])};
  }

  // Places vertices at equal distances along the smooth line.
  void begin(double edge) {
    std::vector<double> lengths = {0};
    Vertex last = smooth(0);
    for (std::size_t i = 1; i <= m_steps; ++i) {
      const Vertex v = smooth(i);
      lengths.push_back(lengths.back() +
                        std::hypot(v.point[0] - last.point[0], v.point[1] - last.point[1]));
      last = v;
    }
    const std::size_t least = m_chain.is_loop ? 4 : 1;
    const auto number = (std::max)(least, std::size_t(std::lround(lengths.back() / edge)));
    for (std::size_t i = 0; i < m_steps; ++i)
      if (lengths[i] * double(number) >= double(m_vertices.size()) * lengths.back())
        m_vertices.push_back(smooth(i));
    if (!m_chain.is_loop)
      m_vertices.push_back(smooth(m_steps));
  }

  std::size_t number_of_segments() const { return m_vertices.size() - (m_chain.is_loop ? 0 : 1); }

  const Vertex& end(std::size_t segment) const {
    return m_vertices[(segment + 1) % m_vertices.size()];
  }

  // Returns the index of the corner at the end of a segment. Indices at the end of a loop continue
  // to increase.
  std::size_t end_index(std::size_t segment) const {
    return segment + 1 < m_vertices.size() ? m_vertices[segment + 1].index
                                           : m_vertices[0].index + m_steps;
  }

  // Returns whether a segment passes, in order, through the gates between its ends.
  bool passes_gates(std::size_t segment) const {
    const Point p = m_vertices[segment].point, q = end(segment).point;
    double last = 0; // parameter of the last crossing on the segment
    for (std::size_t i = m_vertices[segment].index; i < end_index(segment); ++i) {
      const Point a = corner(i), b = corner(i + 1);
      const int along = a[0] != b[0] ? 0 : 1, across = 1 - along;
      const double middle = (a[along] + b[along]) / 2,
                   part = (middle - p[along]) / (q[along] - p[along]),
                   place = p[across] + part * (q[across] - p[across]) - a[across];
      if (!(part >= last && part <= 1 && std::abs(place) <= reach))
        return false;
      last = part;
    }
    return true;
  }

  bool passes_gates() const {
    for (std::size_t s = 0; s < number_of_segments(); ++s)
      if (!passes_gates(s))
        return false;
    return true;
  }

  // Halves segments that miss gates. If such a segment belongs to a single pixel edge, it is
  // replaced by this edge. Returns whether there were such segments.
  bool refine() {
    std::vector<Vertex> refined;
    std::vector<std::size_t> fixed; // indices of corners
    bool has_missed = false;
    for (std::size_t s = 0; s < m_vertices.size(); ++s) {
      refined.push_back(m_vertices[s]);
      if (s == number_of_segments() || passes_gates(s))
        continue;
      has_missed = true;
      const std::size_t first = m_vertices[s].index, last = end_index(s);
      if (last - first > 1)
        refined.push_back(smooth((first + last) / 2));
      else
        fixed.insert(fixed.end(), {first, m_chain.is_loop ? last % m_steps : last});
    }
    std::sort(fixed.begin(), fixed.end());
    for (Vertex& v : refined)
      if (std::binary_search(fixed.begin(), fixed.end(), v.index))
        v = {v.index, corner(v.index), false};
    if (m_chain.is_loop) { // The vertex that halves the last segment may precede the first vertex.
      for (Vertex& v : refined)
        v.index %= m_steps;
      std::sort(refined.begin(), refined.end(),
                [](const Vertex& a, const Vertex& b) { return a.index < b.index; });
    }
    m_vertices.swap(refined);
    return has_missed;
  }

  // Returns twice the area between a polyline and the segment that closes it.
  template <class PointAt> static double doubled_area(std::size_t n, const PointAt& point) {
    double result = 0;
    const Point origin = point(0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const Point p = point(i), q = point(i + 1);
      result += (p[0] - origin[0]) * (q[1] - origin[1]) - (p[1] - origin[1]) * (q[0] - origin[0]);
    }
    return result;
  }

  // Moves all free vertices by the same distance along their normals, until the area equals the
  // area of the pixels. Returns false if this is not possible.
  bool keep_area() {
    // Convergence is quadratic, unless vertices are constrained.
    static constexpr int most_moves = 20;
    const std::size_t n = m_vertices.size();
    const double target = doubled_area(m_steps + 1, [&](std::size_t i) { return corner(i); });
    for (int move = 0; move < most_moves; ++move) {
      const double missing =
          (target - doubled_area(n, [&](std::size_t i) { return m_vertices[i].point; })) / 2;
      if (std::abs(missing) <= exactness)
        return true;
      std::vector<Point> chords(n);
      double length = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const Point &p = m_vertices[(i + n - 1) % n].point, &q = m_vertices[(i + 1) % n].point;
        chords[i] = {q[0] - p[0], q[1] - p[1]};
        if (m_vertices[i].is_free)
          length += std::hypot(chords[i][0], chords[i][1]) / 2;
      }
      if (length == 0)
        return false;
      for (std::size_t i = 0; i < n; ++i) {
        Vertex& v = m_vertices[i];
        const double chord = std::hypot(chords[i][0], chords[i][1]);
        if (v.is_free && chord > 0)
          v.point =
              within_reach(corner(v.index), {v.point[0] + missing / length * chords[i][1] / chord,
                                             v.point[1] - missing / length * chords[i][0] / chord});
      }
    }
    return false;
  }

  // Replaces the polyline by the edges of the pixels.
  void follow_edges(double edge) {
    m_vertices.clear();
    // maximum number of pixel edges in a segment
    const auto most = std::size_t((std::min)(edge, double(m_steps)));
    for (std::size_t i = 0; i < m_steps; ++i) {
      const Point b = corner(i), c = corner(i + 1),
                  a = i > 0             ? corner(i - 1)
                      : m_chain.is_loop ? corner(m_steps - 1)
                                        : b;
      const bool turns = (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0]);
      if (i == 0 || turns || i - m_vertices.back().index >= most)
        m_vertices.push_back({i, b, false});
    }
    if (!m_chain.is_loop)
      m_vertices.push_back({m_steps, corner(m_steps), false});
  }

  const Pixel_chain_2& m_chain;
  std::size_t m_steps; // number of pixel edges
  std::vector<Vertex> m_vertices;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_PIXEL_POLYLINE_2_H

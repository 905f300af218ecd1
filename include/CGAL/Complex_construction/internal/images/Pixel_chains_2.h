// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_PIXEL_CHAINS_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_PIXEL_CHAINS_2_H

#include <CGAL/Complex_construction/Labeled_image_2.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <array>
#include <cstddef>
#include <vector>

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_PIXEL_CHAINS_2_H

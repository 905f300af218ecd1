// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_VERTEX_IMAGES_H
#define DSC_PYTHON_VERTEX_IMAGES_H

#include "Space.h"

#include <map>

namespace dsc_python {

/// The vertices of a complex as points of arrays. On a torus, images of the vertices follow, for
/// the cells and facets that lie across the seam.
template <class Complex> class Vertex_images
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Point;

  /// \param vertices handles; the first points are their positions
  template <class Vertices>
  Vertex_images(const Complex& complex, const Vertices& vertices) : m_complex(complex) {
    for (const auto v : vertices) {
      m_points.push_back(complex.position(v));
      m_ids.push_back(v->time_stamp());
      m_vertices.push_back(m_vertices.size());
    }
  }

  const Point& position(std::size_t i) const { return m_points[i]; }

  /// Returns the index of the image of a vertex at a position.
  std::size_t index(std::size_t vertex, const Point& p) {
    if constexpr (Complex::Domain::has_outside)
      return vertex;
    else
      return index_on_torus(vertex, p);
  }

  py::array_t<double> points() const { return Space<Complex>(m_complex).array(m_points); }
  py::array_t<std::uint64_t> ids() const {
    return array_of<std::uint64_t>(m_ids.size(), [&](std::size_t i) { return m_ids[i]; });
  }
  /// Returns the index of the vertex of each point.
  py::array_t<std::int64_t> vertices() const { return array_of_indices(m_vertices); }

private:
  // The number of periods between a vertex and its image, -1, 0 or 1 along each axis, as a number
  // from 0 to 26.
  std::size_t code_of(std::size_t vertex, const Point& p) const {
    std::size_t result = 0;
    for (int axis = 0; axis < d; ++axis) {
      const double periods =
          (p[axis] - m_points[vertex][axis]) / m_complex.domain().periods()[axis];
      result = 3 * result + std::size_t(std::lround(periods) + 1);
    }
    return result;
  }

  std::size_t index_on_torus(std::size_t vertex, const Point& p) {
    static constexpr int bits_of_ids = 58; // the code of an image needs five more
    if (p == m_points[vertex])
      return vertex;
    const std::size_t code = code_of(vertex, p);
    const auto [place, is_new] = m_images.emplace(std::pair(vertex, code), m_points.size());
    if (is_new) {
      m_points.push_back(p);
      m_ids.push_back(m_ids[vertex] | std::uint64_t(code + 1) << bits_of_ids);
      m_vertices.push_back(vertex);
    }
    return place->second;
  }

  const Complex& m_complex;
  std::vector<Point> m_points;
  std::vector<std::uint64_t> m_ids;
  std::vector<std::size_t> m_vertices;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_images;
};

} // namespace dsc_python

#endif // DSC_PYTHON_VERTEX_IMAGES_H

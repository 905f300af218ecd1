// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_POLYGON_TRIANGULATION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_POLYGON_TRIANGULATION_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The triangulation of a polygon that maximizes the worst quality of the tetrahedra that join its
// triangles to the apices b and a. Computed by Klincsek's dynamic program.
template <class Complex> class Polygon_triangulation_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Cavity = Deformable_simplicial_complexes::Cavity<Complex>;
  using Index = typename Cavity::Index;

  // The maximum number of polygon vertices, which bounds the cubic cost. Polygons around edges of
  // improved meshes are much smaller.
  static constexpr std::size_t maximum_number_of_vertices = 52;

  Polygon_triangulation_3(Cavity& cavity, Index a, Index b) : m_cavity(cavity), m_a(a), m_b(b) {}

  // Plans the tetrahedra in the cavity. The vertices vertex(0), ..., vertex(n - 1) of the polygon
  // are counterclockwise seen from b. Returns false if the worst quality is not above `bound`.
  // \pre n <= maximum_number_of_vertices
  template <class Vertex>
  bool create(std::size_t n, const Vertex& vertex, double bound, Cell_handle parent) {
    CGAL_precondition(n <= maximum_number_of_vertices);
    // best[p * n + q]: quality of the best triangulation of the polygon from p to q > p. The
    // triangle (p, apex, q) is incident to the edge (p, q).
    m_best.assign(n * n, std::numeric_limits<double>::infinity());
    m_apex.assign(n * n, 0);
    for (std::size_t length = 2; length < n; ++length) {
      bool is_one_good = false;
      for (std::size_t p = 0; p + length < n; ++p) {
        const std::size_t q = p + length;
        double& value = m_best[p * n + q];
        value = -std::numeric_limits<double>::infinity();
        for (std::size_t k = p + 1; k < q; ++k) {
          double worst = (std::min)(m_best[p * n + k], m_best[k * n + q]);
          if (worst > bound)
            worst = (std::min)(worst, m_cavity.quality({vertex(p), vertex(k), vertex(q), m_b}));
          if (worst > bound)
            worst = (std::min)(worst, m_cavity.quality({vertex(k), vertex(p), vertex(q), m_a}));
          if (worst > value) {
            value = worst;
            m_apex[p * n + q] = k;
          }
        }
        is_one_good = is_one_good || value > bound;
      }
      // Each triangulation has at least two ears, that is, triangles of three successive vertices.
      // At least one of them does not contain the edge (0, n - 1).
      if (length == 2 && !is_one_good)
        return false;
    }
    if (!(m_best[n - 1] > bound))
      return false;

    m_open.assign(1, {0, n - 1});
    while (!m_open.empty()) {
      const auto [p, q] = m_open.back();
      m_open.pop_back();
      if (q - p < 2)
        continue;
      const std::size_t k = m_apex[p * n + q];
      m_cavity.create({vertex(p), vertex(k), vertex(q), m_b}, parent);
      m_cavity.create({vertex(k), vertex(p), vertex(q), m_a}, parent);
      m_open.emplace_back(p, k);
      m_open.emplace_back(k, q);
    }
    return true;
  }

private:
  Cavity& m_cavity;
  Index m_a, m_b;
  // Sized for polygons with up to eight vertices, which is the usual case.
  template <class T> using Table = boost::container::small_vector<T, 64>;
  Table<double> m_best;
  Table<std::size_t> m_apex;
  boost::container::small_vector<std::pair<std::size_t, std::size_t>, 8> m_open;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_POLYGON_TRIANGULATION_3_H

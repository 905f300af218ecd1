// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_EXTRACTION_EXTRACTED_FACETS_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_EXTRACTION_EXTRACTED_FACETS_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The facets of the interface as an indexed set, in user coordinates. On a torus, each connected
// component is unwrapped: a component that closes around the torus is cut open, and the vertices on
// the cut have several points.
template <class Complex> struct Extracted_facets
{
  static constexpr int d = Complex::dimension;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Label = typename Complex::Label;

  std::vector<Vertex_handle> vertices; // by increasing time stamp, followed by periodic images
  std::vector<Point> points;           // the points of `vertices`
  std::vector<std::array<std::size_t, d>> facets; // oriented out of the first label
  std::vector<std::array<Label, 2>> labels;

  Extracted_facets(const Complex& complex, const std::vector<typename Complex::Facet>& from,
                   bool from_smaller_label) {
    std::vector<Vertex_handle> corners;
    corners.reserve(d * from.size());
    for (const auto& facet : from)
      for (Vertex_handle v : complex.facet_vertices(facet))
        corners.push_back(v);
    vertices = corners;
    sort_by_time_stamp(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const Vertex_numbers number(complex, vertices);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto [cell, index] = from[i];
      facets.emplace_back();
      for (int k = 0; k < d; ++k)
        facets.back()[k] = number(corners[d * i + k]);
      labels.push_back({complex.label(cell), complex.label(cell->neighbor(index))});
      if (from_smaller_label) {
        std::swap(facets.back()[d - 2], facets.back()[d - 1]);
        std::swap(labels.back()[0], labels.back()[1]);
      }
    }
    for (Vertex_handle v : vertices)
      points.push_back(complex.position(v));
    if constexpr (!Complex::Domain::has_outside)
      unwrap(complex);
    for (Point& p : points)
      p = complex.in_user_coordinates(p);
  }

private:
  // Unwraps the facets, from facet to facet: the position of each facet is the one nearest to a
  // point of the previous facet.
  void unwrap(const Complex& complex) {
    const std::size_t n = points.size();
    std::vector<std::vector<std::size_t>> facets_at(n), images(n); // indexed by vertex
    for (std::size_t f = 0; f < facets.size(); ++f)
      for (std::size_t v : facets[f])
        facets_at[v].push_back(f);
    const auto image_near = [&](const Point& from, std::size_t v) {
      const Point p = complex.domain().nearest_image(from, complex.position(vertices[v]));
      for (std::size_t image : images[v])
        if (points[image] == p)
          return image;
      images[v].push_back(images[v].empty() ? v : points.size());
      if (images[v].back() == v) {
        points[v] = p;
      } else {
        points.push_back(p);
        vertices.push_back(vertices[v]);
      }
      return images[v].back();
    };
    std::vector<char> is_found(facets.size(), false);
    std::vector<std::pair<std::size_t, std::size_t>> found; // a facet and one of its points
    for (std::size_t first = 0; first < facets.size(); ++first) {
      if (is_found[first])
        continue;
      is_found[first] = true;
      const std::size_t v = facets[first][0];
      found = {{first, image_near(points[v], v)}};
      for (std::size_t k = 0; k < found.size(); ++k) {
        auto& facet = facets[found[k].first];
        const Point from = points[found[k].second];
        for (std::size_t& w : facet) {
          const std::size_t image = image_near(from, w);
          for (std::size_t next : facets_at[w])
            if (!is_found[next]) {
              is_found[next] = true;
              found.emplace_back(next, image);
            }
          w = image;
        }
      }
    }
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_EXTRACTION_EXTRACTED_FACETS_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_IMAGE_FILLING_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_IMAGE_FILLING_2_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Labeled_image_2.h>
#include <CGAL/Complex_construction/internal/building/Curve_soup_2.h>
#include <CGAL/Complex_construction/internal/building/Planar_filling_2.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Complex_construction/internal/images/Pixel_polyline_2.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Labeled triangles that fill the rectangle of an image, or a box around it.
struct Image_filling_2
{
  std::vector<Planar_kernel::Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
};

// The polylines between the labels of an image.
template <class Kernel> class Image_curves_2
{
public:
  Image_curves_2(const Pixel_chains_2& chains, double edge) {
    const Progress_phase phase("tracing the pixels of the image");
    chains.for_each([&](const Pixel_chain_2& chain) { add(chain, edge); });
    std::sort(m_sides.begin(), m_sides.end());
  }

  const Curve_soup_2& soup() const { return m_soup; }

  // Returns the triangles incident to polylines, with their labels.
  std::vector<std::pair<std::size_t, int>>
  seeds(const std::vector<std::array<std::size_t, 3>>& triangles) const {
    std::vector<std::pair<std::size_t, int>> result;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Side key = {triangles[t][i], triangles[t][(i + 1) % 3], 0};
        const auto side = std::lower_bound(m_sides.begin(), m_sides.end(), key);
        if (side != m_sides.end() && side->from == key.from && side->to == key.to)
          result.emplace_back(t, side->label);
      }
    return result;
  }

private:
  // The label on the left of a segment.
  struct Side
  {
    std::size_t from, to;
    int label;

    friend bool operator<(const Side& a, const Side& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    }
  };

  void add(const Pixel_chain_2& chain, double edge) {
    const auto points = Pixel_polyline_2(chain, edge).points();
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < points.size(); ++i)
      numbers.push_back(!chain.is_loop && i == 0                   ? end(chain.corners.front())
                        : !chain.is_loop && i + 1 == points.size() ? end(chain.corners.back())
                                                                   : add_point(points[i]));
    if (chain.is_loop)
      numbers.push_back(numbers.front());
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      m_soup.walls.push_back(make_wall(std::array<std::size_t, 2>{numbers[i - 1], numbers[i]}, 0));
      m_sides.push_back({numbers[i - 1], numbers[i], chain.left});
      m_sides.push_back({numbers[i], numbers[i - 1], chain.right});
    }
  }

  std::size_t add_point(const Pixel_polyline_2::Point& p) {
    m_soup.points.emplace_back(p[0], p[1]);
    return m_soup.points.size() - 1;
  }

  // Returns the index of the end of a chain. Several chains may have this end.
  std::size_t end(const Pixel_chain_2::Corner& corner) {
    const auto [place, is_new] = m_ends.emplace(corner, m_soup.points.size());
    return is_new ? add_point({double(corner[0]), double(corner[1])}) : place->second;
  }

  Curve_soup_2 m_soup;
  std::vector<Side> m_sides;
  std::map<Pixel_chain_2::Corner, std::size_t> m_ends;
};

template <class Kernel>
void check_image(const Labeled_image_2& image, double edge, const std::optional<Bbox_2>& box) {
  static constexpr std::size_t largest_side = 1 << 20; // also the limit of all image readers
  if (image.width == 0 || image.height == 0 || image.width > largest_side ||
      image.height > largest_side || image.labels.size() != image.width * image.height)
    throw Error("the image has no pixels, more than 2^20 pixels in a row or column, or not one "
                "label for each pixel: correct it");
  if (!(edge >= 1))
    throw Error("the target edge length is less than a pixel: use 1 or more");
  const Bbox_2 pixels = image.bbox();
  if (box && *box != pixels &&
      !(box->xmin() < pixels.xmin() && box->ymin() < pixels.ymin() && box->xmax() > pixels.xmax() &&
        box->ymax() > pixels.ymax() &&
        has_finite_coordinates(
            std::array<double, 4>{box->xmin(), box->ymin(), box->xmax(), box->ymax()})))
    throw Error("the image of " + std::to_string(image.width) + " times " +
                std::to_string(image.height) +
                " pixels, with a corner at the origin, does not fill the enclosing box and is not "
                "strictly inside it: give a larger box, or no box");
}

// Triangulates an image. `edge` is the target edge length, in pixels. Throws `Error` if the image,
// the edge length or the box is invalid, or if there are too many pixel edges between labels.
// Complexity: linear in the number of pixels, and O(n log n) in the number n of pixel edges between
// labels.
template <class Kernel = Planar_kernel>
Image_filling_2 fill_image(const Labeled_image_2& image, double edge,
                           const std::optional<Bbox_2>& given_box) {
  // maximum number of pixel edges; bounds the memory of the triangles
  static constexpr std::size_t most_edges = 1 << 20;
  check_image<Kernel>(image, edge, given_box);
  // If the pixels fill the box, there is no label 0 around them.
  const auto box = given_box == image.bbox() ? std::nullopt : given_box;
  const Pixel_chains_2 chains(image, box.has_value());
  if (const std::size_t edges = chains.number_of_edges(); edges > most_edges)
    throw Error("the image has " + std::to_string(edges) +
                " pixel edges between different labels, more than " + std::to_string(most_edges) +
                ": filter or segment a noisy image or a photograph; reduce or divide other images");
  const Image_curves_2<Kernel> curves(chains, edge);
  Planar_filling_2 filling = fill_box_between<Kernel>(curves.soup(), box.value_or(image.bbox()),
                                                      Construction_options<2>::fine_spacing);
  filling.locate = nullptr; // releases the triangulation
  Image_filling_2 result;
  auto seeds = curves.seeds(filling.triangles);
  if (seeds.empty())
    seeds.emplace_back(0, box ? 0 : image.labels.front());
  // remains empty, because the labels on one side of a chain are equal
  std::optional<Contradicting_seeds> contradicting;
  result.labels =
      label_cells_by_seeds<2>(filling.triangles, curves.soup().walls, seeds, contradicting);
  result.points.swap(filling.points);
  result.triangles.swap(filling.triangles);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_IMAGES_IMAGE_FILLING_2_H

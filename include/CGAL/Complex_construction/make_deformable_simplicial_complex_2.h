// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
#define CGAL_COMPLEX_CONSTRUCTION_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Labeled_curve_2.h>
#include <CGAL/Complex_construction/Labeled_image_2.h>
#include <CGAL/Complex_construction/fill_torus.h>
#include <CGAL/Complex_construction/internal/building/Curve_soup_2.h>
#include <CGAL/Complex_construction/internal/building/Planar_filling_2.h>
#include <CGAL/Complex_construction/internal/building/box_2.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Complex_construction/internal/images/Image_filling_2.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/internal/sets/equal_points.h>
#include <CGAL/Mesh_support/named_parameters.h>

#include <CGAL/Deformable_simplicial_complex_2.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Returns a triangle incident to a corner of the box.
inline std::size_t triangle_on_box(const Planar_filling_2& filling) {
  const auto corner = std::size_t(std::min_element(filling.points.begin(), filling.points.end()) -
                                  filling.points.begin());
  return std::size_t(std::find_if(filling.triangles.begin(), filling.triangles.end(),
                                  [&](const std::array<std::size_t, 3>& t) {
                                    return std::find(t.begin(), t.end(), corner) != t.end();
                                  }) -
                     filling.triangles.begin());
}

// Returns the labels of the triangles that fill a box, given by seed points in its regions. Throws
// `Error` if a seed is invalid, or if two seeds of a region have different labels.
template <class Point>
std::vector<int> label_by_seeds(const Seeded_segments_2<Point>& segments, const Curve_soup_2& soup,
                                const Planar_filling_2& filling) {
  const auto refuse = [&](std::size_t seed, const char* what) {
    const auto& p = segments.seeds[seed].first;
    std::ostringstream message;
    message.imbue(std::locale::classic());
    message << "seed " << seed << ", at (" << to_double(p.x()) << ", " << to_double(p.y()) << "), "
            << what;
    throw Error(message.str());
  };
  std::vector<std::pair<std::size_t, int>> triangles;
  for (std::size_t i = 0; i < segments.seeds.size(); ++i) {
    const auto& [point, label] = segments.seeds[i];
    const Planar_filling_2::Point p(to_double(point.x()), to_double(point.y()));
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
      refuse(i, "has coordinates that are not finite: correct them");
    const Planar_filling_2::Place place = filling.locate(p);
    if (!place.triangle)
      refuse(i, "is outside the enclosing box: give a larger box");
    if (place.is_on_segment)
      refuse(i, "is on a segment: choose a point within its region");
    triangles.emplace_back(*place.triangle, label);
  }
  std::optional<Contradicting_seeds> contradicting;
  auto labels = label_cells_by_seeds<2>(filling.triangles, soup.walls, triangles, contradicting);
  if (contradicting)
    refuse(contradicting->second,
           "is in the region of another seed with another label: are segments missing "
           "between them?");
  if (segments.enclosed_label != 0) {
    for (auto& triangle : triangles)
      triangle.second = 1;
    triangles.emplace_back(triangle_on_box(filling), 1);
    const auto is_told =
        label_cells_by_seeds<2>(filling.triangles, soup.walls, triangles, contradicting);
    for (std::size_t t = 0; t < labels.size(); ++t)
      if (is_told[t] == 0)
        labels[t] = segments.enclosed_label;
  }
  return labels;
}

// Makes a complex of the given triangles, and improves it. `dsc` is an empty complex in the domain.
template <class Complex>
Complex assign_and_improve(Complex dsc, const std::vector<Planar_kernel::Point_2>& planar,
                           const std::vector<std::array<std::size_t, 3>>& triangles,
                           const std::vector<int>& labels, const Construction_options<2>& options) {
  std::vector<typename Complex::Point_2> points;
  points.reserve(planar.size());
  for (const auto& p : planar)
    points.emplace_back(p.x(), p.y());
  dsc.assign(points, triangles, labels);
  improve_new_mesh(dsc, options);
  return dsc;
}

// Fills a box, labels the triangles with `label(filling)`, and makes a complex of them.
template <class Complex, class Label>
Complex fill_box(Complex dsc, const Curve_soup_2& soup, const Bbox_2& box,
                 const Construction_options<2>& options, const Label& label) {
  Planar_filling_2 filling = fill_planar_box(soup, box, options.spacing_per_segment);
  const auto labels = label(filling);
  filling.locate = nullptr; // releases the triangulation
  if constexpr (!Complex::Domain::has_outside)
    join_sides(box, filling.points, filling.triangles);
  return assign_and_improve(std::move(dsc), filling.points, filling.triangles, labels, options);
}

// All closed curves, and the labels of the regions that they enclose.
template <class Label> struct Closed_curves_2
{
  Curve_soup_2 soup;
  std::vector<Label> labels;

  template <class Curve> explicit Closed_curves_2(const std::vector<Curve>& curves) {
    if (curves.empty())
      throw Error("there are no curves: give at least one");
    for (const auto& curve : curves) {
      add_curve(curve, labels.size(), soup);
      labels.push_back(curve.label);
    }
  }

  std::vector<Label> label(const Planar_filling_2& filling) const {
    return label_cells<2>(filling.triangles, soup.walls, labels);
  }
};

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from regions of the plane bounded by closed polylines, in a rectangle that belongs
to the outside. The function `make_deformable_simplicial_complex_3()` is the counterpart in space. n
log n in the number of segments and triangles.

A curve is a set of segments; an even number of them meet at each point. Curves may be nested in any
way, may touch in common ends of segments, and may have whole segments in common. They must not
cross or overlap partially. The label of a point is found along a path from the outside that crosses
as few segments as possible: it is the label of the curve entered last. If several curves are
entered at once, the one that was given last counts. Points outside all curves have label 0.

The rectangle is filled with CGAL's constrained Delaunay triangulation. Its points are as dense as
the named parameter `spacing_per_segment` says near the curves, and sparser away from them. The
coordinates of the points of the curves are bitwise unchanged.

\tparam Complex an instance of `Deformable_simplicial_complex_2`
\tparam NP a sequence of named parameters

\param curves curves with the labels of the regions that they enclose; coordinates are rounded to
       `double`
\param np a `Construction_options<2>`, or named parameters with the names of its members

\throws Invalid_surface_error if a curve is not as described above, or reaches the box; the facets
        of the error are segments
\throws Error if there is no curve, or parameters or the extent of the domain are out of range
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(
    const std::vector<Labeled_curve_2<typename Complex::Point_2>>& curves,
    const NP& np = parameters::default_values()) {
  const internal::Closed_curves_2<typename Complex::Label> closed(curves);
  const auto options = construction_options<2>(np);
  return internal::fill_box(
      Complex(), closed.soup, internal::enclosing_box(closed.soup, options), options,
      [&](const internal::Planar_filling_2& filling) { return closed.label(filling); });
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex on a flat torus from regions bounded by closed polylines, as above. The polylines
are given unwrapped, in the plane, and may cross the seam. Their common bounding box is smaller than
a period in both directions. For regions that wind around the torus, use a function of labels. n log
n in the number of segments and triangles.

\tparam Complex an instance of `Deformable_simplicial_complex_2` with the domain `Torus_domain<2>`

\param domain the torus
\param curves curves as above; points are rounded to the unit of positions on the torus
\param np the named parameters above, except `enclosing_box`

\throws Invalid_surface_error if a curve is not as described above, or too large
\throws Error if there is no curve, or parameters are out of range
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(
    const Torus_domain<2>& domain,
    const std::vector<Labeled_curve_2<typename Complex::Point_2>>& curves,
    const NP& np = parameters::default_values()) {
  internal::refuse_parameters<Construction_options<2>, internal_np::enclosing_box_t>(np);
  const internal::Closed_curves_2<typename Complex::Label> closed(curves);
  return internal::fill_box(
      Complex(domain), closed.soup, internal::box_of_torus(closed.soup, domain.periods()),
      construction_options<2>(np),
      [&](const internal::Planar_filling_2& filling) { return closed.label(filling); });
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from the regions between segments, as above, with labels given by seeds: points in
the regions. Bounded regions without a seed get the label `enclosed_label` of the segments. Segments
need not be closed curves; segments with the same label on both sides become edges of the mesh only.
n log n in the number of segments and triangles.

\param segments segments with seeds; coordinates are rounded to `double`
\param np the named parameters above

\throws Invalid_surface_error if segments cross or overlap, have no length, or reach the box
\throws Error if there is no segment, a seed is outside the box or on a segment, or two seeds give a
        region different labels; or as above
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex
make_deformable_simplicial_complex_2(const Seeded_segments_2<typename Complex::Point_2>& segments,
                                     const NP& np = parameters::default_values()) {
  internal::Curve_soup_2 soup;
  internal::add_segments(segments, 0, soup);
  const auto options = construction_options<2>(np);
  return internal::fill_box(Complex(), soup, internal::enclosing_box(soup, options), options,
                            [&](const internal::Planar_filling_2& filling) {
                              return internal::label_by_seeds(segments, soup, filling);
                            });
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from an image of labels. Each label gets the area of its pixels, and the center of
each pixel keeps its label. The interface is smooth where possible. Elsewhere, it follows the edges
of pixels: the boundary of a single pixel is a square. Pixels of a label that have only a corner in
common touch there. Triangles far from the interface are large.

Linear in the number of pixels, with a byte of memory for each. n log n in the number of pixel edges
between different labels, with about a kilobyte of memory for each segment of the interface.

\tparam Complex an instance of `Deformable_simplicial_complex_2`

\param image labels of square pixels of side 1, from the origin
\param edge approximate length of the segments of the interface, in pixels; at least 1
\param np the named parameters above, except `spacing_per_segment`. By default, `enclosing_box` is
       the rectangle of all pixels. The space between the image and a larger box has label 0.

\throws Error if the image has no pixels, more than 2^20 of them in a row or column, or not one
        label for each pixel; if `edge` is less than 1; if the image is neither strictly inside the
        box nor fills it; or if more than 2^20 pixel edges are between different labels
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(const Labeled_image_2& image, double edge = 2.5,
                                             const NP& np = parameters::default_values()) {
  internal::refuse_parameters<Construction_options<2>, internal_np::spacing_per_segment_t>(np);
  const auto options = construction_options<2>(np);
  const internal::Image_filling_2 filling =
      internal::fill_image(image, edge, options.enclosing_box);
  return internal::assign_and_improve(Complex(), filling.points, filling.triangles, filling.labels,
                                      options);
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from given triangles whose union is a disk. Triangles may be oriented in any way.
The interface keeps its shape; segments at thin parts are bisected. n log n in the number of
triangles, plus the improvement.

\tparam Complex an instance of `Deformable_simplicial_complex_2`

\param points the vertices; each is in a triangle. Equal points are merged.
\param triangles indices into `points`
\param labels one label for each triangle
\param np named parameters: `improve`, `edge_per_thickness`, `most_new_facets`,
       `quality_threshold`, `number_of_iterations`, as above

\throws Invalid_cells_error if coordinates are not finite, sizes or indices do not fit, a triangle
        is degenerate, or the union is not a disk
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(std::vector<typename Complex::Point_2> points,
                                             std::vector<std::array<std::size_t, 3>> triangles,
                                             const std::vector<typename Complex::Label>& labels,
                                             const NP& np = parameters::default_values()) {
  internal::refuse_box<2>(np);
  const auto options = construction_options<2>(np);
  Complex dsc;
  internal::merge_equal_points<2>(points, triangles);
  const auto orientation = dsc.orientation();
  const bool has_numbers = std::all_of(points.begin(), points.end(), [](const auto& p) {
    return has_finite_coordinates(coordinates_of<2>(p));
  });
  for (auto& t : triangles)
    if (has_numbers &&
        std::all_of(t.begin(), t.end(), [&](std::size_t v) { return v < points.size(); }) &&
        orientation(points[t[0]], points[t[1]], points[t[2]]) == CLOCKWISE)
      std::swap(t[1], t[2]);
  dsc.assign(points, triangles, labels);
  internal::improve_new_mesh(dsc, options);
  return dsc;
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex in a rectangle from a function of labels, such as `Labeled_image_2`. Almost regular
triangles get the labels of their barycenters. Then `fit_interface()` moves the interface to the
places where labels change. Linear in the number of triangles.

\tparam Complex an instance of `Deformable_simplicial_complex_2`

\param box the domain, of positive size
\param edge approximate edge length, positive
\param label_at `label_at(p)` returns the label at a `Point_2` in the box; or
       `label_at(points)` returns the labels at a vector of such points
\param np the named parameters of `deform_interface()`, for `fit_interface()`

\throws Error if `edge` is not positive, or too short, or the box is empty
\throws Invalid_cells_error if the box is too small or too large for a complex
*/
template <class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(const Bbox_2& box, double edge,
                                             const LabelAt& label_at,
                                             const NamedParameters& np = NamedParameters()) {
  static_assert(
      internal::labels_points<Complex, LabelAt>,
      "the function of labels: int operator()(Point) const, or a function of a vector of points");
  if constexpr (internal::labels_points<Complex, LabelAt>)
    return internal::fill_grid(Complex(), internal::box_grid(box, edge), label_at, np);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

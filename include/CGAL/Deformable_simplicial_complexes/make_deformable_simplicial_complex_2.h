// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/Labelled_curve_2.h>
#include <CGAL/Deformable_simplicial_complexes/Labelled_image_2.h>
#include <CGAL/Deformable_simplicial_complexes/Seeded_segments_2.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/fill_grid.h>
#include <CGAL/Deformable_simplicial_complexes/fill_torus.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Planar_filling_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/box_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/label_by_seeds_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/label_cells.h>
#include <CGAL/Deformable_simplicial_complexes/internal/images/Image_filling_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/improve_new_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The complex, empty before, of triangles, and its improvement.
template <class Complex, class NP>
Complex assign_and_improve(Complex dsc, const std::vector<Planar_kernel::Point_2>& planar,
                           const std::vector<std::array<std::size_t, 3>>& triangles,
                           const std::vector<int>& labels, const NP& np) {
  const New_mesh_options options = new_mesh_options(np);
  std::vector<typename Complex::Point_2> points;
  points.reserve(planar.size());
  for (const auto& p : planar)
    points.emplace_back(p.x(), p.y());
  dsc.assign(points, triangles, labels);
  improve_new_mesh(dsc, options);
  return dsc;
}

// The same for a filled box, with labels told by `label(filling)`.
template <class Complex, class NP, class Label>
Complex fill_box(Complex dsc, const Curve_soup_2& soup, const Bbox_2& box, const NP& np,
                 const Label& label) {
  Planar_filling_2 filling = fill_planar_box(soup, box);
  const auto labels = label(filling);
  if constexpr (!Complex::Domain::has_outside)
    join_sides(box, filling.points, filling.triangles);
  return assign_and_improve(std::move(dsc), filling.points, filling.triangles, labels, np);
}

// Closed curves together, and the labels of what they enclose.
template <class Label> struct Closed_curves_2
{
  Curve_soup_2 soup;
  std::vector<Label> labels;

  template <class Curve> explicit Closed_curves_2(const std::vector<Curve>& curves) {
    if (curves.empty())
      throw Error("there are no curves: give one at least");
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
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex of regions of the plane that are bounded by closed polylines, in a rectangle that
belongs to the outside: the twin of `make_deformable_simplicial_complex_3()`.

A curve is a set of segments, an even number of them at each point. Curves may be nested in any way,
may touch in common ends of segments, and may have whole segments in common, but not cross or
overlap in parts. A point inside several curves gets the label of the one that is entered last on a
way from the outside that crosses as few segments as possible, the one that was given last if
several are entered at once; outside all of them is label 0.

Space is filled by CGAL's constrained Delaunay triangulation, with points as dense as those of the
curves near them and sparser away from them. Points of the curves keep their coordinates, bit for
bit.

\tparam Complex an instance of `Deformable_simplicial_complex_2`
\tparam NP a sequence of named parameters

\param curves with the labels of what they enclose; coordinates are rounded to `double`
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{enclosing_box}
    \cgalParamDescription{The domain, in which the curves must be strictly inside.}
    \cgalParamType{`Bbox_2` or a class with `bbox()`, such as `Iso_rectangle_2`}
    \cgalParamDefault{the square about the barycenter of the points whose half side is 2.5 times the
                      largest distance of a point from it}
  \cgalParamNEnd
  \cgalParamNBegin{improve}
    \cgalParamDescription{Whether the mesh is improved at the end, as it will be in each step of a
                          deformation.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{quality_threshold}
    \cgalParamDescription{Only cells of lower quality are improved, in [0, 1].}
    \cgalParamType{`double`}
    \cgalParamDefault{0.3}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{How many rounds of improvement at the most.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{10}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_surface_error if a curve is not as described above,
        or reaches the box: its facets are segments
\throws Error if there is no curve, or parameters or the extent of the
        domain are out of range

n log n in the number of segments and triangles.
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(
    const std::vector<Labelled_curve_2<typename Complex::Point_2>>& curves,
    const NP& np = parameters::default_values()) {
  const internal::Closed_curves_2<typename Complex::Label> closed(curves);
  return internal::fill_box(
      Complex(), closed.soup, internal::enclosing_box(closed.soup, np), np,
      [&](const internal::Planar_filling_2& filling) { return closed.label(filling); });
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex on a flat torus of regions that are bounded by closed polylines, as above. The
polylines are given unwrapped, in the plane, and may lie across the seam; together they are less
than a period wide and high. For regions that go around the torus, use a function of labels.

\tparam Complex an instance of `Deformable_simplicial_complex_2` with the domain `Torus_domain<2>`
\param domain the torus
\param curves as above; points are rounded to the unit of positions on the torus
\param np the named parameters above, but for `enclosing_box`

\throws Invalid_surface_error if a curve is not as described above,
        or too large
\throws Error if there is no curve, or parameters are out of range

n log n in the number of segments and triangles.
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(
    const Torus_domain<2>& domain,
    const std::vector<Labelled_curve_2<typename Complex::Point_2>>& curves,
    const NP& np = parameters::default_values()) {
  const internal::Closed_curves_2<typename Complex::Label> closed(curves);
  return internal::fill_box(
      Complex(domain), closed.soup, internal::box_of_torus(closed.soup, domain.periods()), np,
      [&](const internal::Planar_filling_2& filling) { return closed.label(filling); });
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex of the regions between segments, whose labels are told by points in them; enclosed
regions without one get the label `enclosed_label` of the segments. As above, but segments need not
be closed curves: those with the same label on both sides are just edges of the mesh.

\param segments with seeds; coordinates are rounded to `double`
\param np the named parameters above

\throws Invalid_surface_error if segments cross or overlap, have no
        length, or reach the box
\throws Error if there is no segment, a seed is outside the box or on
        a segment, or two seeds give a region different labels; or as above

n log n in the number of segments and triangles.
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex
make_deformable_simplicial_complex_2(const Seeded_segments_2<typename Complex::Point_2>& segments,
                                     const NP& np = parameters::default_values()) {
  internal::Curve_soup_2 soup;
  internal::add_segments(segments, 0, soup);
  return internal::fill_box(Complex(), soup, internal::enclosing_box(soup, np), np,
                            [&](const internal::Planar_filling_2& filling) {
                              return internal::label_by_seeds(segments, soup, filling);
                            });
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex of an image of labels. Each label gets the area of its pixels, and the center of
each pixel keeps its label. The interface is smooth where it can be, and follows the edges of pixels
elsewhere: the boundary of a single pixel is a square. Pixels of a label that have only a corner in
common touch there. Away from the interface, triangles are large.

\tparam Complex an instance of `Deformable_simplicial_complex_2`
\param image the labels of square pixels of side 1, from the origin
\param edge about how long the segments of the interface are to be, in pixels; at least 1
\param np the named parameters above, but `enclosing_box`, which is the rectangle of all pixels by
       default; the space between the image and a larger box has label 0
\throws Error if the image has no pixels, more than 2^20 of them in a
        row or column, or not one label for each pixel; if `edge` is less than 1; if the image is
neither strictly inside the box nor fills it; or if more than 2^20 edges of pixels are between
different labels

Linear in the number of pixels, with a byte of memory for each, and n log n in the number of edges
of pixels between different labels, with about a kilobyte for each segment of the interface.
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(const Labelled_image_2& image, double edge = 2.5,
                                             const NP& np = parameters::default_values()) {
  std::optional<Bbox_2> box;
  if constexpr (!CGAL::parameters::is_default_parameter<NP, internal_np::enclosing_box_t>::value)
    box = internal::box_of(CGAL::parameters::get_parameter(np, internal_np::enclosing_box));
  const internal::Image_filling_2 filling = internal::fill_image(image, edge, box);
  return internal::assign_and_improve(Complex(), filling.points, filling.triangles, filling.labels,
                                      np);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex of given triangles, the union of which is a disk. Triangles may be oriented in any
way. The interface stays what it is, bit for bit.

\tparam Complex an instance of `Deformable_simplicial_complex_2`

\param points the vertices, each in a triangle
\param triangles indices into `points`
\param labels one label for each triangle
\param np named parameters: `improve`, `quality_threshold`, `number_of_iterations`, as above

\throws Invalid_cells_error if coordinates are not finite,
        sizes or indices do not fit, a triangle is flat, or the union is no disk

n log n in the number of triangles, plus the improvement.
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(const std::vector<typename Complex::Point_2>& points,
                                             std::vector<std::array<std::size_t, 3>> triangles,
                                             const std::vector<typename Complex::Label>& labels,
                                             const NP& np = parameters::default_values()) {
  Complex dsc;
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
  internal::improve_new_mesh(dsc, internal::new_mesh_options(np));
  return dsc;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex in a rectangle from a function that tells labels, such as `Labelled_image_2`: almost
regular triangles get the labels of their barycenters, then `fit_interface()` moves the interface to
where labels change.

\tparam Complex an instance of `Deformable_simplicial_complex_2`
\param box the domain, of positive size
\param edge about how long edges are to be, more than 0
\param label_at `label_at(p)` tells the label at an `Approximate_point_2` in the box
\param np the named parameters of `deform_interface()`, for `fit_interface()`
\throws Error if `edge` is not positive, or too short, or the box is
        empty; or Invalid_cells_error if it is smaller or larger than complexes can be

Linear in the number of triangles.
*/
template <class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(const Bbox_2& box, double edge,
                                             const LabelAt& label_at,
                                             const NamedParameters& np = NamedParameters()) {
  return internal::fill_grid(Complex(), internal::box_grid(box, edge), label_at, np);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a complex on a flat torus from a function that tells labels: almost regular triangles get the
labels of their barycenters, then `fit_interface()` moves the interface to where labels change.

\tparam Complex an instance of `Deformable_simplicial_complex_2` with the domain `Torus_domain<2>`
\param domain the torus
\param edge about how long edges are to be, more than 0; there are at least three in each direction
\param label_at `label_at(p)` tells the label at an `Approximate_point_2` in the box of the torus
\param np the named parameters of `deform_interface()`, for `fit_interface()`
\throws Error if `edge` is not positive, or is less than a millionth
        of a period

Linear in the number of triangles.
*/
template <class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(const Torus_domain<2>& domain, double edge,
                                             const LabelAt& label_at,
                                             const NamedParameters& np = NamedParameters()) {
  return internal::fill_torus<Complex>(domain, edge, label_at, np);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

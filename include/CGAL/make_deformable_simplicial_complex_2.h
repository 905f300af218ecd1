// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
#define CGAL_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2/Labelled_curve_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/Graded_points_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Mesh_care_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Own_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/fill_torus.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Extent.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/improve_new_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

// The square about the barycenter of points whose half side is 2.5 times the largest distance of
// one from it, as in space.
inline Bbox_2 default_box(const std::vector<Planar_kernel::Point_2>& points) {
  static constexpr double margin = 2.5;
  double x = 0, y = 0, radius = 0;
  for (const auto& p : points) {
    x += p.x() / double(points.size());
    y += p.y() / double(points.size());
  }
  for (const auto& p : points)
    radius = (std::max)(radius, std::hypot(p.x() - x, p.y() - y));
  return {x - margin * radius, y - margin * radius, x + margin * radius, y + margin * radius};
}

// Refuses boxes and curves that are too large or too small to be measured, and curves that reach
// the box.
inline void check_enclosed(const Curve_soup_2& soup, const Bbox_2& box) {
  const auto is_measurable = [](const std::vector<std::array<double, 2>>& points) {
    return std::all_of(points.begin(), points.end(),
                       has_finite_coordinates<std::array<double, 2>>) &&
           extent_of<2>(points).is_measurable();
  };
  std::vector<std::array<double, 2>> points;
  for (const auto& p : soup.points)
    points.push_back({p.x(), p.y()});
  if (!is_measurable(points) ||
      !is_measurable({{box.xmin(), box.ymin()}, {box.xmax(), box.ymax()}}))
    throw Error(
        "the size of the curves or of the enclosing box is not between 1e-30 and 1e30: scale "
        "the curves, or give another box");
  const auto is_inside = [&](const Planar_kernel::Point_2& p) {
    return box.xmin() < p.x() && p.x() < box.xmax() && box.ymin() < p.y() && p.y() < box.ymax();
  };
  for (std::size_t w = 0; w < soup.walls.size(); ++w)
    for (std::size_t v : soup.walls[w].vertices)
      if (!is_inside(soup.points[v]))
        refuse_curve(Invalid_surface_error::Reason::outside_enclosing_box,
                     "is not strictly inside the enclosing box: give a larger box",
                     soup.walls[w].surface, soup.walls[w].surface, {soup.segments[w]});
}

inline Bbox_2 box_of(const Bbox_2& given) { return given; }
template <class Box> Bbox_2 box_of(const Box& given) { return given.bbox(); }

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex of regions of the plane that are bounded by closed polylines, in a rectangle that
belongs to the outside: the twin of `make_deformable_simplicial_complex_3()`.

A curve is a set of segments, an even number of them at each point. Curves may be nested in any way,
and may touch in common ends of segments, but not cross or overlap. A point inside several curves
gets the label of the one that is entered last on a way from the outside that crosses as few
segments as possible; outside all of them is label 0.

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

\throws Deformable_simplicial_complexes::Invalid_surface_error if a curve is not as described above,
        or reaches the box: its facets are segments
\throws Deformable_simplicial_complexes::Error if there is no curve, or parameters or the extent of the
        domain are out of range

n log n in the number of segments and triangles.
*/
template <class Complex,
          class NP = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_2(
    const std::vector<Labelled_curve_2<typename Complex::Point_2>>& curves,
    const NP& np = Deformable_simplicial_complexes::parameters::default_values()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  namespace tags = Deformable_simplicial_complexes::internal_np;
  using Deformable_simplicial_complexes::Error;
  const internal::New_mesh_options options = internal::new_mesh_options(np);
  if (curves.empty())
    throw Error("there are no curves: give one at least");

  internal::Curve_soup_2 soup;
  std::vector<typename Complex::Label> labels;
  for (const auto& curve : curves) {
    internal::add_curve(curve, labels.size(), soup);
    labels.push_back(curve.label);
  }
  internal::check_crossings(soup);
  Bbox_2 box = internal::default_box(soup.points);
  const auto given = CGAL::parameters::get_parameter(np, tags::enclosing_box);
  if constexpr (!CGAL::parameters::is_default_parameter<NP, tags::enclosing_box_t>::value)
    box = internal::box_of(given);
  internal::check_enclosed(soup, box);

  using Kernel = internal::Planar_kernel;
  using Tds =
      Triangulation_data_structure_2<Triangulation_vertex_base_with_info_2<std::size_t, Kernel>,
                                     Constrained_triangulation_face_base_2<Kernel>>;
  Constrained_Delaunay_triangulation_2<Kernel, Tds, No_constraint_intersection_tag> triangulation;
  std::vector<typename Tds::Vertex_handle> handles;
  for (const auto& p : soup.points)
    handles.push_back(triangulation.insert(p));
  for (const auto& wall : soup.walls)
    triangulation.insert_constraint(handles[wall.vertices[0]], handles[wall.vertices[1]]);
  const internal::Graded_points_2 graded(soup, box);
  triangulation.insert(graded.points().begin(), graded.points().end());

  for (auto v : triangulation.finite_vertex_handles())
    v->info() = std::size_t(-1);
  std::vector<typename Complex::Point_2> points;
  for (auto v : handles) {
    v->info() = points.size();
    points.emplace_back(v->point().x(), v->point().y());
  }
  for (auto v : triangulation.finite_vertex_handles())
    if (v->info() == std::size_t(-1)) {
      v->info() = points.size();
      points.emplace_back(v->point().x(), v->point().y());
    }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto f : triangulation.finite_face_handles())
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});

  Complex dsc;
  dsc.assign(points, triangles, internal::label_cells<2>(triangles, soup.walls, labels));
  internal::improve_new_mesh(dsc, options);
  return dsc;
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex on a flat torus from a function that tells labels: almost regular triangles get the
labels of their barycenters, then `fit_interface()` moves the interface to where labels change.

\tparam Complex an instance of `Deformable_simplicial_complex_2` with the domain `Torus_domain<2>`
\param domain the torus
\param edge about how long edges are to be, more than 0; there are at least three in each direction
\param label_at `label_at(p)` tells the label at an `Approximate_point_2` in the box of the torus
\param np the named parameters of `deform_interface()`, for `fit_interface()`
\throws Deformable_simplicial_complexes::Error if `edge` is not positive, or is less than a millionth
        of a period

Linear in the number of triangles.
*/
template <
    class Complex, class LabelAt,
    class NamedParameters = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex
make_deformable_simplicial_complex_2(const Deformable_simplicial_complexes::Torus_domain<2>& domain,
                                     double edge, const LabelAt& label_at,
                                     const NamedParameters& np = NamedParameters()) {
  return Deformable_simplicial_complexes::internal::fill_torus<Complex>(domain, edge, label_at, np);
}

} // namespace CGAL

#endif // CGAL_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_CONSTRUCTION_OPTIONS_H
#define CGAL_COMPLEX_CONSTRUCTION_CONSTRUCTION_OPTIONS_H

#include <CGAL/Complex_construction/Thin_part_options.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/parameter_values.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

Options of the functions that make a complex, such as `make_deformable_simplicial_complex_3()`. The
named parameters of these functions have the same names. The members of `thin_parts` are the named
parameters `edge_per_thickness` and `most_new_facets`, see `refine_thin_parts()`.

\tparam dimension dimension of the complex, 2 or 3
*/
template <int dimension> struct Construction_options
{
  using Box = std::conditional_t<dimension == 2, Bbox_2, Bbox_3>; ///< a box

  /// The domain, in the coordinates of the input, which must be strictly inside. As a named
  /// parameter, also of a class with `bbox()`, such as `Iso_cuboid_3`. If empty, it is the cube (in
  /// the plane, the square) centered at the barycenter of the points, whose half side is 2.5 times
  /// the largest distance of a point from the barycenter; \f$[-1, 1]^3\f$ if `normalize` is set.
  std::optional<Box> enclosing_box;
  /// Whether the coordinates of the complex are normalized, in space: the barycenter of the points
  /// is the origin, and their largest distance from it is 1/2.5. `Complex::normalization()` is the
  /// map to user coordinates.
  bool normalize = false;
  /// Number of pieces that each edge of the box is divided into, in [1, 1000], in space.
  unsigned box_subdivision = 4;
  /// Spacing of additional vertices beside a curve in the plane, in lengths of its nearest segment,
  /// in [.5, 10]. The default gives few triangles; solvers of equations, such as those of fluids,
  /// need `fine_spacing`.
  double spacing_per_segment = 3;
  static constexpr double fine_spacing = 1.2; ///< gives triangles of the size of the segments
  /// Thin parts are resolved by new facets of the interface.
  Thin_part_options thin_parts;
  /// Whether the mesh is improved at the end, as in each pass of a deformation. `improve_mesh()`
  /// gives a better mesh, since it also inserts vertices.
  bool improve = true;
  /// Only cells of lower quality are improved, in [0, 1]. A new mesh is optimized once. The value
  /// is greater than that of a deformation, so the first deformations have few cells to improve.
  double quality_threshold = .3;
  /// Largest number of rounds of improvement.
  unsigned number_of_iterations = 10;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    thin_parts.check();
    require_quality(quality_threshold);
    if (box_subdivision < 1 || box_subdivision > 1000)
      throw Error("the subdivision of the enclosing box is out of range: use 1 to 1000");
    if (!(spacing_per_segment >= .5 && spacing_per_segment <= 10))
      throw Error("the spacing of vertices beside curves is out of range: use .5 to 10 segments");
  }
};

namespace internal {

inline Bbox_2 box_of(const Bbox_2& given) { return given; }
inline Bbox_3 box_of(const Bbox_3& given) { return given; }
template <class Box> auto box_of(const Box& given) { return given.bbox(); }

// Does not compile if parameters of the box are given to a function that makes a complex of given
// cells.
template <int dimension, class NamedParameters> void refuse_box(const NamedParameters& np) {
  refuse_parameters<Construction_options<dimension>, internal_np::enclosing_box_t,
                    internal_np::normalize_t, internal_np::box_subdivision_t,
                    internal_np::spacing_per_segment_t>(np);
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Returns the options that named parameters give, or checks and returns given options. A named
parameter that has no effect in this dimension does not compile.

\tparam dimension dimension of the complex, 2 or 3
\tparam Others tags of parameters that the caller reads
\param np named parameters, or a `Construction_options<dimension>`
\throws Error if a value is out of its range
*/
template <int dimension, class... Others, class NamedParameters>
Construction_options<dimension> construction_options(const NamedParameters& np) {
  Construction_options<dimension> result;
  if constexpr (std::is_same<NamedParameters, Construction_options<dimension>>::value)
    result = np;
  else {
    using internal_np::enclosing_box_t;
    if constexpr (dimension == 2)
      internal::refuse_parameters<Construction_options<2>, internal_np::normalize_t,
                                  internal_np::box_subdivision_t>(np);
    else
      internal::refuse_parameters<Construction_options<3>, internal_np::spacing_per_segment_t>(np);
    read_parameters<enclosing_box_t, Others...>(np, result);
    if constexpr (is_given<NamedParameters, enclosing_box_t>)
      result.enclosing_box = internal::box_of(parameter(np, enclosing_box_t()));
  }
  result.check();
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_CONSTRUCTION_OPTIONS_H

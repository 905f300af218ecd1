// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H
#define CGAL_COMPLEX_CONSTRUCTION_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/fill_torus.h>
#include <CGAL/Complex_construction/internal/building/Boxed_soup_3.h>
#include <CGAL/Complex_construction/internal/building/Solid_tetrahedra_3.h>
#include <CGAL/Complex_construction/internal/building/grids.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/internal/sets/equal_points.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/internal/checks/check_surfaces_3.h>

#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A cell on one side of a facet of a surface.
struct Cell_at_triangle_3
{
  std::size_t triangle, cell;
  bool is_in_front; // whether the corners of the triangle are counterclockwise, seen from the cell
};

// Returns the two cells of each item of `mesh.facets`, in increasing order of these items.
inline std::vector<Cell_at_triangle_3> cells_at_triangles(const Tetrahedralization_3& mesh) {
  std::vector<Wall<3>> triangles;
  for (std::size_t t = 0; t < mesh.facets.size(); ++t)
    triangles.push_back(make_wall(mesh.facets[t], t));
  std::sort(triangles.begin(), triangles.end());
  const auto point = [&](std::size_t i) { return exact_point(mesh.points[i]); };
  std::vector<Cell_at_triangle_3> result;
  for (const auto& facet : sorted_facets(mesh.tetrahedra)) {
    const auto found =
        std::lower_bound(triangles.begin(), triangles.end(), Wall<3>{facet.vertices, 0});
    if (found == triangles.end() || found->vertices != facet.vertices)
      continue;
    const Triangle_indices& t = mesh.facets[found->surface];
    const auto opposite = mesh.tetrahedra[facet.cell][facet.index];
    result.push_back(
        {found->surface, facet.cell,
         orientation(point(t[0]), point(t[1]), point(t[2]), point(opposite)) == POSITIVE});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
  return result;
}

// The labels behind and in front of the triangles of a patch.
using Labels_of_sides = std::array<int, 2>;

// Returns the label of each cell, given by the labels of the two sides of the patches. Throws
// `Invalid_surface_error` if two patches give different labels to the same region.
inline std::vector<int> label_by_sides(const Tetrahedralization_3& mesh, const Boxed_soup_3& boxed,
                                       const std::vector<Labels_of_sides>& sides) {
  const auto cells = cells_at_triangles(mesh);
  std::vector<std::pair<std::size_t, int>> seeds;
  for (const auto& c : cells)
    seeds.emplace_back(c.cell, sides[boxed.origin(mesh, c.triangle).surface][c.is_in_front]);
  std::optional<Contradicting_seeds> contradicting;
  auto labels = label_cells_by_seeds<3>(mesh.tetrahedra, boxed.walls(mesh), seeds, contradicting);
  if (contradicting) {
    const auto first = boxed.origin(mesh, cells[contradicting->first].triangle),
               second = boxed.origin(mesh, cells[contradicting->second].triangle);
    refuse_surface(Invalid_surface_error::Reason::contradicting_sides, first.surface,
                   second.surface, {first.index, second.index}, {});
  }
  return labels;
}

// Checks, normalizes, encloses and tetrahedralizes surfaces, and makes an improved complex with
// labels.
template <class Complex, class Tetrahedralizer>
Complex make_from_soups(const std::vector<Triangle_soup_3>& surfaces,
                        const std::vector<typename Complex::Label>& surface_labels,
                        const Tetrahedralizer& tetrahedralizer,
                        const Construction_options<3>& options) {
  static_assert(
      is_tetrahedralizer<Tetrahedralizer>,
      "ConstrainedTetrahedralizer_3: Tetrahedralization_3 operator()(points, triangles) const");
  if constexpr (is_tetrahedralizer<Tetrahedralizer>)
    return make_resolved<Complex>(
        put_into_box(check_surfaces(surfaces), options), tetrahedralizer, options,
        [&](const Tetrahedralization_3& mesh, const Boxed_soup_3& boxed) {
          return label_cells<3>(mesh.tetrahedra, boxed.walls(mesh), surface_labels);
        });
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from solids bounded by closed triangle surfaces, in a box that belongs to the
outside (section 3.3 of the paper). n log n in the number of triangles and tetrahedra, plus the
tetrahedralization and the improvement.

A surface is a set of triangles that meet only in common vertices and edges; an even number of them
meet in each edge. It may have any number of connected components, which may touch in vertices and
along edges. Triangles may be oriented in any way and need not share points: equal points are
merged, and points without triangles are ignored. A point is inside a surface if a path from the
outside crosses the surface once; a path that crosses it twice leads into a cavity.

Surfaces may be nested in any way, and may touch in common vertices and along common edges. They
must not cross or share triangles. The label of a point is found along a path from the outside that
crosses as few triangles as possible: it is the label of the surface entered last. Points outside
all surfaces have label 0.

Triangles between different labels form the interface of the complex. The coordinates of the points
are bitwise unchanged unless `normalize` is set. Triangles at thin parts are divided; edges between
triangles that are coplanar up to a millionth of their length are then exchanged, too.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param surfaces surfaces with the labels of the solids that they bound; coordinates are rounded to
       `double`
\param tetrahedralizer tetrahedralizer that fills the box
\param np a `Construction_options<3>`, or named parameters with the names of its members

\throws Invalid_surface_error if a surface is not as described above, or reaches the box
\throws Tetrahedralization_error if the tetrahedralizer fails
\throws Error if the box is not finite, or its subdivision is out of range

*/
template <class Complex, class Tetrahedralizer, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(
    const std::vector<Labeled_surface_3<typename Complex::Point_3>>& surfaces,
    const Tetrahedralizer& tetrahedralizer, const NP& np = parameters::default_values()) {
  std::vector<typename Complex::Label> labels;
  for (const auto& surface : surfaces)
    labels.push_back(surface.label);
  return internal::make_from_soups<Complex>(internal::soups_of(surfaces), labels, tetrahedralizer,
                                            construction_options<3>(np));
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from the solid bounded by a triangle mesh; the solid gets label 1. Otherwise the
function is the same as the overload above for a single surface. Indices in errors follow the order
of `vertices(surface)` and `faces(surface)`.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam FaceListGraph model of `FaceListGraph`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`
\tparam NP a sequence of named parameters

\param surface a closed mesh
\param tetrahedralizer tetrahedralizer that fills the box
\param np named parameters of the overload above, and CGAL's `vertex_point_map`; no struct

\throws Error if a face is not a triangle; otherwise as above
*/
#ifdef DOXYGEN_RUNNING
template <class Complex, class FaceListGraph, class Tetrahedralizer, class NP>
#else
template <class Complex, class FaceListGraph, class Tetrahedralizer,
          class NP = parameters::Default_named_parameters,
          class = decltype(faces(std::declval<const FaceListGraph&>()))>
#endif
Complex make_deformable_simplicial_complex_3(const FaceListGraph& surface,
                                             const Tetrahedralizer& tetrahedralizer,
                                             const NP& np = parameters::default_values()) {
  if (!is_triangle_mesh(surface))
    throw Error("the mesh has facets that are not triangles: triangulate them");
  using Point_map = typename GetVertexPointMap<FaceListGraph, NP>::const_type;
  std::vector<typename boost::property_traits<Point_map>::value_type> points;
  internal::Triangle_soup_3 soup;
  Polygon_mesh_processing::polygon_mesh_to_polygon_soup(surface, points, soup.triangles, np);
  soup.points = internal::all_coordinates(points);
  return internal::make_from_soups<Complex>(
      {soup}, {1}, tetrahedralizer, construction_options<3, CGAL::internal_np::vertex_point_t>(np));
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from patches that share borders, such as the walls between several materials. Each
patch has labels for both of its sides. A region that can be reached from a side without crossing a
triangle has the label of that side. The rest of the box thus has the label of the patches that it
touches. n log n in the number of triangles and tetrahedra, plus the tetrahedralization and the
improvement.

Triangles meet only in common vertices and edges, with any number of triangles in each. They need
not share points: equal points are merged, and points without triangles are ignored. Patches may be
open if regions of different labels are separated. A wall with the same label on both sides is not
part of the interface.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param patches patches with the labels of their sides; coordinates are rounded to `double`
\param tetrahedralizer tetrahedralizer that fills the box
\param np named parameters of the first overload

\throws Invalid_surface_error if a patch is not as described above, or reaches the box, or two
        patches give different labels for the same region
\throws Tetrahedralization_error if the tetrahedralizer fails
\throws Error if the box is not finite, or its subdivision is out of range
*/
template <class Complex, class Tetrahedralizer, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(
    const std::vector<Labeled_patch_3<typename Complex::Point_3>>& patches,
    const Tetrahedralizer& tetrahedralizer, const NP& np = parameters::default_values()) {
  std::vector<internal::Labels_of_sides> sides;
  for (const auto& patch : patches)
    sides.push_back({patch.label_behind, patch.label_in_front});
  const auto options = construction_options<3>(np);
  static_assert(
      internal::is_tetrahedralizer<Tetrahedralizer>,
      "ConstrainedTetrahedralizer_3: Tetrahedralization_3 operator()(points, triangles) const");
  if constexpr (internal::is_tetrahedralizer<Tetrahedralizer>)
    return internal::make_resolved<Complex>(
        internal::put_into_box(internal::check_patches(internal::soups_of(patches)), options),
        tetrahedralizer, options,
        [&](const Tetrahedralization_3& mesh, const internal::Boxed_soup_3& boxed) {
          return internal::label_by_sides(mesh, boxed, sides);
        });
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from given tetrahedra whose union is a ball. Tetrahedra may be oriented in any way.
The interface keeps its shape; facets at thin parts are bisected. n log n in the number of
tetrahedra, plus the improvement.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam NP a sequence of named parameters

\param points the vertices; each is in a tetrahedron. Equal points are merged.
\param tetrahedra indices into `points`
\param labels one label for each tetrahedron
\param np named parameters: `improve`, `edge_per_thickness`, `most_new_facets`,
       `quality_threshold`, `number_of_iterations`, as above

\throws Invalid_cells_error if coordinates are not finite, sizes or indices do not fit, a
        tetrahedron is degenerate, or the union is not a ball
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(std::vector<typename Complex::Point_3> points,
                                             std::vector<std::array<std::size_t, 4>> tetrahedra,
                                             const std::vector<typename Complex::Label>& labels,
                                             const NP& np = parameters::default_values()) {
  internal::refuse_box<3>(np);
  const auto options = construction_options<3>(np);
  Complex dsc;
  internal::merge_equal_points<3>(points, tetrahedra);
  internal::orient_tetrahedra(points, tetrahedra, dsc.geom_traits());
  dsc.assign(points, tetrahedra, labels);
  internal::improve_new_mesh(dsc, options);
  return dsc;
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from given tetrahedra, with any number of connected components and voids. Tetrahedra
with label 0 fill the space around them, in a box. Only the improvement changes the given
tetrahedra. Points of the interface are bitwise unchanged unless `normalize` is set. n log n in the
number of tetrahedra, plus the tetrahedralization and the improvement.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param points the vertices; equal points are merged, and points without tetrahedra are ignored
\param tetrahedra indices into `points`, oriented in any way
\param labels one label for each tetrahedron
\param tetrahedralizer tetrahedralizer that fills the space around the given tetrahedra
\param np named parameters of the first overload

\throws Invalid_cells_error if there are no tetrahedra, coordinates are not finite, sizes or indices
        do not fit, or tetrahedra are degenerate or overlap
\throws Invalid_surface_error if the boundary of the tetrahedra reaches the box; the vertices of the
        error are indices into `points`
\throws Tetrahedralization_error if the tetrahedralizer fails
*/
template <class Complex, class Tetrahedralizer, class NP = parameters::Default_named_parameters,
          class = std::enable_if_t<
              std::is_invocable_v<const Tetrahedralizer&, const std::vector<std::array<double, 3>>&,
                                  const std::vector<std::array<std::size_t, 3>>&>>>
Complex
make_deformable_simplicial_complex_3(const std::vector<typename Complex::Point_3>& points,
                                     const std::vector<std::array<std::size_t, 4>>& tetrahedra,
                                     const std::vector<typename Complex::Label>& labels,
                                     const Tetrahedralizer& tetrahedralizer,
                                     const NP& np = parameters::default_values()) {
  if (labels.size() != tetrahedra.size())
    throw Invalid_cells_error("the number of labels differs from the number of tetrahedra: give "
                              "one label for each tetrahedron");
  const auto options = construction_options<3>(np);
  const internal::Solid_tetrahedra_3 solid(points, tetrahedra, typename Complex::Geom_traits());
  const auto boxed = internal::put_into_box(solid.boundary(), options);
  const auto mesh = solid.with_space_around(internal::fill_box(boxed, tetrahedralizer), boxed);
  auto all_labels = labels;
  all_labels.resize(mesh.tetrahedra.size(), 0);
  Complex dsc;
  dsc.assign(internal::mesh_points<Complex>(mesh), mesh.tetrahedra, all_labels);
  internal::complete_in_frame(dsc, boxed.frame, options);
  return dsc;
}

/*!
\ingroup PkgComplexConstructionRef

Makes a complex in a box from a function of labels, such as one based on implicit functions. Almost
regular tetrahedra get the labels of their barycenters. Then `fit_interface()` moves the interface
to the places where labels change. Linear in the number of tetrahedra.

\tparam Complex an instance of `Deformable_simplicial_complex_3`

\param box the domain, of positive size
\param edge approximate edge length, positive
\param label_at `label_at(p)` returns the label at a `Point_3` in the box; or
       `label_at(points)` returns the labels at a vector of such points
\param np the named parameters of `deform_interface()`, for `fit_interface()`

\throws Error if `edge` is not positive, or too short, or the box is empty
\throws Invalid_cells_error if the box is too small or too large for a complex
*/
template <class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(const Bbox_3& box, double edge,
                                             const LabelAt& label_at,
                                             const NamedParameters& np = NamedParameters()) {
  static_assert(
      internal::labels_points<Complex, LabelAt>,
      "the function of labels: int operator()(Point) const, or a function of a vector of points");
  if constexpr (internal::labels_points<Complex, LabelAt>)
    return internal::fill_grid(Complex(), internal::box_grid(box, edge), label_at, np);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

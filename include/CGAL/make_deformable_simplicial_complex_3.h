// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H
#define CGAL_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

#include <CGAL/Deformable_simplicial_complex_3/Labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Tetrahedralization_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/box_grid_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/check_surfaces_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/check_tetrahedra_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/enclosing_box_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Mesh_care_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Own_operations_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/fill_grid.h>
#include <CGAL/Deformable_simplicial_complexes/fill_torus.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/label_cells.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/improve_new_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parameters/improvement_options.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

// check, normalize, enclose, tetrahedralize, label, assign, improve
template <class Complex, class Tetrahedralizer, class NP>
Complex make_from_soups(const std::vector<Triangle_soup_3>& surfaces,
                        const std::vector<typename Complex::Label>& surface_labels,
                        const Tetrahedralizer& tetrahedralizer, const NP& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const bool normalize = choose_parameter(get_parameter(np, internal_np::normalize), false);
  const unsigned subdivision =
      count_parameter(np, internal_np::box_subdivision, "box_subdivision", 4u);

  Joined_soup_3 soup = check_surfaces(surfaces);
  const Building_frame_3 frame(soup.points, normalize);
  const Bbox_3 box = frame.box(get_parameter(np, internal_np::enclosing_box));
  for (Coordinates_3& p : soup.points)
    p = frame(p);
  check_distinct(soup);
  check_enclosed(soup, box);

  std::vector<Wall<3>> walls;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    walls.push_back(make_wall(soup.triangles[t], soup.triangle_origins[t].surface));
  append(soup, box_surface(box, subdivision));

  const auto mesh = tetrahedralizer(soup.points, soup.triangles);
  if (mesh.points.size() < soup.points.size() ||
      !std::equal(soup.points.begin(), soup.points.end(), mesh.points.begin()))
    throw Tetrahedralization_error("the tetrahedralizer moved points of the surfaces: use another "
                                   "one");
  std::vector<typename Complex::Point_3> points;
  const auto construct_point = typename Complex::Geom_traits().construct_exact_point_3_object();
  for (const Coordinates_3& p : mesh.points)
    points.push_back(construct_point({p[0], p[1], p[2]}));

  for (const auto& t : mesh.tetrahedra)
    if (*std::max_element(t.begin(), t.end()) >= points.size())
      throw Tetrahedralization_error("the tetrahedralizer names a point that does not exist: use "
                                     "another one");
  Complex dsc;
  dsc.assign(points, mesh.tetrahedra, label_cells<3>(mesh.tetrahedra, walls, surface_labels));
  const Coordinates_3& t = frame.translation();
  dsc.set_normalization({{t[0], t[1], t[2]}, frame.scale()});
  improve_new_mesh(dsc, new_mesh_options(np));
  return dsc;
}

template <class Points> std::vector<Coordinates_3> all_coordinates(const Points& points) {
  std::vector<Coordinates_3> result;
  for (const auto& p : points)
    result.push_back(coordinates(p));
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex of solids that are bounded by closed triangle surfaces, in a box that belongs to the
outside (section 3.3 of the paper).

A surface is a set of triangles that meet only in common vertices and edges, an even number of them
in each edge: it may have any number of parts, which may touch in vertices and along edges. Its
triangles may be oriented in any way and need not share points: equal points are merged, points
without triangles are left out. What is inside is counted: points that can be reached from the
outside by crossing a surface once are inside of it, crossing it twice leads into a cavity of it.

Surfaces may be nested in any way, and may touch in common vertices and along common edges, but not
cross nor share triangles. Space inside several surfaces gets the label of the one that is entered
last on a way from the outside that crosses as few triangles as possible; space outside all of them
gets label 0.

Triangles between different labels are the interface of the complex. Points of the surfaces keep
their coordinates, bit for bit unless `normalize` is set.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param surfaces with the labels of what they enclose; coordinates are rounded to `double`
\param tetrahedralizer fills the box with tetrahedra
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{normalize}
    \cgalParamDescription{Whether the complex uses coordinates in which the barycenter of the points
                          of the surfaces is the origin and their largest distance from it is
                          1/2.5. `Complex::normalization()` leads back.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{enclosing_box}
    \cgalParamDescription{The domain, in the coordinates of the surfaces, which must be strictly
                          inside.}
    \cgalParamType{`Bbox_3` or a class with `bbox()`, such as `Iso_cuboid_3`}
    \cgalParamDefault{the cube about the barycenter whose half side is 2.5 times the largest
                      distance of a point from it: \f$[-1, 1]^3\f$ if `normalize` is set}
  \cgalParamNEnd
  \cgalParamNBegin{box_subdivision}
    \cgalParamDescription{Number of parts into which each edge of the box is cut, 1 to 1000.}
    \cgalParamType{`unsigned`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{improve}
    \cgalParamDescription{Whether the mesh is improved at the end, as it will be in each step of a
                          deformation. `improve_mesh()` does more, by inserting vertices.}
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

\throws Deformable_simplicial_complexes::Invalid_surface_error if a surface is not as described
        above, or reaches the box
\throws Deformable_simplicial_complexes::Tetrahedralization_error if the tetrahedralizer fails
\throws Deformable_simplicial_complexes::Error if the box is not finite, or its subdivision is out
of range

n log n in the number of triangles and tetrahedra, plus the tetrahedralization and the improvement.
*/
template <class Complex, class Tetrahedralizer,
          class NP = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(
    const std::vector<Labelled_surface_3<typename Complex::Point_3>>& surfaces,
    const Tetrahedralizer& tetrahedralizer,
    const NP& np = Deformable_simplicial_complexes::parameters::default_values()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  std::vector<internal::Triangle_soup_3> soups;
  std::vector<typename Complex::Label> labels;
  for (const auto& surface : surfaces) {
    soups.push_back({internal::all_coordinates(surface.points), surface.triangles});
    labels.push_back(surface.label);
  }
  return internal::make_from_soups<Complex>(soups, labels, tetrahedralizer, np);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex of the solid, with label 1, that is bounded by a triangle mesh. The same as the
overload above for a single surface; indices in errors count `vertices(surface)` and
`faces(surface)`.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam FaceListGraph model of `FaceListGraph`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`
\tparam NP a sequence of named parameters

\param surface a closed mesh
\param tetrahedralizer fills the box with tetrahedra
\param np named parameters of the overload above, and CGAL's `vertex_point_map`

\throws Deformable_simplicial_complexes::Error if a face is no triangle; else as above
*/
#ifdef DOXYGEN_RUNNING
template <class Complex, class FaceListGraph, class Tetrahedralizer, class NP>
#else
template <class Complex, class FaceListGraph, class Tetrahedralizer,
          class NP = Deformable_simplicial_complexes::parameters::Default_named_parameters,
          class = decltype(faces(std::declval<const FaceListGraph&>()))>
#endif
Complex make_deformable_simplicial_complex_3(
    const FaceListGraph& surface, const Tetrahedralizer& tetrahedralizer,
    const NP& np = Deformable_simplicial_complexes::parameters::default_values()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  if (!is_triangle_mesh(surface))
    throw Deformable_simplicial_complexes::Error(
        "the mesh has facets that are no triangles: triangulate them, see "
        "CGAL::Polygon_mesh_processing::triangulate_faces()");
  using Point_map = typename GetVertexPointMap<FaceListGraph, NP>::const_type;
  std::vector<typename boost::property_traits<Point_map>::value_type> points;
  internal::Triangle_soup_3 soup;
  Polygon_mesh_processing::polygon_mesh_to_polygon_soup(surface, points, soup.triangles, np);
  soup.points = internal::all_coordinates(points);
  return internal::make_from_soups<Complex>({soup}, {1}, tetrahedralizer, np);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex of given tetrahedra, the union of which is a ball. Tetrahedra may be oriented in any
way. The interface stays what it is, bit for bit.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam NP a sequence of named parameters

\param points the vertices, each in a tetrahedron
\param tetrahedra indices into `points`
\param labels one label for each tetrahedron
\param np named parameters: `improve`, `quality_threshold`, `number_of_iterations`, as above

\throws Deformable_simplicial_complexes::Invalid_tetrahedra_error if coordinates are not finite,
        sizes or indices do not fit, a tetrahedron is flat, or the union is no ball

n log n in the number of tetrahedra, plus the improvement.
*/
template <class Complex,
          class NP = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(
    const std::vector<typename Complex::Point_3>& points,
    std::vector<std::array<std::size_t, 4>> tetrahedra,
    const std::vector<typename Complex::Label>& labels,
    const NP& np = Deformable_simplicial_complexes::parameters::default_values()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  Complex dsc;
  internal::orient_tetrahedra(points, tetrahedra, dsc.geom_traits());
  dsc.assign(points, tetrahedra, labels);
  internal::improve_new_mesh(dsc, internal::new_mesh_options(np));
  return dsc;
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex in a box from a function that tells labels, such as one of implicit functions:
almost regular tetrahedra get the labels of their barycenters, then `fit_interface()` moves the
interface to where labels change.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\param box the domain, of positive size
\param edge about how long edges are to be, more than 0
\param label_at `label_at(p)` tells the label at an `Approximate_point_3` in the box
\param np the named parameters of `deform_interface()`, for `fit_interface()`
\throws Deformable_simplicial_complexes::Error if `edge` is not positive, or too short, or the box is
        empty; or Invalid_tetrahedra_error if it is smaller or larger than complexes can be

Linear in the number of tetrahedra.
*/
template <
    class Complex, class LabelAt,
    class NamedParameters = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex make_deformable_simplicial_complex_3(const Bbox_3& box, double edge,
                                             const LabelAt& label_at,
                                             const NamedParameters& np = NamedParameters()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  return internal::fill_grid(Complex(), internal::box_grid(box, edge), label_at, np);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex on a flat torus from a function that tells labels: almost regular tetrahedra get the
labels of their barycenters, then `fit_interface()` moves the interface to where labels change.

\tparam Complex an instance of `Deformable_simplicial_complex_3` with the domain `Torus_domain<3>`
\param domain the torus
\param edge about how long edges are to be, more than 0; there are at least three in each direction
\param label_at `label_at(p)` tells the label at an `Approximate_point_3` in the box of the torus
\param np the named parameters of `deform_interface()`, for `fit_interface()`
\throws Deformable_simplicial_complexes::Error if `edge` is not positive, or is less than a millionth
        of a period

Linear in the number of tetrahedra.
*/
template <
    class Complex, class LabelAt,
    class NamedParameters = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex
make_deformable_simplicial_complex_3(const Deformable_simplicial_complexes::Torus_domain<3>& domain,
                                     double edge, const LabelAt& label_at,
                                     const NamedParameters& np = NamedParameters()) {
  return Deformable_simplicial_complexes::internal::fill_torus<Complex>(domain, edge, label_at, np);
}

} // namespace CGAL

#endif // CGAL_MAKE_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

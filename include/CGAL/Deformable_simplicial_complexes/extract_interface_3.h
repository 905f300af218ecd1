// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXTRACT_INTERFACE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXTRACT_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Extracted_facets.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is the interface of a complex, or a part of it, as a triangle soup in user coordinates. Triangles
share points, so the soup has the connectivity of the interface, which need not be manifold.

Across an edge of only two triangles the orientation is always coherent.

On a torus, each connected part is unwrapped: points may be outside the box, and a part that goes
around is cut open, with several points for the vertices there.

\tparam Complex is an instance of `Deformable_simplicial_complex_3`.

\sa `extract_interface()`
\sa `interface_to_surface_mesh()`
\sa `subdivide_interface()`
*/
template <class Complex> struct Interface_surface_3
{
  using Point_3 = typename Complex::Approximate_point_3; ///< has coordinates of type `double`
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Label = typename Complex::Label;                 ///< name of a phase

  /// the points in user coordinates, by increasing time stamp of their vertices; on a torus,
  /// further images of these follow
  std::vector<Point_3> points;

  /// indices into `points`; the normal points out of the first label of the triangle
  std::vector<std::array<std::size_t, 3>> triangles;

  /// for each triangle the label behind it and the label its normal points into
  std::vector<std::array<Label, 2>> labels;

  /// for each point the vertex it is the position of
  std::vector<Vertex_handle> vertices;

  /// for each point where it lies on the boundary of the domain
  std::vector<Boundary_class::Bits> boundary_classes;
};

namespace internal {

template <class Complex>
Interface_surface_3<Complex> interface_surface(const Complex& dsc,
                                               const std::vector<typename Complex::Facet>& facets,
                                               bool from_smaller_label) {
  Extracted_facets<Complex> extracted(dsc, facets, from_smaller_label);
  std::vector<Boundary_class::Bits> boundary_classes;
  for (auto v : extracted.vertices)
    boundary_classes.push_back(v->boundary_class());
  return {std::move(extracted.points), std::move(extracted.facets), std::move(extracted.labels),
          std::move(extracted.vertices), std::move(boundary_classes)};
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

extracts the whole interface of a complex. Normals point out of the larger label.

\param dsc is the complex; it is not changed.
\return the triangles in the order of `dsc.interface_facets()`.

Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
Interface_surface_3<Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>>
extract_interface(const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc) {
  return internal::interface_surface(dsc, dsc.interface_facets(), false);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

extracts the interface between two labels. Normals point out of `a` into `b`.

\param dsc is the complex; it is not changed.
\param a, b are different labels. If no facets lie between them the result is empty.
\return the triangles in the order of `dsc.interface_facets(a, b)`.

Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
Interface_surface_3<Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>>
extract_interface(
    const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
    typename Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>::Label a,
    typename Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>::Label b) {
  return internal::interface_surface(dsc, dsc.interface_facets(a, b), a < b);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

adds an interface to a polygon mesh.

A polygon mesh is manifold and an interface need not be. Where more than two triangles share an
edge, the surface is cut open along the edge; where the triangles at a vertex form more than one
fan, each fan gets a vertex of its own. `Polygon_mesh_processing::orient_polygon_soup()` does both.
Triangles keep their orientation, and the mesh has them in the order of `surface.triangles`;
vertices come in the order of `surface.points`, followed by the duplicates.

\tparam Complex is an instance of `Deformable_simplicial_complex_3`.
\tparam TriangleMesh is a model of `MutableFaceGraph` with an internal property map for
`CGAL::vertex_point_t` whose points can be constructed from three coordinates.

\param surface is what `extract_interface()` returned.
\param mesh is the mesh that vertices and faces are added to.

n log n in the size of the interface.
*/
template <class Complex, class TriangleMesh>
void interface_to_surface_mesh(const Interface_surface_3<Complex>& surface, TriangleMesh& mesh) {
  using Point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  std::vector<Point> points;
  points.reserve(surface.points.size());
  for (const auto& p : surface.points)
    points.emplace_back(p.x(), p.y(), p.z());
  auto triangles = surface.triangles;
  Polygon_mesh_processing::orient_polygon_soup(points, triangles);
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXTRACT_INTERFACE_3_H

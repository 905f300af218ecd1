// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_EXTRACT_INTERFACE_3_H
#define CGAL_INTERFACE_REMESHING_EXTRACT_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/internal/extraction/Extracted_facets.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/properties.hpp>

#include <boost/property_map/property_map.hpp>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

The interface of a complex in 3D, or a part of it, as a triangle soup in user coordinates. Triangles
share points, so that the soup has the connectivity of the interface, which may be non-manifold. The
two triangles at an edge of exactly two triangles are always consistently oriented.

On a torus, each connected component of the interface is unwrapped, so that points may be outside
the box. A component that winds around the torus is cut open; vertices at the cut have several
points.

\tparam Complex an instance of `Deformable_simplicial_complex_3`

\sa `extract_interface()`
\sa `interface_to_surface_mesh()`
\sa `subdivide_interface()`
*/
template <class Complex> struct Interface_surface_3
{
  /// point with coordinates of type `double`
  using Point_3 = typename Complex::Point_3;
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Label = typename Complex::Label;                 ///< name of a phase

  /// points in user coordinates, by increasing time stamp of their vertices; on a torus, further
  /// images of the vertices follow
  std::vector<Point_3> points;

  /// indices into `points`; the normal points out of the first label of the triangle
  std::vector<std::array<std::size_t, 3>> triangles;

  /// labels behind and in front of each triangle; the normal points from the first to the second
  /// one
  std::vector<std::array<Label, 2>> labels;

  /// vertex at each point
  std::vector<Vertex_handle> vertices;

  /// boundary class of each point
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
\ingroup PkgInterfaceRemeshingRef

Extracts the whole interface of a complex in 3D. Normals point out of the larger label. Linear in
the number of cells, and n log n in the size of the interface.

\param dsc the complex; it is not changed
\return the triangles, in the order of `dsc.interface_facets()`
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
Interface_surface_3<Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>>
extract_interface(const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc) {
  return internal::interface_surface(dsc, dsc.interface_facets(), false);
}

/*!
\ingroup PkgInterfaceRemeshingRef

Extracts the interface between two labels. Normals point out of `a` into `b`. Linear in the number
of cells, and n log n in the size of the interface.

\param dsc the complex; it is not changed
\param a, b different labels
\return the triangles, in the order of `dsc.interface_facets(a, b)`; empty if there is no facet
        between the labels
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
\ingroup PkgInterfaceRemeshingRef

Adds an interface to a polygon mesh. n log n in the size of the interface.

A polygon mesh is manifold, but an interface may be non-manifold. The surface is therefore cut open
along edges of more than two triangles. If the triangles at a vertex form more than one fan, each
fan gets its own vertex. `Polygon_mesh_processing::orient_polygon_soup()` does both. Triangles keep
their orientation and the order of `surface.triangles`. Vertices keep the order of `surface.points`,
followed by the duplicates.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam TriangleMesh model of `MutableFaceGraph` with an internal property map for
        `CGAL::vertex_point_t`, whose points can be constructed from three coordinates

\param surface a result of `extract_interface()`
\param mesh the mesh that vertices and faces are added to
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_EXTRACT_INTERFACE_3_H

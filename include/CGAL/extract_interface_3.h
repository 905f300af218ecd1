// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXTRACT_INTERFACE_3_H
#define CGAL_EXTRACT_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Vertex_numbering.h>

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

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

is the interface of a complex, or a part of it, as a triangle soup in user coordinates. Triangles
share points, so the soup has the connectivity of the interface, which need not be manifold.

Across an edge of only two triangles the orientation is always coherent.

\tparam Complex is an instance of `Deformable_simplicial_complex_3`.

\sa `extract_interface()`
\sa `interface_to_surface_mesh()`
*/
template <class Complex> struct Interface_surface_3
{
  using Point_3 = typename Complex::Approximate_point_3; ///< has coordinates of type `double`
  using Vertex_handle = typename Complex::Vertex_handle; ///< vertex of the complex
  using Label = typename Complex::Label;                 ///< name of a phase

  /// the points in user coordinates, by increasing time stamp of their vertices
  std::vector<Point_3> points;

  /// indices into `points`; the normal points out of the first label of the triangle
  std::vector<std::array<std::size_t, 3>> triangles;

  /// for each triangle the label behind it and the label its normal points into
  std::vector<std::array<Label, 2>> labels;

  /// for each point the vertex it is the position of
  std::vector<Vertex_handle> vertices;
};

namespace Deformable_simplicial_complexes {
namespace internal {

// The soup of interface facets given from their larger labels, turned around if asked for.
template <class Complex>
Interface_surface_3<Complex> interface_surface(const Complex& dsc,
                                               const std::vector<typename Complex::Facet>& facets,
                                               bool from_smaller_label) {
  using Vertex_handle = typename Complex::Vertex_handle;
  std::vector<Vertex_handle> corners;
  corners.reserve(3 * facets.size());
  for (const auto& facet : facets)
    for (Vertex_handle v : dsc.facet_vertices(facet))
      corners.push_back(v);
  const Vertex_numbering<Vertex_handle> number(corners);

  Interface_surface_3<Complex> surface;
  surface.vertices = number.vertices();
  surface.points.reserve(surface.vertices.size());
  for (Vertex_handle v : surface.vertices)
    surface.points.push_back(dsc.user_position(v));
  surface.triangles.reserve(facets.size());
  surface.labels.reserve(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto [cell, index] = facets[i];
    std::array<std::size_t, 3> triangle = {number(corners[3 * i]), number(corners[3 * i + 1]),
                                           number(corners[3 * i + 2])};
    std::array<int, 2> labels = {dsc.label(cell), dsc.label(cell->neighbor(index))};
    if (from_smaller_label) {
      std::swap(triangle[1], triangle[2]);
      std::swap(labels[0], labels[1]);
    }
    surface.triangles.push_back(triangle);
    surface.labels.push_back(labels);
  }
  return surface;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

extracts the whole interface of a complex. Normals point out of the larger label.

\param dsc is the complex; it is not changed.
\return the triangles in the order of `dsc.interface_facets()`.

Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class QualityMeasure>
Interface_surface_3<Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>>
extract_interface(const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc) {
  return Deformable_simplicial_complexes::internal::interface_surface(dsc, dsc.interface_facets(),
                                                                      false);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

extracts the interface between two labels. Normals point out of `a` into `b`.

\param dsc is the complex; it is not changed.
\param a, b are different labels. If no facets lie between them the result is empty.
\return the triangles in the order of `dsc.interface_facets(a, b)`.

Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class QualityMeasure>
Interface_surface_3<Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>>
extract_interface(const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc,
                  typename Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>::Label a,
                  typename Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>::Label b) {
  return Deformable_simplicial_complexes::internal::interface_surface(
      dsc, dsc.interface_facets(a, b), a < b);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

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

} // namespace CGAL

#endif // CGAL_EXTRACT_INTERFACE_3_H

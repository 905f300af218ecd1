// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOXED_SOUP_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOXED_SOUP_3_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/Tetrahedralization_error.h>
#include <CGAL/Complex_construction/internal/building/enclosing_box_3.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Complex_construction/internal/thin_parts/Thickness.h>
#include <CGAL/Complex_construction/internal/thin_parts/improve_new_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/Vertex_numbers.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Soup_bisector_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The box of a complex and a triangle soup strictly inside it, both in the frame of the complex.
struct Boxed_soup_3
{
  Joined_soup_3 soup;
  Building_frame_3 frame;
  Bbox_3 box;
  unsigned subdivision; // number of subdivisions of each edge of the box

  std::vector<Wall<3>> walls() const {
    std::vector<Wall<3>> result;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
      result.push_back(make_wall(soup.triangles[t], soup.triangle_origins[t].surface));
    return result;
  }
};

// Transforms a soup into the frame of the complex. Throws `Invalid_surface_error` if triangles
// reach the box, or if distinct points become equal by rounding in this frame.
inline Boxed_soup_3 put_into_box(Joined_soup_3 soup, const Construction_options<3>& options) {
  const Building_frame_3 frame(soup.points, options.normalize);
  Boxed_soup_3 result = {std::move(soup), frame, frame.box(options.enclosing_box),
                         options.box_subdivision};
  for (Coordinates_3& p : result.soup.points)
    p = frame(p);
  check_distinct(result.soup);
  check_enclosed(result.soup, result.box);
  return result;
}

// Fills the box with tetrahedra. The triangles of the soup are facets of them, and the points of
// the soup come first. Throws `Tetrahedralization_error` if the tetrahedralizer moves these points
// or returns an invalid index.
template <class Tetrahedralizer>
Tetrahedralization_3 fill_box(const Boxed_soup_3& boxed, const Tetrahedralizer& tetrahedralizer) {
  const Progress_phase phase("filling the box with tetrahedra");
  Triangle_soup_3 all = boxed.soup;
  append(all, box_surface(boxed.box, boxed.subdivision));
  auto mesh = tetrahedralizer(all.points, all.triangles);
  if (mesh.points.size() < all.points.size() ||
      !std::equal(all.points.begin(), all.points.end(), mesh.points.begin()))
    throw Tetrahedralization_error(
        "the tetrahedralizer moved points of the surfaces: use another tetrahedralizer");
  for (const auto& t : mesh.tetrahedra)
    if (*std::max_element(t.begin(), t.end()) >= mesh.points.size())
      throw Tetrahedralization_error(
          "the tetrahedralizer refers to a point that does not exist: use another tetrahedralizer");
  return mesh;
}

// Returns the exact points of a mesh.
template <class Complex>
std::vector<typename Complex::Point_3> exact_points(const Tetrahedralization_3& mesh) {
  std::vector<typename Complex::Point_3> result;
  const auto construct_point = typename Complex::Geom_traits().construct_exact_point_3_object();
  for (const Coordinates_3& p : mesh.points)
    result.push_back(construct_point({p[0], p[1], p[2]}));
  return result;
}

// Completes a complex of labeled tetrahedra that are given in a frame.
template <class Complex>
void complete_in_frame(Complex& dsc, const Building_frame_3& frame,
                       const Construction_options<3>& options) {
  const Coordinates_3& t = frame.translation();
  dsc.set_normalization({{t[0], t[1], t[2]}, frame.scale()});
  improve_new_mesh(dsc, options);
}

// Returns what the thin parts of a complex require of the triangles of a soup, so that about `most`
// triangles arise at most. The points of the soup are the first ones of `vertices`.
template <class Complex>
std::vector<Soup_bisector_3::Requirement>
requirements_of_thin_parts(const Complex& dsc, const Triangle_soup_3& soup,
                           const std::vector<typename Complex::Vertex_handle>& vertices,
                           double edge_per_thickness, std::size_t most) {
  const auto coarse = coarse_facets(dsc, edge_per_thickness, most).facets;
  if (coarse.empty())
    return {};
  const Vertex_numbers numbers(dsc, vertices);
  std::map<Triangle_indices, std::size_t> triangles;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    Triangle_indices key = soup.triangles[t];
    std::sort(key.begin(), key.end());
    triangles.emplace(key, t);
  }
  std::vector<Soup_bisector_3::Requirement> result;
  for (const auto& facet : coarse) {
    Triangle_indices key = {};
    for (int i = 0, k = 0; i < Complex::corners; ++i)
      if (i != facet.facet.second)
        key[k++] = numbers(facet.facet.first->vertex(i));
    std::sort(key.begin(), key.end());
    if (const auto found = triangles.find(key); found != triangles.end()) {
      Soup_bisector_3::Requirement requirement = {found->second, facet.longest, {}};
      for (const auto& [place, longest] : facet.places)
        requirement.places.push_back({coordinates(place), longest});
      result.push_back(std::move(requirement));
    }
  }
  return result;
}

// Fills the box, and returns the complex. Triangles that are large beside the thickness of a part
// are bisected, and the box is filled again: so cells are better than those that arise from the
// bisection of flat cells.
// \param label `label(mesh, boxed)` returns the labels of tetrahedra
template <class Complex, class Tetrahedralizer, class Label>
Complex make_resolved(Boxed_soup_3 boxed, const Tetrahedralizer& tetrahedralizer,
                      Construction_options<3> options, const Label& label) {
  const auto make = [&](std::vector<typename Complex::Vertex_handle>& vertices) {
    const auto mesh = fill_box(boxed, tetrahedralizer);
    Complex dsc;
    vertices = dsc.assign(exact_points<Complex>(mesh), mesh.tetrahedra, label(mesh, boxed));
    return dsc;
  };
  std::vector<typename Complex::Vertex_handle> vertices;
  Complex dsc = make(vertices);
  static constexpr int most_fillings = 8; // two usually suffice
  const std::size_t most = boxed.soup.triangles.size() + options.thin_parts.most_new_facets;
  for (int i = 0; i < most_fillings && options.thin_parts.edge_per_thickness > 0; ++i) {
    if (boxed.soup.triangles.size() >= most)
      break;
    Soup_bisector_3 bisector(boxed.soup);
    if (!bisector.run(requirements_of_thin_parts(dsc, boxed.soup, vertices,
                                                 options.thin_parts.edge_per_thickness,
                                                 most - boxed.soup.triangles.size()),
                      most))
      break;
    boxed.soup = bisector.soup();
    try {
      dsc = make(vertices);
    } catch (const Tetrahedralization_error&) {
      break; // the complex of the coarser triangles will do
    }
  }
  options.thin_parts.edge_per_thickness = 0; // done
  complete_in_frame(dsc, boxed.frame, options);
  return dsc;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOXED_SOUP_3_H

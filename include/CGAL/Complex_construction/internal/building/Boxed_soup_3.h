// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOXED_SOUP_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOXED_SOUP_3_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Complex_construction/internal/building/remove_points_on_triangles_3.h>
#include <CGAL/Complex_construction/internal/thin_parts/Thickness.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/internal/checks/check_surfaces_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Soup_bisector_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

inline Bbox_3 cube(const Coordinates_3& center, double half_side) {
  const auto& c = center;
  const double h = half_side;
  return {c[0] - h, c[1] - h, c[2] - h, c[0] + h, c[1] + h, c[2] + h};
}

// The frame in which the complex is built: p = translation + scale * q for a user's point p and the
// corresponding point q of the complex. The default box is the cube centered at the barycenter b of
// the points, with half side 2.5 r, where r is the largest distance of a point from b (section 3.3
// of the paper).
class Building_frame_3
{
public:
  // Computes the frame. Normalization maps the default box to [-1,1]^3; without it, coordinates do
  // not change. Throws `Error` if the size of the default box is zero or not finite.
  Building_frame_3(const std::vector<Coordinates_3>& points, bool normalize) {
    Coordinates_3 barycenter = {0, 0, 0};
    std::size_t n = 0;
    for (const Coordinates_3& p : points) {
      ++n;
      for (std::size_t i = 0; i < 3; ++i)
        barycenter[i] += (p[i] - barycenter[i]) / double(n);
    }
    double radius = 0;
    for (const Coordinates_3& p : points)
      radius = (std::max)(
          radius, std::hypot(p[0] - barycenter[0], p[1] - barycenter[1], p[2] - barycenter[2]));
    const double half_side = 2.5 * radius;
    if (!std::isfinite(half_side) || half_side == 0)
      throw Error(
          "the size of the surfaces is 0 or too large for numbers of type double: scale them");
    if (normalize) {
      m_translation = barycenter;
      m_scale = half_side;
      m_default_box = cube({0, 0, 0}, 1);
    } else
      m_default_box = cube(barycenter, half_side);
  }

  const Coordinates_3& translation() const { return m_translation; }
  double scale() const { return m_scale; }

  Coordinates_3 operator()(const Coordinates_3& p) const {
    return {(p[0] - m_translation[0]) / m_scale, (p[1] - m_translation[1]) / m_scale,
            (p[2] - m_translation[2]) / m_scale};
  }

  // Returns, in this frame, the box given by the user, or else the default box.
  Bbox_3 box(const std::optional<Bbox_3>& given) const {
    if (!given)
      return m_default_box;
    const Coordinates_3 min = (*this)({given->xmin(), given->ymin(), given->zmin()});
    const Coordinates_3 max = (*this)({given->xmax(), given->ymax(), given->zmax()});
    return {min[0], min[1], min[2], max[0], max[1], max[2]};
  }

private:
  Coordinates_3 m_translation = {0, 0, 0};
  double m_scale = 1;
  Bbox_3 m_default_box;
};

// Throws `Invalid_surface_error` with the vertices of the first surface that is not strictly inside
// the box.
inline void check_enclosed(const Joined_soup_3& soup, const Bbox_3& box) {
  const auto is_inside = [&box](const Coordinates_3& p) {
    return box.xmin() < p[0] && p[0] < box.xmax() && box.ymin() < p[1] && p[1] < box.ymax() &&
           box.zmin() < p[2] && p[2] < box.zmax();
  };
  std::size_t surface = 0;
  std::vector<std::size_t> vertices;
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Joined_soup_3::Origin& origin = soup.point_origins[i];
    if (is_inside(soup.points[i]) || (!vertices.empty() && origin.surface != surface))
      continue;
    surface = origin.surface;
    vertices.push_back(origin.index);
  }
  if (!vertices.empty())
    refuse_surface(Invalid_surface_error::Reason::outside_enclosing_box, surface, {},
                   std::move(vertices));
}

// Throws `Invalid_surface_error` if distinct points of the user have become equal by rounding.
inline void check_distinct(const Joined_soup_3& soup) {
  const std::vector<std::size_t> kept = merge_points(soup).input_points;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (i == kept.size() || kept[i] != i)
      refuse_surface(Invalid_surface_error::Reason::too_fine, soup.point_origins[i].surface);
}

// Returns the surface of a box. Each side is divided into n x n rectangles of two triangles each.
// Diagonals run from the corners of a side towards its center, so that no tetrahedron inside can
// have three facets on the box. Throws `Error` if the size of the box is out of
// range.
inline Triangle_soup_3 box_surface(const Bbox_3& box, unsigned n) {
  const std::array<Coordinates_3, 2> corners = {Coordinates_3{box.xmin(), box.ymin(), box.zmin()},
                                                {box.xmax(), box.ymax(), box.zmax()}};
  if (!has_finite_coordinates(corners[0]) || !has_finite_coordinates(corners[1]) ||
      !extent_of<3>(corners).is_measurable())
    throw Error("the size of the enclosing box is not between 1e-30 and 1e30: give another box, "
                "scale the surfaces, or normalize them");

  // The result is exact at both ends, so that adjacent sides have equal corners and edges.
  const auto coordinate = [&](int axis, unsigned i) {
    return i == n ? box.max(axis)
                  : box.min(axis) + (box.max(axis) - box.min(axis)) * (double(i) / n);
  };
  Triangle_soup_3 soup;
  for (int axis = 0; axis < 3; ++axis)
    for (unsigned end : {0u, n}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const std::size_t first = soup.points.size();
      for (unsigned i = 0; i <= n; ++i)
        for (unsigned j = 0; j <= n; ++j) {
          Coordinates_3 p;
          p[axis] = coordinate(axis, end);
          p[u] = coordinate(u, i);
          p[v] = coordinate(v, j);
          soup.points.push_back(p);
        }
      for (unsigned i = 0; i < n; ++i)
        for (unsigned j = 0; j < n; ++j) {
          const std::size_t a = first + i * std::size_t(n + 1) + j, b = a + n + 1;
          const bool rises = (2 * i < n) == (2 * j < n);
          soup.triangles.push_back({a, b, rises ? b + 1 : a + 1});
          soup.triangles.push_back({rises ? a : b, b + 1, a + 1});
        }
    }
  return merge_points(soup);
}

// The box of a complex and a triangle soup strictly inside it, both in the frame of the complex.
struct Boxed_soup_3
{
  Joined_soup_3 soup;
  Building_frame_3 frame;
  Bbox_3 box;
  unsigned subdivision; // number of subdivisions of each edge of the box

  // Returns the facets of the mesh made by `fill_box()` that form the surfaces.
  std::vector<Wall<3>> walls(const Tetrahedralization_3& mesh) const {
    std::vector<Wall<3>> result;
    for (std::size_t i = 0; i < mesh.facets.size(); ++i)
      result.push_back(make_wall(mesh.facets[i], origin(mesh, i).surface));
    return result;
  }

  // Returns the origin of the triangle that contains a facet.
  const Joined_soup_3::Origin& origin(const Tetrahedralization_3& mesh, std::size_t facet) const {
    return soup.triangle_origins[mesh.triangles_of_facets[facet]];
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

// Whether a type is a model of ConstrainedTetrahedralizer_3.
template <class Tetrahedralizer>
inline constexpr bool is_tetrahedralizer =
    std::is_invocable_r_v<Tetrahedralization_3, const Tetrahedralizer&,
                          const std::vector<Coordinates_3>&,
                          const std::vector<std::array<std::size_t, 3>>&>;

// Fills the box with tetrahedra. The points of the soup come first. The members `facets` and
// `triangles_of_facets` of the result are those of the soup, also if no triangle was divided.
// Throws `Tetrahedralization_error` if the tetrahedralizer moves points of the soup or returns an
// invalid index.
template <class Tetrahedralizer>
Tetrahedralization_3 fill_box(const Boxed_soup_3& boxed, const Tetrahedralizer& tetrahedralizer) {
  static_assert(
      is_tetrahedralizer<Tetrahedralizer>,
      "ConstrainedTetrahedralizer_3: Tetrahedralization_3 operator()(points, triangles) const");
  const Progress_phase phase("filling the box with tetrahedra");
  Triangle_soup_3 all = boxed.soup;
  append(all, box_surface(boxed.box, boxed.subdivision));
  Tetrahedralization_3 mesh = tetrahedralizer(all.points, all.triangles);
  if (mesh.points.size() < all.points.size() ||
      !std::equal(all.points.begin(), all.points.end(), mesh.points.begin()))
    throw Tetrahedralization_error(
        "the tetrahedralizer moved points of the surfaces: use another tetrahedralizer");
  for (const auto& t : mesh.tetrahedra)
    if (*std::max_element(t.begin(), t.end()) >= mesh.points.size())
      throw Tetrahedralization_error(
          "the tetrahedralizer refers to a point that does not exist: use another tetrahedralizer");
  Tetrahedralization_3 of_all;
  std::swap(of_all.facets, mesh.facets);
  std::swap(of_all.triangles_of_facets, mesh.triangles_of_facets);
  if (of_all.facets.empty()) {
    mesh.facets = boxed.soup.triangles;
    mesh.triangles_of_facets.resize(mesh.facets.size());
    std::iota(mesh.triangles_of_facets.begin(), mesh.triangles_of_facets.end(), std::size_t(0));
  }
  for (std::size_t i = 0; i < of_all.facets.size(); ++i)
    if (const std::size_t t = of_all.triangles_of_facets.at(i); t < boxed.soup.triangles.size()) {
      mesh.facets.push_back(of_all.facets[i]);
      mesh.triangles_of_facets.push_back(t);
    }
  return mesh;
}

// Returns the points of a mesh.
template <class Complex>
std::vector<typename Complex::Point_3> mesh_points(const Tetrahedralization_3& mesh) {
  std::vector<typename Complex::Point_3> result;
  for (const Coordinates_3& p : mesh.points)
    result.emplace_back(p[0], p[1], p[2]);
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

// Returns what the thin parts of a complex require of the triangles that contain facets of a mesh,
// so that about `most` triangles arise at most. The points of the mesh are `vertices`.
template <class Complex>
std::vector<Soup_bisector_3::Requirement>
requirements_of_thin_parts(const Complex& dsc, const Tetrahedralization_3& mesh,
                           const std::vector<typename Complex::Vertex_handle>& vertices,
                           double edge_per_thickness, std::size_t most) {
  const auto coarse = coarse_facets(dsc, edge_per_thickness, most).facets;
  if (coarse.empty())
    return {};
  const Vertex_numbers numbers(dsc, vertices);
  std::map<Triangle_indices, std::size_t> triangles;
  for (std::size_t i = 0; i < mesh.facets.size(); ++i)
    triangles.emplace(sorted(mesh.facets[i]), mesh.triangles_of_facets[i]);
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
  Tetrahedralization_3 mesh;
  std::size_t number_of_points = 0; // of the surfaces in the mesh
  const auto make = [&](std::vector<typename Complex::Vertex_handle>& vertices) {
    auto filled = fill_box(boxed, tetrahedralizer);
    Complex dsc;
    vertices = dsc.assign(mesh_points<Complex>(filled), filled.tetrahedra, label(filled, boxed));
    mesh = std::move(filled);
    number_of_points = boxed.soup.points.size();
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
    if (!bisector.run(requirements_of_thin_parts(dsc, mesh, vertices,
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
  remove_points_on_triangles(dsc, mesh, number_of_points, vertices);
  complete_in_frame(dsc, boxed.frame, options);
  return dsc;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_BOXED_SOUP_3_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_SOLID_TETRAHEDRA_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_SOLID_TETRAHEDRA_3_H

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/internal/building/Boxed_soup_3.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/sets/equal_points.h>
#include <CGAL/Triangle_soup_repair/internal/checks/check_surfaces_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Soup_regions_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Orients tetrahedra positively by swapping two vertices of the negative ones. Throws
// `Invalid_cells_error` if coordinates are not finite, if indices do not exist, or if tetrahedra
// are degenerate.
template <class Traits>
void orient_tetrahedra(const std::vector<typename Traits::Point_3>& points,
                       std::vector<std::array<std::size_t, 4>>& tetrahedra, const Traits& traits) {
  std::vector<std::size_t> offenders;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!has_finite_coordinates(coordinates(points[i])))
      offenders.push_back(i);
  if (!offenders.empty())
    throw Invalid_cells_error("coordinates are not finite: correct or remove these points", {},
                              std::move(offenders));

  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    if (*std::max_element(tetrahedra[t].begin(), tetrahedra[t].end()) >= points.size())
      offenders.push_back(t);
  if (!offenders.empty())
    throw Invalid_cells_error("tetrahedra have vertices that do not exist: correct these "
                              "indices",
                              std::move(offenders));

  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    std::array<std::size_t, 4>& v = tetrahedra[t];
    switch (traits.orientation_3_object()(points[v[0]], points[v[1]], points[v[2]], points[v[3]])) {
    case COPLANAR:
      offenders.push_back(t);
      break;
    case NEGATIVE:
      std::swap(v[2], v[3]);
      break;
    case POSITIVE:
      break;
    }
  }
  if (!offenders.empty())
    throw Invalid_cells_error("tetrahedra are flat: remesh near these tetrahedra",
                              std::move(offenders));
}

// Returns the facets that belong to exactly one cell.
inline std::vector<Cell_facet<3>>
boundary_facets(const std::vector<std::array<std::size_t, 4>>& cells) {
  std::vector<Cell_facet<3>> result;
  const auto facets = sorted_facets(cells);
  for (std::size_t i = 0; i < facets.size(); ++i)
    if ((i == 0 || facets[i - 1].vertices != facets[i].vertices) &&
        (i + 1 == facets.size() || facets[i + 1].vertices != facets[i].vertices))
      result.push_back(facets[i]);
  return result;
}

// Tetrahedra given by the user, and the tetrahedra of a mesh that surround them.
class Solid_tetrahedra_3
{
public:
  // Stores the tetrahedra, positively oriented, with equal points merged. Throws
  // `Invalid_cells_error` if there are no tetrahedra, if coordinates are not finite, if indices do
  // not exist, or if tetrahedra are degenerate.
  template <class Point, class Traits>
  Solid_tetrahedra_3(const std::vector<Point>& points,
                     std::vector<std::array<std::size_t, 4>> tetrahedra, const Traits& traits)
      : m_tetrahedra(std::move(tetrahedra)) {
    if (m_tetrahedra.empty())
      throw Invalid_cells_error("there are no tetrahedra: give at least one");
    orient_tetrahedra(points, m_tetrahedra, traits);
    m_points = all_coordinates(points);
    const std::vector<std::size_t> first = first_equal_points(m_points);
    for (auto& tetrahedron : m_tetrahedra)
      for (std::size_t& v : tetrahedron)
        v = first[v];
  }

  // Returns the triangles that belong to exactly one tetrahedron. Origins are indices of points.
  // Throws `Invalid_cells_error` if triangles cross, or if there are none.
  Joined_soup_3 boundary() const {
    Triangle_soup_3 soup = {m_points, {}};
    const auto facets = boundary_facets(m_tetrahedra);
    for (const auto& facet : facets)
      soup.triangles.push_back(facet.vertices);
    if (soup.triangles.empty()) // each facet has two tetrahedra, so they overlap
      throw Invalid_cells_error("tetrahedra overlap: remove duplicated tetrahedra", {0});
    Joined_soup_3 result = join({merge_points(soup)});
    std::vector<std::size_t> offenders;
    for (const auto& [s, t] : crossing_triangles(result)) {
      offenders.push_back(facets[s].cell);
      offenders.push_back(facets[t].cell);
    }
    if (!offenders.empty()) {
      std::sort(offenders.begin(), offenders.end());
      offenders.erase(std::unique(offenders.begin(), offenders.end()), offenders.end());
      throw Invalid_cells_error(
          "tetrahedra overlap, or share only parts of facets: remesh near these tetrahedra",
          std::move(offenders));
    }
    check_nesting(result, facets);
    return result;
  }

  // Returns the given tetrahedra, followed by the tetrahedra of the mesh that lie outside them, in
  // the frame of the mesh.
  // \pre `boxed` contains `boundary()`, and the mesh was made by `fill_box()`
  // Throws `Tetrahedralization_error` if triangles of `boundary()` are divided.
  Tetrahedralization_3 with_space_around(const Tetrahedralization_3& mesh,
                                         const Boxed_soup_3& boxed) const {
    if (mesh.facets.size() != boxed.soup.triangles.size())
      throw Tetrahedralization_error("the tetrahedralizer divided facets of the given tetrahedra: "
                                     "use Tetgen_tetrahedralizer_3");
    std::vector<std::size_t> on_boundary(m_points.size(), none);
    for (std::size_t i = 0; i < boxed.soup.points.size(); ++i)
      on_boundary[boxed.soup.point_origins[i].index] = i;

    std::vector<std::size_t> numbers(m_points.size(), none), mesh_numbers(mesh.points.size(), none);
    Tetrahedralization_3 result;
    const auto number = [&](std::size_t& known, const Coordinates_3& p) {
      if (known == none) {
        known = result.points.size();
        result.points.push_back(p);
      }
      return known;
    };
    for (const auto& given : m_tetrahedra) {
      auto& tetrahedron = result.tetrahedra.emplace_back();
      for (std::size_t k = 0; k < given.size(); ++k) {
        const std::size_t v = given[k], b = on_boundary[v];
        tetrahedron[k] = b == none ? number(numbers[v], boxed.frame(m_points[v]))
                                   : number(mesh_numbers[b], mesh.points[b]);
      }
    }
    const auto is_inside = label_cells<3>(mesh.tetrahedra, boxed.walls(mesh), {1});
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
      if (is_inside[t])
        continue;
      auto& tetrahedron = result.tetrahedra.emplace_back();
      for (std::size_t k = 0; k < tetrahedron.size(); ++k) {
        const std::size_t v = mesh.tetrahedra[t][k];
        tetrahedron[k] = number(mesh_numbers[v], mesh.points[v]);
      }
    }
    return result;
  }

private:
  // Throws `Invalid_cells_error` if a region of the boundary contains tetrahedra several times: if
  // a component is inside another one.
  // \param facets facet of a positively oriented tetrahedron for each triangle
  static void check_nesting(const Joined_soup_3& boundary,
                            const std::vector<Cell_facet<3>>& facets) {
    std::vector<int> steps; // of the number of components, from the front to the back of triangles
    for (const auto& facet : facets)
      steps.push_back(facet.is_even ? 1 : -1);
    const auto numbers = Soup_regions_3(boundary).winding_numbers(steps);
    if (numbers && *std::max_element(numbers->begin(), numbers->end()) > 1)
      throw Invalid_cells_error("tetrahedra overlap: some lie inside of others; remove them");
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<Coordinates_3> m_points;
  std::vector<std::array<std::size_t, 4>> m_tetrahedra; // positively oriented
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_SOLID_TETRAHEDRA_3_H

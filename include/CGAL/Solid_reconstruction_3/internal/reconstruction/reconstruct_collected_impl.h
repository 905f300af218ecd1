// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCT_COLLECTED_IMPL_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCT_COLLECTED_IMPL_H

#include <CGAL/Complex_construction/Octree_3.h>
#include <CGAL/Complex_construction/Octree_tetrahedra_3.h>
#include <CGAL/Interface_remeshing/manifold_interface.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Reconstructor_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The initial interface of a reconstruction, around the solid and all points. It consists of faces
// of an octree, whose leaves are small in narrow gaps.
class Cloud_shell_3
{
public:
  using Point = Sampled_surface_3::Point;

  explicit Cloud_shell_3(const Sampled_surface_3& surface) : m_surface(surface) {
    static constexpr double edges = 12;  // on the longest side; smooth parts need few facets
    static constexpr double least = 2.5; // in spacings; smaller facets have no points
    static constexpr double fewest = 4;  // edges on the longest side
    static constexpr double margin = 2;  // leaves between the points and the boundary of the domain
    static constexpr int most_halvings = 10; // of the edge, if spacings differ as much
    const double shortest = least * surface.cloud().spacing();
    Bbox_3 box;
    for (const Point& p : surface.cloud().points())
      box += p.bbox();
    const double side = (std::max)({box.x_span(), box.y_span(), box.z_span()});
    m_edge = (std::min)(side / fewest, (std::max)(side / edges, shortest));
    m_unit = (std::min)(m_edge, (std::max)(shortest, std::ldexp(m_edge, -most_halvings)));
    while (side_of(m_level) * rounding < m_edge)
      ++m_level;
    m_largest = side_of(m_level + 1) <= side / fewest ? m_level + 1 : m_level;
    m_last_level = m_largest + 1;
    while (side_of(m_last_level) < side + 2 * margin * side_of(m_level))
      ++m_last_level;
    for (int axis = 0; axis < 3; ++axis)
      m_low[axis] = box.min(axis) + (box.max(axis) - box.min(axis)) / 2 - side_of(m_last_level) / 2;
  }

  // Returns the length of the largest facets at the beginning.
  double edge() const { return m_edge; }

  // Returns the octree. Leaves at points have about the length of the edge, or of the gap there.
  // Other leaves are so small that leaves in the solid do not touch the boundary of the domain.
  Octree_3 octree() const {
    Octree_3 result(m_last_level);
    const auto& points = m_surface.cloud().points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      Progress_scope::check();
      unsigned level = m_level;
      while (level > 0 && side_of(level) > rounding * m_surface.room(i))
        --level;
      result.split(level + 1, block_of(points[i], level + 1));
    }
    const std::uint32_t end = 1u << (m_last_level - m_largest - 1);
    Octree_3::Place p;
    for (p[2] = 0; p[2] < end; ++p[2])
      for (p[1] = 0; p[1] < end; ++p[1])
        for (p[0] = 0; p[0] < end; ++p[0])
          result.split(m_largest + 1, p);
    result.complete();
    return result;
  }

  std::array<double, 3> coordinates(const Octree_3::Place& p) const {
    std::array<double, 3> result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = m_low[axis] + p[axis] * m_unit;
    return result;
  }

  // Returns the label of a cell of a leaf, given its barycenter: 1 in the solid and near points,
  // else 0.
  int label(const Point& p, unsigned level) const {
    static constexpr double thickness = .6; // in sides of leaves; the layer has few holes
    return m_surface.is_inside(p) || m_surface.cloud().distance(p) < thickness * side_of(level);
  }

private:
  static constexpr double rounding = 1.4142135623730951; // from one level to the middle of the next

  double side_of(unsigned level) const { return std::ldexp(m_unit, int(level)); }

  Octree_3::Place block_of(const Point& p, unsigned level) const {
    Octree_3::Place result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = std::uint32_t((p[axis] - m_low[axis]) / side_of(level));
    return result;
  }

  const Sampled_surface_3& m_surface;
  double m_edge = 0;
  double m_unit = 0;           // side of the smallest leaves
  unsigned m_level = 0;        // of the largest leaves at points
  unsigned m_largest = 0;      // of the largest leaves
  unsigned m_last_level = 0;   // of the root
  std::array<double, 3> m_low; // corner of the domain
};

// Returns a complex with this interface. Cells at non-manifold vertices are relabeled until there
// are no such vertices.
template <class Complex> Complex complex_of_shell(const Cloud_shell_3& shell) {
  Complex result;
  const Octree_3 octree = shell.octree();
  const Octree_tetrahedra_3 mesh(
      octree, [](unsigned level, const Octree_3::Place& /*block*/) { return int(level); });
  std::vector<std::array<double, 3>> coordinates;
  std::vector<typename Complex::Point> points;
  coordinates.reserve(mesh.points.size());
  points.reserve(mesh.points.size());
  for (const auto& place : mesh.points) {
    const std::array<double, 3> p = shell.coordinates(place);
    coordinates.push_back(p);
    points.emplace_back(p[0], p[1], p[2]);
  }
  std::vector<int> labels;
  labels.reserve(mesh.tetrahedra.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Progress_scope::check();
    std::array<double, 3> sum = {0, 0, 0};
    for (const std::size_t v : mesh.tetrahedra[t])
      for (int axis = 0; axis < 3; ++axis)
        sum[axis] += coordinates[v][axis] / 4;
    labels.push_back(
        shell.label(Cloud_shell_3::Point(sum[0], sum[1], sum[2]), unsigned(mesh.labels[t])));
  }
  result.assign(points, mesh.tetrahedra, labels);
  for (auto pinched = non_manifold_vertices(result); !pinched.empty();
       pinched = non_manifold_vertices(result))
    for (auto v : pinched) {
      Progress_scope::check();
      if (is_manifold_at(result, v))
        continue;
      std::vector<typename Complex::Cell_handle> star, cells;
      result.star(v, star);
      const auto out =
          std::find_if(star.begin(), star.end(), [&](auto c) { return c->subdomain_index() == 0; });
      if (!propose_manifold_relabeling(result, *out, 1, cells))
        cells = star;
      for (auto c : cells)
        result.relabel(c, 1);
    }
  result.measure_interface_edges();
  result.take_component_events();
  return result;
}

template <class Complex>
Complex reconstruct_collected(const Collected_points& points,
                              const Reconstruction_options_3<Complex>& options) {
  const Sampled_surface_3 surface(points.points, points.normals, options.number_of_threads);
  const Cloud_shell_3 shell(surface);
  Complex complex = complex_of_shell<Complex>(shell);
  Reconstructor_3<Complex> reconstructor(complex, surface, shell.edge(), options.fit_tolerance,
                                         options.number_of_threads);
  const auto report = reconstructor.run(options.number_of_iterations, options.observer);
  if (options.report)
    *options.report = report;
  return complex;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCT_COLLECTED_IMPL_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_CLOUD_SHELL_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_CLOUD_SHELL_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/building/box_grid_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Own_operations_3.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/control_detail.h>
#include <CGAL/Deformable_simplicial_complexes/fill_grid.h>
#include <CGAL/Deformable_simplicial_complexes/manifold_interface.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Where an interface begins that is to find a surface: around its solid and all points.
class Cloud_shell_3
{
public:
  using Point = Sampled_surface_3::Point;

  explicit Cloud_shell_3(const Sampled_surface_3& surface) : m_surface(surface) {
    static constexpr double edges = 12;  // on the longest side: few, as large parts need few facets
    static constexpr double least = 2.5; // spacings: shorter edges would have no points
    static constexpr double fewest = 4;  // edges on the longest side
    static constexpr double margin = 2;  // edges between the solid and the border of the domain
    for (const Point& p : surface.cloud().points())
      m_bbox += p.bbox();
    const double side = (std::max)({m_bbox.x_span(), m_bbox.y_span(), m_bbox.z_span()});
    m_edge = (std::min)(side / fewest, (std::max)(side / edges, least * surface.cloud().spacing()));
    const auto grown = [&](double low, double high) {
      return (std::ceil((high - low) / m_edge + 2 * margin) * m_edge - (high - low)) / 2;
    };
    const double x = grown(m_bbox.xmin(), m_bbox.xmax()), y = grown(m_bbox.ymin(), m_bbox.ymax()),
                 z = grown(m_bbox.zmin(), m_bbox.zmax());
    m_bbox = Bbox_3(m_bbox.xmin() - x, m_bbox.ymin() - y, m_bbox.zmin() - z, m_bbox.xmax() + x,
                    m_bbox.ymax() + y, m_bbox.zmax() + z);
    choose_sizes();
  }

  const Bbox_3& bbox() const { return m_bbox; } // of the domain
  double edge() const { return m_edge; }        // of the cells to begin with

  // How long edges are to be: short in narrow gaps.
  template <class P> double size(const P& q) const {
    static constexpr double grading = .7; // of the distance from points
    const Point p(q.x(), q.y(), q.z());
    const std::size_t i = m_surface.cloud().nearest(p);
    const double distance = std::sqrt((m_surface.cloud().points()[i] - p).squared_length());
    return (std::max)(m_sizes[i], grading * distance);
  }

  // 1 in the solid and near points, 0 elsewhere.
  template <class P> int label(const P& q) const {
    static constexpr double thickness =
        .6;                            // edges: cells with points are within, by their barycenter
    static constexpr double part = .5; // of the room
    const Point p(q.x(), q.y(), q.z());
    if (m_surface.is_inside(p))
      return 1;
    const std::size_t i = m_surface.cloud().nearest(p);
    const double reach = (std::min)(thickness * m_edge, part * m_surface.room(i));
    return (m_surface.cloud().points()[i] - p).squared_length() < reach * reach ? 1 : 0;
  }

private:
  // Rooms jump from point to point where a cloud is open or noisy. Sizes that jump would make edges
  // be split across long cells, which become flat: most of a mesh, in the end.
  void choose_sizes() {
    static constexpr double least = 2;   // spacings
    static constexpr double growth = .7; // of the distance between points
    static constexpr unsigned around = 8;
    const Point_cloud_3& cloud = m_surface.cloud();
    using Item = std::pair<double, std::size_t>; // a size and its point
    std::priority_queue<Item, std::vector<Item>, std::greater<Item>> smallest;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      m_sizes.push_back((std::max)(least * cloud.spacing(), (std::min)(m_edge, m_surface.room(i))));
      if (m_sizes[i] < m_edge)
        smallest.emplace(m_sizes[i], i);
    }
    while (!smallest.empty()) {
      Progress_scope::check();
      const auto [size, i] = smallest.top();
      smallest.pop();
      if (size > m_sizes[i])
        continue;
      const Point& p = cloud.points()[i];
      for (std::size_t k : cloud.nearest(p, around)) {
        const double bound = size + growth * std::sqrt((cloud.points()[k] - p).squared_length());
        if (bound < m_sizes[k]) {
          m_sizes[k] = bound;
          smallest.emplace(bound, k);
        }
      }
    }
  }

  const Sampled_surface_3& m_surface;
  Bbox_3 m_bbox;
  double m_edge = 0;
  std::vector<double> m_sizes; // of edges at the points
};

// A complex with that interface, and without pinches.
template <class Complex> Complex complex_of_shell(const Cloud_shell_3& shell) {
  static constexpr double longest = 1.7; // of what is asked for; of a grid, 1.15
  static constexpr unsigned rounds = 60; // three for each halving; most need none
  Complex result = fill_grid(
      Complex(), box_grid(shell.bbox(), shell.edge()), [](const auto&) { return 0; },
      parameters::default_values());
  control_detail(result, parameters::size_field([&](const auto& p) { return shell.size(p); })
                             .split_length(longest)
                             .collapse_length(0.)
                             .number_of_iterations(rounds));
  for (auto c : result.cells()) {
    Progress_scope::check();
    result.relabel(c, shell.label(barycenter(result, c)));
  }
  for (auto pinched = non_manifold_vertices(result); !pinched.empty();
       pinched = non_manifold_vertices(result))
    for (auto v : pinched) {
      Progress_scope::check();
      if (is_manifold_at(result, v))
        continue;
      std::vector<typename Complex::Cell_handle> star, cells;
      result.star(v, star);
      const auto out =
          std::find_if(star.begin(), star.end(), [&](auto c) { return c->label() == 0; });
      if (!propose_manifold_relabeling(result, *out, 1, cells))
        cells = star;
      for (auto c : cells)
        result.relabel(c, 1);
    }
  result.measure_interface_edges();
  result.take_component_events();
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_CLOUD_SHELL_3_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CURVATURE_SIZE_FIELD_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CURVATURE_SIZE_FIELD_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_bends.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/vertices_on_junctions.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Lengths of edges by the curvature of an interface, as it is when the field is made: an edge of
length h lies up to about \f$\kappa h^2 / 8\f$ below a surface that bends with the curvature
\f$\kappa\f$ along it, and that is to be a given tolerance. Between vertices, the length of the
nearest one holds. For `improve_interface()` and `control_detail()`.

\tparam d the dimension
*/
template <int d> class Curvature_size_field
{
public:
  /// A point in the coordinates of the complex.
  using Point = std::conditional_t<d == 2, Simple_cartesian<double>::Point_2,
                                   Simple_cartesian<double>::Point_3>;

  /*!
  Estimates the curvatures from the normals of the vertices, but for those on sharp edges and on
  lines where more than two labels meet, which have none.

  \param dsc the complex.
  \param tolerance distance between edges and surface, positive.
  \param shortest, longest bounds on the lengths, positive. Far from the interface, too.
  \param gradation by how much lengths may differ from vertex to vertex along an edge of the
         interface, by the length of that edge, positive.
  \param feature_angle edges are sharp where the normals of their facets differ by more, in degrees,
         in [0, 180]; with 180, none is.
  \throws Deformable_simplicial_complexes::Error if a parameter is out of its range, or `shortest`
          is more than `longest`.

  n log n in the size of the interface.
  */
  template <class Complex>
  Curvature_size_field(const Complex& dsc, double tolerance, double shortest, double longest,
                       double gradation = .5, double feature_angle = 180) {
    if (!(tolerance > 0 && shortest > 0 && shortest <= longest && gradation > 0))
      throw Deformable_simplicial_complexes::Error(
          "a size field by curvature needs a tolerance, a gradation and lengths that are positive, "
          "the shortest one up to the longest one");
    if (!(feature_angle >= 0 && feature_angle <= 180))
      throw Deformable_simplicial_complexes::Error(
          "the angle of features is out of range: use 0 to 180 degrees");
    const Deformable_simplicial_complexes::Interface_snapshot<Complex> interface_(dsc);
    const auto positions = interface_.positions(dsc);
    std::vector<double> lengths =
        lengths_by_curvature(interface_, positions, tolerance, shortest, longest, feature_angle);
    grade(interface_, positions, gradation, lengths);
    std::vector<Sized_point> points;
    for (std::size_t i = 0; i < positions.size(); ++i)
      points.emplace_back(positions[i], lengths[i]);
    m_longest = longest;
    m_periods = interface_.domain.template periods<d>();
    m_tree = std::make_shared<Tree>(points.begin(), points.end());
    if (!points.empty())
      m_tree->build();
  }

  /// The wanted length of an edge at p: that of the nearest vertex, or the shorter one of the
  /// nearest two if they are equally near, as the ends of the edge are. Logarithmic in the size of
  /// the interface.
  double operator()(const Point& p) const {
    static constexpr double same = 1 + 1e-6; // ratio of squared distances that rounding may change
    double result = m_longest, nearest = std::numeric_limits<double>::infinity();
    for (const Point& image : images(p)) {
      if (m_tree->empty())
        break;
      const Search search(*m_tree, image, 2);
      for (auto found = search.begin(); found != search.end(); ++found) {
        const auto& [point, squared_distance] = *found;
        if (squared_distance * same < nearest)
          result = point.second;
        else if (squared_distance <= same * nearest)
          result = (std::min)(result, point.second);
        nearest = (std::min)(nearest, double(squared_distance));
      }
    }
    return result;
  }

private:
  using Sized_point = std::pair<Point, double>;
  using Point_traits = std::conditional_t<d == 2, Search_traits_2<Simple_cartesian<double>>,
                                          Search_traits_3<Simple_cartesian<double>>>;
  using Tree_traits =
      Search_traits_adapter<Sized_point, First_of_pair_property_map<Sized_point>, Point_traits>;
  using Search = Orthogonal_k_neighbor_search<Tree_traits>;
  using Tree = typename Search::Tree;

  // On a torus, the image of a point in the box and those that may be nearer to a point of the box.
  std::vector<Point> images(const Point& p) const {
    namespace internal = Deformable_simplicial_complexes::internal;
    auto inside = internal::coordinates_of<d>(p);
    for (int i = 0; i < d; ++i)
      if (m_periods[i] > 0)
        inside[i] -= m_periods[i] * std::floor(inside[i] / m_periods[i]);
    std::vector<Point> result = {internal::point_of<Point>(inside)};
    for (int i = 0; i < d; ++i)
      if (m_periods[i] > 0)
        for (std::size_t k = result.size(); k-- > 0;) {
          auto image = internal::coordinates_of<d>(result[k]);
          image[i] += image[i] < m_periods[i] / 2 ? m_periods[i] : -m_periods[i];
          result.push_back(internal::point_of<Point>(image));
        }
    return result;
  }

  template <class Complex>
  using Snapshot = Deformable_simplicial_complexes::Interface_snapshot<Complex>;

  template <class Complex, class Points>
  static std::vector<double>
  lengths_by_curvature(const Snapshot<Complex>& interface_, const Points& positions,
                       double tolerance, double shortest, double longest, double feature_angle) {
    namespace internal = Deformable_simplicial_complexes::internal;
    using Bends = internal::Interface_bends<Complex>;
    const auto normals = Bends::normals(interface_, positions);
    const std::vector<char> is_on_junction = internal::vertices_on_junctions(interface_);
    const std::vector<char> is_on_feature =
        Bends::on_features(interface_, positions, feature_angle * (CGAL_PI / 180));
    const auto has_normal = [&](std::size_t v) { return !is_on_junction[v] && !is_on_feature[v]; };
    std::vector<double> lengths(positions.size(), longest);
    for_each_edge(interface_, [&](std::size_t a, std::size_t b) {
      if (!has_normal(a) || !has_normal(b))
        return;
      const auto edge = interface_.domain.near(positions[a], positions[b]) - positions[a];
      const double bend = std::abs((normals[b] - normals[a]) * edge); // curvature * squared length
      if (!(bend > 0))
        return;
      const double length =
          (std::max)(shortest, std::sqrt(8 * tolerance * edge.squared_length() / bend));
      lengths[a] = (std::min)(lengths[a], length);
      lengths[b] = (std::min)(lengths[b], length);
    });
    return lengths;
  }

  // Short lengths spread until none is longer than its neighbors allow: the shortest first, as in
  // Dijkstra's algorithm.
  template <class Interface, class Points>
  static void grade(const Interface& interface_, const Points& positions, double gradation,
                    std::vector<double>& lengths) {
    using Edge = std::pair<std::size_t, std::size_t>; // from a vertex to a neighbor
    std::vector<Edge> edges;
    for_each_edge(interface_, [&](std::size_t a, std::size_t b) {
      edges.emplace_back(a, b);
      edges.emplace_back(b, a);
    });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

    using Entry = std::pair<double, std::size_t>; // the length of a vertex
    std::vector<Entry> entries;
    for (std::size_t v = 0; v < lengths.size(); ++v)
      entries.emplace_back(lengths[v], v);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue(std::greater<>(),
                                                                         std::move(entries));
    while (!queue.empty()) {
      const auto [length, a] = queue.top();
      queue.pop();
      if (length > lengths[a])
        continue; // it has become shorter since
      for (auto e = std::lower_bound(edges.begin(), edges.end(), Edge(a, 0));
           e != edges.end() && e->first == a; ++e) {
        const std::size_t b = e->second;
        const double bound =
            length + gradation * std::sqrt((interface_.domain.near(positions[a], positions[b]) -
                                            positions[a])
                                               .squared_length());
        if (lengths[b] > bound) {
          lengths[b] = bound;
          queue.emplace(bound, b);
        }
      }
    }
  }

  template <class Interface, class Function>
  static void for_each_edge(const Interface& interface_, const Function& function) {
    for (const auto& facet : interface_.facets())
      for (int i = 0; i < d; ++i)
        if (d > 2 || i == 0)
          function(facet.vertices[i], facet.vertices[(i + 1) % d]);
  }

  std::shared_ptr<Tree> m_tree; // shared by copies, and never changed
  double m_longest = 0;
  std::array<double, d> m_periods = {}; // of a torus
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CURVATURE_SIZE_FIELD_H

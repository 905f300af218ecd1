// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_CURVATURE_SIZING_FIELD_H
#define CGAL_INTERFACE_REMESHING_CURVATURE_SIZING_FIELD_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_remeshing/internal/interface/Curvature_lengths.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <memory>

namespace CGAL::Deformable_simplicial_complexes {
/*!
\ingroup PkgInterfaceRemeshingRef

Sizing field for `improve_interface()` and `control_detail()` that follows the curvature of an
interface. The curvature is that of the interface at construction. An edge of length h lies up to
about \f$\kappa h^2 / 8\f$ below a surface with the curvature \f$\kappa\f$ along the edge. The
target edge length is the h for which this distance is a given tolerance. A point gets the target
edge length of the nearest vertex.

\tparam d the dimension
*/
template <int d> class Curvature_sizing_field
{
public:
  /// Point in the coordinates of the complex.
  using Point = std::conditional_t<d == 2, Epick::Point_2, Epick::Point_3>;

  /*!
  Estimates the curvatures from the normals of the vertices. Vertices on sharp edges and on lines
  where more than two labels meet have no normal, and no curvature is estimated there.

  \param dsc the complex
  \param tolerance distance between edges and surface, positive
  \param shortest, longest bounds on the target edge lengths, positive; they also hold far from the
         interface
  \param gradation largest difference of target edge lengths of the two ends of an interface edge,
         divided by the length of that edge; positive
  \param feature_angle an edge is sharp if the normals of its facets differ by a larger angle, in
         degrees, in [0, 180]; with 180, no edge is sharp
  \throws Error if a parameter is out of its range, or if `shortest` is larger than `longest`

  n log n in the size of the interface.
  */
  template <class Complex>
  Curvature_sizing_field(const Complex& dsc, double tolerance, double shortest, double longest,
                         double gradation = .5, double feature_angle = 180) {
    if (!(tolerance > 0 && shortest > 0 && shortest <= longest && gradation > 0))
      throw Error("a parameter of the curvature sizing field is out of range: use a positive "
                  "tolerance, a positive gradation, and positive lengths, of which the shortest "
                  "does not exceed the longest");
    if (!(feature_angle >= 0 && feature_angle <= 180))
      throw Error("the feature angle is out of range: use 0 to 180 degrees");
    const Interface_snapshot<Complex> interface_(dsc);
    const auto positions = interface_.positions(dsc);
    const internal::Curvature_lengths<Complex> lengths(
        interface_, positions,
        internal::Smooth_normals<Complex>(interface_, positions, feature_angle), tolerance,
        shortest);
    *this = Curvature_sizing_field(positions, lengths.graded(longest, gradation), longest,
                                   interface_.domain.template periods<d>());
  }

  /// Constructs the field from known target edge lengths. n log n in the number of points.
  /// \param points the points
  /// \param lengths a target edge length for each point, positive
  /// \param longest the target edge length everywhere if there are no points
  /// \param periods of a torus; 0 in a ball
  /// \pre `lengths.size() == points.size()`; points on a torus lie in the box of its periods
  Curvature_sizing_field(const std::vector<Point>& points, const std::vector<double>& lengths,
                         double longest, const std::array<double, d>& periods = {})
      : m_longest(longest), m_periods(periods) {
    std::vector<Sized_point> sized;
    for (std::size_t i = 0; i < points.size(); ++i)
      sized.emplace_back(points[i], lengths[i]);
    m_tree = std::make_shared<Tree>(sized.begin(), sized.end());
    if (!sized.empty())
      m_tree->build();
  }

  /// Returns the target edge length at p, which is that of the nearest vertex. If two vertices are
  /// equally near, such as the ends of an edge at its midpoint, it is the shorter one. Logarithmic
  /// in the size of the interface.
  double operator()(const Point& p) const {
    static constexpr double same = 1 + 1e-6; // ratio of squared distances within rounding
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
  using Point_traits = std::conditional_t<d == 2, Search_traits_2<Epick>, Search_traits_3<Epick>>;
  using Tree_traits =
      Search_traits_adapter<Sized_point, First_of_pair_property_map<Sized_point>, Point_traits>;
  using Search = Orthogonal_k_neighbor_search<Tree_traits>;
  using Tree = typename Search::Tree;

  // Returns the points to search from. On a torus, these are the image of p in the box and the
  // images that may be nearer to a point of the box.
  std::vector<Point> images(const Point& p) const {
    auto inside = coordinates_of<d>(p);
    for (int i = 0; i < d; ++i)
      if (m_periods[i] > 0)
        inside[i] -= m_periods[i] * std::floor(inside[i] / m_periods[i]);
    std::vector<Point> result = {point_of<Point>(inside)};
    for (int i = 0; i < d; ++i)
      if (m_periods[i] > 0)
        for (std::size_t k = result.size(); k-- > 0;) {
          auto image = coordinates_of<d>(result[k]);
          image[i] += image[i] < m_periods[i] / 2 ? m_periods[i] : -m_periods[i];
          result.push_back(point_of<Point>(image));
        }
    return result;
  }

  std::shared_ptr<Tree> m_tree; // shared by copies, never changed
  double m_longest = 0;
  std::array<double, d> m_periods = {}; // of a torus; 0 in a ball
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_CURVATURE_SIZING_FIELD_H

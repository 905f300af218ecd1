// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_POINT_CLOUD_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_POINT_CLOUD_3_H

#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Euclidean_distance.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <cmath>
#include <memory>
#include <numeric>
#include <tuple>

namespace CGAL::Deformable_simplicial_complexes::internal {

using Cloud_kernel = Epick;

// The plane that fits points by least squares: their barycenter, the normal, and the root mean
// square of their distances.
struct Fitted_plane_3
{
  Cloud_kernel::Point_3 center;
  Cloud_kernel::Vector_3 normal; // of unit length
  double residual;
  double width, length; // standard deviations of the points along the axes of the plane

  double height(const Cloud_kernel::Point_3& p) const { return normal * (p - center); }
};

template <class Points> Fitted_plane_3 fit_plane(const Points& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points)
    mean += Eigen::Vector3d(p.x(), p.y(), p.z());
  mean /= double(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d d = Eigen::Vector3d(p.x(), p.y(), p.z()) - mean;
    covariance += d * d.transpose();
  }
  covariance /= double(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d n = solver.eigenvectors().col(0);
  return {{mean[0], mean[1], mean[2]},
          {n[0], n[1], n[2]},
          std::sqrt((std::max)(0., solver.eigenvalues()[0])),
          std::sqrt((std::max)(0., solver.eigenvalues()[1])),
          std::sqrt((std::max)(0., solver.eigenvalues()[2]))};
}

// The graph of a quadratic function over a plane that fits points by least squares.
struct Fitted_quadric_3
{
  double residual;  // root mean square of distances, corrected for the number of unknowns
  double curvature; // largest absolute principal curvature, in the middle
  Cloud_kernel::Vector_3 normal; // at the first point, of unit length
  Cloud_kernel::Point_3 foot;    // of the first point, along the normal of the plane
};

template <class Points>
Fitted_quadric_3 fit_quadric(const Points& points, const Fitted_plane_3& plane) {
  static constexpr Eigen::Index unknowns = 6;
  const auto n = Eigen::Index(points.size());
  if (n <= unknowns)
    return {plane.residual, 0, plane.normal, points[0] - plane.height(points[0]) * plane.normal};
  const Cloud_kernel::Vector_3 axis = plane.normal.x() * plane.normal.x() < .5
                                          ? Cloud_kernel::Vector_3(1, 0, 0)
                                          : Cloud_kernel::Vector_3(0, 1, 0);
  auto u = cross_product(plane.normal, axis);
  u = u / std::sqrt(u.squared_length());
  const auto v = cross_product(plane.normal, u);
  double extent = 0;
  for (const auto& p : points)
    extent = (std::max)(extent, std::sqrt((p - plane.center).squared_length()));
  Eigen::Matrix<double, Eigen::Dynamic, unknowns> terms(n, unknowns);
  Eigen::VectorXd heights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto d = (points[std::size_t(i)] - plane.center) / extent;
    const double x = d * u, y = d * v;
    terms.row(i) << 1, x, y, x * x, x * y, y * y;
    heights[i] = d * plane.normal;
  }
  const Eigen::VectorXd q = terms.colPivHouseholderQr().solve(heights);
  const double x = terms(0, 1), y = terms(0, 2);
  const auto normal =
      plane.normal - (q[1] + 2 * q[3] * x + q[4] * y) * u - (q[2] + q[4] * x + 2 * q[5] * y) * v;
  return {extent * (heights - terms * q).norm() / std::sqrt(double(n - unknowns)),
          (std::abs(q[3] + q[5]) + std::hypot(q[3] - q[5], q[4])) / extent,
          normal / std::sqrt(normal.squared_length()),
          points[0] - extent * (heights[0] - terms.row(0) * q) * plane.normal};
}

// The reach of a point, in distances to its sixth neighbor. Facets within this distance touch the
// point.
inline constexpr double reach_of_points = 2;

// Keeps the elements whose marks are not 0, in their order.
template <class T> void keep_marked(std::vector<T>& elements, const std::vector<char>& marks) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (marks[i] != 0)
      elements[number++] = elements[i];
  elements.erase(elements.begin() + std::ptrdiff_t(number), elements.end());
}

// A splitter of a kd-tree that splits nodes as CGAL does by default and can be interrupted.
template <class Traits> struct Stoppable_splitter : Sliding_midpoint<Traits>
{
  using Base = Sliding_midpoint<Traits>;

  void operator()(typename Base::Separator& separator, typename Base::Container& low,
                  typename Base::Container& high) const {
    Progress_scope::check();
    Base::operator()(separator, low, high);
  }
};

// Points in lexicographic order, with search for nearest neighbors. Of equal points, only the first
// is kept.
class Point_cloud_3
{
public:
  using Point = Cloud_kernel::Point_3;
  using Vector = Cloud_kernel::Vector_3;
  static constexpr unsigned ring = 6; // number of neighbors around a point of a surface

  // Sorts the points. Of equal points, the point with the greatest vector is kept, if there are
  // vectors; the null vector is the smallest. Throws Invalid_points_error if coordinates are not
  // finite, the extent is too large or too small, or there are too few points.
  Point_cloud_3(const std::vector<Point>& points, const std::vector<Vector>& vectors,
                unsigned number_of_threads)
      : m_for_each(number_of_threads) {
    require_finite(points);
    m_indices.resize(points.size());
    std::iota(m_indices.begin(), m_indices.end(), std::size_t(0));
    std::stable_sort(m_indices.begin(), m_indices.end(), [&](std::size_t i, std::size_t j) {
      return points[i] == points[j] ? !vectors.empty() && less(vectors[j], vectors[i])
                                    : points[i] < points[j];
    });
    m_indices.erase(
        std::unique(m_indices.begin(), m_indices.end(),
                    [&](std::size_t i, std::size_t j) { return points[i] == points[j]; }),
        m_indices.end());
    m_duplicates = points.size() - m_indices.size();
    for (std::size_t i : m_indices)
      m_points.push_back(points[i]);
    require_extent();
    plant();
    measure();
    drop_isolated();
  }

  Point_cloud_3(const Point_cloud_3&) = delete; // the tree refers to the points
  Point_cloud_3& operator=(const Point_cloud_3&) = delete;

  const std::vector<Point>& points() const { return m_points; }
  std::size_t size() const { return m_points.size(); }
  // Returns the index of a point in the input.
  std::size_t index(std::size_t i) const { return m_indices[i]; }
  std::size_t number_of_duplicates() const { return m_duplicates; }
  // Returns the number of outliers, which are not used.
  std::size_t number_of_outliers() const { return m_outliers; }

  // Returns the function that loops over many points or facets, with threads.
  const For_each_index& for_each() const { return m_for_each; }

  // Removes the points that are not marked. Throws Invalid_points_error if too few remain.
  void keep(const std::vector<char>& is_kept) {
    const auto number = std::size_t(std::count(is_kept.begin(), is_kept.end(), 1));
    if (number == size())
      return;
    m_outliers += size() - number;
    keep_marked(m_points, is_kept);
    keep_marked(m_indices, is_kept);
    keep_marked(m_reaches, is_kept);
    require_extent();
    plant();
    m_spacing = mean_distance();
  }

  // Throws Invalid_points_error if the points lie in a plane.
  void require_volume() const {
    static constexpr double thinnest = 1e-9; // of the extent
    const Fitted_plane_3 plane = fit_plane(m_points);
    double thickness = 0, extent = 0;
    for (const Point& p : m_points) {
      thickness = (std::max)(thickness, std::abs(plane.height(p)));
      extent = (std::max)(extent, std::sqrt((p - plane.center).squared_length()));
    }
    if (!(thickness > thinnest * extent))
      throw Invalid_points_error(Reason::flat, "all points lie in a plane: they bound no solid");
  }

  // Returns the mean distance of points from their six nearest neighbors.
  double spacing() const { return m_spacing; }
  // Returns the distance of a point to its sixth neighbor.
  double reach(std::size_t i) const { return m_reaches[i]; }
  const std::vector<double>& reaches() const { return m_reaches; }

  // Returns the nearest points, sorted by distance.
  std::vector<std::size_t> nearest(const Point& p, unsigned number) const {
    const Search search(*m_tree, p, number, 0, true, Distance(map()));
    std::vector<std::size_t> result;
    for (const auto& item : search)
      result.push_back(item.first);
    return result;
  }
  std::size_t nearest(const Point& p) const {
    return Search(*m_tree, p, 1, 0, true, Distance(map())).begin()->first;
  }
  double distance(const Point& p) const {
    return std::sqrt((m_points[nearest(p)] - p).squared_length());
  }

private:
  using Map = Pointer_property_map<Point>::const_type;
  using Traits = Search_traits_adapter<std::size_t, Map, Search_traits_3<Cloud_kernel>>;
  using Search = Orthogonal_k_neighbor_search<
      Traits, Distance_adapter<std::size_t, Map, Euclidean_distance<Search_traits_3<Cloud_kernel>>>,
      Stoppable_splitter<Traits>>;
  using Tree = Search::Tree;
  using Distance = Search::Distance;
  using Reason = Invalid_points_error::Reason;
  static bool less(const Vector& a, const Vector& b) {
    return std::make_tuple(a != NULL_VECTOR, a.x(), a.y(), a.z()) <
           std::make_tuple(b != NULL_VECTOR, b.x(), b.y(), b.z());
  }

  Map map() const { return make_property_map(m_points); }

  static void require_finite(const std::vector<Point>& points) {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::isfinite(points[i].x()) || !std::isfinite(points[i].y()) ||
          !std::isfinite(points[i].z()))
        wrong.push_back(i);
    if (!wrong.empty())
      throw Invalid_points_error(Reason::not_finite,
                                 "the coordinates of point " + std::to_string(wrong.front()) +
                                     " are not finite: remove the point",
                                 wrong);
  }

  void require_extent() const {
    static constexpr std::size_t least = 4;
    if (m_points.size() < least)
      throw Invalid_points_error(
          Reason::too_few,
          m_outliers == 0 ? "there are fewer than four different points: they bound no solid"
                          : "fewer than four points are near other points: they bound no solid");
    static constexpr double smallest = 1e-30, largest = 1e30; // extents that complexes support
    Bbox_3 box;
    for (const Point& p : m_points)
      box += p.bbox();
    const double side = (std::max)({box.x_span(), box.y_span(), box.z_span()});
    if (!(side >= smallest && side <= largest))
      throw Invalid_points_error(
          Reason::out_of_range,
          "the extent of the points is not between 1e-30 and 1e30: scale them");
  }

  // Builds the tree of the points.
  void plant() {
    std::vector<std::size_t> all(size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    m_tree = std::make_unique<Tree>(all.begin(), all.end(), Tree::Splitter(), Traits(map()));
    m_tree->build();
  }

  void measure() {
    m_reaches.resize(size());
    m_for_each(size(), [&](std::size_t i) {
      Progress_scope::check();
      const Point& p = m_points[i];
      m_reaches[i] = std::sqrt((m_points[nearest(p, ring + 1).back()] - p).squared_length());
    });
    m_spacing = mean_distance();
  }

  // Returns the mean distance of points from their nearest neighbors.
  double mean_distance() const {
    std::vector<double> sums(size(), 0);
    m_for_each(size(), [&](std::size_t i) {
      Progress_scope::check();
      for (std::size_t k : nearest(m_points[i], ring + 1)) // including the point itself
        sums[i] += std::sqrt((m_points[k] - m_points[i]).squared_length());
    });
    const double number = double((std::min)(std::size_t(ring), size() - 1));
    return std::accumulate(sums.begin(), sums.end(), 0.) / (number * double(size()));
  }

  // Removes isolated points. A point is isolated if the distance to its sixth neighbor is large
  // compared with the median of this distance around it. The reach of a point is bounded by this
  // median.
  void drop_isolated() {
    static constexpr double distant = 3;   // in medians of the reaches around
    static constexpr unsigned around = 32; // more than the number of outliers in a cluster
    std::vector<char> is_kept(size());
    std::vector<double> medians(size());
    m_for_each(size(), [&](std::size_t i) {
      Progress_scope::check();
      std::vector<double> reaches;
      for (std::size_t k : nearest(m_points[i], around))
        reaches.push_back(m_reaches[k]);
      const auto middle = reaches.begin() + std::ptrdiff_t(reaches.size() / 2);
      std::nth_element(reaches.begin(), middle, reaches.end());
      is_kept[i] = m_reaches[i] <= distant * *middle;
      medians[i] = *middle;
    });
    for (std::size_t i = 0; i < size(); ++i)
      m_reaches[i] = (std::min)(m_reaches[i], medians[i]);
    keep(is_kept);
  }

  For_each_index m_for_each;
  std::vector<Point> m_points;
  std::vector<std::size_t> m_indices; // in the input
  std::size_t m_duplicates = 0, m_outliers = 0;
  std::unique_ptr<Tree> m_tree;
  std::vector<double> m_reaches;
  double m_spacing = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_POINT_CLOUD_3_H

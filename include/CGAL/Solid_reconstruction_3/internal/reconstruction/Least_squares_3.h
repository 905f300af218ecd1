// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_LEAST_SQUARES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_LEAST_SQUARES_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_facets_3.h>

#include <Eigen/Sparse>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The diagonal preconditioner of Eigen, with iterations that can be interrupted.
class Stoppable_preconditioner : public Eigen::DiagonalPreconditioner<double>
{
public:
  template <class Right> auto solve(const Eigen::MatrixBase<Right>& right) const {
    Progress_scope::check();
    return Eigen::DiagonalPreconditioner<double>::solve(right);
  }
};

// The displacements of the vertices of an interface that minimize the distances of all points of a
// cloud from their facets, by least squares. Vertices with few points move towards the mean of
// their neighbors.
template <class Facets> class Least_squares_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  Least_squares_3(const Sampled_surface_3& surface, const Facets& facets,
                  const std::vector<Point>& positions, const Cloud_triangles_3& triangles)
      : m_facets(facets), m_right(Eigen::VectorXd::Zero(3 * Eigen::Index(positions.size()))),
        m_weights(positions.size(), 0), m_neighbors(positions.size()),
        m_to_middle(positions.size(), NULL_VECTOR) {
    add_points(surface, triangles);
    find_loose(surface, positions);
    add_smoothness();
    for (Eigen::Index i = 0; i < m_right.size(); ++i)
      m_entries.emplace_back(i, i, stiffness);
  }

  std::vector<Vector> displacements() const {
    static constexpr double tolerance = 1e-4; // relative residual; the next step reduces it further
    Eigen::SparseMatrix<double> matrix(m_right.size(), m_right.size());
    matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                             Stoppable_preconditioner>
        solver(matrix);
    solver.setTolerance(tolerance);
    const Eigen::VectorXd solution = solver.solve(m_right);
    std::vector<Vector> result;
    for (Eigen::Index i = 0; i < solution.size(); i += 3)
      result.emplace_back(solution[i], solution[i + 1], solution[i + 2]);
    return result;
  }

  // Returns the displacements to the mean of their neighbors of vertices that have few points and
  // are far from all points. Such vertices close holes, or are the tips of fins over sharp edges.
  std::vector<Vector> displacements_of_loose() const {
    std::vector<Vector> result = m_to_middle;
    for (std::size_t v = 0; v < result.size(); ++v)
      if (m_is_far[v] == 0)
        result[v] = NULL_VECTOR;
    return result;
  }

private:
  // Weights of a vertex, where a point has weight 1: for its present position, and for the mean of
  // its neighbors.
  static constexpr double stiffness = .05, smoothness = .1;

  Eigen::Index row(std::size_t f, int k) const {
    return 3 * Eigen::Index(m_facets[f].vertices[std::size_t(k)]);
  }

  // The contributions of the points of a facet to its corners, along its normal.
  struct Sums
  {
    double squares[3][3] = {}, heights[3] = {};
  };

  void add_points(const Sampled_surface_3& surface, const Cloud_triangles_3& triangles) {
    const Point_cloud_3& cloud = surface.cloud();
    std::vector<Vector> normals; // null for facets of area 0
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const auto& t = triangles[f];
      const Vector across = cross_product(t[1] - t[0], t[2] - t[0]);
      const double area = std::sqrt(across.squared_length());
      normals.push_back(area > 0 ? across / area : across);
    }
    std::vector<Sums> sums(triangles.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      Progress_scope::check();
      const std::size_t f = triangles.nearest(i);
      const auto& t = triangles[f];
      const Point& foot = triangles.foot(i);
      const Vector to_point = cloud.points()[i] - foot;
      const double reach = reach_of_points * cloud.reach(i),
                   twice_area = cross_product(t[1] - t[0], t[2] - t[0]) * normals[f];
      if (!(twice_area > 0) || to_point.squared_length() > reach * reach ||
          (surface.is_oriented(i) && surface.normal(i) * normals[f] < 0))
        continue;
      double b[3]; // barycentric coordinates of the foot
      for (int k = 0; k < 3; ++k)
        b[k] = cross_product(t[k + 1] - foot, t[k + 2] - foot) * normals[f] / twice_area;
      for (int k = 0; k < 3; ++k) {
        sums[f].heights[k] += b[k] * (to_point * normals[f]);
        for (int l = 0; l < 3; ++l)
          sums[f].squares[k][l] += b[k] * b[l];
      }
    }
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        m_weights[m_facets[f].vertices[std::size_t(k)]] += sums[f].squares[k][k];
        for (int u = 0; u < 3; ++u) {
          m_right[row(f, k) + u] += sums[f].heights[k] * normals[f][u];
          for (int l = 0; l < 3; ++l)
            for (int v = 0; v < 3; ++v)
              m_entries.emplace_back(row(f, k) + u, row(f, l) + v,
                                     sums[f].squares[k][l] * normals[f][u] * normals[f][v]);
        }
      }
  }

  // Finds loose vertices and their neighbors. A loose vertex has few points, or is far from its
  // points.
  void find_loose(const Sampled_surface_3& surface, const std::vector<Point>& positions) {
    static constexpr double few = .3, some = 3; // in weights of points
    static constexpr double distant =
        1.4; // in spacings; the distance from points beyond a sharp edge
    std::vector<char> is_loose;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      Progress_scope::check();
      m_is_far.push_back(m_weights[v] < some && surface.cloud().distance(positions[v]) >
                                                    distant * surface.cloud().spacing());
      is_loose.push_back(m_is_far[v] != 0 || m_weights[v] < few);
    }
    for (const auto& f : m_facets)
      for (std::size_t k = 0; k < 3; ++k)
        if (is_loose[f.vertices[k]] != 0)
          m_neighbors[f.vertices[k]].push_back(f.vertices[(k + 1) % 3]);
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (std::size_t n : m_neighbors[v])
        m_to_middle[v] += (positions[n] - positions[v]) / double(m_neighbors[v].size());
  }

  void add_smoothness() {
    for (std::size_t v = 0; v < m_neighbors.size(); ++v) {
      if (m_neighbors[v].empty())
        continue;
      std::vector<std::pair<std::size_t, double>> terms = {{v, 1}};
      for (std::size_t n : m_neighbors[v])
        terms.emplace_back(n, -1 / double(m_neighbors[v].size()));
      for (const auto& [i, a] : terms)
        for (int u = 0; u < 3; ++u) {
          const Eigen::Index at = 3 * Eigen::Index(i) + u;
          m_right[at] += smoothness * a * m_to_middle[v][u];
          for (const auto& [j, b] : terms)
            m_entries.emplace_back(at, 3 * Eigen::Index(j) + u, smoothness * a * b);
        }
    }
  }

  const Facets& m_facets;
  std::vector<Eigen::Triplet<double>> m_entries;
  Eigen::VectorXd m_right;
  std::vector<double> m_weights; // sums over the points of each vertex
  std::vector<char> m_is_far;    // whether a vertex is far from points and has few
  std::vector<std::vector<std::size_t>> m_neighbors; // of loose vertices only
  std::vector<Vector> m_to_middle;                   // displacement of a loose vertex to the mean
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_LEAST_SQUARES_3_H

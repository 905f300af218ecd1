// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_INTERFACE_LABEL_VOLUMES_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_INTERFACE_LABEL_VOLUMES_3_H

#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/geometry/vectors_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/interface_triangles_3.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>

#include <Eigen/Dense>

#include <boost/container/flat_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Moves the vertices of an interface so that volumes of labels change by given amounts, up to
// rounding: by Newton's method with one unknown for each label, the length of the way in a
// direction that goes with it. Volumes are those that the interface encloses: where it ends on the
// boundary of the domain, the part between it and the boundary is not counted.
template <class Complex> class Volume_changer_3
{
public:
  using Label = typename Complex::Label;
  using Point = typename Complex::Approximate_point_3;
  using Vector = typename Complex::Approximate_vector_3;

  explicit Volume_changer_3(const Interface_snapshot_3<Complex>& interface_)
      : m_interface(interface_) {}

  // Changes of the volumes of labels between two states of the vertices.
  std::map<Label, double> changes(const std::vector<Point>& from,
                                  const std::vector<Point>& to) const {
    std::map<Label, double> result;
    for (const auto& triangle : m_interface.triangles) {
      const auto before = corners(triangle, from), after = corners(triangle, to);
      const double change = swept_volume(before, after);
      result[triangle.behind] += change;
      result[triangle.in_front] -= change;
    }
    return result;
  }

  // Directions of the vertices for each of some labels, in their order; where one is zero, it may
  // be left out.
  using Directions = std::vector<boost::container::flat_map<Eigen::Index, Vector>>;

  // Those in which the volumes of labels change fastest.
  Directions gradients(const std::map<Label, double>& labels,
                       const std::vector<Point>& positions) const {
    std::map<Label, Eigen::Index> row;
    for (const auto& [label, amount] : labels)
      row.emplace(label, Eigen::Index(row.size()));
    Directions result(positions.size());
    for (const auto& triangle : m_interface.triangles) {
      const Vector normal = area_vector(corners(triangle, positions)) / 3;
      for (const auto& [label, sign] :
           {std::make_pair(triangle.behind, 1.), std::make_pair(triangle.in_front, -1.)}) {
        const auto found = row.find(label);
        if (found != row.end())
          for (std::size_t v : triangle.vertices) {
            Vector& gradient = result[v].try_emplace(found->second, 0, 0, 0).first->second;
            gradient = gradient + sign * within_sides(normal, m_interface.vertices[v]);
          }
      }
    }
    return result;
  }

  // Labels that are not mentioned take what is left.
  void change_by(const std::map<Label, double>& amounts, const Directions& directions,
                 std::vector<Point>& positions) const {
    static constexpr int iterations = 10; // Newton's method doubles the digits in each
    const std::vector<Point> start = positions;
    std::vector<Point> candidate = positions;
    double least_error = std::numeric_limits<double>::infinity();
    for (int k = 0; k < iterations; ++k) {
      const auto changed = changes(start, candidate);
      Eigen::VectorXd missing(amounts.size());
      Eigen::Index row = 0;
      for (const auto& [label, amount] : amounts) {
        const auto found = changed.find(label);
        missing(row++) = amount - (found == changed.end() ? 0 : found->second);
      }
      const double error = missing.size() == 0 ? 0 : missing.cwiseAbs().maxCoeff();
      if (!(error < least_error))
        return;
      least_error = error;
      positions = candidate;
      advance(gradients(amounts, candidate), directions, missing, candidate);
    }
  }

  // Along the normals: flat parts between two labels stay flat and go equally far.
  void change_by(const std::map<Label, double>& amounts, std::vector<Point>& positions) const {
    Directions directions = gradients(amounts, positions);
    std::vector<double> areas(positions.size(), 0); // a third of each facet around
    for (const auto& triangle : m_interface.triangles) {
      const Vector normal = area_vector(corners(triangle, positions)) / 3;
      for (std::size_t v : triangle.vertices)
        areas[v] += std::sqrt(normal.squared_length());
    }
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (auto& [i, direction] : directions[v])
        direction = areas[v] > 0 ? direction / areas[v] : Vector(0, 0, 0);
    change_by(amounts, directions, positions);
  }

private:
  // The volume that a triangle sweeps on its way, positive if towards its front; exact for motions
  // of the corners along straight lines.
  static double swept_volume(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    // Simpson's rule is exact for the quadratic polynomial in time that the flux is.
    const std::array<Point, 3> m = {midpoint(a[0], b[0]), midpoint(a[1], b[1]),
                                    midpoint(a[2], b[2])};
    const Vector way = ((b[0] - a[0]) + (b[1] - a[1]) + (b[2] - a[2])) / 3;
    return way * (area_vector(a) + 4 * area_vector(m) + area_vector(b)) / 6;
  }

  // One step of Newton's method.
  static void advance(const Directions& gradients, const Directions& directions,
                      const Eigen::VectorXd& missing, std::vector<Point>& positions) {
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(missing.size(), missing.size());
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (const auto& [i, a] : gradients[v])
        for (const auto& [j, b] : directions[v])
          products(i, j) += a * b;
    // Singular where all labels are given, as their sum is.
    static constexpr double rounding = 1e-10;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(rounding);
    decomposition.compute(products);
    const Eigen::VectorXd lengths = decomposition.solve(missing);
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (const auto& [i, direction] : directions[v])
        positions[v] = positions[v] + lengths(i) * direction;
  }

  // What is left of a vector where the vertex must stay on sides of the domain.
  template <class Vertex_handle> static Vector within_sides(const Vector& vector, Vertex_handle v) {
    const auto component = [&](int axis) {
      return Boundary_class::fixes(v->boundary_class(), axis) ? 0 : vector[axis];
    };
    return Vector(component(0), component(1), component(2));
  }

  const Interface_snapshot_3<Complex>& m_interface;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_INTERFACE_LABEL_VOLUMES_3_H

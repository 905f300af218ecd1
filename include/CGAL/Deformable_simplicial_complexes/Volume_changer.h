// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VOLUME_CHANGER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VOLUME_CHANGER_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>

#include <CGAL/Origin.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

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

// Moves the vertices of an interface so that volumes of labels, in the plane their areas, change by
// given amounts, up to rounding: by Newton's method with one unknown for each label, the length of
// the way in a direction that goes with it. Volumes are those that the interface encloses: where it
// ends on the boundary of the domain, the part between it and the boundary is not counted.
template <class Complex> class Volume_changer
{
public:
  using Label = typename Complex::Label;
  using Point = typename Complex::Approximate_point;
  using Vector = typename Complex::Approximate_vector;

  explicit Volume_changer(const Interface_snapshot<Complex>& interface_)
      : m_interface(interface_) {}

  // Changes of the volumes of labels between two states of the vertices.
  std::map<Label, double> changes(const std::vector<Point>& from,
                                  const std::vector<Point>& to) const {
    std::map<Label, double> result;
    for (const auto& facet : m_interface.facets()) {
      const double change = swept_measure(corners(facet, from), corners(facet, to));
      result[facet.behind] += change;
      result[facet.in_front] -= change;
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
    for (const auto& facet : m_interface.facets()) {
      const Vector share = normal(corners(facet, positions)) / d;
      for (const auto& [label, sign] :
           {std::make_pair(facet.behind, 1.), std::make_pair(facet.in_front, -1.)}) {
        const auto found = row.find(label);
        if (found != row.end())
          for (std::size_t v : facet.vertices) {
            Vector& gradient = result[v].try_emplace(found->second, NULL_VECTOR).first->second;
            gradient = gradient + sign * within_sides(share, m_interface.vertices[v]);
          }
      }
    }
    return result;
  }

  static constexpr int most_iterations = 10; // Newton's method doubles the digits in each

  // Labels that are not mentioned take what is left.
  void change_by(const std::map<Label, double>& amounts, const Directions& directions,
                 std::vector<Point>& positions, int iterations = most_iterations) const {
    const std::vector<Point> start = positions;
    std::vector<Point> candidate = positions;
    double least_error = std::numeric_limits<double>::infinity();
    for (int k = 0; k < iterations; ++k) {
      Progress_scope::check();
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
      if (k + 1 < iterations)
        advance(gradients(amounts, candidate), directions, missing, candidate);
    }
  }

  // Along the normals: flat parts between two labels stay flat and go equally far.
  void change_by(const std::map<Label, double>& amounts, std::vector<Point>& positions,
                 int iterations = most_iterations) const {
    Directions directions = gradients(amounts, positions);
    std::vector<double> areas(positions.size(), 0); // a third of each facet around
    for (const auto& facet : m_interface.facets()) {
      const Vector share = normal(corners(facet, positions)) / d;
      for (std::size_t v : facet.vertices)
        areas[v] += std::sqrt(share.squared_length());
    }
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (auto& [i, direction] : directions[v])
        direction = areas[v] > 0 ? direction / areas[v] : Vector(NULL_VECTOR);
    change_by(amounts, directions, positions, iterations);
  }

private:
  static constexpr int d = Complex::dimension;
  using Corners = std::array<Point, Complex::dimension>;

  // Those of a facet, as seen from the first.
  template <class Facet>
  Corners corners(const Facet& facet, const std::vector<Point>& positions) const {
    Corners result;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] =
          m_interface.domain.near(positions[facet.vertices[0]], positions[facet.vertices[i]]);
    return result;
  }

  // Towards the front of a facet, as long as that measures.
  static Vector normal(const Corners& p) { return Complex::Space::facet_normal(p) / (d - 1); }

  // What a facet sweeps on its way, positive if towards its front; exact for motions of the corners
  // along straight lines.
  double swept_measure(const Corners& a, const Corners& b) const {
    // Simpson's rule is exact for the polynomial in time that the flux is, of degree d - 1.
    const Vector image = m_interface.domain.near(a[0], b[0]) - b[0];
    Corners m;
    Vector way(NULL_VECTOR);
    for (std::size_t i = 0; i < m.size(); ++i) {
      const Vector v = (b[i] + image) - a[i];
      m[i] = a[i] + v / 2;
      way = way + v / d;
    }
    return way * (normal(a) + 4 * normal(m) + normal(b)) / 6;
  }

  // Up to here the cube of the number of labels is a short time.
  static constexpr Eigen::Index few_labels = 64;

  // Lengths of the ways in the directions that change volumes as they are missing.
  static Eigen::VectorXd solve_directly(const Directions& gradients, const Directions& directions,
                                        const Eigen::VectorXd& missing) {
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(missing.size(), missing.size());
    for (std::size_t v = 0; v < gradients.size(); ++v)
      for (const auto& [i, a] : gradients[v])
        for (const auto& [j, b] : directions[v])
          products(i, j) += a * b;
    // Singular where all labels are given, as their sum is.
    static constexpr double rounding = 1e-10;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(rounding);
    decomposition.compute(products);
    return decomposition.solve(missing);
  }

  // The same by iterations, with the products of labels that share vertices only.
  static Eigen::VectorXd solve_iteratively(const Directions& gradients,
                                           const Directions& directions,
                                           const Eigen::VectorXd& missing) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t v = 0; v < gradients.size(); ++v)
      for (const auto& [i, a] : gradients[v])
        for (const auto& [j, b] : directions[v])
          entries.emplace_back(int(i), int(j), a * b);
    Eigen::SparseMatrix<double> products(missing.size(), missing.size());
    products.setFromTriplets(entries.begin(), entries.end());
    static constexpr double residual = 1e-6; // relative; the next iteration corrects what is left
    Eigen::BiCGSTAB<Eigen::SparseMatrix<double>> solver;
    solver.setTolerance(residual);
    solver.compute(products);
    const Eigen::VectorXd lengths = solver.solve(missing);
    if (solver.info() == Eigen::Success && lengths.allFinite())
      return lengths;
    // Slower, but right where all labels are given and the system is singular.
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> least_squares;
    least_squares.setTolerance(residual);
    least_squares.compute(products);
    return least_squares.solve(missing);
  }

  // One step of Newton's method.
  static void advance(const Directions& gradients, const Directions& directions,
                      const Eigen::VectorXd& missing, std::vector<Point>& positions) {
    const Eigen::VectorXd lengths = missing.size() <= few_labels
                                        ? solve_directly(gradients, directions, missing)
                                        : solve_iteratively(gradients, directions, missing);
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (const auto& [i, direction] : directions[v])
        positions[v] = positions[v] + lengths(i) * direction;
  }

  // What is left of a vector where the vertex must stay on sides of the domain.
  template <class Vertex_handle> static Vector within_sides(const Vector& vector, Vertex_handle v) {
    std::array<double, d> result;
    for (int axis = 0; axis < d; ++axis)
      result[axis] = Boundary_class::fixes(v->boundary_class(), axis) ? 0 : vector[axis];
    return vector_of<Complex>(result);
  }

  const Interface_snapshot<Complex>& m_interface;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VOLUME_CHANGER_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_VOLUME_CHANGER_H
#define CGAL_INTERFACE_REMESHING_VOLUME_CHANGER_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Origin.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <boost/container/flat_map.hpp>

#include <limits>
#include <map>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Computes positions of the vertices of an interface that change the volumes of labels, in the plane
the areas, by given amounts. The complex does not change; pass the positions to
`deform_interface_to()`.

Newton's method solves for one unknown per label: the step length in a direction that belongs to the
label. The change of a volume is the volume that the facets of the interface sweep. Where the
interface ends on the boundary of the domain, this is the change of the volume of the label only if
the vertices there stay on the boundary.

Lengths and volumes are in the coordinates of the complex. Any number of threads can call functions
of one object at once.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Volume_changer
{
public:
  using Label = typename Complex::Label;   ///< a label
  using Point = typename Complex::Point;   ///< a position of a vertex
  using Vector = typename Complex::Vector; ///< a displacement

  /// Refers to the snapshot of an interface.
  /// \pre The snapshot outlives the object. For `gradients()` and `change_by()`, the complex must
  ///      not have changed, because these functions read the sides of the domain from its vertices.
  explicit Volume_changer(const Interface_snapshot<Complex>& interface_)
      : m_interface(interface_) {}

  /// Returns the changes of the volumes of all labels at the interface when each vertex moves along
  /// a straight line from one position to another. Linear in the size of the interface, times the
  /// logarithm of the number of labels.
  /// \param from, to positions of the vertices, in the order of the snapshot
  std::map<Label, double> changes(const std::vector<Point>& from,
                                  const std::vector<Point>& to) const {
    std::map<Label, double> result;
    for (const auto& facet : m_interface.facets()) {
      const double change =
          swept_measure(m_interface.corners(facet, from), m_interface.corners(facet, to));
      result[facet.behind] += change;
      result[facet.in_front] -= change;
    }
    return result;
  }

  /// For each vertex a direction for each label. The key is the index of the label in the sorted
  /// list of labels. A missing direction is zero.
  using Directions = std::vector<boost::container::flat_map<Eigen::Index, Vector>>;

  /// Returns the gradients of the volumes of labels with respect to the vertices. Components that
  /// would move a vertex off its sides of the domain are 0. Linear in the size of the interface,
  /// times the logarithm of the number of labels.
  /// \param labels the labels; the mapped values are not used
  /// \param positions of the vertices, in the order of the snapshot
  Directions gradients(const std::map<Label, double>& labels,
                       const std::vector<Point>& positions) const {
    std::map<Label, Eigen::Index> row;
    for (const auto& [label, amount] : labels)
      row.emplace(label, Eigen::Index(row.size()));
    Directions result(positions.size());
    for (const auto& facet : m_interface.facets()) {
      const Vector share = normal(m_interface.corners(facet, positions)) / d;
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

  static constexpr int most_iterations = 10; ///< default bound on the evaluations

  /// Changes volumes by given amounts, by motions in given directions. Stops when the largest error
  /// no longer decreases, which is the case at the accuracy of rounding, or after `iterations`
  /// evaluations of the volumes. `positions` are those with the smallest error that was found.
  /// Check the result with `changes()`: no error is thrown if amounts cannot be reached.
  ///
  /// Each iteration is linear in the size of the interface, times the square of the number of
  /// labels at a vertex, and solves a sparse system with one unknown for each label.
  /// \param amounts changes of the volumes. Labels that are not mentioned take the rest.
  /// \param directions for each vertex and each label of `amounts`, such as `gradients()`
  /// \param positions of the vertices, in the order of the snapshot; changed
  /// \param iterations bound on the evaluations; there is one Newton step less
  /// \throws Interrupted_error if a `Progress_scope` stops the function; `positions` are then the
  ///         best ones so far.
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

  /// Changes volumes by given amounts, by motions along the normals of the vertices. Where the
  /// interface is flat between two labels, it stays flat, and its vertices have displacements of
  /// equal length. See the function above for the other parameters, the result and exceptions.
  void change_by(const std::map<Label, double>& amounts, std::vector<Point>& positions,
                 int iterations = most_iterations) const {
    Directions directions = gradients(amounts, positions);
    std::vector<double> areas(positions.size(), 0); // for each vertex, 1 / d of the incident facets
    for (const auto& facet : m_interface.facets()) {
      const Vector share = normal(m_interface.corners(facet, positions)) / d;
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

  // Returns the normal towards the front of a facet; its length is the measure of the facet.
  static Vector normal(const Corners& p) { return Complex::Space::facet_normal(p) / (d - 1); }

  // Returns the signed volume that a facet sweeps while its corners move along straight lines,
  // positive towards its front; exact up to rounding.
  double swept_measure(const Corners& a, const Corners& b) const {
    // The flux is a polynomial in time of degree d - 1, for which Simpson's rule is exact.
    const Vector image = m_interface.domain.nearest_image(a[0], b[0]) - b[0];
    Corners m;
    Vector displacement(NULL_VECTOR);
    for (std::size_t i = 0; i < m.size(); ++i) {
      const Vector v = (b[i] + image) - a[i];
      m[i] = a[i] + v / 2;
      displacement = displacement + v / d;
    }
    return displacement * (normal(a) + 4 * normal(m) + normal(b)) / 6;
  }

  // Returns the step lengths in the directions that change the volumes by the missing amounts. Only
  // labels that share a vertex have an entry in the matrix, which is singular if all labels are
  // given, as the sum of their volumes is constant.
  static Eigen::VectorXd step_lengths(const Directions& gradients, const Directions& directions,
                                      const Eigen::VectorXd& missing) {
    Eigen::SparseMatrix<double> products(missing.size(), missing.size());
    for (std::size_t v = 0; v < gradients.size(); ++v)
      for (const auto& [i, a] : gradients[v])
        for (const auto& [j, b] : directions[v])
          products.coeffRef(i, j) += a * b;
    products.makeCompressed();
    // The solvers square numbers, so that these should be near 1.
    const double scale = products.nonZeros() > 0 ? products.coeffs().abs().maxCoeff() : 0;
    const double amount = scale > 0 ? missing.cwiseAbs().maxCoeff() : 0;
    if (!(amount > 0))
      return Eigen::VectorXd::Zero(missing.size());
    products /= scale;
    const Eigen::VectorXd wanted = missing / amount;
    static constexpr double residual = 1e-10; // relative; later Newton steps correct the rest
    Eigen::BiCGSTAB<Eigen::SparseMatrix<double>> solver;
    solver.setTolerance(residual);
    solver.compute(products);
    const Eigen::VectorXd lengths = solver.solve(wanted);
    if (solver.info() == Eigen::Success && lengths.allFinite())
      return amount / scale * lengths;
    // Slower, but also solves singular systems.
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> least_squares;
    least_squares.setTolerance(residual);
    least_squares.compute(products);
    return amount / scale * least_squares.solve(wanted);
  }

  // Moves the positions by one step of Newton's method.
  static void advance(const Directions& gradients, const Directions& directions,
                      const Eigen::VectorXd& missing, std::vector<Point>& positions) {
    const Eigen::VectorXd lengths = step_lengths(gradients, directions, missing);
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (const auto& [i, direction] : directions[v])
        positions[v] = positions[v] + lengths(i) * direction;
  }

  // Returns the component of a vector along the sides of the domain on which the vertex lies.
  template <class Vertex_handle> static Vector within_sides(const Vector& vector, Vertex_handle v) {
    std::array<double, d> result;
    for (int axis = 0; axis < d; ++axis)
      result[axis] = Boundary_class::fixes(v->boundary_class(), axis) ? 0 : vector[axis];
    return vector_of<Complex>(result);
  }

  const Interface_snapshot<Complex>& m_interface;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_VOLUME_CHANGER_H

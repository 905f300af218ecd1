// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_INTERFACE_DESCENT_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_INTERFACE_DESCENT_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Image_segmentation/internal/segmentation/Cell_costs.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/internal/numbers/Facet_tension.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Moves the interface of a segmentation against the gradient of the energy: the costs of cells, and
// a tension times the measure of the interface. Each vertex has its own step length, which grows
// while it moves in one direction and shrinks when it returns (resilient propagation: M. Riedmiller
// and H. Braun, 1993).
template <class Complex> class Interface_descent
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  // `tension` and `stiffness` are in units of the complex. The stiffness is a lower bound of the
  // derivative of the force per unit of the interface with respect to its displacement.
  Interface_descent(Complex& complex, Cell_costs<Complex>& costs, double tension, double stiffness,
                    const Deformation_options<Complex>& options)
      : m_complex(complex), m_costs(costs), m_tension(tension), m_stiffness(stiffness),
        m_options(options) {}

  // Moves each vertex by at most `longest`.
  void step(double longest, const For_each_index& for_each_index) {
    const Interface_snapshot<Complex> interface_(m_complex, for_each_index);
    std::vector<Point> destinations = interface_.positions(m_complex);
    const auto [forces, shares] = forces_of(interface_, destinations, for_each_index);
    std::vector<Step> steps(destinations.size());
    auto before = m_steps.begin();
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Step& step = steps[i];
      step.time_stamp = interface_.vertices[i]->time_stamp();
      while (before != m_steps.end() && before->time_stamp < step.time_stamp)
        ++before;
      const double force = std::sqrt(forces[i].squared_length());
      step.direction = force > 0 ? forces[i] / force : Vector(NULL_VECTOR);
      step.length = longest * first;
      if (before != m_steps.end() && before->time_stamp == step.time_stamp) {
        const double cosine = before->direction * step.direction;
        step.length = before->length * (cosine > same       ? growth
                                        : cosine < opposite ? shrinkage
                                                            : decay);
      }
      step.length = (std::min)(step.length, longest);
      if (shares[i] > 0)
        destinations[i] =
            destinations[i] +
            (std::min)(step.length, force / (m_stiffness * shares[i])) * step.direction;
    }
    m_steps = std::move(steps);
    deform_interface_to(m_complex, interface_, destinations, m_options);
  }

private:
  // The rule of step lengths: factors for the next step, by the cosine of the angle between the
  // directions of two steps, and the first step relative to the longest one.
  static constexpr double same = .5, growth = 1.2, opposite = -.2, shrinkage = .5, decay = .9,
                          first = .5;

  struct Step
  {
    std::size_t time_stamp = 0; // of the vertex
    Vector direction = Vector(NULL_VECTOR);
    double length = 0;
  };

  struct Forces
  {
    std::vector<Vector> forces;
    std::vector<double> shares; // measure of the interface of each vertex
  };

  Forces forces_of(const Interface_snapshot<Complex>& interface_,
                   const std::vector<Point>& positions,
                   const For_each_index& for_each_index) const {
    const auto& facets = interface_.facets();
    std::vector<std::array<Vector, d>> forces(facets.size());
    std::vector<std::array<double, d>> shares(facets.size());
    for_each_index(facets.size(), [&](std::size_t f) {
      std::array<Point, d> corners;
      for (int i = 0; i < d; ++i)
        corners[i] = positions[facets[f].vertices[i]];
      forces[f] = forces_of_image(corners, facets[f].behind, facets[f].in_front);
      const Facet_tension<d> tension(corners);
      shares[f] = tension.shares;
      for (std::size_t e = 0; e < tension.weights.size(); ++e) {
        const auto [i, j] = Complex::Space::facet_edges[e];
        const Vector force = m_tension * tension.weights[e] * (corners[j] - corners[i]);
        forces[f][i] = forces[f][i] + force;
        forces[f][j] = forces[f][j] - force;
      }
    });
    Forces result = {std::vector<Vector>(positions.size(), Vector(NULL_VECTOR)),
                     std::vector<double>(positions.size(), 0.)};
    for (std::size_t f = 0; f < facets.size(); ++f)
      for (int i = 0; i < d; ++i) {
        const auto v = facets[f].vertices[i];
        result.forces[v] = result.forces[v] + forces[f][i];
        result.shares[v] += shares[f][i];
      }
    return result;
  }

  // Returns the forces of the image on the corners of a facet: the integral of the difference of
  // the costs in front and behind, with linear weights, along the normal.
  std::array<Vector, d> forces_of_image(const std::array<Point, d>& corners, int behind,
                                        int in_front) const {
    std::array<typename Image_moments<d>::Place, d> places;
    for (int i = 0; i < d; ++i)
      places[i] = m_costs.moments().place(m_complex.in_user_coordinates(corners[i]));
    std::array<double, d> pressures = {};
    m_costs.moments().for_each_piece(
        places, [&](const std::array<double, d>& weights, double share, std::size_t pixel) {
          const double gain =
              share * (m_costs.of_pixel(pixel, in_front) - m_costs.of_pixel(pixel, behind));
          for (int i = 0; i < d; ++i)
            pressures[i] += weights[i] * gain;
        });
    // The length of the normal is the length of a segment, or twice the area of a triangle.
    const Vector normal =
        Complex::Space::facet_normal(corners) * (std::pow(m_costs.pixels_in_unit(), d) / (d - 1));
    std::array<Vector, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = pressures[i] * normal;
    return result;
  }

  Complex& m_complex;
  Cell_costs<Complex>& m_costs;
  double m_tension, m_stiffness;
  Deformation_options<Complex> m_options;
  std::vector<Step> m_steps; // the last ones, by increasing time stamps of vertices
};

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_INTERFACE_DESCENT_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_STEP_VELOCITY_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_STEP_VELOCITY_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>
#include <CGAL/Interface_flows/internal/paths/velocity_properties.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <memory>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A velocity of any form, as a time step sees it. The functions are called a few times in each
// step, so that the step is compiled once for all velocities.
template <class Complex> class Step_velocity
{
public:
  using Interface = Interface_vertices<Complex>;
  using Points = std::vector<typename Complex::Point>;
  using Vectors = std::vector<typename Complex::Vector>;

  // Vertices that were inserted at corners before a step.
  struct Opened_corners
  {
    std::size_t inserted = 0;
    // replaces their destinations; `interface_` was listed after the insertion
    std::function<void(const Interface& interface_, Points& destinations)> place;
  };

  virtual ~Step_velocity() = default;

  // Whether free vertices follow the velocity, too.
  virtual bool is_flow_of_space() const = 0;
  // Whether open_corners() inserts vertices.
  virtual bool opens_corners() const = 0;
  // Whether the velocity contracts the interface.
  virtual bool contracts() const = 0;
  virtual bool preserves_volumes() const = 0;
  // Returns the energy of the velocity, or `other` if it has none.
  virtual Interface_energy energy_or(const Interface_energy& other) const = 0;

  // Lists the interface for the functions below.
  virtual std::shared_ptr<const Interface> interface_of(const Complex& dsc,
                                                        const For_each_index& loop) const = 0;
  virtual Points destinations(const Interface& interface_, const Points& start, double t, double dt,
                              Integration_scheme scheme, double tolerance, double* error) const = 0;
  // Returns the velocities of vertices. \pre the velocity opens corners
  virtual Vectors velocities(const Interface& interface_, const Points& positions,
                             double t) const = 0;
  // Moves points of space. \pre the velocity is a flow of space
  virtual Points follow(const typename Complex::Domain& domain, const Points& start, double t,
                        double dt) const = 0;
  // Inserts vertices before a step of the length `dt`. \pre the velocity opens corners
  virtual Opened_corners open_corners(Complex& dsc, const Interface& interface_, double dt,
                                      Deformation_visitor<Complex>& visitor) const = 0;
};

// The velocity of a user.
template <class Complex, class Velocity> class Step_velocity_of : public Step_velocity<Complex>
{
public:
  using Base = Step_velocity<Complex>;
  using typename Base::Interface;
  using typename Base::Opened_corners;
  using typename Base::Points;
  using typename Base::Vectors;

  // `velocity` must outlive the object.
  explicit Step_velocity_of(const Velocity& velocity) : m_velocity(velocity) {}

  bool is_flow_of_space() const override { return internal::is_flow_of_space<Complex, Velocity>; }
  bool opens_corners() const override { return internal::opens_corners<Complex, Velocity>; }
  bool contracts() const override { return contracts_interface<Velocity>; }
  bool preserves_volumes() const override { return internal::preserves_volumes(m_velocity); }
  Interface_energy energy_or(const Interface_energy& other) const override {
    return energy_of(m_velocity, other);
  }

  std::shared_ptr<const Interface> interface_of(const Complex& dsc,
                                                const For_each_index& loop) const override {
    return std::make_shared<const Seen>(dsc, loop);
  }

  Points destinations(const Interface& interface_, const Points& start, double t, double dt,
                      Integration_scheme scheme, double tolerance, double* error) const override {
    return find_destinations(seen(interface_), start, m_velocity, t, dt, scheme, tolerance, error);
  }

  Vectors velocities(const Interface& interface_, const Points& positions,
                     double t) const override {
    if constexpr (internal::opens_corners<Complex, Velocity>)
      return velocities_at(seen(interface_), positions, t, m_velocity);
    else
      return {};
  }

  Points follow(const typename Complex::Domain& domain, const Points& start, double t,
                double dt) const override {
    if constexpr (internal::is_flow_of_space<Complex, Velocity>)
      return follow_flow<Complex>(domain, start, m_velocity, t, dt);
    else
      return {};
  }

  Opened_corners open_corners(Complex& dsc, const Interface& interface_, double dt,
                              Deformation_visitor<Complex>& visitor) const override {
    if constexpr (internal::opens_corners<Complex, Velocity>) {
      const auto corners = m_velocity.open_corners(dsc, seen(interface_), dt, visitor);
      return {corners.inserted(), [corners](const Interface& now, Points& destinations) {
                corners.place(seen(now), destinations);
              }};
    } else {
      return {};
    }
  }

private:
  using Seen = Interface_seen_by<Complex, Velocity>;

  // interface_of() made the interface.
  static const Seen& seen(const Interface& interface_) {
    return static_cast<const Seen&>(interface_);
  }

  const Velocity& m_velocity;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_STEP_VELOCITY_H

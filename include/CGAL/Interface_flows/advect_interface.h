// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_ADVECT_INTERFACE_H
#define CGAL_INTERFACE_FLOWS_ADVECT_INTERFACE_H

#include <CGAL/Complex_construction/grow_domain.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/internal/corners/Passed_edges.h>
#include <CGAL/Interface_flows/internal/paths/Step_velocity.h>
#include <CGAL/Interface_flows/internal/paths/long_steps.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {
/*!
\ingroup PkgInterfaceFlowsRef

Options of `advect_interface()`. The named parameters of that function have the same names.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Advection_options
{
  /// Options of the deformation; by default with `Domain_rule::refuse`.
  Deformation_options<Complex> deformation;
  Integration_scheme scheme = Integration_scheme::rk2; ///< The method that integrates velocities.
  /// Largest estimated error of a destination in each substep of `Integration_scheme::adaptive`, in
  /// mean edges of the initial interface, greater than 0. It is far below the distance between an
  /// edge and a curved interface.
  double integration_tolerance = 1e-4;
  /// Longest displacement of a vertex relative to its neighbors in one deformation, in local edge
  /// lengths, at least 0. In a rotation, 0.5 is a turn by 29 degrees: straight paths then deviate
  /// from the circle by less than a thirtieth of the radius. If the free vertices do not follow the
  /// velocity, a vertex also moves by at most four times this length. A segment of a
  /// `Normal_offset` in the plane moves by at most one such length, and parts also end when a
  /// segment vanishes; `scheme` is not used. A longer time step is divided into parts: a flow map,
  /// a step and an interface velocity are called for each part, and the paths in a field are
  /// integrated adaptively, unless `scheme` is `Integration_scheme::euler`. With 0, or if the
  /// parameter `flow` is given, the time step is not divided.
  double largest_displacement = .5;

  /// Constructs options with default values.
  Advection_options() { deformation.domain_rule = Domain_rule::refuse; }

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    deformation.check();
    if (!(integration_tolerance > 0))
      throw Error("the integration tolerance is out of range: use more than 0");
    if (!(largest_displacement >= 0))
      throw Error("the largest displacement is out of range: use 0 or more");
  }
};

namespace internal {

// Returns the volumes of all labels, as the beginning of their changes.
template <class Complex>
std::vector<typename Deformation_report<Complex>::Label_change> volumes_before(const Complex& dsc) {
  std::vector<typename Deformation_report<Complex>::Label_change> result;
  for (const auto label : dsc.labels())
    change_of_label(result, label).volume_before = dsc.measure(label);
  return result;
}

// Replaces the volumes at the beginning of a report by those before earlier operations.
template <class Complex>
void begin_with(const std::vector<typename Deformation_report<Complex>::Label_change>& earlier,
                Deformation_report<Complex>& report) {
  for (const auto& before : earlier)
    change_of_label(report.labels, before.label).volume_before = before.volume_before;
}

// Returns the destinations of the vertices of the interface in a time step.
template <class Complex>
std::vector<typename Complex::Point>
destinations_of_step(const Complex& dsc, const Interface_vertices<Complex>& interface_,
                     const Step_velocity<Complex>& velocity, double t, double dt,
                     const Advection_options<Complex>& options, double* error = nullptr) {
  if (options.scheme == Integration_scheme::adaptive && !(dsc.mean_interface_edge() > 0) &&
      !interface_.vertices.empty())
    throw Error("the complex was built without an interface and has no unit of length for the "
                "integration tolerance: use another scheme");
  return velocity.destinations(interface_, interface_.positions(dsc), t, dt, options.scheme,
                               options.integration_tolerance * dsc.mean_interface_edge(), error);
}

// A time step that is divided into parts. Each part is one deformation.
template <class Complex> class Divided_step
{
public:
  using Report = Deformation_report<Complex>;
  using Velocity = Step_velocity<Complex>;
  using Points = typename Velocity::Points;

  Divided_step(Complex& dsc, const Velocity& velocity, const Advection_options<Complex>& options)
      : m_dsc(dsc), m_velocity(velocity), m_options(options),
        m_for_each_index(options.deformation.number_of_threads) {}

  Report run(double t, double dt) {
    Report report;
    double rest = dt;
    m_longest = dt;
    for (bool is_first = true; is_first || rest != 0; is_first = false) {
      m_step = std::abs(rest) < std::abs(m_longest) ? rest : m_longest;
      const Report part = advance(t + (dt - rest), dt);
      if (is_first) {
        report = part;
        m_grown = 0;
      } else {
        report.append(part);
      }
      if (report.stopped)
        break;
      // The last part ends exactly at the end of the time step.
      static constexpr double rounding = 1e-9; // of a part
      rest = std::abs(rest - m_step) <= rounding * std::abs(m_step) ? 0 : rest - m_step;
    }
    // The domain takes part in the balance as if it had grown before.
    if (m_grown > 0)
      change_of_label(report.labels, 0).volume_before += m_grown;
    return report;
  }

private:
  using Interface = std::shared_ptr<const Interface_vertices<Complex>>;

  // Operations before a part.
  struct Operations
  {
    std::vector<typename Report::Label_change> volumes; // before the operations
    std::size_t collapsed = 0, inserted = 0;
  };

  // Does a part of the time step `dt`, from the time `t` on.
  Report advance(double t, double dt) {
    Interface interface_ = listed();
    Points destinations = destinations_of_part(*interface_, t, dt);
    if constexpr (Complex::Domain::has_outside)
      while (m_options.deformation.domain_rule == Domain_rule::grow &&
             leaves_domain(m_dsc, *interface_, destinations)) {
        const double before = m_dsc.measure(0);
        grow_domain(m_dsc);
        m_grown += m_dsc.measure(0) - before;
        interface_ = listed();
        destinations = destinations_of_part(*interface_, t, dt);
      }
    const auto before = m_velocity.opens_corners() ? open_corners(interface_, destinations, t, dt)
                                                   : std::optional<Operations>();
    Report report = deform(m_dsc, interface_->vertices, destinations, deformation(t));
    report.estimated_error = m_error;
    if (before) {
      begin_with(before->volumes, report);
      report.split += before->inserted;
      report.collapsed += before->collapsed;
      report.complete = report.complete && report.is_balanced();
    }
    return report;
  }

  Interface listed() const { return m_velocity.interface_of(m_dsc, m_for_each_index); }

  bool moves_segments() const { return Complex::dimension == 2 && m_velocity.opens_corners(); }

  Points destinations_of_part(const Interface_vertices<Complex>& interface_, double t, double dt) {
    return find_part(interface_, dt, [&] {
      return moves_segments() ? straight_destinations(interface_, t)
                              : destinations_of_step(m_dsc, interface_, m_velocity, t, m_step,
                                                     m_options, &m_error);
    });
  }

  // Opens corners and edges of polyhedra before a part. In the plane, collapses edges that vanish
  // before, and may shorten the part. Returns nothing if neither the interface nor its destinations
  // change.
  std::optional<Operations> open_corners(Interface& interface_, Points& destinations, double t,
                                         double dt) {
    Operations result;
    result.volumes = volumes_before(m_dsc);
    Deformation_visitor<Complex> none;
    auto& visitor = m_options.deformation.visitor ? *m_options.deformation.visitor : none;
    if constexpr (Complex::dimension == 2) {
      // Errors are found before the interface is changed.
      require_interface_edge(m_dsc);
      require_finite(destinations, "a destination");
      Passed_edges<Complex> passed(m_dsc,
                                   static_cast<const Interface_snapshot<Complex>&>(*interface_),
                                   destinations, visitor);
      passed.collapse();
      result.collapsed = passed.collapsed();
      if (result.collapsed > 0)
        interface_ = listed();
      shorten(passed.until(), dt);
    }
    const auto corners = m_velocity.open_corners(m_dsc, *interface_, m_step, visitor);
    result.inserted = corners.inserted;
    if (result.inserted > 0)
      interface_ = listed();
    else if (!moves_segments())
      return std::nullopt;
    destinations = moves_segments() ? straight_destinations(*interface_, t)
                                    : destinations_of_step(m_dsc, *interface_, m_velocity, t,
                                                           m_step, m_options, &m_error);
    corners.place(*interface_, destinations);
    return result;
  }

  bool may_divide() const {
    return m_options.largest_displacement > 0 && !m_options.deformation.flow;
  }

  // Ends the part shortly before an edge vanishes, unless the part would be too short.
  void shorten(double until, double dt) {
    static constexpr double shortly = .98;      // the edge has a fiftieth of its length then
    static constexpr double shortest = 1. / 62; // of the time step
    if (may_divide() && until < 1 && std::abs(m_step * until) >= shortest * std::abs(dt))
      m_step *= shortly * until;
  }

  // Returns the destinations by constant velocities: segments move along their normals until one of
  // them vanishes.
  Points straight_destinations(const Interface_vertices<Complex>& interface_, double t) const {
    Points result = interface_.positions(m_dsc);
    const auto velocities = m_velocity.velocities(interface_, result, t);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = result[i] + m_step * velocities[i];
    return result;
  }

  // Shortens the part until it is not too long. Returns its destinations.
  // \param find returns the destinations of a part of the length `m_step`
  template <class Find>
  Points find_part(const Interface_vertices<Complex>& interface_, double dt, const Find& find) {
    // A time step that needs more parts is an error of units or of signs.
    static constexpr double most_parts = 1e4;
    for (;;) {
      Points result = find();
      const double length =
          may_divide() ? length_of_step(m_dsc, interface_, result, m_velocity.is_flow_of_space(),
                                        moves_segments(), m_options.largest_displacement)
                       : 0;
      if (!(length > 1))
        return result;
      m_longest = m_step /= std::ceil(length);
      // Velocities of the interface are not smooth where its normals change.
      if (m_options.scheme != Integration_scheme::euler && m_velocity.is_flow_of_space())
        m_options.scheme = Integration_scheme::adaptive;
      if (!(std::abs(m_step) * most_parts >= std::abs(dt)))
        throw Error("the time step is too long: it would be divided into more than 10 000 parts; "
                    "use a shorter time step, or check the unit of the velocities");
    }
  }

  // Returns the options of the deformation of a part.
  Deformation_options<Complex> deformation(double t) const {
    Deformation_options<Complex> result = m_options.deformation;
    result.interface_energy = m_velocity.energy_or(result.interface_energy);
    if (m_velocity.is_flow_of_space() && !result.flow)
      result.flow = [this, t](const std::vector<typename Complex::Vertex_handle>& vertices) {
        Points positions;
        for (const auto v : vertices)
          positions.push_back(m_dsc.position(v));
        return m_velocity.follow(m_dsc.domain(), positions, t, m_step);
      };
    return result;
  }

  Complex& m_dsc;
  const Velocity& m_velocity;
  Advection_options<Complex> m_options;
  For_each_index m_for_each_index;
  double m_longest = 0; // length of a part
  double m_step = 0;    // length of the current part
  double m_error = 0;   // that the velocity estimates for this part
  double m_grown = 0;   // volume of the domain added after the first part
};

// Moves the interface for one time step. No template of the velocity, so it is compiled once.
template <class Complex>
Deformation_report<Complex> advect(Complex& dsc, const Step_velocity<Complex>& velocity, double t,
                                   double dt, const Advection_options<Complex>& options) {
  options.check();
  return Divided_step<Complex>(dsc, velocity, options).run(t, dt);
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Moves the interface with a velocity for one time step. The function integrates the path of each
vertex, then moves the interface to the end points of the paths, as `deform_interface()` does. The
interface does not follow the paths within the step. If the velocity is a field or an invertible
flow map, free vertices near the interface also move with it, unless the parameter `flow` is given.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param velocity one of the following forms. If a type has several of these operators, the order is:
       flow map, interface step, velocity field, interface velocity.
  - A velocity field (model of `VelocityField`), called as `velocity(p, t)`. It returns the velocity
    at the position `p` at the time `t`.
  - A velocity field for many points (model of `VelocityFieldOfPoints`), called as
    `velocity(points, t, velocities)`. It fills `velocities`.
  - A flow map (model of `InterfaceFlowMap`), called as `velocity(p, t, dt)`. It returns the
    position at `t + dt` of the point that is at `p` at `t`. The scheme is not used.
  - An interface velocity (model of `InterfaceVelocity`), called as
    `velocity(snapshot, positions, t, velocities)` once for each evaluation. It fills `velocities`.
  - An interface step (model of `InterfaceStep`), called as
    `velocity(snapshot, positions, t, dt, destinations)` once for the time step. It fills
    `destinations`. The scheme is not used.
  .
  If the velocity has a member function `energy()` that returns an `Interface_energy`, this energy
  replaces the parameter `interface_energy`.
  Positions have the type `Complex::Point` and vectors `Complex::Vector`, in
  the coordinates of the complex.
\param t the time at the beginning of the step
\param dt the length of the step. A negative value moves backwards in time.
\param np an `Advection_options`, or named parameters: those of `deform_interface()`, and those with
       the names of the other members of `Advection_options`. The default of `domain_rule` is
`Domain_rule::refuse`.

\return the report of `deform_interface()`. The report of a divided time step contains the sums over
        its parts.
\throws Invalid_destination_error if a velocity is not finite, if the interface would leave the
        domain and `domain_rule` is `Domain_rule::refuse`, or if an interface velocity or an
        interface step returns another number of vectors or points than there are vertices.
\throws Error if the tolerance is not positive, or the time step would be divided into more than
        10 000 parts. With `Integration_scheme::adaptive`, also if the
        tolerance needs substeps shorter than a millionth of the time step, if a step vanishes
        beside the time `t` by rounding, or if there is an interface and `dsc.mean_interface_edge()`
        is 0.

The complex is unchanged if one of these errors is thrown in the first part of the time step.
Otherwise, the earlier parts are done.
*/
template <class ConcurrencyTag = Sequential_tag, class Complex, class Velocity,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> advect_interface(Complex& dsc, const Velocity& velocity, double t,
                                             double dt,
                                             const NamedParameters& np = NamedParameters()) {
  if constexpr (internal::require_velocity<Complex, Velocity>())
    return internal::call_with_parameters<ConcurrencyTag>(
        dsc, np, Advection_options<Complex>(), [&](const auto& options) {
          return internal::advect(dsc, internal::Step_velocity_of<Complex, Velocity>(velocity), t,
                                  dt, options);
        });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_ADVECT_INTERFACE_H

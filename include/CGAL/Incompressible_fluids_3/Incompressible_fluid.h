// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INCOMPRESSIBLE_FLUID_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INCOMPRESSIBLE_FLUID_H

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>
#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/Fluid_report.h>
#include <CGAL/Incompressible_fluids_3/Fluid_state.h>
#include <CGAL/Incompressible_fluids_3/Fluid_step_options.h>
#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>
#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_solver.h>
#include <CGAL/Incompressible_fluids_3/Side_behavior.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Energy_check.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Fluid_bookkeeping.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Fluid_motion.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Liquid_interface.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Step_plan.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Component_momenta.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/Open_sides.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/side_velocities.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Field_diffusion.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Fluid_sources.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Fluid_step.h>
#include <CGAL/Interface_remeshing/Adaptive_advection.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/Interface_adaptation.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

The incompressible flow of any number of liquids with free surfaces, surface tension, viscosity and
solids, in space or in the plane. Linear finite elements on the cells of a complex discretize the
equations. The mesh moves with the liquids. See Section 4.4 of the paper, and
\cgalCite{cgal:mbeba-obfsu-10}.

Each label is a liquid, a gas or void, see `Fluid_properties`. A time step solves one system for
all velocities and pressures.

- With the default `implicitness`, the system is the implicit midpoint rule. Energy then changes
  only by external work, viscosity, damping, contacts and remeshing. External work includes the
  work of sources and of liquid that passes through sides. Surface tension and viscosity are
  implicit, so they do not bound the time step.
- The volume of each connected component of a liquid changes only by sources and through sides, up
  to rounding. When components merge, their volumes are added. `Report::volume_error` contains the
  remaining error.
- The momentum and the angular momentum of each connected component change only by gravity, gases,
  walls, bodies, sources and the liquid that passes through sides.
- Two liquids slip along their interface. The normal velocity is common to both. If both are
  viscous, friction resists the slip. So the relative velocity vanishes where the mesh resolves the
  viscosity. Where three media meet, liquids have a common velocity.
- A liquid on a side of the domain stays on it, provided that the domain is a box. By default, it
  slips along the side, see `set_side()`. Other surfaces keep a distance of a quarter of an edge
  from the sides.
- The surface of a liquid can touch a solid and leave it, see `Wall_behavior`. Vertices of the
  surface are moved out of solids. `Report::depth_in_solids` contains the remaining depth. A solid
  inside a liquid needs a hole: its cells must have a label that is not a liquid.

Coordinates are those of the complex. All units must be consistent. In the plane, volumes are areas,
and masses, forces and energies are those of a layer of thickness 1. The reports, gravity and solids
have three coordinates nevertheless. A solid is intersected with the plane in which the third
coordinate is 0.

The complex can have the domain `Torus_domain`. A flow on a torus is periodic along each axis, and
differs as follows.

- A liquid can fill the torus, without an interface.
- Angular momentum and the potential of gravity do not exist. The reports contain 0 for both, and no
  angular momentum is restored. Gravity acts, and its work enters the energy check.
- Positions of vertices lie in the box from the origin to the periods. Solids, sources and functions
  of users get points of this box or near it. A solid acts at its own place only, not at its images.
  Bodies cross the seams. They are smaller than half a period.
- `set_side()` has no effect, because there are no sides.

\tparam Complex an instance of `Deformable_simplicial_complex_2` or `Deformable_simplicial_complex_3`
\tparam Solver a model of `SaddlePointSolver`
*/
template <class Complex, class Solver = Saddle_point_solver> class Incompressible_fluid
{
public:
  static constexpr int dimension = Complex::dimension; ///< the dimension, 2 or 3
  using Point = typename Complex::Point;               ///< a point of the complex
  using Vector = typename Complex::Vector;             ///< a vector in the same coordinates
  /// A vorticity: a number in the plane, a `Vector` in space.
  using Vorticity = std::conditional_t<dimension == 2, double, Vector>;
  using Vertex_handle = typename Complex::Vertex_handle; ///< a vertex of the complex
  using Properties = Fluid_properties;                   ///< the media of the labels
  using Balance = Fluid_balance;                         ///< the balance of all liquids
  using Report = Fluid_report<Complex>;                  ///< the report of a time step
  using State = Fluid_state;                             ///< the state, to be saved and restored
  using Options = Fluid_step_options<Complex>;           ///< the options of a time step

  /// \name Creation
  /// @{

  /// Constructs a fluid at rest. The present volumes of the liquids are the volumes to be
  /// preserved. The complex must outlive the fluid, and only the fluid may change it. Takes O(n log
  /// n) time.
  /// \throws Error if no label is a liquid, if no cell has the label of a liquid, or if the liquids
  /// have no interface and the domain is not a torus
  Incompressible_fluid(Complex& complex, const Properties& properties)
      : m_complex(complex), m_properties(properties) {
    if (properties.liquids().empty())
      throw Error("there is no liquid: set the density of at least one label");
    const Mesh mesh(updated_complex(), m_properties);
    if (!mesh.can_move())
      throw Error(
          mesh.cells.empty()
              ? "no cell has the label of a liquid: set the density of a label of the complex"
              : "the liquid fills the domain and has no interface: give some cells another label");
    m_complex.take_component_lineage();
    m_liquids.set_volumes(Liquid_bookkeeping::measure(mesh, mesh.positions(m_complex)));
    m_gases.set_components(Gas_bookkeeping::measure(mesh, m_properties));
  }

  /// Fluids cannot be copied.
  Incompressible_fluid(const Incompressible_fluid&) = delete;
  /// Fluids cannot be assigned.
  Incompressible_fluid& operator=(const Incompressible_fluid&) = delete;

  /// Adds a copy of a solid.
  /// \tparam Solid a model of `Solid_3`
  /// \throws Error if the contact angle is not in [0, 180] degrees
  template <class Solid> void add_solid(const Solid& solid, const Wall_behavior& behavior = {}) {
    m_solids.push_back(any_solid(solid, behavior));
  }

  /// Adds a copy of a solid that liquids move. The motion of the body and the flow are solved
  /// together, so the body can be lighter than the liquid that it displaces. Gravity acts on the
  /// body. Two bodies, or a body and another solid, do not touch each other: they pass through each
  /// other.
  ///
  /// The cells inside the solid have the label of the void or of a gas. If it is a gas, its
  /// component includes the volume of the body. `relax()` does not move bodies.
  /// \tparam Solid a model of `Solid_3`
  /// \param solid the solid at its initial place. Its walls must not depend on the time.
  /// \param body the mass, inertia and initial motion. `Rigid_body_3::rotation` must be the
  /// identity.
  /// \param behavior the boundary conditions of liquids at the solid
  /// \return the number of the body, from 0 on
  /// \throws Error if the contact angle is not in [0, 180] degrees, if the mass is not positive, if
  /// the tensor of inertia is not symmetric and positive definite, if a number is not finite, or if
  /// the initial motion is not along the free axes
  template <class Solid>
  std::size_t add_body(const Solid& solid, const Rigid_body_3& body,
                       const Wall_behavior& behavior = {}) {
    auto any = any_solid(solid, behavior);
    internal::require_body(body, dimension);
    any.body = body;
    any.initial_center = body.center;
    m_solids.push_back(std::move(any));
    return number_of_bodies() - 1;
  }

  /// Sets the boundary condition at a side of the domain, slip by default. It applies to liquids
  /// that are on the side at the beginning, and has no effect if the domain is not a box. Where
  /// several no-slip sides meet, the first one determines the velocity, in the order x minimum, x
  /// maximum, y minimum, and so on. `state()` does not contain the conditions, so set them again
  /// after `restore()` into a new fluid.
  ///
  /// `relax()` ignores inflows and pressures. `advance()` throws the exceptions of their functions.
  /// It throws an `Error` if a velocity or a pressure is not finite, if the liquid that leaves
  /// empties a component, or if an inlet or an open part of the surface of a liquid contains no
  /// vertex.
  /// \param axis the axis perpendicular to the side: 0 for x, 1 for y, 2 for z
  /// \param is_upper whether the side has the larger coordinate
  /// \param behavior the boundary condition
  /// \throws Error if the axis is out of range, if the velocity is not finite, or if liquid can
  /// pass through the side and the domain is not a box
  void set_side(int axis, bool is_upper, const Side_behavior& behavior) {
    if (axis < 0 || axis >= dimension)
      throw Error("the axis of a side is out of range: use 0 for x, 1 for y, or 2 for z in space");
    for (double v : behavior.velocity.value_or(std::array<double, 3>()))
      if (!std::isfinite(v))
        throw Error("the velocity of a side is not finite: give finite coordinates");
    if (behavior.inflow || behavior.pressure)
      for (Vertex_handle v : m_complex.finite_vertices())
        if (v->boundary_class() & Boundary_class::fixed)
          throw Error(
              "the domain is not a box, so liquid cannot pass through a side: use a box, or "
              "solids and sources");
    m_sides[std::size_t(2 * axis) + is_upper] = behavior;
  }

  /// Sets the sources. The function `divergence_at(point, time)` takes a `Point` and a `double`,
  /// and returns the divergence of the velocity: the volume that a unit of volume of liquid gains
  /// in a unit of time. It is positive for inflow and negative for outflow. New liquid has the
  /// velocity of the liquid around it. The function is evaluated at the barycenter of each liquid
  /// cell, at the midpoint of the step, or of each part if the step is divided.
  ///
  /// `advance()` throws the exceptions of the function. It throws an `Error` if a divergence is not
  /// finite, or if its absolute value, multiplied by the time step, is 1 or more. `relax()` ignores
  /// sources. `state()` does not contain them, so set them again after `restore()` into a new
  /// fluid.
  template <class DivergenceAt> void set_sources(const DivergenceAt& divergence_at) {
    m_sources.divergence = [divergence_at](const Eigen::Vector3d& p, double time) {
      return divergence_at(internal::from_eigen<Point>(p), time);
    };
  }

  /// Adds a source with a given flux. The cells of liquids whose barycenters are in a region gain
  /// together the volume `flux_at(time)` in a unit of time. The function is evaluated at the
  /// midpoint of the step, or of each part if the step is divided. Each unit of their volume gains
  /// the same volume. The flux is negative for a drain. If no cell is in the region, the source has
  /// no effect, and `Report::gained_volume` is 0.
  ///
  /// New liquid, exceptions, `relax()` and `state()` are as for `set_sources()`, and the divergence
  /// has the same bound. Both kinds of sources are added.
  /// \param is_in a function that returns whether a `Point` is in the region
  /// \param flux_at a function that returns the flux at a time, a `double`
  template <class IsIn, class FluxAt> void add_source(const IsIn& is_in, const FluxAt& flux_at) {
    m_sources.fluxes.push_back(
        {[is_in](const Eigen::Vector3d& p) { return is_in(internal::from_eigen<Point>(p)); },
         flux_at});
  }

  /// Sets the acceleration of gravity for the next steps.
  /// \throws Error if a coordinate is not finite
  void set_gravity(const std::array<double, 3>& gravity) { m_properties.set_gravity(gravity); }

  /// Returns the solver of the linear systems, to be configured between steps. For example,
  /// `Saddle_point_solver::use()` replaces the default solver.
  Solver& solver() { return m_solver; }

  /// Sets the velocities of all vertices of liquids. The function `velocity_at(v)` or
  /// `velocity_at(v, label)` returns a `Vector`, the velocity at the vertex `v` of the liquid with
  /// a label. Liquids with different velocities at a common vertex slip along each other, see
  /// `velocity()`. The next step begins with a projection: it takes the nearest velocities, in the
  /// norm of the kinetic energy, that preserve volumes and enter no wall.
  /// \throws Error if a velocity is not finite. Also throws `Error`, and exceptions of functions of
  /// the user, as `advance()` does. After any exception, nothing is changed.
  template <class VelocityAt> void set_velocities(const VelocityAt& velocity_at) {
    const Flow flow(*this, m_properties);
    Vectors velocities(flow.mesh.vertices.size(), Eigen::Vector3d::Zero()), count = velocities;
    std::vector<std::pair<std::size_t, int>> places; // of velocities: a vertex and a label
    for (const auto& cell : flow.mesh.cells)
      for (auto v : cell.vertices)
        places.emplace_back(v, cell.label);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const auto& [v, label] : places) {
      const Eigen::Vector3d velocity =
          internal::eigen_vector(call(velocity_at, flow.mesh.vertices[v], label));
      if (!velocity.allFinite())
        throw Error("a velocity is not finite: give finite velocities");
      velocities[v] += velocity;
      count[v] += Eigen::Vector3d::Ones();
    }
    for (std::size_t v = 0; v < velocities.size(); ++v)
      velocities[v] = velocities[v].cwiseQuotient(count[v]);
    m_motion.stop();
    m_motion.set(flow.mesh, velocities, Vectors(velocities.size(), Eigen::Vector3d::Zero()));
    m_knows_accelerations = false;
  }

  /*!
  Sets the field that liquids carry, such as a temperature or a concentration. A fluid has one
  field. It is 0 everywhere if it is not set. The function `value_at(point)` takes a `Point` and
  returns the value at a vertex of a liquid. See `Fluid_properties::set_surface_tension()` for
  surface tensions that depend on the field.

  - A vertex keeps its value when it moves with the liquid. Where the mesh changes, the field is
    interpolated as velocities are, so its integral can change slightly.
  - At the end of a step, the field diffuses with `Liquid::diffusivity`, by the backward Euler
    method. Diffusion preserves the integral of the field. The field and its flux are continuous
    where two liquids meet. Boundaries are insulated where `fix_field()` gives no value.
  - Where two liquids slip along each other, the vertex carries the field with its own velocity.
  - Liquid of a source has the value of the liquid around it. Liquid that enters through a side has
    the values of the vertices in the inflow, which do not move: set them with `fix_field()`.
  - Vertices at which liquid leaves through a side do not move with the liquid. They take the values
    of the liquid that reaches them, by linear interpolation.
  - `relax()` moves the field, but the field does not diffuse.

  If a surface tension is negative at a field of 0, set the field before any other function is
  called. Otherwise, `advance()` and other functions throw an `Error`.

  \throws Error if a value is not finite; then nothing is changed
  */
  template <class ValueAt> void set_field(const ValueAt& value_at) {
    const Mesh mesh(updated_complex(), m_properties);
    std::vector<double> field;
    for (const Eigen::Vector3d& p : mesh.positions(m_complex)) {
      field.push_back(value_at(internal::from_eigen<Point>(p)));
      if (!std::isfinite(field.back()))
        throw Error("a value of the field is not finite: give finite values");
    }
    m_motion.set_field(mesh, field);
    m_has_field = true;
  }

  /// Gives values of the field on the boundary. The function `value_at(point, time)` takes a
  /// `Point` and a `double`. It returns a `std::optional<double>`: the value, or nothing where the
  /// boundary is insulated. Each step calls it at its end, for vertices of liquids on the sides of
  /// the domain and on free surfaces. Free surfaces include facets on solids.
  ///
  /// `advance()` throws the exceptions of the function, and an `Error` if a value is not finite.
  /// `state()` does not contain the function, so set it again after `restore()` into a new fluid.
  template <class ValueAt> void fix_field(const ValueAt& value_at) {
    m_fixed_field = [value_at](const Eigen::Vector3d& p, double time) {
      return std::optional<double>(value_at(internal::from_eigen<Point>(p), time));
    };
  }

  /// @}
  /// \name Access
  /// @{

  const Complex& complex() const { return m_complex; }          ///< Returns the complex.
  const Properties& properties() const { return m_properties; } ///< Returns the media.
  double time() const { return m_time; }                        ///< Returns the time, initially 0.
  /// Returns the velocity of a vertex of a liquid, or 0 at other vertices.
  Vector velocity(Vertex_handle v) const { return vector(m_motion.velocity(v)); }
  /// Returns the velocity of the liquid with a label at a vertex. At the interface of two liquids,
  /// it is the velocity of the vertex plus a velocity along the interface. If the liquid is not at
  /// the vertex, returns the common velocity.
  Vector velocity(Vertex_handle v, int label) const { return vector(m_motion.velocity(v, label)); }
  /// Returns the pressure at a vertex of a liquid in the last step: the mean of the pressures of
  /// the liquids around the vertex. It is 0 at other vertices and before the first step.
  double pressure(Vertex_handle v) const { return m_motion.pressure(v); }
  /// Returns the pressure of the liquid with a label at a vertex in the last step. If the liquid is
  /// not at the vertex, returns the mean pressure of the liquids around it.
  double pressure(Vertex_handle v, int label) const { return m_motion.pressure(v, label); }
  /// Returns the value of the field at a vertex of a liquid, or 0 at other vertices. See
  /// `set_field()`.
  double field(Vertex_handle v) const { return m_motion.field(v); }
  /// Returns whether the liquids carry a field.
  bool has_field() const { return m_has_field; }
  /// Returns the vorticity of the liquid in a cell: the curl of its velocity, which is linear in
  /// the cell. It is 0 if the label of the cell is not a liquid.
  /// \pre The cell is finite, and its measure is not 0.
  Vorticity vorticity(typename Complex::Cell_handle c) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    if (m_properties.liquids().count(c->subdomain_index()) > 0) {
      const Linear_element<Complex> element(m_complex, c);
      for (int i = 0; i <= dimension; ++i)
        result += internal::eigen_vector(element.gradient(i))
                      .cross(m_motion.velocity(c->vertex(i), c->subdomain_index()));
    }
    if constexpr (dimension == 2)
      return result.z();
    else
      return vector(result);
  }
  /// Returns the present balance of all liquids. Takes O(n log n) time.
  /// \throws Error, and exceptions of functions of the user, as `advance()` does
  Balance balance() const {
    const Flow flow(*this, m_properties);
    return flow.balance(*this, flow.positions, flow.velocities, m_time);
  }
  /// Returns the connected components of gases, by increasing number of component. Takes O(n log n)
  /// time.
  /// \throws Error, and exceptions of functions of the user, as `advance()` does
  std::vector<Fluid_gas> gases() const {
    if (m_properties.gases().empty())
      return {};
    const Flow flow(*this, m_properties);
    const auto components = m_gases.components_of(flow.mesh);
    std::vector<Fluid_gas> result;
    for (std::size_t k = 0; k < components.size(); ++k)
      result.push_back({flow.mesh.gases[k].component, flow.mesh.gases[k].label,
                        components[k].volume, components[k].pressure()});
    return result;
  }
  /// Returns the number of bodies.
  std::size_t number_of_bodies() const {
    return std::size_t(std::count_if(m_solids.begin(), m_solids.end(),
                                     [](const auto& solid) { return solid.body.has_value(); }));
  }
  /// Returns the present place and motion of a body, by its number.
  /// \throws Error if there is no such body
  const Rigid_body_3& body(std::size_t number) const {
    for (const auto& solid : m_solids)
      if (solid.body && number-- == 0)
        return *solid.body;
    throw Error("there is no body with this number: use a number from add_body()");
  }
  /// Returns the volume to be preserved for each connected component of a liquid, by
  /// `Complex::component()`.
  const std::map<std::uint32_t, double>& volumes() const { return m_liquids.volumes(); }

  /// Returns the depth of the deepest surface vertex in a solid, or 0 if no vertex is inside a
  /// solid. Takes O(n log n) time.
  /// \throws Error, and exceptions of functions of the user, as `advance()` does
  double depth_in_solids() const { return Flow(*this, m_properties).depth_in_solids(*this); }

  /*!
  Returns the longest time step in which no vertex of a liquid moves by more than a fraction of an
  edge. It uses the present velocities and the accelerations of the last step. At a vertex of the
  interface, the length of an edge is the length when the surface was built or last remeshed. At
  other vertices, it is `Complex::mean_interface_edge()`. If the complex was built without an
  interface on a torus, it is the edge length of a regular simplex with the mean measure of the
  cells. Returns infinity for a fluid at rest. Takes linear time.

  The result does not include the effect of solids, sides and sources that begin to move the liquid
  later.
  \pre `fraction > 0`
  \param fraction the fraction of an edge, also called CFL number. Use at most 0.25 if liquids
         collide.
  */
  double largest_step(double fraction = .25) const;

  /// @}
  /// \name Motion
  /// @{

  /*!
  Performs one time step, completely or not at all.

  Each attempt at a step is checked, and an attempt that fails is undone. An attempt fails if

  - the equations have no accurate solution, or
  - the volume of a component differs from its preserved volume by more than 0.05, relative to it,
    or
  - the energy rises by more than moving walls, bodies, sources and liquid that passes through sides
    supply, and this unexplained rise exceeds its bound. On a torus, gravity also supplies energy.
    The bound is 1e-3 if the motion causes at least half of the rise. It is 0.05 if changes of the
    mesh cause the larger part.

  Both bounds of the energy are relative to an amount of energy. This amount is the sum of the
  kinetic energy, the absolute surface energy, the potential energy above the lowest vertex, and the
  products of pressure and volume of compressible gases. On a torus, the potential energy is
  replaced by the weight of the liquids, multiplied by half of the period along gravity.

  The next attempt depends on the cause of the failure:

  - If changes of the mesh cause the larger part of the rise, the attempt is repeated with the same
    length and with the mesh preserved. The mesh then changes only where the motion is otherwise
    impossible. If this attempt fails for the same reason, the length is halved, and the mesh stays
    preserved.
  - In all other cases, the length is halved, and the mesh is improved or adapted before the next
    attempt.

  If the length is halved, the step is divided into parts. The shortest part is a 32nd of the step.
  `Report::repetitions` lists all attempts that failed. If `adaptation_interval` is 0, the mesh is
  neither adapted nor improved before an attempt.

  \param dt the length of the time step, greater than 0
  \param np named parameters: those of `deform_interface()`, except `flow` and `visitor`, and those
         with the names of the other members of `Fluid_step_options`

  \return the report of the step
  \throws Error if a parameter is out of its range, if `dt` is not positive, not finite, or too
          short to change the time, if a viscosity is negative or not finite, if sources or
          inflows change the volume of a liquid without a free surface, or if a part of a liquid
          without free vertices is in a solid by more than half an edge. Also throws the exceptions
          described at `set_side()`, `set_sources()`, `add_source()`, `fix_field()`,
          `Moving_solid_3` and `Fluid_properties::set_surface_tension()`.
  \throws Fluid_step_error if no attempt succeeds. It contains the step, the time, the cause and the
          place.

  After any exception, the fluid and the complex are in their state before the step. This includes
  exceptions of all functions of the user. The handles of the complex are invalidated if an attempt
  that was undone had changed the complex. This also holds if a later attempt succeeds.

  A step solves from two to some dozens of linear systems and deforms the complex. Its time is
  almost linear in the number of vertices of liquids.
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Report advance(double dt, const NamedParameters& np = NamedParameters()) {
    return advance(dt, options(np));
  }

  /// Performs one time step as `advance()` with named parameters does.
  /// \throws Error if an option is out of its range, see `Fluid_step_options::check()`, or as
  ///         that function does
  Report advance(double dt, const Options& options);

  /*!
  Moves the liquids to an equilibrium of forces. The function performs time steps with an
  `implicitness` of 1. Velocities are set to 0 before the first step and after each step. Between
  the steps, the interface moves to an extrapolation of the last steps (Anderson acceleration). An
  extrapolation that increases the energy is undone. The mesh is adapted at the beginning only. The
  time does not advance, and solids do not move.

  The shape converges in a few steps. Vertices converge more slowly in the directions along the
  surface.

  \param dt the length of a time step, greater than 0: about the time that a wave takes to cross the
         liquid
  \param steps the largest number of steps. Fewer steps are made if vertices come to rest up to
         rounding.
  \param np the named parameters of `advance()`
  \return the greatest velocity of a vertex in the last step
  \throws Error as `advance()` does, or if there is gravity on a torus
  \throws Convergence_error if the equations have no accurate solution

  If an argument is out of its range, or if there is gravity on a torus, nothing is changed. After
  any other exception, the complex is valid but may have changed, and the fluid is at rest.
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  double relax(double dt, unsigned steps, const NamedParameters& np = NamedParameters()) {
    return relax(dt, steps, options(np));
  }

  /// Moves the liquids to an equilibrium as `relax()` with named parameters does.
  /// \throws Error if an option is out of its range, or as that function does
  double relax(double dt, unsigned steps, Options options);

  /// @}
  /// \name Files
  /// @{

  /// Returns the state of the fluid. Together with `Complex::state()`, it permits to continue with
  /// bitwise identical results. It contains the field and the places and motions of bodies. It does
  /// not contain the media, gravity, solids, sides, sources and given values of the field. Takes
  /// O(n log n) time.
  State state() const;

  /// Restores a state of the fluid. Restore the state of the complex first, as it was when
  /// `state()` was called, and add the bodies.
  /// \throws Error if the state does not fit the complex or the bodies, or if it contains numbers that
  /// are not finite; then nothing is changed
  void restore(const State& state);

  /// @}

private:
  using Mesh = internal::Fluid_mesh<Complex>;
  using Vectors = internal::Vectors_3;
  using Liquid_bookkeeping = internal::Liquid_bookkeeping;
  using Gas_bookkeeping = internal::Gas_bookkeeping;
  using Wall = Wall_3;
  using Liquid_interface = internal::Liquid_interface<Complex>;
  using Contacts = internal::Wall_contacts<Complex>;
  using Step = internal::Fluid_step<Complex, Solver>;
  using Motion_map = internal::Fluid_motion::Map<Complex>;
  using Carrier = Carried_vertex_values<Complex, Motion_map>;
  using Energy_judge = internal::Energy_check;
  using Snapshot = internal::Fluid_snapshot<Incompressible_fluid, Complex>;

  // The mesh, positions and motion of the liquids at present.
  struct Flow : internal::Liquid_flow<Complex>
  {
    using Base = internal::Liquid_flow<Complex>;
    using Base::accelerations;
    using Base::mesh;
    using Base::positions;
    using Base::velocities;
    std::vector<double> field; // by vertex of the mesh

    Flow(const Incompressible_fluid& fluid, const Properties& properties)
        : Base{Mesh(fluid.updated_complex(), properties), {}, {}, {}} {
      positions = mesh.positions(fluid.m_complex);
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        velocities.push_back(fluid.m_motion.velocity(mesh.vertices[v], mesh.labels[v]));
        accelerations.push_back(fluid.m_motion.acceleration(mesh.vertices[v], mesh.labels[v]));
        field.push_back(fluid.m_motion.field(mesh.vertices[v]));
      }
      internal::set_tensions(mesh, properties, field);
      const internal::Open_sides open(mesh, fluid.m_sides, positions, fluid.m_time);
      keep_on_closed_sides(mesh, open, velocities);
      keep_on_closed_sides(mesh, open, accelerations);
      const auto inflow = internal::inflow_velocities(mesh, fluid.m_sides, positions, fluid.m_time);
      for (std::size_t v = 0; v < inflow.size(); ++v)
        if (inflow[v])
          velocities[v] = fluid.m_motion.velocity(mesh.vertices[v], mesh.labels[v]);
    }

    Balance balance(const Incompressible_fluid& fluid, const Vectors& at, const Vectors& with,
                    double time) const {
      const Contacts contacts(mesh, fluid.m_solids, fluid.m_complex, at, time);
      Balance result = internal::balance(mesh, fluid.m_properties, at, with,
                                         [&](std::size_t f) { return contacts.tension(f); });
      const auto gases = fluid.m_gases.components_of(mesh);
      const auto volumes = internal::volumes_of_gases(mesh, gases, positions, at);
      for (std::size_t k = 0; k < gases.size(); ++k)
        result.gas_energy += gases[k].energy(volumes[k]);
      const auto range = std::minmax_element(field.begin(), field.end());
      if (range.first != field.end())
        std::tie(result.least_field, result.greatest_field) = std::tie(*range.first, *range.second);
      for (const auto& cell : mesh.cells)
        for (auto v : cell.vertices)
          result.field_integral +=
              field[v] / Complex::corners * internal::volume(mesh.corners_at(cell.vertices, at));
      return result;
    }

    // Returns the budget of a time step that begins with the present energy.
    internal::Energy_budget budget(const Incompressible_fluid& fluid) const {
      double springs = 0;
      for (const auto& gas : fluid.m_gases.components_of(mesh))
        springs += gas.gas.exponent > 0 ? gas.pressure() * gas.volume : 0;
      const Balance begin = balance(fluid, positions, velocities, fluid.m_time);
      Eigen::Vector3d gravity(fluid.m_properties.gravity().data());
      if constexpr (Mesh::is_periodic) {
        // Gravity has no potential. The scale of energies is the same as for a full box.
        const auto periods = fluid.m_complex.domain().template periods<dimension>();
        for (std::size_t axis = 0; axis < periods.size(); ++axis)
          springs += begin.mass * std::abs(gravity[Eigen::Index(axis)]) * periods[axis] / 2;
        gravity.setZero();
      }
      return {begin, gravity, positions, springs};
    }

    typename Liquid_bookkeeping::Volumes volumes() const {
      return Liquid_bookkeeping::measure(mesh, positions);
    }

    // Returns the contacts with solids. The flow must outlive them.
    Contacts contacts(const Incompressible_fluid& fluid) const {
      return Contacts(mesh, fluid.m_solids, fluid.m_complex, positions, fluid.m_time);
    }

    // Returns the depth in a solid of the deepest vertex, or of the deepest barycenter of a cell
    // without free vertices: a solid can lie between vertices.
    double depth_in_solids(const Incompressible_fluid& fluid) const {
      const Contacts contacts = this->contacts(fluid);
      double result = 0;
      for (const Eigen::Vector3d& p : positions)
        result = (std::max)(result, contacts.depth(p, fluid.m_time));
      for (std::size_t k = 0; k < mesh.cells.size(); ++k)
        if (is_inside(contacts, k))
          result = (std::max)(result, contacts.depth(mesh.barycenter(k, positions), fluid.m_time));
      return result;
    }

    // Throws an exception if a solid is inside a liquid, where it has no effect.
    // \throws Error if a vertex or a barycenter inside a liquid is in a solid, by more than half an
    //         edge
    void require_holes(const Incompressible_fluid& fluid, const Contacts& contacts) const {
      static constexpr double deepest = .5; // in edges; the flow moves inner vertices
      const double bound = deepest * fluid.mean_edge();
      const auto check = [&](const Eigen::Vector3d& p) {
        if (contacts.depth(p, fluid.m_time) <= bound)
          return;
        std::ostringstream message;
        message << "a solid is inside a liquid near (" << p.x() << ", " << p.y() << ", " << p.z()
                << ") at time " << fluid.m_time
                << ", but solids act on free surfaces only: give the cells in the solid a label "
                   "that is not a liquid";
        throw Error(message.str());
      };
      for (std::size_t v = 0; v < positions.size(); ++v)
        if (!contacts.is_free(v))
          check(positions[v]);
      for (std::size_t k = 0; k < mesh.cells.size(); ++k)
        if (is_inside(contacts, k))
          check(mesh.barycenter(k, positions));
    }

    // Returns whether no vertex is in a solid, and no change of the mesh has moved a vertex off a
    // wall.
    bool fits_solids(const Incompressible_fluid& fluid, const Contacts& contacts) const {
      for (std::size_t v = 0; v < positions.size(); ++v)
        if ((contacts.is_free(v) && contacts.depth(positions[v], fluid.m_time) > 0) ||
            (fluid.m_motion.is_from_wall(mesh.vertices[v]) &&
             !contacts.displacement_to_wall(v, fluid.m_time).isZero(0)))
          return false;
      return true;
    }

  private:
    // Returns whether no vertex of a cell is on a free surface.
    bool is_inside(const Contacts& contacts, std::size_t k) const {
      const auto& vertices = mesh.cells[k].vertices;
      return std::none_of(vertices.begin(), vertices.end(),
                          [&](auto v) { return contacts.is_free(v); });
    }
  };

  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
  template <class VelocityAt>
  static Vector call(const VelocityAt& velocity_at, Vertex_handle v, int label) {
    if constexpr (std::is_invocable_v<const VelocityAt&, Vertex_handle, int>)
      return velocity_at(v, label);
    else
      return velocity_at(v);
  }
  static std::array<double, 7> array(const internal::Fluid_motion::Numbers& numbers) {
    std::array<double, 7> result;
    std::copy(numbers.data(), numbers.data() + numbers.size(), result.begin());
    return result;
  }
  static Vector vector(const Eigen::Vector3d& v) { return internal::from_eigen<Vector>(v); }
  static Point point(const Eigen::Vector3d& p) { return internal::from_eigen<Point>(p); }

  // Returns the length of an edge at a vertex: the initial length for vertices of the interface,
  // and the mean length of an edge of the initial interface for others.
  double edge_at(Vertex_handle v) const { return v->spacing() > 0 ? v->spacing() : mean_edge(); }

  // Returns the mean length of an edge of the initial interface. If there was none, because a
  // liquid fills a torus, returns the edge length of a regular simplex with the mean measure of the
  // cells.
  double mean_edge() const {
    // of a regular triangle and of a regular tetrahedron with edges of length 1
    static constexpr double measure = dimension == 2 ? .4330127018922193 : .1178511301977579;
    const double result = m_complex.mean_interface_edge();
    if constexpr (Mesh::is_periodic)
      if (!(result > 0))
        return std::pow(m_complex.domain().measure() /
                            (measure * double(m_complex.number_of_cells())),
                        1. / dimension);
    return result;
  }

  // Returns the complex with its components up to date. They are a cache.
  const Complex& updated_complex() const {
    m_complex.update_components();
    return m_complex;
  }

  Carrier carrier() {
    return Carrier(
        m_complex, Motion_map(m_motion),
        [this](typename Complex::Cell_handle c) {
          return m_properties.liquid(c->subdomain_index()) != nullptr;
        },
        Carried_gradient::mean); // preserves most of the kinetic energy
  }

  template <class Solid>
  static internal::Any_solid_3 any_solid(const Solid& solid, const Wall_behavior& behavior) {
    if (!(behavior.contact_angle >= 0 && behavior.contact_angle <= 180))
      throw Error("a contact angle is out of range: use 0 to 180 degrees");
    return {[solid](const Epick::Point_3& p, double t, std::vector<Wall>& walls) {
              solid.walls(p, t, walls);
            },
            std::cos(behavior.contact_angle * CGAL_PI / 180), behavior.sticks, behavior.separates};
  }
  void set_motion_of_bodies(const Contacts& contacts,
                            const std::vector<internal::Body_velocity>& velocities, bool moves);

  static void require_step(double dt) {
    if (!(dt > 0) || !std::isfinite(dt))
      throw Error("the time step is not positive and finite: use a positive, finite number");
  }

  template <class NamedParameters> Options options(const NamedParameters& np) const;
  Report advance_in_parts(const Options& chosen, double dt, const Snapshot& start);
  std::optional<Fluid_repetition> attempt(const internal::Step_plan& plan, double begin, double dt,
                                          Options chosen, Report& report);
  Fluid_repetition::Point fastest_vertex() const;
  Fluid_repetition::Point flattest_cell() const;
  void adapt(const Options& chosen, internal::Mesh_treatment treatment, Report& report);
  Improvement_report adapt_lengths(double tolerance, Deformation_visitor<Complex>* visitor);
  void make_admissible(double dt, unsigned number_of_threads, Report& report);
  void step(double dt, double end, const Options& chosen, double longest_displacement,
            Report& report, Energy_judge* judge);
  bool jumps(const Flow& flow, const Contacts& contacts, double end, Energy_judge& judge) const;
  template <class Selects>
  std::vector<char> give_field(const Mesh& mesh, const Vectors& positions, const Selects& selects,
                               std::vector<double>& field) const;
  void carry_field(const Flow& flow, const Step& step);
  void diffuse_field(Flow& flow, double dt, Report& report);
  void add_source_volumes(const Flow& flow, const Step& step, double dt, Report& report);
  Vectors shortened(Vectors destinations, const Flow& flow, double longest_displacement,
                    const Contacts& contacts) const;
  void describe(const Step& step, const Flow& flow, Report& report) const;
  Balance energies_with_gases_of(const Report& report) const;
  Flow restore_components(const Options& chosen, Report& report);
  Deformation_report<Complex> move(const Flow& flow, const Contacts& contacts,
                                   const Vectors& destinations, const Options& chosen);
  template <class Change> auto change_mesh(const Change& change);
  void restore_volumes(Flow& flow, const Options& chosen, Report& report);
  Flow move_interface(const Flow& flow, const Contacts& contacts,
                      const Eigen::VectorXd& coordinates, const Options& chosen, Report& report);
  std::vector<std::size_t> stamps_of_interface() const;
  Eigen::VectorXd coordinates_of_interface(const Eigen::VectorXd& nearby = {}) const;
  double update_components(const Mesh& mesh, const Liquid_bookkeeping::Volumes& volumes);
  double restore_momenta(Flow& flow);
  template <class MomentumOf> void record_momenta(const Flow& flow, const MomentumOf& momentum_of);

  static constexpr std::uint32_t steps_after_change = 4; // of topology: waves are then smooth
  static constexpr double implicitness_after_change = .6;
  // Relative to the volume of a component. Corrections are exact up to rounding unless walls leave
  // no room. The volume of a liquid between curved walls changes when remeshing refines the walls.
  static constexpr double largest_volume_error = .05;

  Complex& m_complex;
  Properties m_properties;
  Solver m_solver;
  typename Contacts::Solids m_solids;
  internal::Side_behaviors m_sides;
  internal::Fluid_motion m_motion;
  internal::Fluid_sources m_sources;
  // The given values of the field on the boundary; can be empty.
  std::function<std::optional<double>(const Eigen::Vector3d&, double)> m_fixed_field;
  Liquid_bookkeeping m_liquids; // the volumes and momenta of connected components
  Gas_bookkeeping m_gases;
  double m_time = 0;
  std::uint64_t m_steps = 0;
  std::uint32_t m_damped_steps = 0;
  bool m_knows_accelerations = false, m_has_field = false;
};

} // namespace CGAL::Deformable_simplicial_complexes

#include <CGAL/Incompressible_fluids_3/internal/fluid/Incompressible_fluid_attempts_impl.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Incompressible_fluid_impl.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Incompressible_fluid_mesh_impl.h>

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INCOMPRESSIBLE_FLUID_H

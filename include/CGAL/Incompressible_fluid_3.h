// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUID_3_H
#define CGAL_INCOMPRESSIBLE_FLUID_3_H

#include <CGAL/Deformable_simplicial_complexes/Carried_vertex_values.h>
#include <CGAL/Deformable_simplicial_complexes/Curvature_sizing_field.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_adaptation.h>
#include <CGAL/Deformable_simplicial_complexes/control_detail.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>
#include <CGAL/Deformable_simplicial_complexes/improve_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>
#include <CGAL/Incompressible_fluids_3/Fluid_properties_3.h>
#include <CGAL/Incompressible_fluids_3/Fluid_report_3.h>
#include <CGAL/Incompressible_fluids_3/Fluid_state_3.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_solver.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Energy_check_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Fixed_point_accelerator.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Fluid_motion_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Fluid_snapshot_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Gas_bookkeeping_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Liquid_bookkeeping_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Liquid_interface_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Step_plan_3.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Component_momenta_3.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Fluid_step_3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

Incompressible flow of any number of liquids with free surfaces, surface tension, viscosity and
solids (section 4.4 of the paper; M. K. Misztal, R. Bridson, K. Erleben, J. A. Bærentzen, F. Anton,
"Optimization-based fluid simulation on unstructured meshes", VRIPHYS 2010), by linear finite
elements on the tetrahedra of a complex, which go with the flow.

Labels are liquids, gases or void, see `Fluid_properties_3`. A step solves for velocities and
pressures at once, in the middle of the step, so that energy neither grows nor fades but for
viscosity and what changes of the mesh take; surface tension is implicit and bounds no step. The
volume of each connected part of a liquid stays what it was to rounding, but for what sources bring;
parts that merge add theirs. So do momenta, but for what gravity, gases, walls and sources give.
Where liquids lie on sides of the domain, which must be a box for that, they slide along them and do
not leave them; other surfaces keep off by a quarter of an edge, as from a wall. The surface of a
liquid never enters a solid with a vertex; it may touch and leave it, see `Wall_behavior`.

All is in the coordinates of the complex, in any units that fit together.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Solver model of `SaddlePointSolver`
*/
template <class Complex, class Solver = Saddle_point_solver> class Incompressible_fluid
{
  static_assert(Complex::Domain::has_outside, "fluids on tori are not supported");

public:
  using Point = Simple_cartesian<double>::Point_3;       ///< of space
  using Vector = Simple_cartesian<double>::Vector_3;     ///< of space
  using Vertex_handle = typename Complex::Vertex_handle; ///< of the complex
  using Properties = Fluid_properties_3;                 ///< of labels
  using Balance = Fluid_balance_3;                       ///< of all liquids
  using Report = Fluid_report_3<Complex>;                ///< of a step
  using State = Fluid_state_3;                           ///< to go on from

  /// \name Creation
  /// @{

  /// A fluid at rest. Its volumes are those of now. The complex must outlive it, and be changed by
  /// it only. \throws Error if there are no liquids, or no interface of one. n log n.
  Incompressible_fluid(Complex& complex, const Properties& properties)
      : m_complex(complex), m_properties(properties) {
    if (properties.liquids().empty())
      throw Error("there is no liquid: tell the density of a label at least");
    const Flow flow(*this, m_properties);
    if (flow.mesh.facets.empty())
      throw Error(flow.mesh.cells.empty()
                      ? "no cell has the label of a liquid"
                      : "liquids fill the domain and have no surface that could move");
    m_complex.take_component_lineage();
    m_ledger.set_volumes(flow.volumes());
    m_gas_ledger.set_bodies(Gas_bookkeeping::measure(flow.mesh, m_properties));
  }

  /// Not to be copied.
  Incompressible_fluid(const Incompressible_fluid&) = delete;
  /// Not to be copied.
  Incompressible_fluid& operator=(const Incompressible_fluid&) = delete;

  /// Adds a solid, which is copied. \tparam Solid model of `Solid_3`
  /// \throws Error if the contact angle is out of its range
  template <class Solid> void add_solid(const Solid& solid, const Wall_behavior& behavior = {}) {
    if (!(behavior.contact_angle >= 0 && behavior.contact_angle <= 180))
      throw Error("a contact angle is out of range: use 0 to 180 degrees");
    m_solids.push_back(
        {[solid](const Point& p, double t, std::vector<Wall>& walls) { solid.walls(p, t, walls); },
         std::cos(behavior.contact_angle * CGAL_PI / 180), behavior.sticks, behavior.separates});
  }

  /// Sets sources: `divergence_at(point, time)`, of `Point` and `double`, is what a unit of volume
  /// of liquid gains there in a unit of time, with the velocity that it has there: inflow if
  /// positive, outflow if negative. It counts in the middle of each cell, half-way in each step. To
  /// be set again for a new object that is to `restore()`. What it throws, `advance()` does, and an
  /// `Error` if it is not finite or, times the step, not between -1 and 1; `relax()` leaves it out.
  template <class DivergenceAt> void set_sources(const DivergenceAt& divergence_at) {
    m_source = divergence_at;
  }

  /// Sets the velocities of all vertices: `velocity_at(v)` is a `Vector`. The next step begins with
  /// the nearest ones, as masses weigh them, that keep volumes and enter no wall.
  /// \throws Error if one is not finite; nothing is changed then
  template <class VelocityAt> void set_velocities(const VelocityAt& velocity_at) {
    internal::Fluid_motion_3 motion;
    for (Vertex_handle v : m_complex.vertices()) {
      const Eigen::Vector3d velocity = internal::eigen_vector(velocity_at(v));
      if (!velocity.allFinite())
        throw Error("a velocity is not finite");
      motion.set(v, velocity, Eigen::Vector3d::Zero());
    }
    m_motion = std::move(motion);
    m_knows_accelerations = false;
  }

  /// @}
  /// \name Access
  /// @{

  const Complex& complex() const { return m_complex; }          ///< what moves
  const Properties& properties() const { return m_properties; } ///< of labels
  double time() const { return m_time; }                        ///< 0 in the beginning
  /// Of a vertex of a liquid.
  Vector velocity(Vertex_handle v) const { return vector(m_motion.velocity(v)); }
  /// Of a vertex of a liquid, in the last step: the mean of the pressures of the liquids around it.
  /// 0 before the first step.
  double pressure(Vertex_handle v) const { return m_motion.pressure(v); }
  /// What all liquids have now. n log n.
  Balance balance() const {
    const Flow flow(*this, m_properties);
    return flow.balance(*this, flow.positions, flow.velocities, m_time);
  }
  /// The connected parts of gases, by component. n log n.
  std::vector<Fluid_gas_3> gases() const {
    if (m_properties.gases().empty())
      return {};
    const Flow flow(*this, m_properties);
    const auto bodies = m_gas_ledger.bodies_of(flow.mesh);
    std::vector<Fluid_gas_3> result;
    for (std::size_t k = 0; k < bodies.size(); ++k)
      result.push_back({flow.mesh.gases[k].component, flow.mesh.gases[k].label, bodies[k].volume,
                        bodies[k].pressure()});
    return result;
  }
  /// The volumes that the connected parts of liquids are to have, by `Complex::component()`.
  const std::map<std::uint32_t, double>& volumes() const { return m_ledger.volumes(); }

  /// How deep a vertex of a liquid's surface is in a solid, the most; 0 if none is. n log n.
  double depth_in_solids() const { return Flow(*this, m_properties).depth_in_solids(*this); }

  /*!
  The longest step in which no vertex of a liquid goes farther than a part of the edges of the
  interface: of those that its surface had there when it was built or last made finer or coarser,
  inside of their mean. Infinite at rest. Linear.
  \param part "CFL number"; .25 where liquids collide
  */
  double largest_step(double part = .25) const;

  /// @}
  /// \name Motion
  /// @{

  /*!
  One step of time. It happens whole, or not at all.

  A step is undone if its equations have no accurate solution, or if the energy rises, by more than
  forces and sources explain, by more than 1e-3. The unit of that is the energy: kinetic energy,
  tension times area, the potential above the lowest vertex, and pressure times volume of gases that
  are compressible. A step that was undone is repeated: first with the mesh preserved, if only
  changes of the mesh raise the energy, else after remeshing and in parts of half the length, down
  to a 32nd of the step. `Report::repetitions` tells all attempts that failed. With an
  `adaptation_interval` of 0, nothing is remeshed.

  \param dt its length, positive.
  \param np named parameters: `number_of_threads`, `quality_threshold`, `minimum_angle`,
         `minimum_facet_angle`, `relabeling_threshold`, `topology_control` and `manifold_interface`
  of `deform_interface()`, and

  \cgalNamedParamsBegin
    \cgalParamNBegin{implicitness}
      \cgalParamDescription{when in the step forces are taken, in [0.5, 1]: 0.5, half-way, keeps
                            energy, 1 loses most of what oscillates. In the four steps after a
  change of topology 0.6 at least.}
      \cgalParamType{`double`} \cgalParamDefault{0.5}
    \cgalParamNEnd
    \cgalParamNBegin{interface_tolerance}
      \cgalParamDescription{how far edges of the interface may lie from a smooth surface, in units of
                            `mean_interface_edge()`: it is made finer and coarser if worn, as by
                            `advect_adaptively()`; 0 leaves it as it is}
      \cgalParamType{`double`} \cgalParamDefault{0.04}
    \cgalParamNEnd
    \cgalParamNBegin{adaptation_interval}
      \cgalParamDescription{number of steps from one that adapts the mesh to the next, the first one
                            being one; 0 never adapts it}
      \cgalParamType{`unsigned int`} \cgalParamDefault{4}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return what it did.
  \throws Error if a parameter is out of its range or `dt` too short to change the time.
  \throws Fluid_step_error if no attempt succeeds: it tells the step, the time, the cause and the
          place.

  Whatever is thrown, also by `topology_control`, sources or a `Progress_scope`, the fluid and the
  complex are in their state before the step. Handles of the complex are invalidated if the step had
  changed it, also if it was repeated then.

  Some dozens of iterations of a linear solver, almost linear in the number of vertices of liquids,
  and the deformation.
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Report advance(double dt, const NamedParameters& np = NamedParameters()) {
    return advance_with(options(np), dt);
  }

  /*!
  Takes liquids to rest, where forces balance: steps of full implicitness, velocities dropped before
  the first one and after each, and between them jumps to where the last steps lead, unless energy
  would grow. The mesh is adapted in the beginning only. Time stands still, and so do solids. What
  is round is round after some steps; that vertices of the surface rest along it, to ten digits,
  takes a hundred.
  \param dt of a step: about that of a wave over the liquid
  \param steps at the most; fewer if vertices come to rest up to rounding
  \param np the named parameters of `advance()`
  \return the velocity, at the most, by which vertices still went in the last step
  \throws Error as `advance()` does, and Convergence_error if equations cannot be solved; the complex
          is valid then, and nothing moves
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  double relax(double dt, unsigned steps, const NamedParameters& np = NamedParameters()) {
    return relax_with(options(np), dt, steps);
  }

  /// @}
  /// \name Files
  /// @{

  /// What to put aside, besides `Complex::state()`, to go on to the same bits. n log n.
  State state() const;

  /// Goes on from what `state()` was, with the complex restored to its state of then.
  /// \throws Error if it is none of the complex, or numbers are not
  /// finite; nothing is changed then
  void restore(const State& state);

  /// @}

private:
  using Mesh = internal::Fluid_mesh_3<Complex>;
  using Vectors = internal::Vectors_3;
  using Ledger = internal::Liquid_bookkeeping_3;
  using Gas_bookkeeping = internal::Gas_bookkeeping_3;
  using Wall = Wall_3;
  using Part_interface = internal::Liquid_interface_3<Complex>;
  using Contacts = internal::Wall_contacts_3<Complex>;
  using Step = internal::Fluid_step_3<Complex, Solver>;
  using Approximate_point = typename Complex::Approximate_point;
  using Motion_map = internal::Fluid_motion_3::Map<Complex>;
  using Carrier = Carried_vertex_values<Complex, Motion_map>;
  using Energy_judge = internal::Energy_check_3;
  using Snapshot = internal::Fluid_snapshot_3<Incompressible_fluid, Complex>;

  // The liquids as they are.
  struct Flow
  {
    Mesh mesh;
    Vectors positions, velocities, accelerations;

    Flow(const Incompressible_fluid& fluid, const Properties& properties)
        : mesh(fluid.updated_complex(), properties), positions(mesh.positions(fluid.m_complex)) {
      for (Vertex_handle v : mesh.vertices) {
        velocities.push_back(fluid.m_motion.velocity(v));
        accelerations.push_back(fluid.m_motion.acceleration(v));
      }
      mesh.keep_on_sides(velocities);
      mesh.keep_on_sides(accelerations);
    }

    Balance balance(const Incompressible_fluid& fluid, const Vectors& at, const Vectors& with,
                    double time) const {
      const Contacts contacts(mesh, fluid.m_solids, fluid.m_complex, at, time);
      Balance result = internal::balance(mesh, fluid.m_properties, at, with, [&](std::size_t f) {
        return contacts.tension(mesh.facets[f]);
      });
      const auto gases = fluid.m_gas_ledger.bodies_of(mesh);
      const auto volumes = internal::volumes_of_gases(mesh, gases, positions, at);
      for (std::size_t k = 0; k < gases.size(); ++k)
        result.gas_energy += gases[k].energy(volumes[k]);
      return result;
    }

    // With the energy of now.
    internal::Energy_budget_3 budget(const Incompressible_fluid& fluid) const {
      double springs = 0;
      for (const auto& gas : fluid.m_gas_ledger.bodies_of(mesh))
        springs += gas.gas.exponent > 0 ? gas.pressure() * gas.volume : 0;
      return {balance(fluid, positions, velocities, fluid.m_time),
              Eigen::Vector3d(fluid.m_properties.gravity().data()), positions, springs};
    }

    typename Ledger::Volumes volumes() const { return Ledger::measure(mesh, positions); }

    double depth_in_solids(const Incompressible_fluid& fluid) const {
      const Contacts contacts(mesh, fluid.m_solids, fluid.m_complex, positions, fluid.m_time);
      double result = 0;
      for (std::size_t v = 0; v < positions.size(); ++v)
        result = (std::max)(result, contacts.depth(v, positions[v], fluid.m_time));
      return result;
    }
  };

  struct Options
  {
    internal::Deformation_options<Complex> deformation;
    double implicitness, interface_tolerance;
    unsigned adaptation_interval, number_of_threads;

    // Changes of the mesh only where the motion is impossible otherwise.
    void preserve_mesh() {
      deformation.quality_threshold = deformation.relabeling_threshold = 0;
      deformation.minimum_angle = deformation.minimum_facet_angle = 0;
    }

    // For deformations.
    auto parameters() const {
      return Deformable_simplicial_complexes::parameters::quality_threshold(
                 deformation.quality_threshold)
          .relabeling_threshold(deformation.relabeling_threshold)
          .minimum_angle(deformation.minimum_angle)
          .minimum_facet_angle(deformation.minimum_facet_angle)
          .manifold_interface(deformation.manifold_interface)
          .collision_order(deformation.collision_order)
          .topology_control(deformation.topology_control)
          .number_of_threads(number_of_threads);
    }
  };

  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
  static Vector vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
  static Approximate_point point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

  // How long edges of the interface are there, inside of liquids about so.
  double edge_at(Vertex_handle v) const {
    return v->spacing() > 0 ? v->spacing() : m_complex.mean_interface_edge();
  }

  // Numbers of components are caches of the complex.
  const Complex& updated_complex() const {
    m_complex.update_components();
    return m_complex;
  }

  Carrier carrier() {
    return Carrier(m_complex, Motion_map(m_motion), [this](typename Complex::Cell_handle c) {
      return m_properties.liquid(c->label()) != nullptr;
    });
  }

  static void require_step(double dt) {
    if (!(dt > 0) || !std::isfinite(dt))
      throw Error("the step of time is not positive and finite");
  }

  template <class NamedParameters> Options options(const NamedParameters& np) const;
  Report advance_with(const Options& chosen, double dt);
  Report advance_in_parts(const Options& chosen, double dt, const Snapshot& start);
  std::optional<Fluid_repetition_3> attempt(const internal::Step_plan_3& plan, double begin,
                                            double dt, Options chosen, Report& report);
  Point fastest_vertex() const;
  Point flattest_cell() const;
  double relax_with(Options chosen, double dt, unsigned steps);
  void adapt(const Options& chosen, internal::Mesh_treatment_3 treatment, Report& report);
  template <class Visitor>
  Improvement_report adapt_lengths(double tolerance, const Visitor& visitor);
  void make_admissible(double dt, unsigned number_of_threads, Report& report);
  void step(double dt, double end, const Options& chosen, double longest_way, Report& report,
            Energy_judge* judge);
  void own_gains(const Flow& flow, const Step& step, double dt, Report& report);
  Vectors shortened(Vectors destinations, const Flow& flow, double longest_way,
                    const Contacts& contacts) const;
  void describe(const Step& step, const Flow& flow, Report& report) const;
  Balance energies_with_gases_of(const Report& report) const;
  void store(const Flow& flow, const Vectors& velocities, const std::vector<double>& pressures,
             double dt);
  Flow settle(const Options& chosen, Report& report);
  Deformation_report<Complex> move(const Flow& flow, const Contacts& contacts,
                                   const Vectors& destinations, const Options& chosen);
  template <class Change> auto change_followed(const Change& change);
  void restore_volumes(Flow& flow, const Options& chosen, Report& report);
  Flow move_interface(const Flow& flow, const Eigen::VectorXd& coordinates, const Options& chosen,
                      Report& report);
  std::vector<std::size_t> stamps_of_interface() const;
  Eigen::VectorXd coordinates_of_interface() const;
  double follow_parts(const Flow& now);
  double restore_momenta(Flow& flow);
  template <class MomentumOf> void note_momenta(const Flow& flow, const MomentumOf& momentum_of);

  static constexpr std::uint32_t steps_after_change = 4; // of topology, until waves are smooth
  static constexpr double implicitness_after_change = .6;

  Complex& m_complex;
  Properties m_properties;
  Solver m_solver;
  typename Contacts::Solids m_solids;
  internal::Fluid_motion_3 m_motion;
  typename Step::Source m_source;
  Ledger m_ledger; // of connected parts
  Gas_bookkeeping m_gas_ledger;
  double m_time = 0;
  std::uint64_t m_steps = 0;
  std::uint32_t m_damped_steps = 0;
  bool m_knows_accelerations = false;
};

} // namespace Deformable_simplicial_complexes

/// \ingroup PkgIncompressibleFluids3Ref
/// Incompressible flow in a complex, see `Deformable_simplicial_complexes::Incompressible_fluid`.
template <class Complex, class Solver = Deformable_simplicial_complexes::Saddle_point_solver>
using Incompressible_fluid_3 =
    Deformable_simplicial_complexes::Incompressible_fluid<Complex, Solver>;

} // namespace CGAL

#include <CGAL/Incompressible_fluids_3/internal/fluid/Incompressible_fluid_attempts_impl.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Incompressible_fluid_impl.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Incompressible_fluid_mesh_impl.h>

#endif // CGAL_INCOMPRESSIBLE_FLUID_3_H

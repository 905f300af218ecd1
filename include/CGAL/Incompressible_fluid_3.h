// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUID_3_H
#define CGAL_INCOMPRESSIBLE_FLUID_3_H

#include <CGAL/Deformable_simplicial_complex_3/Fluid_properties_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Fluid_report_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Saddle_point_solver.h>
#include <CGAL/Deformable_simplicial_complex_3/Solids_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/fluids/Body_momenta_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/fluids/Component_volumes_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/fluids/Fluid_motion_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/fluids/Fluid_step_3.h>
#include <CGAL/Deformable_simplicial_complexes/Carried_vertex_values.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Volume_changer.h>

namespace CGAL {

template <class Complex_, class Solver_ = Deformable_simplicial_complexes::Direct_saddle_point_solver>
class Incompressible_fluid_3
{
public:
  using Complex = Complex_;
  using Solver = Solver_;
  using Vector = Simple_cartesian<double>::Vector_3;
  using Point = Simple_cartesian<double>::Point_3;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Properties = Deformable_simplicial_complexes::Fluid_properties_3;
  using Report = Fluid_report_3<Complex>;

  Incompressible_fluid_3(Complex& complex, const Properties& properties)
      : m_complex(complex), m_properties(properties) {
    m_complex.take_component_lineage();
    m_volumes.set_wanted(Volumes::measure(m_complex, m_properties));
  }

  template <class Solid>
  void add_solid(const Solid& solid, double contact_angle = 90, bool sticks = false,
                 bool separates = true) {
    m_solids.push_back({[solid](const Point& p, double t, std::vector<Wall>& walls) {
                          solid.walls(p, t, walls);
                        },
                        std::cos(contact_angle * CGAL_PI / 180), sticks, separates});
  }

  template <class VelocityAt> void set_velocities(const VelocityAt& velocity_at) {
    for (Vertex_handle v : m_complex.vertices())
      m_motion.set(v, Deformable_simplicial_complexes::internal::eigen_vector(velocity_at(m_complex.position(v))),
                   Eigen::Vector3d::Zero());
    m_knows_accelerations = false;
  }

  double time() const { return m_time; }
  Vector velocity(Vertex_handle v) const { return vector(m_motion.velocity(v)); }

  Report advance(double dt, double theta = .5, unsigned threads = 1) {
    Report report;
    report.dt = dt;
    m_complex.update_components();
    const Mesh mesh(m_complex, m_properties);
    const Vectors positions = mesh.positions(m_complex);
    Vectors velocities, accelerations;
    for (Vertex_handle v : mesh.vertices) {
      velocities.push_back(m_motion.velocity(v));
      accelerations.push_back(m_motion.acceleration(v));
    }
    Deformable_simplicial_complexes::internal::Fluid_step_3<Complex, Solver> step(mesh, m_properties, m_solids, m_complex, m_solver,
                                                 {dt, theta}, m_time, positions, velocities,
                                                 accelerations);
    step.solve(2, m_knows_accelerations);
    m_knows_accelerations = true;
    m_time += dt;

    const Vectors after = step.final_velocities();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      m_motion.set(mesh.vertices[v], after[v], (after[v] - velocities[v]) / dt);
    Vectors destinations = step.destinations();
    step.contacts().put_out(destinations, m_time);
    // Momenta are of parts that have to do with each other; which ones, is known afterwards.
    const auto set_of_component = [](std::uint32_t component) { return std::size_t(component); };
    const std::size_t number_of_components = count_components(mesh);
    const auto bodies = Deformable_simplicial_complexes::internal::masses_of_sets(mesh, positions, number_of_components,
                                                 set_of_component);
    std::vector<Deformable_simplicial_complexes::internal::Momentum_3> before;
    for (const auto& body : bodies)
      before.push_back(step.final_momentum(body));

    report.deformation = move(mesh, destinations, step.contacts(), threads);
    const Deformable_simplicial_complexes::internal::Component_groups_3 groups(m_complex.take_component_lineage());
    report.lost_volume = m_volumes.follow(groups, Volumes::measure(m_complex, m_properties));
    report.volume_error = correct_volumes(threads);
    report.correction = restore_momenta(groups, before);
    report.iterations = step.iterations();
    report.solutions = step.solutions();
    report.held = step.contacts().number_of_held();
    for (const auto& force : step.contacts().forces(step.reactions()))
      report.forces_on_solids.push_back(vector(force));
    for (std::size_t v = 0; v < after.size(); ++v)
      report.change_of_velocity = (std::max)(report.change_of_velocity, (after[v] - velocities[v]).norm());
    measure(report);
    return report;
  }

  // Energies, momentum and volumes of now.
  void measure(Report& report) const {
    const Mesh mesh(m_complex, m_properties);
    const Vectors positions = mesh.positions(m_complex);
    const Eigen::Vector3d gravity(m_properties.gravity().data());
    const auto body = Deformable_simplicial_complexes::internal::masses_of_sets(mesh, positions, 1, [](std::uint32_t) { return 0; });
    Vectors velocities;
    for (Vertex_handle v : mesh.vertices)
      velocities.push_back(m_motion.velocity(v));
    const Deformable_simplicial_complexes::internal::Momentum_3 sum = Deformable_simplicial_complexes::internal::momentum(body[0], positions, velocities);
    report.time = m_time;
    report.momentum = vector(sum.linear);
    report.angular_momentum = vector(sum.angular);
    report.kinetic_energy = report.potential_energy = report.surface_energy = 0;
    for (const auto& [v, m] : body[0]) {
      report.kinetic_energy += m * velocities[v].squaredNorm() / 2;
      report.potential_energy -= m * gravity.dot(positions[v]);
      report.fastest = (std::max)(report.fastest, velocities[v].norm());
    }
    const Deformable_simplicial_complexes::internal::Wall_contacts_3<Complex> contacts(mesh, m_solids, m_complex, positions, m_time);
    for (const auto& facet : mesh.facets) {
      const std::size_t solid = contacts.solid_of(facet);
      const auto& v = facet.vertices;
      const double area = (positions[v[1]] - positions[v[0]]).cross(positions[v[2]] - positions[v[0]]).norm() / 2;
      report.surface_energy += area * facet.tension *
                               (solid == m_solids.size() ? 1 : -m_solids[solid].cosine);
    }
  }

private:
  using Mesh = Deformable_simplicial_complexes::internal::Fluid_mesh_3<Complex>;
  using Vectors = Deformable_simplicial_complexes::internal::Vectors_3;
  using Volumes = Deformable_simplicial_complexes::internal::Component_volumes_3;
  using Wall = Deformable_simplicial_complexes::Wall_3;
  using Snapshot = Deformable_simplicial_complexes::Interface_snapshot<Complex>;
  using Contacts = Deformable_simplicial_complexes::internal::Wall_contacts_3<Complex>;
  using Approximate_point = typename Complex::Approximate_point;

  static Vector vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

  static std::size_t count_components(const Mesh& mesh) {
    std::size_t result = 0;
    for (const auto& cell : mesh.cells)
      result = (std::max)(result, std::size_t(cell.component) + 1);
    return result;
  }

  // The interface, whose sides are connected parts of liquids instead of labels, -1 for void.
  Snapshot interface_of_components() const {
    Snapshot result(m_complex);
    const auto facets = m_complex.interface_facets();
    const auto part = [&](typename Complex::Cell_handle c) {
      return m_properties.liquid(c->label()) ? int(c->component()) : -1;
    };
    for (std::size_t i = 0; i < facets.size(); ++i) {
      result.triangles[i].behind = part(facets[i].first);
      result.triangles[i].in_front = part(facets[i].first->neighbor(facets[i].second));
    }
    return result;
  }

  // Moves the interface so that parts have the volumes that they are to have, vertices at walls
  // along them only.
  template <class IsHeld>
  void add_volumes(const Snapshot& interface_, const std::map<int, double>& missing,
                   const IsHeld& is_held, std::vector<Approximate_point>& positions) const {
    Deformable_simplicial_complexes::internal::Volume_changer<Complex> changer(interface_);
    auto directions = changer.gradients(missing, positions);
    std::vector<double> areas(positions.size(), 0);
    for (const auto& facet : interface_.triangles) {
      const auto &a = positions[facet.vertices[0]], &b = positions[facet.vertices[1]],
                 &c = positions[facet.vertices[2]];
      const double area = std::sqrt(cross_product(b - a, c - a).squared_length()) / 6;
      for (std::size_t v : facet.vertices)
        areas[v] += area;
    }
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (auto& [row, direction] : directions[v])
        direction = is_held(v) || !(areas[v] > 0) ? typename Complex::Approximate_vector(0, 0, 0)
                                                  : direction / areas[v];
    changer.change_by(missing, directions, positions);
  }

  Deformation_report<Complex> move(const Mesh& mesh, const Vectors& destinations,
                                   const Contacts& contacts, unsigned threads) {
    const Snapshot interface_ = interface_of_components();
    // The numbers of the mesh, of the interface's vertices and of others.
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      mesh.vertices[v]->set_scratch_index(std::uint32_t(v));
    const auto number = [&](Vertex_handle v) -> std::size_t {
      const std::size_t i = v->scratch_index();
      return i < mesh.vertices.size() && mesh.vertices[i] == v ? i : mesh.vertices.size();
    };
    std::vector<Approximate_point> targets;
    std::vector<char> is_held;
    for (Vertex_handle v : interface_.vertices) {
      const std::size_t i = number(v);
      if (i == mesh.vertices.size()) {
        targets.push_back(m_complex.position(v));
        is_held.push_back(false);
      } else {
        targets.push_back(point(destinations[i]));
        is_held.push_back(contacts.is_held(i));
      }
    }
    std::map<std::size_t, Approximate_point> flow;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if (!mesh.is_on_interface[i])
        flow.emplace(mesh.vertices[i]->time_stamp(), point(destinations[i]));
    const Deformable_simplicial_complexes::internal::Volume_changer<Complex> changer(interface_);
    const auto swept = changer.changes(interface_.positions(m_complex), targets);
    std::map<int, double> missing;
    const auto present = Volumes::measure(m_complex, m_properties);
    for (const auto& [component, volume] : m_volumes.wanted()) {
      const auto change = swept.find(int(component));
      missing[int(component)] = volume - present.at(component) - (change == swept.end() ? 0 : change->second);
    }
    add_volumes(interface_, missing, [&](std::size_t v) { return is_held[v] != 0; }, targets);
    Carrier carrier(m_complex, Map(m_motion), is_liquid());
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return deform_interface_to(
        m_complex, interface_, targets,
        Deformable_simplicial_complexes::parameters::flow([&flow](Vertex_handle v) {
          const auto found = flow.find(v->time_stamp());
          return found == flow.end() ? Approximate_point(unknown, unknown, unknown) : found->second;
        }).number_of_threads(threads).visitor(std::ref(carrier)));
  }

  // Again where the mesh was changed on the way. Returns the largest relative error of before.
  double correct_volumes(unsigned threads) {
    static constexpr double rounding = 1e-13;
    static constexpr int rounds = 3;
    double error = 0;
    for (int k = 0; k < rounds; ++k) {
      const auto present = Volumes::measure(m_complex, m_properties);
      std::map<int, double> missing;
      double worst = 0;
      for (const auto& [component, volume] : m_volumes.wanted()) {
        missing[int(component)] = volume - present.at(component);
        worst = (std::max)(worst, std::abs(volume - present.at(component)) / volume);
      }
      if (k == 0)
        error = worst;
      if (worst <= rounding)
        break;
      const Mesh mesh(m_complex, m_properties);
      const Contacts contacts(mesh, m_solids, m_complex, mesh.positions(m_complex), m_time);
      std::map<std::size_t, char> touches;
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (contacts.touches(v))
          touches[mesh.vertices[v]->time_stamp()] = true;
      const Snapshot interface_ = interface_of_components();
      auto targets = interface_.positions(m_complex);
      add_volumes(interface_, missing,
                  [&](std::size_t v) { return touches.count(interface_.vertices[v]->time_stamp()) > 0; },
                  targets);
      Carrier carrier(m_complex, Map(m_motion), is_liquid());
      deform_interface_to(m_complex, interface_, targets,
                          Deformable_simplicial_complexes::parameters::quality_threshold(0.).relabeling_threshold(0.)
                              .minimum_angle(0.).minimum_facet_angle(0.).number_of_threads(threads)
                              .visitor(std::ref(carrier)));
      const Deformable_simplicial_complexes::internal::Component_groups_3 groups(m_complex.take_component_lineage());
      m_volumes.follow(groups, Volumes::measure(m_complex, m_properties));
    }
    return error;
  }

  // Gives parts the momenta back that they had before the mesh was changed. Returns the largest
  // change of a velocity.
  double restore_momenta(const Deformable_simplicial_complexes::internal::Component_groups_3& groups,
                         const std::vector<Deformable_simplicial_complexes::internal::Momentum_3>& before) {
    std::vector<Deformable_simplicial_complexes::internal::Momentum_3> wanted(groups.size());
    for (std::size_t component = 0; component < before.size(); ++component)
      if (const auto group = groups.then(std::uint32_t(component))) {
        wanted[*group].linear += before[component].linear;
        wanted[*group].angular += before[component].angular;
      }
    const Mesh mesh(m_complex, m_properties);
    const Vectors positions = mesh.positions(m_complex);
    Vectors velocities;
    for (Vertex_handle v : mesh.vertices)
      velocities.push_back(m_motion.velocity(v));
    const auto bodies =
        Deformable_simplicial_complexes::internal::masses_of_sets(mesh, positions, groups.size(), [&](std::uint32_t component) {
          return groups.now(component).value_or(0);
        });
    double result = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      Deformable_simplicial_complexes::internal::Momentum_3 missing = Deformable_simplicial_complexes::internal::momentum(bodies[k], positions, velocities);
      missing.linear = wanted[k].linear - missing.linear;
      missing.angular = wanted[k].angular - missing.angular;
      const auto correction = Deformable_simplicial_complexes::internal::rigid_velocity(bodies[k], positions, missing);
      for (const auto& [v, m] : bodies[k]) {
        const Eigen::Vector3d change = correction.at(positions[v]);
        result = (std::max)(result, change.norm());
        m_motion.set(mesh.vertices[v], velocities[v] + change, m_motion.acceleration(mesh.vertices[v]));
      }
    }
    return result;
  }

  static Approximate_point point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

  using Map = Deformable_simplicial_complexes::internal::Fluid_motion_3::Map<Complex>;
  using Carrier = Deformable_simplicial_complexes::Carried_vertex_values<Complex, Map>;

  auto is_liquid() const {
    return [this](typename Complex::Cell_handle c) { return m_properties.liquid(c->label()) != nullptr; };
  }

  Complex& m_complex;
  Properties m_properties;
  Solver m_solver;
  std::vector<Deformable_simplicial_complexes::internal::Any_solid_3> m_solids;
  Deformable_simplicial_complexes::internal::Fluid_motion_3 m_motion;
  Volumes m_volumes;
  double m_time = 0;
  bool m_knows_accelerations = false;
};

} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUID_3_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_WALL_CONTACTS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_WALL_CONTACTS_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/side_velocities.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Body_equations.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Body_motion.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Vertex_constraints.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A solid and its boundary conditions.
struct Any_solid_3
{
  using Point = Epick::Point_3;

  std::function<void(const Point&, double, std::vector<Wall_3>&)> walls;
  double cosine;  // of the contact angle
  bool sticks;    // no-slip
  bool separates; // the liquid may leave the wall
  // The body that liquids move. The solid is the body before any rotation, with its initial center.
  std::optional<Rigid_body_3> body = {};
  Rigid_body_3::Point initial_center = ORIGIN;
};

// The contacts of the surface of liquids with solids. A vertex must not enter a solid, and only
// vertices that would enter a solid are constrained. These vertices are found by iteration, see
// `revise()`. The sides of the domain are walls for the vertices that do not lie on them. These
// vertices keep a distance, because the mesh needs space there.
//
// A slip wall must exert no force along itself. The direction of a constraint is therefore the
// gradient of the volume of liquids at the midpoint of the step: the sum of the area vectors of the
// facets around the vertex that the wall wets. Then a constant pressure along the wall has no
// effect on the motion. If other facets end at the vertex, the direction is the normal of the wall
// at the midpoint. The length of the motion along this direction brings the vertex onto the wall.
//
// The walls of a rigid body are those of its present motion, see `set_velocities_of_bodies()`. The
// constraints of its vertices are linear in its unknown velocities.
template <class Complex> class Wall_contacts
{
public:
  using Mesh = Fluid_mesh<Complex>;
  using Solids = std::vector<Any_solid_3>;

  // Finds the walls that vertices touch at a time.
  Wall_contacts(const Mesh& mesh, const Solids& solids, const Complex& complex,
                const Vectors_3& positions, double time)
      : m_mesh(mesh), m_solids(solids), m_positions(positions), m_spacings(positions.size(), 0),
        m_touched(positions.size()) {
    for (std::size_t solid = 0; solid < solids.size(); ++solid)
      if (const auto& body = solids[solid].body) {
        m_body_of_solid.push_back(m_bodies.size());
        m_bodies.push_back({solid, place_of(*body), velocity_of(*body)});
      } else
        m_body_of_solid.push_back(no_body);
    m_time = time;
    for (const auto& facet : mesh.facets)
      if (facet.is_free)
        for (auto v : facet.vertices) {
          const double spacing = mesh.vertices[v]->spacing();
          m_spacings[v] = spacing > 0 ? spacing : complex.mean_interface_edge();
        }
    for (std::size_t v = 0; v < positions.size(); ++v)
      for_each_wall(v, positions[v], time,
                    [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
                      if (!is_side(solid) && w.distance <= touching * m_spacings[v])
                        m_touched[v].emplace_back(solid, wall);
                    });
    m_adheres.assign(positions.size(), false);
    m_is_covered.assign(positions.size(), true);
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
      m_wall_of_facet.push_back(wall_of(mesh.facets[f]));
      const bool adheres = tension(f) < mesh.facets[f].tension, is_wetted(m_wall_of_facet[f]);
      for (auto v : mesh.facets[f].vertices) {
        m_adheres[v] = m_adheres[v] || adheres;
        m_is_covered[v] = m_is_covered[v] && is_wetted;
      }
    }
  }

  // Return the places of bodies, which move with their present velocities, at a time. Bodies are
  // numbered in the order of solids.
  std::size_t number_of_bodies() const { return m_bodies.size(); }
  Body_place place_of_body(std::size_t k, double time) const {
    return m_bodies[k].place.moved(m_bodies[k].velocity, time - m_time);
  }
  std::size_t solid_of_body(std::size_t k) const { return m_bodies[k].solid; }

  // Sets the velocities of bodies in the step. The initial ones are those of the solids.
  void set_velocities_of_bodies(const std::vector<Body_velocity>& velocities) {
    for (std::size_t k = 0; k < m_bodies.size(); ++k)
      m_bodies[k].velocity = velocities[k];
  }
  std::vector<Body_velocity> velocities_of_bodies() const {
    std::vector<Body_velocity> result;
    for (const Moving_body& body : m_bodies)
      result.push_back(body.velocity);
    return result;
  }

  // Sets the parts of the sides of the domain from which vertices need not keep a distance:
  // `is_open(side, p)` with a point p of the side.
  void set_open_sides(std::function<bool(std::size_t, const Eigen::Vector3d&)> is_open) {
    m_is_open = std::move(is_open);
  }

  // Returns the displacements that keep vertices on walls in front of the ends of these walls, if
  // they would otherwise move with the liquid to `moved` in the time dt. Without them, a vertex
  // that slides along a wall would get past the corner of a solid, and the surface would cut the
  // corner. Only vertices whose facets are all wetted return, so the surface keeps its place.
  Vectors_3 returns_from_ends(const Vectors_3& moved, double dt) const {
    // The least square of the sine of the angle between a wall and its end.
    static constexpr double flattest = .25;
    Vectors_3 result(m_positions.size(), Eigen::Vector3d::Zero());
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
      if (!m_is_covered[v] || !touches(v))
        continue;
      std::vector<Eigen::Vector3d> normals; // of the walls and sides of the vertex, orthonormal
      const auto along = [&normals](Eigen::Vector3d direction) {
        for (const Eigen::Vector3d& n : normals)
          direction -= direction.dot(n) * n;
        return direction;
      };
      const auto add = [&](const Eigen::Vector3d& normal) {
        if (const Eigen::Vector3d other = along(normal); other.squaredNorm() > flattest)
          normals.push_back(other.normalized());
      };
      for (int axis = 0; axis < 3; ++axis)
        if (axis >= Mesh::dimension ||
            Boundary_class::fixes(m_mesh.vertices[v]->boundary_class(), axis))
          add(Eigen::Vector3d::Unit(axis));
      std::vector<Wall_3> ends;
      for_each_wall_of_solids(m_positions[v], m_time,
                              [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
                                if (is_touching(v, solid, wall))
                                  add(eigen_vector(w.normal));
                                else if (w.is_end)
                                  ends.push_back(w);
                              });
      for (const Wall_3& end : ends) {
        const Eigen::Vector3d normal = eigen_vector(end.normal), inward = along(normal);
        const double after =
            end.distance + normal.dot(moved[v] - m_positions[v] - dt * eigen_vector(end.velocity));
        if (inward.dot(normal) > flattest)
          result[v] += (kept_distance(end.distance, after, clearance * m_spacings[v]) - after) /
                       inward.dot(normal) * inward;
      }
    }
    return result;
  }

  // Predicts the contacts of vertices that move to the expected positions in the time dt. Walls
  // move from their places at `begin` to those at `end`. If the times are equal, the contacts are
  // those of a projection: nothing changes its place, but walls have their present
  // velocities. Walls have no velocity if `walls_move` is false. A vertex that touches a wall is
  // constrained until `revise()` releases it.
  void predict(const Vectors_3& expected, double begin, double end, double dt, bool walls_move) {
    // In edge lengths. Later predictions find walls that are farther away.
    static constexpr double nearby = .5;
    const bool projects = walls_move && begin == end;
    const std::vector<Contact> before = std::move(m_contacts);
    m_contacts.clear();
    Vectors_3 middles;
    for (std::size_t v = 0; v < expected.size(); ++v)
      middles.push_back(projects ? m_positions[v]
                                 : Eigen::Vector3d((m_positions[v] + expected[v]) / 2));
    const double time_of_middle = (begin + end) / 2;
    const auto areas = areas_on_walls(middles);
    auto known = before.begin();
    for (std::size_t v = 0; v < expected.size(); ++v)
      for_each_wall(
          v, projects ? m_positions[v] : expected[v], end,
          [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
            const Place place(v, solid, wall);
            known = std::lower_bound(known, before.end(), place,
                                     [](const Contact& c, const auto& p) { return c.place() < p; });
            const bool is_known = known != before.end() && known->place() == place;
            const bool touches = is_touching(v, solid, wall);
            if (w.is_end && m_is_covered[v] && !touches)
              return; // see returns_from_ends()
            const Eigen::Vector3d normal = eigen_vector(w.normal),
                                  velocity = (walls_move ? 1. : 0.) * eigen_vector(w.velocity),
                                  displacement = expected[v] - m_positions[v];
            // At the end. A projection does not return vertices to walls.
            double distance = projects && touches ? 0 : w.distance;
            if (projects)
              distance += normal.dot(displacement - dt * velocity);
            if (distance > nearby * m_spacings[v] && !touches && !is_known)
              return;
            const Eigen::Vector3d direction =
                touches ? direction_of(place, areas, middles[v], time_of_middle, normal) : normal;
            const double remaining = distance / direction.dot(normal);
            m_contacts.push_back({v,
                                  solid,
                                  wall,
                                  normal,
                                  direction,
                                  (direction.dot(displacement) - remaining) / dt,
                                  velocity,
                                  is_known ? known->is_active : touches || distance < 0,
                                  is_known && known->was_released,
                                  {}});
            if (walls_move && is_body(solid))
              attach(m_contacts.back(), middles[v], time_of_middle);
          });
  }

  // Adds the active contacts to the constraints.
  void constrain(Vertex_constraints& constraints) const {
    for (const Contact& c : m_contacts)
      if (c.is_active)
        constrain(c, c.direction, c.least, c.body, constraints);
  }

  // Adds the active contacts to the constraints on the velocities at the end of the step, with the
  // vertices at given positions. With slip, the normal component is that of the wall. With no-slip,
  // the velocity is that of the wall.
  void constrain_at_end(const Vectors_3& positions, double time,
                        Vertex_constraints& constraints) const {
    for (const Contact& c : m_contacts) {
      if (!c.is_active)
        continue;
      if (c.body) {
        const std::size_t body = c.body->body;
        const Eigen::Vector3d arm = arm_of(place_of_body(body, time), positions[c.vertex]);
        constrain(c, c.normal, 0, Vertex_constraints::Attached_body{body, arm}, constraints);
      } else
        constrain(c, c.normal, c.normal.dot(c.wall_velocity), std::nullopt, constraints);
    }
  }

  // Calls `f(facet, vertex, wall_velocity, body)` for each vertex of a facet that slides along the
  // wall that wets the facet. All facets around the vertex are wetted. If the wall belongs to a
  // moving body, the velocity is zero and the body is given.
  template <class Function> void for_each_slip(const Function& f) const {
    for (std::size_t k = 0; k < m_mesh.facets.size(); ++k) {
      const auto& wall = m_wall_of_facet[k];
      if (!wall || sticks(wall->first))
        continue;
      for (auto v : m_mesh.facets[k].vertices)
        if (m_is_covered[v])
          if (const Contact* c = active_contact({v, wall->first, wall->second}))
            f(k, std::size_t(v),
              c->body ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : c->wall_velocity, c->body);
    }
  }

  // Activates contacts at which a vertex would enter a wall, and releases contacts with a negative
  // normal force. Vertices of wetted facets are not released, because this would gain surface
  // energy from nothing. Returns whether a contact has changed. A contact is released once at most
  // in a step, and no contact is released after some rounds, so that the iteration ends.
  bool revise(const Eigen::VectorXd& velocities, const Eigen::VectorXd& reactions, unsigned round) {
    static constexpr unsigned rounds_of_release = 8;
    static constexpr double rounding = 1e-9;
    const double slowest = rounding * velocities.lpNorm<Eigen::Infinity>(),
                 weakest = rounding * reactions.lpNorm<Eigen::Infinity>();
    std::vector<Contact*> revised;
    for (Contact& c : m_contacts) {
      const Eigen::Index row = 3 * Eigen::Index(c.vertex);
      double excess = c.direction.dot(velocities.segment<3>(row)) - c.least;
      if (c.body)
        excess -= c.direction.dot(m_bodies[c.body->body].velocity.at(c.body->arm));
      if (!c.is_active ? excess < -slowest
                       : round < rounds_of_release && !c.was_released && separates(c.solid) &&
                             !m_adheres[c.vertex] && push(c, reactions) < -weakest) {
        revised.push_back(&c);
      }
    }
    for (Contact* c : revised) {
      c->is_active = !c->is_active;
      c->was_released = c->was_released || !c->is_active;
    }
    return !revised.empty();
  }

  // Moves vertices out of walls, and constrained vertices onto their walls.
  void project_out_of_solids(Vectors_3& positions, double time) const {
    static constexpr int rounds = 4; // several rounds are necessary where walls meet
    for (int k = 0; k < rounds; ++k)
      for (std::size_t v = 0; v < positions.size(); ++v)
        for_each_wall(v, positions[v], time,
                      [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
                        if (w.distance < 0 || active_contact({v, solid, wall}))
                          positions[v] -= w.distance * eigen_vector(w.normal);
                      });
  }

  // Returns the energy of a unit of area of facet f. On a wall, it is the energy of wetting. By
  // Young's equation, the tensions of the wet and of the dry wall differ by the surface tension
  // times the cosine of the contact angle.
  double tension(std::size_t f) const {
    const double tension = m_mesh.facets[f].tension;
    const auto& wall = m_wall_of_facet[f];
    return wall ? -m_solids[wall->first].cosine * tension : tension;
  }

  // Returns the depth of a point in a solid, or 0 if the point is outside.
  double depth(const Eigen::Vector3d& p, double time) const {
    double result = 0;
    for_each_wall_of_solids(p, time, [&](std::size_t, std::size_t, const Wall_3& w) {
      result = (std::max)(result, -w.distance);
    });
    return result;
  }

  // Returns whether a vertex is between a liquid and void or a gas. Solids act on no other vertex.
  bool is_free(std::size_t v) const { return m_spacings[v] > 0; }

  bool touches(std::size_t v) const { return !m_touched[v].empty(); }

  // A motion of the wall of a solid at a vertex that its velocity does not explain.
  struct Jump
  {
    std::size_t solid = 0, vertex = 0;
    double length = 0; // in edges
  };

  // Returns the greatest jump of a touched wall from one time to another. It is the distance from
  // the wall at the end of a point that moves with the velocity of the wall, by the midpoint rule,
  // or the distance by which the velocities at the end and in the middle differ. Bodies do not
  // jump.
  Jump greatest_jump(double begin, double end) const {
    const double dt = end - begin;
    Jump result;
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      for (const auto& [solid, wall] : m_touched[v]) {
        if (is_body(solid))
          continue;
        const auto first = wall_at(solid, wall, m_positions[v], begin);
        if (!first)
          continue;
        const Eigen::Vector3d half = dt / 2 * eigen_vector(first->velocity);
        const auto middle = wall_at(solid, wall, m_positions[v] + half, (begin + end) / 2);
        if (!middle)
          continue;
        const Eigen::Vector3d velocity = eigen_vector(middle->velocity);
        const auto last = wall_at(solid, wall, m_positions[v] + dt * velocity, end);
        if (!last)
          continue;
        const double length = (std::max)(
            std::abs(last->distance),
            dt * std::abs(eigen_vector(last->normal).dot(eigen_vector(last->velocity) - velocity)));
        if (length > result.length * m_spacings[v])
          result = {solid, v, length / m_spacings[v]};
      }
    return result;
  }

  // Returns whether a wall that a vertex touches moves at a time.
  bool touches_moving_wall(double time) const {
    bool result = false;
    for (std::size_t v = 0; v < m_positions.size() && !result; ++v)
      if (touches(v))
        for_each_wall(
            v, m_positions[v], time, [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
              result = result || (w.velocity != NULL_VECTOR && is_touching(v, solid, wall));
            });
    return result;
  }

  // Returns the displacement by which a vertex that touches no wall gets onto the nearest wall. The
  // result is zero if the vertex touches a wall, or if no wall is near.
  Eigen::Vector3d displacement_to_wall(std::size_t v, double time) const {
    // In edge lengths. A chord of a circle has this distance if it is half as long as the diameter.
    static constexpr double reach = .25;
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    double nearest = reach * m_spacings[v];
    if (!touches(v))
      for_each_wall(v, m_positions[v], time, [&](std::size_t solid, std::size_t, const Wall_3& w) {
        if (!is_side(solid) && std::abs(w.distance) < nearest) {
          nearest = std::abs(w.distance);
          result = -w.distance * eigen_vector(w.normal);
        }
      });
    return result;
  }

  bool is_constrained(std::size_t v) const {
    const auto first =
        std::lower_bound(m_contacts.begin(), m_contacts.end(), v,
                         [](const Contact& c, std::size_t w) { return c.vertex < w; });
    for (auto c = first; c != m_contacts.end() && c->vertex == v; ++c)
      if (c->is_active)
        return true;
    return false;
  }

  // Returns the number of constrained vertices.
  std::size_t number_of_constrained() const {
    std::size_t result = 0;
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      result += is_constrained(v);
    return result;
  }

  // A force and a torque about the origin.
  struct Load
  {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
  };

  // Returns the force and the torque of liquids on each solid, with the vertices at given
  // positions: the opposite of the reactions, in the normal directions of walls, and with no-slip
  // also along walls.
  std::vector<Load> loads(const Eigen::VectorXd& reactions, const Vectors_3& positions) const {
    std::vector<Load> result(m_solids.size());
    for_each_reaction(reactions, [&](const Contact& c, const Eigen::Vector3d& reaction) {
      result[c.solid].force -= reaction;
      Eigen::Vector3d position = positions[c.vertex];
      if (is_body(c.solid))
        position = m_mesh.nearest_image(m_bodies[m_body_of_solid[c.solid]].place.center, position);
      result[c.solid].torque -= position.cross(reaction);
    });
    return result;
  }

  // Returns an upper bound of the power that moving walls supply to liquids. Power that walls
  // remove is not subtracted. Bodies are omitted.
  double power(const Eigen::VectorXd& reactions) const {
    double result = 0;
    for_each_reaction(reactions, [&](const Contact& c, const Eigen::Vector3d& reaction) {
      if (!c.body)
        result += (std::max)(0., reaction.dot(c.wall_velocity));
    });
    return result;
  }

private:
  // The greatest distance of a vertex from a wall that it touches, in edge lengths of the
  // interface. It is larger than the displacement by which mesh optimization moves vertices off a
  // curved wall.
  static constexpr double touching = 1e-3;
  // The distance that vertices keep from a side of the domain on which they do not lie, and from
  // ends of walls, in the same unit. Vertices that are already nearer keep their distance.
  static constexpr double clearance = .25;

  using Place = std::tuple<std::size_t, std::size_t, std::size_t>; // vertex, solid and wall
  using Wall = std::pair<std::size_t, std::size_t>;                // solid and wall

  struct Contact
  {
    std::size_t vertex, solid, wall;
    Eigen::Vector3d normal;    // of the wall, at the end of the step
    Eigen::Vector3d direction; // of the constraint and of its force
    double least; // least velocity along the direction, relative to the body if there is one
    Eigen::Vector3d wall_velocity;
    bool is_active;
    bool was_released;                                     // in this step
    std::optional<Vertex_constraints::Attached_body> body; // a moving body

    Place place() const { return {vertex, solid, wall}; }
  };

  struct Moving_body
  {
    std::size_t solid;
    Body_place place; // at `m_time`
    Body_velocity velocity;
  };
  static constexpr std::size_t no_body = std::size_t(-1);

  bool is_body(std::size_t solid) const {
    return !is_side(solid) && m_body_of_solid[solid] != no_body;
  }

  // Returns the vector from the center of a body to a point. On a torus, it is the shortest one.
  Eigen::Vector3d arm_of(const Body_place& place, const Eigen::Vector3d& p) const {
    return m_mesh.nearest_image(place.center, p) - place.center;
  }

  // Adds the constraint of a contact along a direction and, with no-slip, perpendicular to it.
  void constrain(const Contact& c, const Eigen::Vector3d& direction, double velocity,
                 const std::optional<Vertex_constraints::Attached_body>& body,
                 Vertex_constraints& constraints) const {
    constraints.add(c.vertex, {direction, velocity, body});
    if (!sticks(c.solid))
      return;
    const Eigen::Vector3d along = direction.unitOrthogonal();
    for (const Eigen::Vector3d& d : {along, Eigen::Vector3d(direction.cross(along))})
      constraints.add(c.vertex, {d, body ? 0 : d.dot(c.wall_velocity), body});
  }

  // Attaches a contact to the body of its solid.
  void attach(Contact& contact, const Eigen::Vector3d& middle, double time_of_middle) const {
    const std::size_t k = m_body_of_solid[contact.solid];
    const Eigen::Vector3d arm = arm_of(place_of_body(k, time_of_middle), middle);
    contact.body = {k, arm};
    contact.least -= contact.direction.dot(m_bodies[k].velocity.at(arm));
  }

  // Appends the walls of a solid at a point.
  void append_walls(std::size_t solid, const Eigen::Vector3d& p, double time,
                    std::vector<Wall_3>& walls) const {
    using Point = Any_solid_3::Point;
    const auto point = [](const Eigen::Vector3d& q) { return Point(q.x(), q.y(), q.z()); };
    const Any_solid_3& any = m_solids[solid];
    if (!is_body(solid)) {
      any.walls(point(p), time, walls);
      return;
    }
    const std::size_t k = m_body_of_solid[solid];
    const Body_place place = place_of_body(k, time);
    const Eigen::Matrix3d turn = place.rotation.toRotationMatrix();
    const Eigen::Vector3d arm = arm_of(place, p);
    any.walls(point(eigen_vector(any.initial_center) + turn.transpose() * arm), time, walls);
    for (Wall_3& wall : walls) {
      const Eigen::Vector3d normal = turn * eigen_vector(wall.normal);
      wall.normal = from_eigen<Wall_3::Vector>(normal);
      wall.velocity =
          from_eigen<Wall_3::Vector>(m_bodies[k].velocity.at(arm - wall.distance * normal));
    }
  }

  // Returns the wall that wets a facet: all its vertices touch this wall.
  std::optional<Wall> wall_of(const typename Mesh::Facet& facet) const {
    if (facet.is_free)
      for (const auto& [solid, wall] : m_touched[facet.vertices[0]])
        if (std::all_of(facet.vertices.begin(), facet.vertices.end(),
                        [&, &s = solid, &w = wall](auto v) { return is_touching(v, s, w); }))
          return Wall(solid, wall);
    return std::nullopt;
  }

  // Returns the sum of the area vectors of the facets that a wall wets, towards the liquid, for
  // each wall of each vertex whose facets are all wetted.
  std::map<Place, Eigen::Vector3d> areas_on_walls(const Vectors_3& positions) const {
    std::map<Place, Eigen::Vector3d> result;
    for (std::size_t f = 0; f < m_mesh.facets.size(); ++f) {
      if (!m_wall_of_facet[f])
        continue;
      const auto& facet = m_mesh.facets[f];
      const Eigen::Vector3d area = area_vector(m_mesh.corners_at(facet.vertices, positions));
      for (auto v : facet.vertices)
        if (m_is_covered[v])
          result
              .try_emplace({v, m_wall_of_facet[f]->first, m_wall_of_facet[f]->second},
                           Eigen::Vector3d::Zero())
              .first->second += facet.is_gas_in_front ? Eigen::Vector3d(-area) : area;
    }
    return result;
  }

  // Returns the direction in which a wall constrains a vertex that touches it. `normal` is the
  // normal at the end of the step.
  Eigen::Vector3d direction_of(const Place& place, const std::map<Place, Eigen::Vector3d>& areas,
                               const Eigen::Vector3d& middle, double time,
                               const Eigen::Vector3d& normal) const {
    static constexpr double least_cosine = .5; // of the angle to the normal
    const auto [v, solid, wall] = place;
    Eigen::Vector3d result = normal;
    if (const auto found = areas.find(place); found != areas.end())
      result = found->second;
    else if (const auto at_middle = wall_at(solid, wall, middle, time))
      result = eigen_vector(at_middle->normal);
    for (int axis = 0; axis < 3; ++axis)
      if (Boundary_class::fixes(m_mesh.vertices[v]->boundary_class(), axis))
        result[axis] = 0;
    result.normalize();
    return result.dot(normal) > least_cosine ? result : normal;
  }

  // Calls `f(contact, reaction)` for each active contact with a solid. `reaction` is the share of
  // the contact in the reactions.
  template <class Function>
  void for_each_reaction(const Eigen::VectorXd& reactions, const Function& f) const {
    Eigen::VectorXd left = reactions; // the remaining reactions, along walls
    for (const Contact& c : m_contacts)
      if (c.is_active)
        left.segment<3>(3 * Eigen::Index(c.vertex)) -= push(c, reactions) * c.direction;
    for (const Contact& c : m_contacts)
      if (c.is_active && !is_side(c.solid)) {
        Eigen::Vector3d reaction = push(c, reactions) * c.direction;
        if (sticks(c.solid)) {
          reaction += left.segment<3>(3 * Eigen::Index(c.vertex));
          left.segment<3>(3 * Eigen::Index(c.vertex)).setZero();
        }
        f(c, reaction);
      }
  }

  // The index after the last solid denotes the sides of the domain.
  bool is_side(std::size_t solid) const { return solid == m_solids.size(); }
  bool sticks(std::size_t solid) const { return !is_side(solid) && m_solids[solid].sticks; }
  bool separates(std::size_t solid) const { return is_side(solid) || m_solids[solid].separates; }

  // Calls a function for each wall at a point, with the indices of the solid and of the wall. Only
  // vertices between a liquid and void or a gas have walls.
  template <class Function>
  void for_each_wall(std::size_t v, const Eigen::Vector3d& p, double time,
                     const Function& function) const {
    if (!is_free(v))
      return;
    for_each_wall_of_solids(p, time, [&](std::size_t solid, std::size_t wall, Wall_3 w) {
      if (w.is_end && is_touching(v, solid, wall))
        w = from_front(w); // the vertex has passed the wall that it touches
      function(solid, wall, w);
    });
    for (int axis = 0; axis < 3; ++axis)
      if (!Boundary_class::fixes(m_mesh.vertices[v]->boundary_class(), axis))
        for (int side : {0, 1}) {
          const double sign = side == 0 ? 1 : -1, at = m_mesh.sides[2 * axis + side],
                       nearest = (std::min)(clearance * m_spacings[v],
                                            sign * (m_positions[v][axis] - at));
          Eigen::Vector3d foot = m_positions[v];
          foot[axis] = at;
          if (std::isfinite(at) && !(m_is_open && m_is_open(std::size_t(2 * axis + side), foot)))
            function(m_solids.size(), std::size_t(2 * axis + side),
                     {sign * (p[axis] - at) - nearest,
                      sign * Wall_3::Vector(axis == 0, axis == 1, axis == 2)});
        }
  }

  // Calls a function for each wall of a solid at a point, with the indices of the solid and of the
  // wall.
  template <class Function>
  void for_each_wall_of_solids(const Eigen::Vector3d& p, double time,
                               const Function& function) const {
    std::vector<Wall_3> walls;
    for (std::size_t solid = 0; solid < m_solids.size(); ++solid) {
      walls.clear();
      append_walls(solid, p, time, walls);
      for (std::size_t wall = 0; wall < walls.size(); ++wall)
        if (Mesh::dimension == 3 || is_in_plane(walls[wall]))
          function(solid, wall, walls[wall]);
    }
  }

  // Returns a wall of a solid at a point, seen from its front, or nothing if the solid has none
  // with this index there.
  std::optional<Wall_3> wall_at(std::size_t solid, std::size_t wall, const Eigen::Vector3d& p,
                                double time) const {
    std::vector<Wall_3> walls;
    append_walls(solid, p, time, walls);
    if (wall >= walls.size() || (Mesh::dimension == 2 && !is_in_plane(walls[wall])))
      return std::nullopt;
    return walls[wall].is_end ? from_front(walls[wall]) : walls[wall];
  }

  // Turns a wall that is seen from behind: the result has the outward normal of the solid.
  static Wall_3 from_front(const Wall_3& w) { return {-w.distance, -w.normal, w.velocity}; }

  // Replaces a wall by its intersection with the plane of a planar mesh. Returns false if there is
  // none near.
  static bool is_in_plane(Wall_3& wall) {
    static constexpr double least_slope = 1e-6;
    const double length = std::hypot(wall.normal.x(), wall.normal.y());
    if (!(length > least_slope))
      return false;
    wall.normal = Wall_3::Vector(wall.normal.x() / length, wall.normal.y() / length, 0);
    wall.velocity = Wall_3::Vector(wall.velocity.x(), wall.velocity.y(), 0);
    wall.distance /= length;
    return true;
  }

  bool is_touching(std::size_t v, std::size_t solid, std::size_t wall) const {
    return std::find(m_touched[v].begin(), m_touched[v].end(), std::make_pair(solid, wall)) !=
           m_touched[v].end();
  }

  // Returns the active contact at a place, or null if there is none.
  const Contact* active_contact(const Place& place) const {
    const auto c = std::lower_bound(m_contacts.begin(), m_contacts.end(), place,
                                    [](const Contact& a, const auto& b) { return a.place() < b; });
    return c != m_contacts.end() && c->place() == place && c->is_active ? &*c : nullptr;
  }

  // Returns the normal force of a contact. If several contacts or sides of the domain constrain the
  // vertex, its reaction is decomposed into their normals.
  double push(const Contact& contact, const Eigen::VectorXd& reactions) const {
    std::vector<Eigen::Vector3d> normals;
    Eigen::Index own = 0;
    const auto first =
        std::lower_bound(m_contacts.begin(), m_contacts.end(), contact.vertex,
                         [](const Contact& c, std::size_t v) { return c.vertex < v; });
    for (auto c = first; c != m_contacts.end() && c->vertex == contact.vertex; ++c)
      if (c->is_active) {
        if (&*c == &contact)
          own = Eigen::Index(normals.size());
        normals.push_back(c->direction);
      }
    for (int axis = 0; axis < 3; ++axis)
      if (Boundary_class::fixes(m_mesh.vertices[contact.vertex]->boundary_class(), axis))
        normals.push_back(Eigen::Vector3d::Unit(axis));
    const Eigen::Vector3d r = reactions.segment<3>(3 * Eigen::Index(contact.vertex));
    if (normals.size() == 1)
      return r.dot(contact.direction);
    Eigen::MatrixXd matrix(3, normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
      matrix.col(Eigen::Index(i)) = normals[i];
    return matrix.completeOrthogonalDecomposition().solve(r)(own);
  }

  const Mesh& m_mesh;
  const Solids& m_solids;
  Vectors_3 m_positions;
  // Edge lengths of the interface by vertex, or 0 for vertices that are not between a liquid and
  // void or a gas.
  std::vector<double> m_spacings;
  std::vector<char> m_adheres;    // by vertex: whether it belongs to a wetted facet
  std::vector<char> m_is_covered; // by vertex: whether all its facets are wetted
  std::vector<std::optional<Wall>> m_wall_of_facet;
  std::vector<std::vector<Wall>> m_touched; // by vertex
  std::vector<Contact> m_contacts;          // by vertex, solid and wall
  std::vector<std::size_t> m_body_of_solid; // or `no_body`
  std::vector<Moving_body> m_bodies;
  double m_time; // at which the contacts were found, and at which bodies have their places
  std::function<bool(std::size_t, const Eigen::Vector3d&)> m_is_open;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_WALL_CONTACTS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_WALL_CONTACTS_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_WALL_CONTACTS_3_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Fluid_mesh_3.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Vertex_constraints_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A solid, and what liquids do at it.
struct Any_solid_3
{
  using Point = Simple_cartesian<double>::Point_3;

  std::function<void(const Point&, double, std::vector<Wall_3>&)> walls;
  double cosine;  // of the contact angle
  bool sticks;    // the liquid goes with the wall
  bool separates; // it may leave the wall
};

// Where the surface of a liquid touches solids: vertices must not enter them, and only those that
// would are held back. Which ones, is found by trying: see `revise()`. The sides of the domain are
// walls, too, for what does not lie on them: it keeps off, as the mesh needs room there.
template <class Complex> class Wall_contacts_3
{
public:
  using Mesh = Fluid_mesh_3<Complex>;
  using Solids = std::vector<Any_solid_3>;

  // At a time.
  Wall_contacts_3(const Mesh& mesh, const Solids& solids, const Complex& complex,
                  const Vectors_3& positions, double time)
      : m_mesh(mesh), m_solids(solids), m_positions(positions), m_spacings(positions.size(), 0),
        m_touched(positions.size()) {
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
    for (const auto& facet : mesh.facets)
      if (tension(facet) < facet.tension)
        for (auto v : facet.vertices)
          m_adheres[v] = true;
  }

  // What must hold for velocities by which vertices go for some time, the walls being those where
  // they are expected to arrive; they may stand still. What touches a wall is held until `revise()`
  // lets it go.
  void predict(const Vectors_3& expected, double time, double dt, bool walls_move) {
    static constexpr double near = .5; // spacings: beyond, the next prediction will find it
    const std::vector<Contact> before = std::move(m_contacts);
    m_contacts.clear();
    auto known = before.begin();
    for (std::size_t v = 0; v < expected.size(); ++v)
      for_each_wall(
          v, expected[v], time, [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
            const auto place = std::make_tuple(v, solid, wall);
            known = std::lower_bound(known, before.end(), place,
                                     [](const Contact& c, const auto& p) { return c.place() < p; });
            const bool is_known = known != before.end() && known->place() == place;
            const bool touches = is_touching(v, solid, wall);
            if (w.distance > near * m_spacings[v] && !touches && !is_known)
              return;
            const Eigen::Vector3d normal = eigen_vector(w.normal);
            m_contacts.push_back({v, solid, wall, normal,
                                  (normal.dot(expected[v] - m_positions[v]) - w.distance) / dt,
                                  (walls_move ? 1. : 0.) * eigen_vector(w.velocity),
                                  is_known ? known->is_active : touches || w.distance < 0});
          });
  }

  void constrain(Vertex_constraints_3& constraints) const {
    for (const Contact& c : m_contacts)
      if (c.is_active) {
        constraints.add(c.vertex, {c.normal, c.least});
        if (sticks(c.solid)) {
          const Eigen::Vector3d along = c.normal.unitOrthogonal();
          for (const Eigen::Vector3d& d : {along, Eigen::Vector3d(c.normal.cross(along))})
            constraints.add(c.vertex, {d, d.dot(c.wall_velocity)});
        }
      }
  }

  // Holds what would enter a wall, and lets go what a wall would have to pull, but for what wets
  // it: that would gain the energy of a surface from nothing. Returns whether there was any. After
  // some rounds nothing is let go any more, so that they end.
  bool revise(const Eigen::VectorXd& velocities, const Eigen::VectorXd& reactions, unsigned round) {
    static constexpr unsigned rounds_of_release = 8;
    static constexpr double rounding = 1e-9;
    const double slowest = rounding * velocities.lpNorm<Eigen::Infinity>(),
                 weakest = rounding * reactions.lpNorm<Eigen::Infinity>();
    std::vector<Contact*> revised;
    for (Contact& c : m_contacts) {
      const Eigen::Index row = 3 * Eigen::Index(c.vertex);
      const double excess = c.normal.dot(velocities.segment<3>(row)) - c.least;
      if (!c.is_active ? excess < -slowest
                       : round < rounds_of_release && separates(c.solid) && !m_adheres[c.vertex] &&
                             push(c, reactions) < -weakest) {
        revised.push_back(&c);
      }
    }
    for (Contact* c : revised)
      c->is_active = !c->is_active;
    return !revised.empty();
  }

  // The velocity of what is held is that of the wall, where the step ends.
  void stop(Vectors_3& velocities) const {
    for (const Contact& c : m_contacts)
      if (c.is_active) {
        Eigen::Vector3d& v = velocities[c.vertex];
        v = sticks(c.solid) ? c.wall_velocity
                            : Eigen::Vector3d(v - c.normal * c.normal.dot(v - c.wall_velocity));
      }
  }

  // Moves vertices out of walls, and those that are held onto them.
  void put_out(Vectors_3& positions, double time) const {
    static constexpr int rounds = 4; // where walls meet
    for (int k = 0; k < rounds; ++k)
      for (std::size_t v = 0; v < positions.size(); ++v)
        for_each_wall(v, positions[v], time,
                      [&](std::size_t solid, std::size_t wall, const Wall_3& w) {
                        if (w.distance < 0 || is_held(v, solid, wall))
                          positions[v] -= w.distance * eigen_vector(w.normal);
                      });
  }

  // The energy of a unit of area of a facet, where it is on a wall that of wetting it: by Young's
  // equation, the tensions of wet and dry wall differ by that of the surface times the cosine of
  // the contact angle.
  double tension(const typename Mesh::Facet& facet) const {
    if (facet.is_free)
      for (const auto& [solid, wall] : m_touched[facet.vertices[0]])
        if (is_touching(facet.vertices[1], solid, wall) &&
            is_touching(facet.vertices[2], solid, wall))
          return -m_solids[solid].cosine * facet.tension;
    return facet.tension;
  }

  // How deep a vertex would be in a solid; 0 for outside.
  double depth(std::size_t v, const Eigen::Vector3d& p, double time) const {
    double result = 0;
    for_each_wall(v, p, time, [&](std::size_t solid, std::size_t, const Wall_3& w) {
      if (!is_side(solid))
        result = (std::max)(result, -w.distance);
    });
    return result;
  }

  bool touches(std::size_t v) const { return !m_touched[v].empty(); }

  bool is_held(std::size_t v) const {
    const auto first =
        std::lower_bound(m_contacts.begin(), m_contacts.end(), v,
                         [](const Contact& c, std::size_t w) { return c.vertex < w; });
    for (auto c = first; c != m_contacts.end() && c->vertex == v; ++c)
      if (c->is_active)
        return true;
    return false;
  }

  // Vertices.
  std::size_t number_of_held() const {
    std::size_t result = 0;
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      result += is_held(v);
    return result;
  }

  // Of liquids on each solid: the opposite of what holds vertices back, across walls and, where
  // liquids stick, along them.
  Vectors_3 forces(const Eigen::VectorXd& reactions) const {
    Vectors_3 result(m_solids.size(), Eigen::Vector3d::Zero());
    for_each_reaction(reactions, [&](const Contact& c, const Eigen::Vector3d& reaction) {
      result[c.solid] -= reaction;
    });
    return result;
  }

  // The power, at the most, that moving walls give to liquids: power that they take is left out.
  double power(const Eigen::VectorXd& reactions) const {
    double result = 0;
    for_each_reaction(reactions, [&](const Contact& c, const Eigen::Vector3d& reaction) {
      result += (std::max)(0., reaction.dot(c.wall_velocity));
    });
    return result;
  }

private:
  // How near a vertex is to a wall that it touches, in spacings of the interface: above what the
  // improvement of a mesh moves vertices off a curved wall.
  static constexpr double touching = 1e-3;
  // How far what does not lie on a side of the domain keeps off, in the same unit, unless it is
  // nearer already.
  static constexpr double clearance = .25;

  struct Contact
  {
    std::size_t vertex, solid, wall;
    Eigen::Vector3d normal;
    double least; // velocity along the normal
    Eigen::Vector3d wall_velocity;
    bool is_active;

    std::tuple<std::size_t, std::size_t, std::size_t> place() const {
      return {vertex, solid, wall};
    }
  };

  // Calls `f(contact, reaction)` with the part of each contact with a solid in the reactions.
  template <class Function>
  void for_each_reaction(const Eigen::VectorXd& reactions, const Function& f) const {
    Eigen::VectorXd left = reactions; // along walls
    for (const Contact& c : m_contacts)
      if (c.is_active)
        left.segment<3>(3 * Eigen::Index(c.vertex)) -= push(c, reactions) * c.normal;
    for (const Contact& c : m_contacts)
      if (c.is_active && !is_side(c.solid)) {
        Eigen::Vector3d reaction = push(c, reactions) * c.normal;
        if (sticks(c.solid)) {
          reaction += left.segment<3>(3 * Eigen::Index(c.vertex));
          left.segment<3>(3 * Eigen::Index(c.vertex)).setZero();
        }
        f(c, reaction);
      }
  }

  // The sides of the domain come after the solids.
  bool is_side(std::size_t solid) const { return solid == m_solids.size(); }
  bool sticks(std::size_t solid) const { return !is_side(solid) && m_solids[solid].sticks; }
  bool separates(std::size_t solid) const { return is_side(solid) || m_solids[solid].separates; }

  // Of vertices between liquid and void.
  template <class Function>
  void for_each_wall(std::size_t v, const Eigen::Vector3d& p, double time,
                     const Function& function) const {
    if (m_spacings[v] == 0)
      return;
    std::vector<Wall_3> walls;
    for (std::size_t solid = 0; solid < m_solids.size(); ++solid) {
      walls.clear();
      m_solids[solid].walls(Any_solid_3::Point(p.x(), p.y(), p.z()), time, walls);
      for (std::size_t wall = 0; wall < walls.size(); ++wall)
        function(solid, wall, walls[wall]);
    }
    for (int axis = 0; axis < 3; ++axis)
      if (!Boundary_class::fixes(m_mesh.vertices[v]->boundary_class(), axis))
        for (int side : {0, 1}) {
          const double sign = side == 0 ? 1 : -1, at = m_mesh.sides[2 * axis + side],
                       nearest = (std::min)(clearance * m_spacings[v],
                                            sign * (m_positions[v][axis] - at));
          if (std::isfinite(at))
            function(m_solids.size(), std::size_t(2 * axis + side),
                     {sign * (p[axis] - at) - nearest,
                      sign * Wall_3::Vector(axis == 0, axis == 1, axis == 2)});
        }
  }

  bool is_touching(std::size_t v, std::size_t solid, std::size_t wall) const {
    return std::find(m_touched[v].begin(), m_touched[v].end(), std::make_pair(solid, wall)) !=
           m_touched[v].end();
  }

  bool is_held(std::size_t v, std::size_t solid, std::size_t wall) const {
    const auto place = std::make_tuple(v, solid, wall);
    const auto c = std::lower_bound(m_contacts.begin(), m_contacts.end(), place,
                                    [](const Contact& a, const auto& b) { return a.place() < b; });
    return c != m_contacts.end() && c->place() == place && c->is_active;
  }

  // The part of a contact in what holds its vertex, where several do, or sides of the domain.
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
        normals.push_back(c->normal);
      }
    for (int axis = 0; axis < 3; ++axis)
      if (Boundary_class::fixes(m_mesh.vertices[contact.vertex]->boundary_class(), axis))
        normals.push_back(Eigen::Vector3d::Unit(axis));
    const Eigen::Vector3d r = reactions.segment<3>(3 * Eigen::Index(contact.vertex));
    if (normals.size() == 1)
      return r.dot(contact.normal);
    Eigen::MatrixXd matrix(3, normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
      matrix.col(Eigen::Index(i)) = normals[i];
    return matrix.completeOrthogonalDecomposition().solve(r)(own);
  }

  const Mesh& m_mesh;
  const Solids& m_solids;
  Vectors_3 m_positions;
  std::vector<double> m_spacings; // by vertex; 0 for those that are not between liquid and void
  std::vector<char> m_adheres;    // by vertex: whether it wets a wall
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> m_touched; // solids and walls
  std::vector<Contact> m_contacts;                                         // by place
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_WALL_CONTACTS_3_H

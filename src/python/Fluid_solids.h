// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_FLUID_SOLIDS_H
#define DSC_PYTHON_FLUID_SOLIDS_H

#include "Fluid_object.h"
#include "callbacks.h"
#include "options.h"
#include "options_of_construction.h"

#include <CGAL/Incompressible_fluids_3/Fluid_state.h>
#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>
#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

namespace dsc_python {

/// The places of a solid that a Python function gives: `function(t)` returns the displacement and
/// the rotation, with three coordinates each. Several threads can use it.
class Place_function
{
public:
  using Place = CGAL::Deformable_simplicial_complexes::Solid_place_3;

  explicit Place_function(py::function function) : m_function(std::move(function)) {}

  Place operator()(double t) const {
    using CGAL::Deformable_simplicial_complexes::point_of;
    const py::gil_scoped_acquire lock;
    const auto vectors = m_function(t).cast<std::array<std::array<double, 3>, 2>>();
    return {point_of<Place::Vector>(vectors[0]), point_of<Place::Vector>(vectors[1])};
  }

private:
  Shared_function m_function;
};

/// The options of all solids of a fluid. Vectors have three coordinates in the plane, too.
struct Solid_options
{
  /// \throws py::type_error if an option is unknown or of another type
  explicit Solid_options(const py::dict& options) {
    Options rest(options);
    rest.read("contact_angle", wall.contact_angle);
    rest.read("no_slip", wall.sticks);
    rest.read("separates", wall.separates);
    rest.read("velocity", velocity);
    rest.read("angular_velocity", angular_velocity);
    if (const py::object given = rest.take("motion"); !given.is_none()) {
      const auto [function, step] = given.cast<std::pair<py::function, double>>();
      motion =
          CGAL::Deformable_simplicial_complexes::motion_of_places(Place_function(function), step);
    }
    rest.require_all_read();
  }

  /// Returns whether the solid has a constant velocity other than 0.
  bool has_velocity() const {
    return velocity != std::array<double, 3>() || angular_velocity != std::array<double, 3>();
  }

  CGAL::Deformable_simplicial_complexes::Wall_behavior wall;
  std::array<double, 3> velocity = {};         ///< of a body, the initial velocity
  std::array<double, 3> angular_velocity = {}; ///< of a body, the initial angular velocity
  /// A motion as a function of time; empty without one.
  std::function<CGAL::Deformable_simplicial_complexes::Solid_motion_3(double)> motion;
};

/// The solids of a fluid for Python. In the plane, coordinates are two numbers.
template <class Complex> class Fluid_solids
{
public:
  static constexpr int d = Complex::dimension;
  using Object = Fluid_object<Complex>;
  using Coordinates = std::array<double, d>;

  /// A density, whether the body moves along each axis, and whether it rotates. None if the solid
  /// is not a body.
  using Body = std::optional<std::tuple<double, std::array<bool, 3>, bool>>;

  static void add_plane(Object& object, const Coordinates& point, const Coordinates& normal,
                        const py::dict& options) {
    add(object, DSC::Plane_solid_3(point_in_space(point), vector_in_space(normal)),
        point_in_space(point), options);
  }

  static void add_tank(Object& object, const Box<d>& box, bool is_open, const py::dict& options) {
    add(object, DSC::Tank_solid_3(bbox_of(box), is_open), middle_of(box), options);
  }

  static void add_box(Object& object, const Box<d>& box, const Body& body,
                      const py::dict& options) {
    const DSC::Box_solid_3 solid(bbox_of(box));
    if (!body) {
      add(object, solid, middle_of(box), options);
      return;
    }
    const Vector_3 half_thickness(0, 0, d == 2 ? .5 : 0);
    add(object, solid,
        DSC::rigid_box(point_in_space(box.first) - half_thickness,
                       point_in_space(box.second) + half_thickness, density_of(body)),
        body, options);
  }

  static void add_ball(Object& object, const Coordinates& center, double radius, bool is_outside,
                       const Body& body, const py::dict& options) {
    const Point_3 c = point_in_space(center);
    const DSC::Ball_solid_3 solid(c, radius, side(is_outside));
    if (!body)
      add(object, solid, c, options);
    else
      add(object, solid,
          d == 2 ? DSC::rigid_disk(c, radius, density_of(body))
                 : DSC::rigid_ball(c, radius, density_of(body)),
          body, options);
  }

  static void add_cylinder(Object& object, const Coordinates& point, const Coordinates& axis,
                           double radius, bool is_outside, const py::dict& options) {
    add(object,
        DSC::Cylinder_solid_3(point_in_space(point), vector_in_space(axis), radius,
                              side(is_outside)),
        point_in_space(point), options);
  }

  static void add_mesh(Object& object, const Array<double>& points, const py::array& triangles,
                       bool is_outside, const Body& body, const py::dict& options) {
    const Mesh mesh = mesh_of(points, triangles);
    const DSC::Mesh_solid_3 solid(mesh, side(is_outside));
    if (body) {
      add(object, solid, DSC::rigid_body_of_mesh(mesh, density_of(body)), body, options);
      return;
    }
    Vector_3 sum(0, 0, 0);
    for (const auto v : mesh.vertices())
      sum = sum + (mesh.point(v) - CGAL::ORIGIN);
    add(object, solid, CGAL::ORIGIN + sum / double(mesh.number_of_vertices()), options);
  }

  /// Returns the places and motions of the bodies.
  static py::list bodies(const Object& object) {
    const auto& fluid = *object.read().fluid;
    py::list result;
    for (std::size_t k = 0; k < fluid.number_of_bodies(); ++k) {
      const DSC::Rigid_body_3& body = fluid.body(k);
      const auto& q = body.rotation;
      py::dict values;
      values["center"] = array_of_first<d>(body.center);
      values["velocity"] = array_of_first<d>(body.velocity);
      values["angular_velocity"] = rotation_to_python<d>(body.angular_velocity);
      if constexpr (d == 2)
        values["rotation"] = std::remainder(2 * std::atan2(q[3], q[0]), 2 * CGAL_PI);
      else
        values["rotation"] = array_of<double>(q.size(), [&](std::size_t i) { return q[i]; });
      values["mass"] = body.mass;
      result.append(values);
    }
    return result;
  }

private:
  using Mesh = DSC::Mesh_solid_3::Mesh;

  static DSC::Solid_side side(bool is_outside) {
    return is_outside ? DSC::Solid_side::outside : DSC::Solid_side::inside;
  }

  static Point_3 middle_of(const Box<d>& box) {
    return CGAL::midpoint(point_in_space(box.first), point_in_space(box.second));
  }

  static double density_of(const Body& body) { return std::get<0>(*body); }

  static Mesh mesh_of(const Array<double>& points, const py::array& triangles) {
    Mesh mesh;
    for (const auto& row : rows_of<double, 3>(points, "points"))
      mesh.add_vertex(point_in_space(row));
    for (const auto& t : index_rows_of<3>(triangles, "triangles")) {
      for (const std::size_t v : t)
        if (v >= mesh.number_of_vertices())
          throw py::index_error("a triangle of the solid has an unknown point");
      using Vertex = Mesh::Vertex_index;
      if (mesh.add_face(Vertex(unsigned(t[0])), Vertex(unsigned(t[1])), Vertex(unsigned(t[2]))) ==
          Mesh::null_face())
        throw py::value_error("the triangles of the solid are not an oriented manifold");
    }
    return mesh;
  }

  /// Adds a solid at rest, or with a motion that does not depend on liquids.
  template <class Solid>
  static void add(Object& object, const Solid& solid, const Point_3& center,
                  const py::dict& options) {
    const Solid_options chosen(options);
    object.change(py::none(), [&](Owned_fluid<Complex>& owned) {
      using Moving_solid = DSC::Moving_solid_3<Solid>;
      if (chosen.motion)
        owned.fluid->add_solid(Moving_solid(solid, center, chosen.motion), chosen.wall);
      else if (chosen.has_velocity())
        owned.fluid->add_solid(Moving_solid(solid, vector_in_space(chosen.velocity), center,
                                            vector_in_space(chosen.angular_velocity)),
                               chosen.wall);
      else
        owned.fluid->add_solid(solid, chosen.wall);
    });
  }

  /// Adds a solid that liquids move.
  template <class Solid>
  static void add(Object& object, const Solid& solid, DSC::Rigid_body_3 rigid, const Body& body,
                  const py::dict& options) {
    const Solid_options chosen(options);
    rigid.velocity = vector_in_space(chosen.velocity);
    rigid.angular_velocity = vector_in_space(chosen.angular_velocity);
    rigid.translates = std::get<1>(*body);
    rigid.rotates.fill(std::get<2>(*body));
    object.change(py::none(), [&](Owned_fluid<Complex>& owned) {
      owned.fluid->add_body(solid, rigid, chosen.wall);
    });
  }
};

} // namespace dsc_python

#endif // DSC_PYTHON_FLUID_SOLIDS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_FLUID_SOLIDS_H
#define DSC_PYTHON_FLUID_SOLIDS_H

#include "Guarded.h"
#include "arrays.h"
#include "callbacks.h"

#include "scenes/add_solid.h"
#include "scenes/json_fields.h"
#include "scenes/scene_solid.h"

#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>

#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace dsc_python {

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Point_3 = CGAL::Epick::Point_3;
using Vector_3 = CGAL::Epick::Vector_3;

/// A fluid with its own complex. The fluid refers to the complex, so the complex does not move.
template <class Complex> struct Owned_fluid
{
  std::unique_ptr<Complex> complex;
  std::unique_ptr<DSC::Incompressible_fluid<Complex>> fluid;
};

/// A fluid for Python.
template <class Complex> using Fluid_object = Guarded<Owned_fluid<Complex>>;

/// Returns coordinates in space. In the plane, the third coordinate is 0.
template <std::size_t d> std::array<double, 3> in_space(const std::array<double, d>& coordinates) {
  std::array<double, 3> result = {};
  std::copy(coordinates.begin(), coordinates.end(), result.begin());
  return result;
}

/// Returns the first d coordinates of a point or a vector in space, as an array of shape (d,).
template <int d, class Coordinates> py::array_t<double> array_of_first(const Coordinates& c) {
  return array_of<double>(std::size_t(d), [&](std::size_t i) { return c[int(i)]; });
}

/// Returns a vector of rotation, such as a torque: a number in the plane, an array in space.
template <int d> py::object rotation_to_python(const Vector_3& v) {
  if constexpr (d == 2)
    return py::float_(v.z());
  else
    return array_of_first<3>(v);
}

/// The places of a solid that a Python function gives: `function(t)` returns the displacement and
/// the rotation, with three coordinates each. Several threads can use it.
class Place_function : private Shared_function
{
public:
  using Place = dsc::Scene_solid::Place;

  using Shared_function::Shared_function;

  Place operator()(double t) const {
    using CGAL::Deformable_simplicial_complexes::point_of;
    const py::gil_scoped_acquire lock;
    const auto vectors = call(t).cast<std::array<std::array<double, 3>, 2>>();
    return {point_of<Place::Vector>(vectors[0]), point_of<Place::Vector>(vectors[1])};
  }
};

/// Returns a Python value of texts, truth values, numbers, lists and dictionaries as JSON.
inline dsc::Json json_of(const py::handle& value) {
  if (py::isinstance<py::str>(value))
    return value.cast<std::string>();
  if (py::isinstance<py::bool_>(value))
    return value.cast<bool>();
  if (py::isinstance<py::dict>(value)) {
    dsc::Json result = dsc::Json::object();
    for (const auto& [name, field] : value.cast<py::dict>())
      result[name.cast<std::string>()] = json_of(field);
    return result;
  }
  if (!py::isinstance<py::list>(value))
    return value.cast<double>();
  dsc::Json result = dsc::Json::array();
  for (const py::handle& entry : value.cast<py::list>())
    result.push_back(json_of(entry));
  return result;
}

/// The solids of a fluid for Python.
template <class Complex> class Fluid_solids
{
public:
  static constexpr int d = Complex::dimension;
  using Object = Fluid_object<Complex>;

  /// Adds a solid. `description` describes it as a scene of the program does, with an empty name of
  /// the file of a mesh.
  /// \param mesh points and triangles of a mesh
  /// \param motion a function for `Place_function`, and the time step of its differences
  static void add(Object& object, const py::dict& description,
                  const std::optional<std::pair<Array<double>, py::array>>& mesh,
                  const std::optional<std::pair<py::function, double>>& motion) {
    const dsc::Json json = json_of(description);
    dsc::Scene_solid solid = dsc::read_solid(dsc::Json_fields(json, "the solid", d));
    if (mesh)
      solid.set_mesh(mesh_of(mesh->first, mesh->second));
    if (motion)
      solid.place = Place_function(motion->first);
    object.change(py::none(), [&](Owned_fluid<Complex>& owned) {
      dsc::add_solid(solid, motion ? motion->second : 0, *owned.fluid);
    });
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
  static dsc::Scene_solid::Mesh mesh_of(const Array<double>& points, const py::array& triangles) {
    using Mesh = dsc::Scene_solid::Mesh;
    Mesh mesh;
    for (const auto& row : rows_of<double, 3>(points, "points"))
      mesh.add_vertex(DSC::point_of<Point_3>(row));
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
};

} // namespace dsc_python

#endif // DSC_PYTHON_FLUID_SOLIDS_H

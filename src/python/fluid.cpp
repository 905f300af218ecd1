// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// First, because this header declares the templates that are compiled already.
#include <CGAL/Incompressible_fluids_3/compiled_3.h>

#include "Complex_object.h"
#include "bind_complex.h"
#include "module.h"
#include "options_of_construction.h"

#include <CGAL/Incompressible_fluids_3/Solids_3.h>

#include <cmath>

namespace dsc_python {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Fluid = DSC::Incompressible_fluid<Complex>;
using Coordinates = std::array<double, 3>;

/// A ball in which liquid appears, with a volume in a unit of time that is negative for a drain.
using Source = std::tuple<Coordinates, double, double>;

/// A fluid with its own complex. The fluid refers to the complex, so the complex does not move.
struct Owned_fluid
{
  std::unique_ptr<Complex> complex;
  std::unique_ptr<Fluid> fluid;
};
using Object = Guarded<Owned_fluid>;

DSC::Wall_3::Vector vector_of(const Coordinates& c) { return {c[0], c[1], c[2]}; }
Fluid::Point point_of(const Coordinates& c) { return {c[0], c[1], c[2]}; }
DSC::Solid_side side(bool is_outside) {
  return is_outside ? DSC::Solid_side::outside : DSC::Solid_side::inside;
}

DSC::Fluid_properties properties_of(const std::map<int, std::pair<double, double>>& liquids,
                                    const std::map<int, std::pair<double, double>>& gases,
                                    const std::map<std::pair<int, int>, double>& tensions,
                                    const Coordinates& gravity) {
  DSC::Fluid_properties result;
  for (const auto& [label, liquid] : liquids)
    result.set_liquid(label, {liquid.first, liquid.second});
  for (const auto& [label, gas] : gases)
    result.set_gas(label, {gas.first, gas.second});
  for (const auto& [labels, tension] : tensions) {
    if (labels.first > labels.second && tensions.count({labels.second, labels.first}) > 0)
      throw py::value_error("a surface tension is given twice, for both orders of its labels");
    result.set_surface_tension(labels.first, labels.second, tension);
  }
  result.set_gravity(gravity);
  return result;
}

std::unique_ptr<Object> make_fluid(const Complex_object<Complex>& given,
                                   const std::map<int, std::pair<double, double>>& liquids,
                                   const std::map<int, std::pair<double, double>>& gases,
                                   const std::map<std::pair<int, int>, double>& tensions,
                                   const Coordinates& gravity) {
  const auto& normalization = given.read().normalization();
  if (normalization.scale != 1 || normalization.translation != Complex::Approximate_vector(0, 0, 0))
    throw py::value_error("the complex has an origin or a unit of its own, which fluids do not "
                          "support: use Complex3.from_tetrahedra(cells.points, cells.cells, "
                          "cells.labels) with cells = complex.cells()");
  Owned_fluid result;
  result.complex = std::make_unique<Complex>(given.read());
  result.fluid =
      std::make_unique<Fluid>(*result.complex, properties_of(liquids, gases, tensions, gravity));
  return std::make_unique<Object>(std::move(result));
}

/// Adds a solid, which is of a type of the package.
template <class Solid>
void add_solid(Object& object, const Solid& solid, double contact_angle, bool no_slip,
               bool separates) {
  object.change(py::none(), [&](Owned_fluid& owned) {
    owned.fluid->add_solid(solid, {contact_angle, no_slip, separates});
  });
}

void add_mesh(Object& object, const Array<double>& points, const py::array& triangles,
              bool is_outside, double contact_angle, bool no_slip, bool separates) {
  DSC::Mesh_solid_3::Mesh mesh;
  for (const auto& row : rows_of<double, 3>(points, "points"))
    mesh.add_vertex(point_of(row));
  for (const auto& t : index_rows_of<3>(triangles, "triangles")) {
    for (const std::size_t v : t)
      if (v >= mesh.number_of_vertices())
        throw py::index_error("a triangle of the solid has an unknown point");
    using Vertex = DSC::Mesh_solid_3::Mesh::Vertex_index;
    if (mesh.add_face(Vertex(unsigned(t[0])), Vertex(unsigned(t[1])), Vertex(unsigned(t[2]))) ==
        DSC::Mesh_solid_3::Mesh::null_face())
      throw py::value_error("the triangles of the solid are not an oriented manifold");
  }
  add_solid(object, DSC::Mesh_solid_3(mesh, side(is_outside)), contact_angle, no_slip, separates);
}

void set_sources(Object& object, const std::vector<Source>& sources) {
  for (const auto& [center, radius, rate] : sources)
    if (!(radius > 0) || !std::isfinite(radius) || !std::isfinite(rate) ||
        !std::isfinite(center[0] + center[1] + center[2]))
      throw py::value_error(
          "a source must have a finite center, a positive radius and a finite rate");
  object.change(py::none(), [&](Owned_fluid& owned) {
    owned.fluid->set_sources([sources](const Fluid::Point& p, double) {
      double result = 0;
      for (const auto& [center, radius, rate] : sources)
        if ((p - point_of(center)).squared_length() < radius * radius)
          result += rate / (4. / 3 * CGAL_PI * radius * radius * radius);
      return result;
    });
  });
}

void set_velocities(Object& object, const Array<double>& velocities) {
  const auto rows = rows_of<double, 3>(velocities, "velocities");
  if (rows.size() != object.read().complex->number_of_vertices())
    throw py::value_error("give one velocity for each vertex, in the order of cells().points");
  object.change(py::none(), [&](Owned_fluid& owned) {
    const auto vertices = owned.complex->vertices();
    const DSC::Vertex_numbers numbers(*owned.complex, vertices);
    owned.fluid->set_velocities(
        [&](Complex::Vertex_handle v) { return vector_of(rows[numbers(v)]); });
  });
}

py::dict balance_to_dict(const DSC::Fluid_balance& balance) {
  const auto array = [](const DSC::Fluid_balance::Vector& v) {
    return array_of<double>(3, [&](std::size_t i) { return v[int(i)]; });
  };
  py::dict result;
  result["volume"] = balance.volume;
  result["mass"] = balance.mass;
  result["kinetic_energy"] = balance.kinetic_energy;
  result["potential_energy"] = balance.potential_energy;
  result["surface_energy"] = balance.surface_energy;
  result["gas_energy"] = balance.gas_energy;
  result["energy"] = balance.energy();
  result["momentum"] = array(balance.momentum);
  result["angular_momentum"] = array(balance.angular_momentum);
  return result;
}

DSC::Fluid_step_options<Complex> step_options(const py::dict& options, const Complex& complex) {
  DSC::Fluid_step_options<Complex> result;
  Options rest(options);
  rest.read("implicitness", result.implicitness);
  rest.read("interface_tolerance", result.interface_tolerance);
  rest.read("adaptation_interval", result.adaptation_interval);
  Complex_functions<Complex>::read_deformation(rest, Space<Complex>(complex), result.deformation);
  rest.require_all_read();
  return result;
}

py::dict step(Object& object, double dt, const py::dict& options, const py::object& progress) {
  const Owned_fluid& owned = object.read();
  const auto chosen = step_options(options, *owned.complex);
  const Fluid::Report report = object.change(
      progress, [&](Owned_fluid& changed) { return changed.fluid->advance(dt, chosen); });
  py::dict result;
  result["dt"] = report.dt;
  result["substeps"] = report.parts;
  result["balance"] = balance_to_dict(report.after);
  result["greatest_velocity"] = report.greatest_velocity;
  result["greatest_correction"] = report.greatest_correction;
  result["volume_error"] = report.volume_error;
  result["residual"] = report.residual;
  result["contacts"] = report.contacts;
  result["depth_in_solids"] = report.depth_in_solids;
  result["forces_on_solids"] =
      array_of<double>(report.forces_on_solids.size(), 3, [&](std::size_t i, std::size_t j) {
        return report.forces_on_solids[i][int(j)];
      });
  result["repetitions"] = report.repetitions.size();
  result["deformation"] = report_to_dict(report.deformation, *owned.complex);
  return result;
}

double relax(Object& object, double dt, unsigned steps, const py::dict& options,
             const py::object& progress) {
  const auto chosen = step_options(options, *object.read().complex);
  return object.change(progress,
                       [&](Owned_fluid& owned) { return owned.fluid->relax(dt, steps, chosen); });
}

/// Returns values at all vertices, in the order of cells().points. Vertices off liquids have the
/// value 0.
template <class Value> auto at_vertices(const Object& object, const Value& value) {
  const Owned_fluid& owned = object.read();
  const auto vertices = owned.complex->vertices();
  return value(*owned.fluid, vertices);
}

} // namespace

void bind_fluid(py::module_& module) {
  using Vertices = std::vector<Complex::Vertex_handle>;
  py::class_<Object>(module, "Fluid")
      .def(py::init(&make_fluid))
      .def("complex",
           [](const Object& object) {
             return std::make_unique<Complex_object<Complex>>(Complex(*object.read().complex));
           })
      .def("time", [](const Object& object) { return object.read().fluid->time(); })
      .def("balance",
           [](const Object& object) { return balance_to_dict(object.read().fluid->balance()); })
      .def("largest_step",
           [](const Object& object, double fraction) {
             if (!(fraction > 0) || !std::isfinite(fraction))
               throw py::value_error("the fraction must be positive and finite");
             return object.read().fluid->largest_step(fraction);
           })
      .def("velocities",
           [](const Object& object) {
             return at_vertices(object, [](const Fluid& fluid, const Vertices& vertices) {
               return array_of<double>(vertices.size(), 3, [&](std::size_t i, std::size_t j) {
                 return fluid.velocity(vertices[i])[int(j)];
               });
             });
           })
      .def("pressures",
           [](const Object& object) {
             return at_vertices(object, [](const Fluid& fluid, const Vertices& vertices) {
               return array_of<double>(vertices.size(),
                                       [&](std::size_t i) { return fluid.pressure(vertices[i]); });
             });
           })
      .def("set_velocities", &set_velocities)
      .def("set_sources", &set_sources)
      .def("add_plane",
           [](Object& object, const Coordinates& point, const Coordinates& normal, double angle,
              bool no_slip, bool separates) {
             add_solid(object, DSC::Plane_solid_3(point_of(point), vector_of(normal)), angle,
                       no_slip, separates);
           })
      .def("add_tank",
           [](Object& object, const Box<3>& box, bool is_open, double angle, bool no_slip,
              bool separates) {
             add_solid(object, DSC::Tank_solid_3(bbox_of(box), is_open), angle, no_slip, separates);
           })
      .def("add_ball",
           [](Object& object, const Coordinates& center, double radius, bool is_outside,
              double angle, bool no_slip, bool separates) {
             add_solid(object, DSC::Ball_solid_3(point_of(center), radius, side(is_outside)), angle,
                       no_slip, separates);
           })
      .def("add_cylinder",
           [](Object& object, const Coordinates& point, const Coordinates& axis, double radius,
              bool is_outside, double angle, bool no_slip, bool separates) {
             add_solid(
                 object,
                 DSC::Cylinder_solid_3(point_of(point), vector_of(axis), radius, side(is_outside)),
                 angle, no_slip, separates);
           })
      .def("add_mesh", &add_mesh)
      .def("step", &step)
      .def("relax", &relax);
}

} // namespace dsc_python

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// First, because these headers declare the templates that are compiled already.
#include <CGAL/Incompressible_fluids_3/compiled_2.h>
#include <CGAL/Incompressible_fluids_3/compiled_3.h>

#include "Complex_object.h"
#include "bind_complex.h"
#include "module.h"
#include "options_of_construction.h"

#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dsc_python {
namespace {

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

/// Returns coordinates in space. In the plane, the third coordinate is 0.
template <std::size_t d> std::array<double, 3> in_space(const std::array<double, d>& coordinates) {
  std::array<double, 3> result = {};
  std::copy(coordinates.begin(), coordinates.end(), result.begin());
  return result;
}
template <std::size_t d> Point_3 point_in_space(const std::array<double, d>& coordinates) {
  return DSC::point_of<Point_3>(in_space(coordinates));
}
template <std::size_t d> Vector_3 vector_in_space(const std::array<double, d>& coordinates) {
  return DSC::point_of<Vector_3>(in_space(coordinates));
}

DSC::Solid_side side(bool is_outside) {
  return is_outside ? DSC::Solid_side::outside : DSC::Solid_side::inside;
}

DSC::Wall_behavior wall_behavior(const py::dict& options) {
  DSC::Wall_behavior result;
  Options rest(options);
  rest.read("contact_angle", result.contact_angle);
  rest.read("no_slip", result.sticks);
  rest.read("separates", result.separates);
  rest.require_all_read();
  return result;
}

DSC::Mesh_solid_3 mesh_solid(const Array<double>& points, const py::array& triangles,
                             bool is_outside) {
  DSC::Mesh_solid_3::Mesh mesh;
  for (const auto& row : rows_of<double, 3>(points, "points"))
    mesh.add_vertex(point_in_space(row));
  for (const auto& t : index_rows_of<3>(triangles, "triangles")) {
    for (const std::size_t v : t)
      if (v >= mesh.number_of_vertices())
        throw py::index_error("a triangle of the solid has an unknown point");
    using Vertex = DSC::Mesh_solid_3::Mesh::Vertex_index;
    if (mesh.add_face(Vertex(unsigned(t[0])), Vertex(unsigned(t[1])), Vertex(unsigned(t[2]))) ==
        DSC::Mesh_solid_3::Mesh::null_face())
      throw py::value_error("the triangles of the solid are not an oriented manifold");
  }
  return {mesh, side(is_outside)};
}

/// The functions of a fluid for Python. In the plane, coordinates are two numbers.
template <class Complex> class Fluid_functions
{
public:
  static constexpr int d = Complex::dimension;
  using Fluid = DSC::Incompressible_fluid<Complex>;
  using Vector = typename Fluid::Vector;
  using Vertex_handle = typename Fluid::Vertex_handle;
  using Coordinates = std::array<double, d>;
  using Label = std::optional<int>; ///< of a liquid

  /// A ball in which liquid appears, with a volume in a unit of time that is negative for a drain.
  using Source = std::tuple<Coordinates, double, double>;

  /// A fluid with its own complex. The fluid refers to the complex, so the complex does not move.
  struct Owned_fluid
  {
    std::unique_ptr<Complex> complex;
    std::unique_ptr<Fluid> fluid;
  };
  using Object = Guarded<Owned_fluid>;

  static std::unique_ptr<Object> make(const Complex_object<Complex>& given,
                                      const std::map<int, std::pair<double, double>>& liquids,
                                      const std::map<int, std::pair<double, double>>& gases,
                                      const std::map<std::pair<int, int>, double>& tensions,
                                      const Coordinates& gravity) {
    const auto& normalization = given.read().normalization();
    if (normalization.scale != 1 || normalization.translation != CGAL::NULL_VECTOR)
      throw py::value_error(
          std::string("the complex has an origin or a unit of its own, which fluids do not "
                      "support: use ") +
          (d == 2 ? "Complex2.from_triangles" : "Complex3.from_tetrahedra") +
          "(cells.points, cells.cells, cells.labels) with cells = complex.cells()");
    Owned_fluid result;
    result.complex = std::make_unique<Complex>(given.read());
    result.fluid =
        std::make_unique<Fluid>(*result.complex, properties_of(liquids, gases, tensions, gravity));
    return std::make_unique<Object>(std::move(result));
  }

  // Set-up

  static void add_plane(Object& object, const Coordinates& point, const Coordinates& normal,
                        const py::dict& wall) {
    add_solid(object, DSC::Plane_solid_3(point_in_space(point), vector_in_space(normal)), wall);
  }

  static void add_tank(Object& object, const Box<d>& box, bool is_open, const py::dict& wall) {
    add_solid(object, DSC::Tank_solid_3(bbox_of(box), is_open), wall);
  }

  static void add_ball(Object& object, const Coordinates& center, double radius, bool is_outside,
                       const py::dict& wall) {
    add_solid(object, DSC::Ball_solid_3(point_in_space(center), radius, side(is_outside)), wall);
  }

  static void add_cylinder(Object& object, const Coordinates& point, const Coordinates& axis,
                           double radius, bool is_outside, const py::dict& wall) {
    add_solid(object,
              DSC::Cylinder_solid_3(point_in_space(point), vector_in_space(axis), radius,
                                    side(is_outside)),
              wall);
  }

  static void add_mesh(Object& object, const Array<double>& points, const py::array& triangles,
                       bool is_outside, const py::dict& wall) {
    add_solid(object, mesh_solid(points, triangles, is_outside), wall);
  }

  static void set_side(Object& object, int axis, bool is_upper,
                       const std::optional<Coordinates>& velocity) {
    DSC::Side_behavior behavior;
    if (velocity)
      behavior.velocity = in_space(*velocity);
    object.change(py::none(),
                  [&](Owned_fluid& owned) { owned.fluid->set_side(axis, is_upper, behavior); });
  }

  static void set_sources(Object& object, const std::vector<Source>& sources) {
    for (const auto& [center, radius, rate] : sources)
      if (!(radius > 0) || !std::isfinite(radius) || !std::isfinite(rate) ||
          !std::all_of(center.begin(), center.end(), [](double c) { return std::isfinite(c); }))
        throw py::value_error(
            "a source must have a finite center, a positive radius and a finite rate");
    object.change(py::none(), [&](Owned_fluid& owned) {
      owned.fluid->set_sources([sources](const typename Fluid::Point& p, double) {
        double result = 0;
        for (const auto& [center, radius, rate] : sources)
          if ((p - DSC::point_of<typename Fluid::Point>(center)).squared_length() < radius * radius)
            result += rate / (d == 2 ? CGAL_PI * radius * radius
                                     : 4. / 3 * CGAL_PI * radius * radius * radius);
        return result;
      });
    });
  }

  /// Sets the velocities of all liquids, or of the liquid with a label.
  static void set_velocities(Object& object, const Array<double>& velocities, const Label& label) {
    const auto rows = rows_of<double, d>(velocities, "velocities");
    if (rows.size() != object.read().complex->number_of_vertices())
      throw py::value_error("give one velocity for each vertex, in the order of cells().points");
    if (label)
      require_liquid(*object.read().fluid, *label);
    object.change(py::none(), [&](Owned_fluid& owned) {
      const auto vertices = owned.complex->vertices();
      const DSC::Vertex_numbers numbers(*owned.complex, vertices);
      const Fluid& fluid = *owned.fluid;
      owned.fluid->set_velocities([&](Vertex_handle v, int liquid) {
        return label && liquid != *label ? fluid.velocity(v, liquid)
                                         : DSC::point_of<Vector>(rows[numbers(v)]);
      });
    });
  }

  // Access

  static auto complex(const Object& object) {
    return std::make_unique<Complex_object<Complex>>(Complex(*object.read().complex));
  }

  static double time(const Object& object) { return object.read().fluid->time(); }

  static py::dict balance(const Object& object) {
    return balance_to_dict(object.read().fluid->balance());
  }

  static double largest_step(const Object& object, double fraction) {
    if (!(fraction > 0) || !std::isfinite(fraction))
      throw py::value_error("the fraction must be positive and finite");
    return object.read().fluid->largest_step(fraction);
  }

  static py::array_t<double> velocities(const Object& object, const Label& label) {
    const Fluid& fluid = *object.read().fluid;
    const auto values =
        at_vertices(fluid, label, Vector(CGAL::NULL_VECTOR),
                    [&](const auto&... arguments) { return fluid.velocity(arguments...); });
    return array_of<double>(values.size(), d,
                            [&](std::size_t i, std::size_t j) { return values[i][int(j)]; });
  }

  static py::array_t<double> pressures(const Object& object, const Label& label) {
    const Fluid& fluid = *object.read().fluid;
    const auto values = at_vertices(
        fluid, label, 0., [&](const auto&... arguments) { return fluid.pressure(arguments...); });
    return array_of<double>(values.size(), [&](std::size_t i) { return values[i]; });
  }

  // Motion

  static py::dict step(Object& object, double dt, const py::dict& options,
                       const py::object& progress) {
    const Owned_fluid& owned = object.read();
    const auto chosen = step_options(options, *owned.complex);
    const typename Fluid::Report report = object.change(
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
        array_of<double>(report.forces_on_solids.size(), d, [&](std::size_t i, std::size_t j) {
          return report.forces_on_solids[i][int(j)];
        });
    result["repetitions"] = report.repetitions.size();
    result["deformation"] = report_to_dict(report.deformation, *owned.complex);
    return result;
  }

  static double relax(Object& object, double dt, unsigned steps, const py::dict& options,
                      const py::object& progress) {
    const auto chosen = step_options(options, *object.read().complex);
    return object.change(progress,
                         [&](Owned_fluid& owned) { return owned.fluid->relax(dt, steps, chosen); });
  }

private:
  static DSC::Fluid_properties
  properties_of(const std::map<int, std::pair<double, double>>& liquids,
                const std::map<int, std::pair<double, double>>& gases,
                const std::map<std::pair<int, int>, double>& tensions, const Coordinates& gravity) {
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
    result.set_gravity(in_space(gravity));
    return result;
  }

  /// Adds a solid, which is of a type of the package.
  template <class Solid>
  static void add_solid(Object& object, const Solid& solid, const py::dict& wall) {
    const DSC::Wall_behavior behavior = wall_behavior(wall);
    object.change(py::none(), [&](Owned_fluid& owned) { owned.fluid->add_solid(solid, behavior); });
  }

  /// \throws py::value_error if a label is not a liquid
  static void require_liquid(const Fluid& fluid, int label) {
    if (fluid.properties().liquid(label) == nullptr)
      throw py::value_error("label " + std::to_string(label) + " is not a liquid");
  }

  /// Returns `value_at(v)` for all vertices, in the order of cells().points. With a label, returns
  /// `value_at(v, label)` for the vertices of this liquid, and zero for all other vertices.
  template <class Value, class ValueAt>
  static std::vector<Value> at_vertices(const Fluid& fluid, const Label& label, const Value& zero,
                                        const ValueAt& value_at) {
    const Complex& complex = fluid.complex();
    const auto vertices = complex.vertices();
    std::vector<Value> result(vertices.size(), zero);
    if (!label) {
      std::transform(vertices.begin(), vertices.end(), result.begin(),
                     [&](Vertex_handle v) { return value_at(v); });
      return result;
    }
    require_liquid(fluid, *label);
    const DSC::Vertex_numbers numbers(complex, vertices);
    for (const auto c : complex.cells())
      for (int i = 0; i < Complex::corners && c->label() == *label; ++i)
        result[numbers(c->vertex(i))] = value_at(c->vertex(i), *label);
    return result;
  }

  static py::dict balance_to_dict(const DSC::Fluid_balance& balance) {
    const auto array = [](const Vector_3& v) {
      return array_of<double>(std::size_t(d), [&](std::size_t i) { return v[int(i)]; });
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
    if constexpr (d == 2)
      result["angular_momentum"] = balance.angular_momentum.z();
    else
      result["angular_momentum"] = array(balance.angular_momentum);
    return result;
  }

  static DSC::Fluid_step_options<Complex> step_options(const py::dict& options,
                                                       const Complex& complex) {
    DSC::Fluid_step_options<Complex> result;
    Options rest(options);
    rest.read("implicitness", result.implicitness);
    rest.read("interface_tolerance", result.interface_tolerance);
    rest.read("adaptation_interval", result.adaptation_interval);
    Complex_functions<Complex>::read_deformation(rest, Space<Complex>(complex), result.deformation);
    rest.require_all_read();
    return result;
  }
};

/// Adds the class of fluids of a complex to the module.
template <class Complex> void bind_fluid(py::module_& module, const char* name) {
  using Functions = Fluid_functions<Complex>;
  py::class_<typename Functions::Object> fluid(module, name);
  fluid.def(py::init(&Functions::make))
      .def("add_plane", &Functions::add_plane)
      .def("add_tank", &Functions::add_tank)
      .def("add_ball", &Functions::add_ball)
      .def("set_side", &Functions::set_side)
      .def("set_sources", &Functions::set_sources)
      .def("set_velocities", &Functions::set_velocities)
      .def("complex", &Functions::complex)
      .def("time", &Functions::time)
      .def("balance", &Functions::balance)
      .def("largest_step", &Functions::largest_step)
      .def("velocities", &Functions::velocities)
      .def("pressures", &Functions::pressures)
      .def("step", &Functions::step)
      .def("relax", &Functions::relax);
  if constexpr (Complex::dimension == 3)
    fluid.def("add_cylinder", &Functions::add_cylinder).def("add_mesh", &Functions::add_mesh);
}

} // namespace

void bind_fluids(py::module_& module) {
  bind_fluid<CGAL::Deformable_simplicial_complex_2<>>(module, "Fluid2");
  bind_fluid<CGAL::Deformable_simplicial_complex_3<>>(module, "Fluid3");
}

} // namespace dsc_python

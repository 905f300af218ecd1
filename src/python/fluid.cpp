// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// First, because these headers declare the templates that are compiled already.
#include <CGAL/Incompressible_fluids_3/compiled_2.h>
#include <CGAL/Incompressible_fluids_3/compiled_3.h>

#include "Complex_object.h"
#include "Fluid_solids.h"
#include "bind_complex.h"
#include "module.h"

#include <CGAL/Mesh_support/coordinates.h>

namespace dsc_python {
namespace {

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

  using Object = Fluid_object<Complex>;
  using Owned = Owned_fluid<Complex>;

  /// Density, viscosity and diffusivity by label
  using Liquids = std::map<int, std::array<double, 3>>;
  /// Numbers or functions of the field, by labels
  using Tensions = std::map<std::pair<int, int>, py::object>;

  static std::unique_ptr<Object> make(const Complex_object<Complex>& given, const Liquids& liquids,
                                      const std::map<int, std::pair<double, double>>& gases,
                                      const Tensions& tensions, const Coordinates& gravity) {
    const auto& normalization = given.read().normalization();
    if (normalization.scale != 1 || normalization.translation != CGAL::NULL_VECTOR)
      throw py::value_error(
          std::string("the complex has an origin or a unit of its own, which fluids do not "
                      "support: use ") +
          (d == 2 ? "Complex2.from_triangles" : "Complex3.from_tetrahedra") +
          "(cells.points, cells.cells, cells.labels) with cells = complex.cells()");
    Owned result;
    result.complex = std::make_unique<Complex>(given.read());
    result.fluid =
        std::make_unique<Fluid>(*result.complex, properties_of(liquids, gases, tensions, gravity));
    return std::make_unique<Object>(std::move(result));
  }

  // Set-up

  static void set_side(Object& object, int axis, bool is_upper,
                       const std::optional<Coordinates>& velocity,
                       const std::optional<py::function>& inflow,
                       const std::optional<py::function>& pressure) {
    DSC::Side_behavior behavior;
    if (velocity)
      behavior.velocity = in_space(*velocity);
    using Point = std::array<double, 3>;
    if (inflow)
      behavior.inflow = [given = Side_function<d>(*inflow)](const Point& p, double t) {
        return given.vector(p, t);
      };
    if (pressure)
      behavior.pressure = [given = Side_function<d>(*pressure)](const Point& p, double t) {
        return given.number(p, t);
      };
    object.change(py::none(),
                  [&](Owned& owned) { owned.fluid->set_side(axis, is_upper, behavior); });
  }

  static void set_gravity(Object& object, const Coordinates& gravity) {
    object.change(py::none(), [&](Owned& owned) { owned.fluid->set_gravity(in_space(gravity)); });
  }

  static void set_sources(Object& object, const std::vector<Source>& sources) {
    for (const auto& [center, radius, rate] : sources)
      if (!(radius > 0) || !std::isfinite(radius) || !std::isfinite(rate) ||
          !std::all_of(center.begin(), center.end(), [](double c) { return std::isfinite(c); }))
        throw py::value_error(
            "a source must have a finite center, a positive radius and a finite rate");
    object.change(py::none(), [&](Owned& owned) {
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

  /// Adds a source.
  /// \param is_in a function of an array of points
  /// \param flux a number or a function of the time
  static void add_source(Object& object, const py::function& is_in, const py::object& flux) {
    const Region_function<typename Fluid::Point> region(is_in);
    const Number_function flux_at(flux);
    object.change(py::none(), [&](Owned& owned) { owned.fluid->add_source(region, flux_at); });
  }

  /// Sets the field.
  /// \param function a function of an array of points
  static void set_field(Object& object, const py::function& function) {
    const Field_function<typename Fluid::Point> field(function);
    object.change(py::none(), [&](Owned& owned) {
      owned.fluid->set_field([&](const typename Fluid::Point& p) {
        return field(p).value_or(std::numeric_limits<double>::quiet_NaN());
      });
    });
  }

  /// Gives values of the field on the boundary.
  /// \param function a function of an array of points and a time
  static void fix_field(Object& object, const py::function& function) {
    const Field_function<typename Fluid::Point> field(function);
    object.change(py::none(), [&](Owned& owned) { owned.fluid->fix_field(field); });
  }

  /// Sets the velocities of all liquids, or of the liquid with a label.
  static void set_velocities(Object& object, const Array<double>& velocities, const Label& label) {
    const auto rows = rows_of<double, d>(velocities, "velocities");
    if (rows.size() != object.read().complex->number_of_vertices())
      throw py::value_error("give one velocity for each vertex, in the order of cells().points");
    if (label)
      require_liquid(*object.read().fluid, *label);
    object.change(py::none(), [&](Owned& owned) {
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
    return array_of_vectors(values, d);
  }

  static py::array_t<double> pressures(const Object& object, const Label& label) {
    const Fluid& fluid = *object.read().fluid;
    const auto values = at_vertices(
        fluid, label, 0., [&](const auto&... arguments) { return fluid.pressure(arguments...); });
    return array_of<double>(values.size(), [&](std::size_t i) { return values[i]; });
  }

  /// Returns the field at the vertices, in the order of cells().points.
  static py::array_t<double> field(const Object& object) {
    const Fluid& fluid = *object.read().fluid;
    const auto vertices = fluid.complex().vertices();
    return array_of<double>(vertices.size(),
                            [&](std::size_t i) { return fluid.field(vertices[i]); });
  }

  /// Returns the vorticity of each cell, in the order of cells().cells.
  static py::array_t<double> vorticity(const Object& object) {
    const Fluid& fluid = *object.read().fluid;
    const auto cells = fluid.complex().cells();
    if constexpr (d == 2) {
      return array_of<double>(cells.size(),
                              [&](std::size_t i) { return fluid.vorticity(cells[i]); });
    } else {
      std::vector<Vector> values;
      for (const auto c : cells)
        values.push_back(fluid.vorticity(c));
      return array_of_vectors(values, d);
    }
  }

  // Motion

  static py::dict step(Object& object, double dt, const py::dict& options,
                       const py::object& progress) {
    const Owned& owned = object.read();
    const auto chosen = step_options(options, *owned.complex);
    const typename Fluid::Report report =
        object.change(progress, [&](Owned& changed) { return changed.fluid->advance(dt, chosen); });
    py::dict result;
    result["dt"] = report.dt;
    result["substeps"] = report.parts;
    result["balance"] = balance_to_dict(report.after);
    result["greatest_velocity"] = report.greatest_velocity;
    result["greatest_correction"] = report.greatest_correction;
    result["volume_error"] = report.volume_error;
    result["gained_volume"] = report.gained_volume;
    result["volume_through_sides"] = array_of<double>(
        std::size_t(2 * d), [&](std::size_t i) { return report.volume_through_sides[i]; });
    result["work_of_tensions"] = report.work_of_tensions;
    result["residual"] = report.residual;
    result["contacts"] = report.contacts;
    result["depth_in_solids"] = report.depth_in_solids;
    result["forces_on_solids"] = array_of_vectors(report.forces_on_solids, d);
    result["torques_on_solids"] = torques_to_array(report.torques_on_solids);
    result["repetitions"] = report.repetitions.size();
    result["deformation"] = report_to_dict(report.deformation, *owned.complex);
    return result;
  }

  static double relax(Object& object, double dt, unsigned steps, const py::dict& options,
                      const py::object& progress) {
    const auto chosen = step_options(options, *object.read().complex);
    return object.change(progress,
                         [&](Owned& owned) { return owned.fluid->relax(dt, steps, chosen); });
  }

private:
  static DSC::Fluid_properties properties_of(const Liquids& liquids,
                                             const std::map<int, std::pair<double, double>>& gases,
                                             const Tensions& tensions, const Coordinates& gravity) {
    DSC::Fluid_properties result;
    for (const auto& [label, liquid] : liquids)
      result.set_liquid(label, {liquid[0], liquid[1], {}, liquid[2]});
    for (const auto& [label, gas] : gases)
      result.set_gas(label, {gas.first, gas.second});
    for (const auto& [labels, tension] : tensions) {
      if (labels.first > labels.second && tensions.count({labels.second, labels.first}) > 0)
        throw py::value_error("a surface tension is given twice, for both orders of its labels");
      if (py::isinstance<py::function>(tension))
        result.set_surface_tension(labels.first, labels.second, Number_function(tension));
      else
        result.set_surface_tension(labels.first, labels.second, tension.template cast<double>());
    }
    result.set_gravity(in_space(gravity));
    return result;
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
      for (int i = 0; i < Complex::corners && c->subdomain_index() == *label; ++i)
        result[numbers(c->vertex(i))] = value_at(c->vertex(i), *label);
    return result;
  }

  static py::array_t<double> torques_to_array(const std::vector<Vector_3>& torques) {
    if constexpr (d == 2)
      return array_of<double>(torques.size(), [&](std::size_t i) { return torques[i].z(); });
    else
      return array_of_vectors(torques, d);
  }

  static py::dict balance_to_dict(const DSC::Fluid_balance& balance) {
    py::dict result;
    result["volume"] = balance.volume;
    result["mass"] = balance.mass;
    result["kinetic_energy"] = balance.kinetic_energy;
    result["potential_energy"] = balance.potential_energy;
    result["surface_energy"] = balance.surface_energy;
    result["gas_energy"] = balance.gas_energy;
    result["energy"] = balance.energy();
    result["field_integral"] = balance.field_integral;
    result["least_field"] = balance.least_field;
    result["greatest_field"] = balance.greatest_field;
    result["momentum"] = array_of_first<d>(balance.momentum);
    result["angular_momentum"] = rotation_to_python<d>(balance.angular_momentum);
    return result;
  }

  static DSC::Fluid_step_options<Complex> step_options(const py::dict& options,
                                                       const Complex& complex) {
    DSC::Fluid_step_options<Complex> result;
    Complex_functions<Complex>::read_motion(Options(options), Space<Complex>(complex), result,
                                            result.deformation);
    return result;
  }
};

/// Adds the class of fluids of a complex to the module.
template <class Complex> void bind_fluid(py::module_& module, const char* name) {
  using Functions = Fluid_functions<Complex>;
  using Solids = Fluid_solids<Complex>;
  py::class_<typename Functions::Object>(module, name)
      .def(py::init(&Functions::make))
      .def("add_solid", &Solids::add)
      .def("bodies", &Solids::bodies)
      .def("set_side", &Functions::set_side)
      .def("set_gravity", &Functions::set_gravity)
      .def("set_sources", &Functions::set_sources)
      .def("add_source", &Functions::add_source)
      .def("set_field", &Functions::set_field)
      .def("fix_field", &Functions::fix_field)
      .def("set_velocities", &Functions::set_velocities)
      .def("complex", &Functions::complex)
      .def("time", &Functions::time)
      .def("balance", &Functions::balance)
      .def("largest_step", &Functions::largest_step)
      .def("velocities", &Functions::velocities)
      .def("pressures", &Functions::pressures)
      .def("field", &Functions::field)
      .def("vorticity", &Functions::vorticity)
      .def("step", &Functions::step)
      .def("relax", &Functions::relax);
}

} // namespace

void bind_fluids(py::module_& module) {
  bind_fluid<CGAL::Deformable_simplicial_complex_2<>>(module, "Fluid2");
  bind_fluid<CGAL::Deformable_simplicial_complex_3<>>(module, "Fluid3");
}

} // namespace dsc_python

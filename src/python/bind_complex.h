// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_BIND_COMPLEX_H
#define DSC_PYTHON_BIND_COMPLEX_H

#include "Complex_object.h"
#include "Growth_object.h"
#include "Vertex_images.h"
#include "callbacks.h"
#include "motions/motion.h"
#include "options.h"
#include "reports.h"

#include <CGAL/Complex_construction/fill_torus.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Complex_construction/sample_labels.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/grain_statistics.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Interface_remeshing/remove_components.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_files/checkpoint.h>

namespace dsc_python {

template <> struct Names_of<DSC::Domain_rule>
{
  inline static const std::map<std::string, DSC::Domain_rule> values = {
      {"refuse", DSC::Domain_rule::refuse},
      {"grow", DSC::Domain_rule::grow},
      {"stop", DSC::Domain_rule::stop}};
};

template <> struct Names_of<DSC::Integration_scheme>
{
  inline static const auto& values = dsc::integration_schemes();
};

/// Returns a complex for Python. `make()` makes it, as a long function.
template <class Make> auto guarded(const py::object& progress, const Make& make) {
  using Complex = decltype(make());
  const Long_function function(progress);
  return std::make_unique<Complex_object<Complex>>(make());
}

/// The functions of a complex for Python. Coordinates and measures are those of the user.
template <class Complex> class Complex_functions
{
public:
  using Object = Complex_object<Complex>;
  static constexpr int d = Complex::dimension;

  static py::tuple interface_(const Object& object) {
    const Complex& complex = object.read();
    const DSC::Interface_snapshot<Complex> snapshot(complex);
    const auto& facets = snapshot.facets();
    Vertex_images<Complex> images(complex, snapshot.vertices);
    const auto indices =
        array_of<std::int64_t>(facets.size(), d, [&](std::size_t i, std::size_t j) {
          const auto& v = facets[i].vertices;
          return images.index(
              v[j], complex.domain().nearest_image(images.position(v[0]), images.position(v[j])));
        });
    const auto labels = array_of<std::int32_t>(facets.size(), 2, [&](std::size_t i, std::size_t j) {
      return j == 0 ? facets[i].behind : facets[i].in_front;
    });
    return py::make_tuple(images.points(), indices, labels, images.ids(), images.vertices());
  }

  static py::tuple cells(const Object& object) {
    const Complex& complex = object.read();
    const auto vertices = complex.vertices();
    const auto cells = complex.cells();
    const DSC::Vertex_numbers numbers(complex, vertices);
    Vertex_images<Complex> images(complex, vertices);
    const auto indices =
        array_of<std::int64_t>(cells.size(), d + 1, [&](std::size_t i, std::size_t j) {
          return images.index(numbers(cells[i]->vertex(int(j))), complex.corner(cells[i], int(j)));
        });
    const auto labels = array_of<std::int32_t>(
        cells.size(), [&](std::size_t i) { return cells[i]->subdomain_index(); });
    return py::make_tuple(images.points(), indices, labels, images.ids(), images.vertices());
  }

  static py::array_t<double> qualities(const Object& object) {
    const Complex& complex = object.read();
    const auto cells = complex.cells();
    return array_of<double>(cells.size(), [&](std::size_t i) { return complex.quality(cells[i]); });
  }

  static std::map<int, double> volumes(const Object& object) {
    const Complex& complex = object.read();
    const Space<Complex> space(complex);
    std::map<int, double> result;
    for (const int label : complex.labels())
      result[label] = space.measure(complex.measure(label));
    return result;
  }

  static std::map<int, std::size_t> components(const Object& object) {
    const Complex& complex = object.read();
    std::map<int, std::size_t> result;
    for (const int label : complex.labels())
      result[label] = complex.number_of_components(label);
    return result;
  }

  /// Returns the labels at the points of a grid, the first axis fastest.
  static py::array_t<std::int32_t> sample(const Object& object,
                                          const std::array<std::size_t, d>& size,
                                          const std::array<double, d>& spacing,
                                          const std::array<double, d>& origin, int outside,
                                          const py::object& progress) {
    std::vector<int> labels;
    if constexpr (Complex::Domain::has_outside)
      labels = object.read_long(progress, [&](const Complex& complex) {
        return DSC::sample_labels(complex, {size, spacing, origin}, outside);
      });
    else
      throw py::value_error("labels cannot be sampled on a torus");
    return array_of<std::int32_t>(labels.size(), [&](std::size_t i) { return labels[i]; });
  }

  static std::size_t missing_facets(const Object& object, double edge_per_thickness) {
    if constexpr (Complex::Domain::has_outside)
      return DSC::missing_facets(object.read(), edge_per_thickness);
    else
      throw py::value_error("thin parts are not measured on a torus");
  }

  static py::bytes to_bytes(const Object& object, const std::string& metadata) {
    return object.read_long(py::none(), [&](const Complex& complex) {
      return CGAL::IO::checkpoint_to_bytes(complex.state(), metadata);
    });
  }

  /// Returns the complex and the metadata.
  static py::tuple from_bytes(const std::string& bytes, const py::object& progress) {
    std::string metadata;
    auto object = guarded(progress, [&] {
      auto checkpoint = CGAL::IO::checkpoint_from_bytes<d>(bytes);
      metadata = std::move(checkpoint.metadata);
      Complex complex;
      complex.restore(checkpoint.state);
      return complex;
    });
    return py::make_tuple(py::cast(std::move(object)), py::bytes(metadata));
  }

  static py::dict advect(Object& object, const py::function& velocity, double t, double dt,
                         const py::dict& options, const py::object& progress) {
    return move(
        object, false, Options(options), progress, dt,
        [&](const Space<Complex>& space) { return Velocity_function<Complex>(velocity, space); },
        t);
  }

  static py::dict offset(Object& object, double distance, const py::dict& options,
                         const py::object& progress) {
    Options rest(options);
    DSC::Corner_rule corners = DSC::Corner_rule::miter;
    rest.read_name("corners", dsc::corner_rules(), corners);
    return move(object, false, rest, progress, 1., [&](const Space<Complex>& space) {
      return DSC::Normal_offset{distance / space.scale(), corners};
    });
  }

  static py::dict mean_curvature(Object& object, double dt, bool keeps_volumes,
                                 const py::dict& options, const py::object& progress) {
    // The flow shrinks areas at a constant rate, so that time has the unit of an area.
    const double scale = Space<Complex>(object.read()).scale();
    Options rest(options);
    const DSC::Interface_energy energy = read_energy(rest, scale);
    return move(object, true, rest, progress, dt / (scale * scale), [&](const Space<Complex>&) {
      return DSC::Mean_curvature_flow(energy, keeps_volumes);
    });
  }

  /// Returns the measures of all labels.
  static py::list grains(const Object& object) {
    const Complex& complex = object.read();
    const double scale = Space<Complex>(complex).scale();
    py::list result;
    for (const auto& grain : DSC::grain_statistics(complex)) {
      py::dict entry;
      entry["label"] = grain.label;
      entry["measure"] = grain.measure * std::pow(scale, d);
      entry["boundary"] = grain.boundary * std::pow(scale, d - 1);
      entry["neighbors"] = grain.neighbors;
      entry["corners"] = grain.corners;
      entry["right_angles"] = grain.right_angles;
      entry["triple_lines"] = grain.triple_lines * scale;
      entry["mean_width"] = grain.mean_width * scale;
      entry["growth"] = grain.growth(d) * (d == 2 ? 1 : scale);
      result.append(entry);
    }
    return result;
  }

  /// Removes all components of each label but the largest one. Returns the labels of those removed.
  static std::vector<int> keep_largest_components(Object& object, const py::object& progress) {
    return object.change(progress, [&](Complex& complex) {
      Value_visitor<Complex> visitor(complex, object);
      return DSC::keep_largest_components(complex, {}, object.has_values() ? &visitor : nullptr);
    });
  }

  static py::dict deform(Object& object, const Array<double>& destinations, const py::dict& options,
                         const py::object& progress) {
    const Complex& complex = object.read();
    const Space<Complex> space(complex);
    DSC::Deformation_options<Complex> deformation;
    read_motion(Options(options), space, deformation, deformation);
    const auto points = space.points(destinations, "destinations");
    const auto report = change(object, progress, deformation, [&](Complex& changed) {
      const DSC::Interface_vertices<Complex> interface_vertices(changed);
      return DSC::deform_interface_to(changed, interface_vertices, points, deformation);
    });
    return report_to_dict(report, complex);
  }

  static bool restore_volumes(Object& object, std::map<int, double> volumes,
                              const py::dict& options, const py::object& progress) {
    const Space<Complex> space(object.read());
    DSC::Volume_restoration_options<Complex> restoration;
    read_motion(Options(options), space, restoration, restoration.deformation);
    for (auto& [label, volume] : volumes)
      volume /= space.measure(1);
    return change(object, progress, restoration.deformation, [&](Complex& complex) {
      return DSC::restore_volumes(complex, volumes, restoration).complete;
    });
  }

  static py::dict improve(Object& object, const py::dict& options, const py::object& progress) {
    return remesh<DSC::Mesh_improvement_options<Complex>>(
        object, options, {}, progress,
        [](auto&... arguments) { return DSC::improve_mesh(arguments...); });
  }

  static py::dict improve_interface(Object& object, const py::dict& options,
                                    const py::object& progress) {
    return remesh<DSC::Interface_improvement_options<Complex>>(
        object, options,
        {{"interface_split_length", "split_length"},
         {"interface_collapse_length", "collapse_length"}},
        progress, [](auto&... arguments) { return DSC::improve_interface(arguments...); });
  }

  static py::dict control_detail(Object& object, const py::dict& options,
                                 const py::object& progress) {
    return remesh<DSC::Detail_options<Complex>>(
        object, options, {}, progress,
        [](auto&... arguments) { return DSC::control_detail(arguments...); });
  }

  /// Reads the options of a motion, and those of its deformations.
  template <class Motion>
  static void read_motion(Options rest, const Space<Complex>& space, Motion& motion,
                          DSC::Deformation_options<Complex>& deformation) {
    const py::object topology = rest.take("topology");
    rest.read_all(motion);
    read_topology(topology, space, deformation);
  }

private:
  using Deformation_options = DSC::Deformation_options<Complex>;

  /// Changes the complex, and transfers its values.
  template <class Options, class Change>
  static auto change(Object& object, const py::object& progress, Options& options,
                     const Change& change) {
    return object.change(progress, [&](Complex& complex) {
      Value_visitor<Complex> visitor(complex, object);
      if (object.has_values())
        options.visitor = &visitor;
      return change(complex);
    });
  }

  /// Reads options and changes the mesh.
  /// \param names names of options that differ in Python
  template <class Remeshing, class Remesh>
  static py::dict remesh(Object& object, const py::dict& options,
                         const std::map<std::string, std::string>& names,
                         const py::object& progress, const Remesh& change_mesh) {
    Remeshing remeshing;
    Options(options).read_all(remeshing, names);
    return report_to_dict(change(object, progress, remeshing, [&](Complex& complex) {
      return change_mesh(complex, remeshing);
    }));
  }

  /// Moves the interface for one time step. With the option `adapt`, also adapts it.
  template <class Flow_in>
  static py::dict move(Object& object, bool contracts, Options rest, const py::object& progress,
                       double dt, const Flow_in& flow_in, double t = 0) {
    const Complex& complex = object.read();
    const Space<Complex> space(complex);
    const auto flow = flow_in(space);
    bool adapts = false;
    rest.read("adapt", adapts);
    DSC::Adaptive_advection_options<Complex> adaptive(contracts);
    DSC::Advection_options<Complex> plain;
    DSC::Advection_options<Complex>& advection = adapts ? adaptive.advection : plain;
    if (!object.has_values()) // a domain that grows gets other vertices and cells
      advection.deformation.domain_rule = DSC::Domain_rule::grow;
    if (adapts)
      read_motion(rest, space, adaptive, advection.deformation);
    else
      read_motion(rest, space, plain, advection.deformation);
    if (object.has_values() && advection.deformation.domain_rule == DSC::Domain_rule::grow)
      throw py::value_error(
          "the domain of a complex with values cannot grow: remove the values, or "
          "use a larger box");
    const auto report = change(object, progress, advection.deformation, [&](Complex& changed) {
      return adapts ? DSC::advect_adaptively(changed, flow, t, dt, adaptive)
                    : DSC::advect_interface(changed, flow, t, dt, plain);
    });
    return report_to_dict(report, complex);
  }

  /// Reads 'allow', 'forbid', pairs of labels, or a function.
  static void read_topology(const py::object& topology, const Space<Complex>& space,
                            Deformation_options& deformation) {
    if (topology.is_none())
      return;
    if (py::isinstance<py::function>(topology)) {
      deformation.topology_control = Topology_function<Complex>(topology, space);
    } else if (py::isinstance<py::str>(topology)) {
      const auto name = topology.cast<std::string>();
      if (name == "forbid")
        deformation.forbid_topology_changes();
      else if (name != "allow")
        throw py::value_error("topology must be 'allow', 'forbid', pairs of labels or a function, "
                              "not '" +
                              name + "'");
    } else {
      try {
        deformation.topology_control =
            DSC::Allow_topology_changes_between(topology.cast<std::vector<std::pair<int, int>>>());
      } catch (const py::cast_error&) {
        throw py::type_error("topology must be 'allow', 'forbid', pairs of labels or a function");
      }
    }
  }
};

/// Adds the class of a complex to the module. Constructors that depend on the dimension are added
/// by the caller.
template <class Complex>
py::class_<Complex_object<Complex>> bind_complex(py::module_& module, const char* name) {
  using Functions = Complex_functions<Complex>;
  using Object = Complex_object<Complex>;
  using Growth = Growth_object<Complex>;
  py::class_<Growth>(module, ("GrainGrowth" + std::string(name)).c_str())
      .def(py::init<Object&, const py::dict&>(), py::keep_alive<1, 2>())
      .def("time", &Growth::time)
      .def("set_time", &Growth::set_time)
      .def("advance", &Growth::advance);
  return py::class_<Object>(module, name)
      .def_static("from_bytes", &Functions::from_bytes)
      .def("to_bytes", &Functions::to_bytes)
      .def("copy", &Object::copy)
      .def("equals",
           [](const Object& a, const Object& b) { return a.read().state() == b.read().state(); })
      .def("number_of_vertices",
           [](const Object& object) { return object.read().number_of_vertices(); })
      .def("number_of_cells", [](const Object& object) { return object.read().number_of_cells(); })
      .def("labels", [](const Object& object) { return object.read().labels(); })
      .def("mean_interface_edge",
           [](const Object& object) {
             return object.read().mean_interface_edge() * Space<Complex>(object.read()).scale();
           })
      .def("is_valid", [](const Object& object) { return object.read().is_valid(); })
      .def("interface", &Functions::interface_)
      .def("cells", &Functions::cells)
      .def("qualities", &Functions::qualities)
      .def("value_names",
           [](const Object& object, bool on_cells) {
             object.read();
             return on_cells ? object.cell_values.names() : object.vertex_values.names();
           })
      .def("get_values",
           [](const Object& object, bool on_cells, const std::string& name) {
             const Complex& complex = object.read();
             return on_cells ? object.cell_values.get(name, complex.cells())
                             : object.vertex_values.get(name, complex.vertices());
           })
      .def("set_values",
           [](Object& object, bool on_cells, const std::string& name, const Array<double>& values) {
             const Complex& complex = object.at_rest();
             if (on_cells)
               object.cell_values.set(name, values, complex.cells());
             else
               object.vertex_values.set(name, values, complex.vertices());
           })
      .def("remove_values",
           [](Object& object, bool on_cells, const std::string& name) {
             object.at_rest();
             return on_cells ? object.cell_values.remove(name) : object.vertex_values.remove(name);
           })
      .def("sample", &Functions::sample)
      .def("volumes", &Functions::volumes)
      .def("components", &Functions::components)
      .def("advect", &Functions::advect)
      .def("offset", &Functions::offset)
      .def("mean_curvature", &Functions::mean_curvature)
      .def("grains", &Functions::grains)
      .def("keep_largest_components", &Functions::keep_largest_components)
      .def("deform", &Functions::deform)
      .def("restore_volumes", &Functions::restore_volumes)
      .def("improve", &Functions::improve)
      .def("improve_interface", &Functions::improve_interface)
      .def("missing_facets", &Functions::missing_facets)
      .def("control_detail", &Functions::control_detail);
}

/// Binds a complex on a torus.
template <class Complex> void bind_torus(py::module_& module, const char* name) {
  constexpr int d = Complex::dimension;
  bind_complex<Complex>(module, name)
      .def_static("from_function",
                  [](const py::function& label_at, const std::array<double, d>& periods,
                     double edge, const py::object& progress) {
                    const Label_function<Complex> labels(label_at);
                    const DSC::Torus_domain<d> domain(periods);
                    return guarded(progress, [&] {
                      return DSC::fill_torus<Complex>(domain, edge, labels,
                                                      DSC::Deformation_options<Complex>());
                    });
                  })
      .def("periods",
           [](const Complex_object<Complex>& object) { return object.read().domain().periods(); });
}

} // namespace dsc_python

#endif // DSC_PYTHON_BIND_COMPLEX_H

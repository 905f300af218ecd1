// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind_complex.h"
#include "module.h"
#include "options_of_construction.h"

#include <CGAL/Complex_construction/fill_solids_3.h>
#include <CGAL/Interface_flows/compiled_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <optional>

namespace dsc_python {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;

/// \param surfaces points (n, 3), triangles (m, 3) and label of each surface
auto from_surfaces(const std::vector<std::tuple<Array<double>, py::array, int>>& surfaces,
                   const py::dict& options, const py::object& progress) {
  std::vector<DSC::Labeled_surface_3<Point>> input;
  for (const auto& [points, triangles, label] : surfaces)
    input.push_back(
        {input_points<Complex>(points, "points"), index_rows_of<3>(triangles, "triangles"), label});
  const auto construction = construction_options<3>(options);
  return guarded(progress, [&] {
    std::optional<DSC::Patches_of_surfaces_3<Point>> patches;
    return DSC::fill_solids_3<Complex>(input, CGAL::Tetgen_tetrahedralizer_3(), patches,
                                       construction);
  });
}

/// \param is_domain whether the tetrahedra are the domain; otherwise space around them is filled
auto from_tetrahedra(const Array<double>& points, const py::array& tetrahedra,
                     const py::array& labels, bool is_domain, const py::dict& options,
                     const py::object& progress) {
  const auto corners = input_points<Complex>(points, "points");
  const auto cells = index_rows_of<4>(tetrahedra, "tetrahedra");
  const auto cell_labels = labels_of(labels, "labels");
  const auto construction = construction_options<3>(options);
  return guarded(progress, [&] {
    return is_domain
               ? DSC::make_deformable_simplicial_complex_3<Complex>(corners, cells, cell_labels,
                                                                    construction)
               : DSC::make_deformable_simplicial_complex_3<Complex>(
                     corners, cells, cell_labels, CGAL::Tetgen_tetrahedralizer_3(), construction);
  });
}

auto from_function(const py::function& label_at, const Box<3>& box, double edge,
                   const py::object& progress) {
  const Label_function<Complex> labels(label_at);
  return guarded(progress, [&] {
    return DSC::make_deformable_simplicial_complex_3<Complex>(bbox_of(box), edge, labels);
  });
}

} // namespace

void bind_complex_3(py::module_& module) {
  bind_complex<Complex>(module, "Complex3")
      .def_static("from_surfaces", &from_surfaces)
      .def_static("from_tetrahedra", &from_tetrahedra)
      .def_static("from_function", &from_function);
}

} // namespace dsc_python

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind_complex.h"
#include "module.h"
#include "options.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/compiled_2.h>

namespace dsc_python {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;

/// \param polygons closed polylines (n, 2) and label of each region
auto from_polygons(const std::vector<std::pair<std::vector<Array<double>>, int>>& polygons,
                   const py::dict& options, const py::object& progress) {
  std::vector<DSC::Labeled_curve_2<Point>> input;
  for (const auto& [rings, label] : polygons) {
    input.emplace_back();
    input.back().label = label;
    for (const Array<double>& ring : rings)
      input.back().add_polyline(input_points<Complex>(ring, "a polygon"));
  }
  const auto construction = construction_options<2>(options);
  return guarded(progress, [&] {
    return DSC::make_deformable_simplicial_complex_2<Complex>(input, construction);
  });
}

auto from_triangles(const Array<double>& points, const py::array& triangles,
                    const py::array& labels, const py::dict& options, const py::object& progress) {
  const auto corners = input_points<Complex>(points, "points");
  const auto cells = index_rows_of<3>(triangles, "triangles");
  const auto cell_labels = labels_of(labels, "labels");
  const auto construction = construction_options<2>(options);
  return guarded(progress, [&] {
    return DSC::make_deformable_simplicial_complex_2<Complex>(corners, cells, cell_labels,
                                                              construction);
  });
}

auto from_function(const py::function& label_at, const Box<2>& box, double edge,
                   const py::object& progress) {
  const Label_function<Complex> labels(label_at);
  return guarded(progress, [&] {
    return DSC::make_deformable_simplicial_complex_2<Complex>(bbox_of(box), edge, labels);
  });
}

/// \param labels the pixels row by row from top to bottom
auto from_image(const py::array& labels, std::size_t width, std::size_t height, double spacing,
                const std::array<double, 2>& origin, double edge, const py::object& progress) {
  const DSC::Labeled_image_2 image{width, height, labels_of(labels, "labels")};
  static constexpr double least = 1e-30, most = 1e30; // as for all complexes
  const double extent = spacing * double((std::max)(width, height));
  if (!(extent >= least && extent <= most))
    throw py::value_error(
        "the spacing must be positive, and the extent of the image between 1e-30 and "
        "1e30");
  if (!std::isfinite(origin[0]) || !std::isfinite(origin[1]))
    throw py::value_error("the origin must be finite");
  return guarded(progress, [&] {
    Complex complex = DSC::make_deformable_simplicial_complex_2<Complex>(image, edge / spacing);
    // Pixels have the side 1, and the origin is the lower left corner of the image.
    complex.set_normalization(
        {Complex::Vector(origin[0] - spacing / 2, origin[1] - spacing / 2), spacing});
    return complex;
  });
}

} // namespace

void bind_complex_2(py::module_& module) {
  bind_complex<Complex>(module, "Complex2")
      .def_static("from_polygons", &from_polygons)
      .def_static("from_triangles", &from_triangles)
      .def_static("from_image", &from_image)
      .def_static("from_function", &from_function);
}

} // namespace dsc_python

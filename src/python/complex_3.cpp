// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind_complex.h"
#include "module.h"
#include "options.h"

#include "input/tetrahedralizer.h"

#include <CGAL/Complex_construction/convert_labeled_image_3.h>
#include <CGAL/Complex_construction/fill_solids_3.h>
#include <CGAL/Interface_flows/compiled_3.h>

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
    return DSC::fill_solids_3<Complex>(input, dsc::Tetrahedralizer(), patches, construction);
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
    return is_domain ? DSC::make_deformable_simplicial_complex_3<Complex>(corners, cells,
                                                                          cell_labels, construction)
                     : DSC::make_deformable_simplicial_complex_3<Complex>(
                           corners, cells, cell_labels, dsc::Tetrahedralizer(), construction);
  });
}

auto from_function(const py::function& label_at, const Box<3>& box, double edge,
                   const py::object& progress) {
  const Label_function<Complex> labels(label_at);
  return guarded(progress, [&] {
    return DSC::make_deformable_simplicial_complex_3<Complex>(bbox_of(box), edge, labels);
  });
}

using Coordinates = std::array<double, 3>;

/// Returns an image with its first voxel at the origin, whose fastest axis is the first one.
CGAL::Image_3 image_of(const std::vector<int>& labels, const std::array<std::size_t, 3>& size,
                       const Coordinates& spacing) {
  _image* image = _createImage(size[0], size[1], size[2], 1, spacing[0], spacing[1], spacing[2],
                               sizeof(int), WK_FIXED, SGN_SIGNED);
  std::copy(labels.begin(), labels.end(), static_cast<int*>(image->data));
  return CGAL::Image_3(image); // frees the data
}

/// \param labels the voxels, the first axis fastest
auto from_image(const py::array& labels, const std::array<std::size_t, 3>& size,
                const Coordinates& spacing, const Coordinates& origin, double edge,
                const py::dict& options, const py::object& progress) {
  for (const double x : origin)
    if (!std::isfinite(x))
      throw py::value_error("the origin must be finite");
  const std::vector<int> voxels = labels_of(labels, "labels");
  auto construction = construction_options<3>(options);
  if (auto& box = construction.enclosing_box)
    box = CGAL::Bbox_3(box->xmin() - origin[0], box->ymin() - origin[1], box->zmin() - origin[2],
                       box->xmax() - origin[0], box->ymax() - origin[1], box->zmax() - origin[2]);
  const CGAL::Image_3 image = image_of(voxels, size, spacing);
  return guarded(progress, [&] {
    Complex complex = DSC::make_complex_from_labeled_image_3<Complex>(image, edge, construction);
    Complex::Normalization normalization = complex.normalization();
    normalization.translation =
        normalization.translation + Complex::Vector(origin[0], origin[1], origin[2]);
    complex.set_normalization(normalization);
    return complex;
  });
}

} // namespace

void bind_complex_3(py::module_& module) {
  bind_complex<Complex>(module, "Complex3")
      .def_static("from_surfaces", &from_surfaces)
      .def_static("from_tetrahedra", &from_tetrahedra)
      .def_static("from_function", &from_function);
  module.def("complex_from_image_3", &from_image);
}

} // namespace dsc_python

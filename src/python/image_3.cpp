// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// First, because this header declares the templates that are compiled already.
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>

#include "bind_complex.h"
#include "module.h"
#include "options_of_construction.h"

#include <CGAL/Complex_construction/convert_labeled_image_3.h>

#include <algorithm>
#include <cmath>

namespace dsc_python {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
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
        normalization.translation + Complex::Approximate_vector(origin[0], origin[1], origin[2]);
    complex.set_normalization(normalization);
    return complex;
  });
}

} // namespace

void bind_image_3(py::module_& module) { module.def("complex_from_image_3", &from_image); }

} // namespace dsc_python

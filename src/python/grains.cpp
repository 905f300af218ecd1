// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Space.h"
#include "module.h"

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/Grain_orientations.h>
#include <CGAL/Interface_flows/Voronoi_labels.h>

#include <pybind11/stl.h>

namespace dsc_python {
namespace {

namespace DSC = CGAL::Deformable_simplicial_complexes;

/// Adds the Voronoi labels and the orientations of grains of one dimension.
template <class Complex> void bind_grains_of_dimension(py::module_& module) {
  static constexpr int d = Complex::dimension;
  using Labels = DSC::Voronoi_labels<Complex>;
  using Orientations = DSC::Grain_orientations<d>;
  const std::string dimension = std::to_string(d);
  py::class_<Labels>(module, ("Voronoi" + dimension).c_str())
      .def(py::init<std::size_t, const std::array<double, d>&, bool, std::uint32_t, double>())
      .def("__call__", [](const Labels& labels, const Array<double>& points) {
        const auto rows = rows_of<double, d>(points, "points");
        for (const auto& row : rows)
          for (int axis = 0; axis < d; ++axis)
            if (!(row[axis] >= 0 && row[axis] <= labels.sides()[axis]))
              throw py::value_error("a point is outside of the box of the Voronoi diagram");
        return array_of<std::int32_t>(
            rows.size(), [&](std::size_t i) { return labels(DSC::point_at<Complex>(rows[i])); });
      });
  py::class_<Orientations>(module, ("Orientations" + dimension).c_str())
      .def(py::init<std::size_t, std::uint32_t>())
      .def("misorientation", &Orientations::misorientation);
}

} // namespace

void bind_grains(py::module_& module) {
  bind_grains_of_dimension<CGAL::Deformable_simplicial_complex_2<>>(module);
  bind_grains_of_dimension<CGAL::Deformable_simplicial_complex_3<>>(module);
  module.def("read_shockley_energy", &DSC::read_shockley_energy);
}

} // namespace dsc_python

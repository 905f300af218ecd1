// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind_complex.h"
#include "module.h"

#include <CGAL/Complex_construction/fill_torus.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>

namespace dsc_python {
namespace {

using Domain = DSC::Torus_domain<3>;
using Complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                          CGAL::Default, DSC::Volume_length_ratio_3, Domain>;

auto from_function(const py::function& label_at, const std::array<double, 3>& periods, double edge,
                   const py::object& progress) {
  const Label_function<Complex> labels(label_at);
  const Domain domain(periods);
  return guarded(progress, [&] {
    return DSC::fill_torus<Complex>(domain, edge, labels, DSC::Deformation_options<Complex>());
  });
}

} // namespace

void bind_torus_3(py::module_& module) {
  bind_complex<Complex>(module, "Torus3")
      .def_static("from_function", &from_function)
      .def("periods",
           [](const Complex_object<Complex>& object) { return object.read().domain().periods(); });
}

} // namespace dsc_python

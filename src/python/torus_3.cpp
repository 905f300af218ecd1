// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind_complex.h"
#include "module.h"

#include <CGAL/Interface_flows/compiled_torus_3.h>

namespace dsc_python {

void bind_torus_3(py::module_& module) {
  using Complex =
      CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                            CGAL::Default, DSC::Volume_length_ratio_3,
                                            DSC::Torus_domain<3>>;
  bind_torus<Complex>(module, "Torus3");
}

} // namespace dsc_python

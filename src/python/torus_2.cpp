// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind_complex.h"
#include "module.h"

#include <CGAL/Interface_flows/compiled_torus_2.h>

namespace dsc_python {

void bind_torus_2(py::module_& module) {
  bind_torus<DSC::internal::Torus_complex_2>(module, "Torus2");
}

} // namespace dsc_python

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "module.h"

PYBIND11_MODULE(_dsc, module) {
  module.doc() = "Compiled part of the package dsc, which documents its functions.";
  dsc_python::bind_exceptions(module);
  dsc_python::bind_complex_2(module);
  dsc_python::bind_complex_3(module);
#ifdef DSC_PYTHON_TORI
  dsc_python::bind_torus_2(module);
  dsc_python::bind_torus_3(module);
#endif
  dsc_python::bind_reconstruction_3(module);
  dsc_python::bind_cut_loci(module);
  dsc_python::bind_grains(module);
  dsc_python::bind_segmentation(module);
  dsc_python::bind_film(module);
  dsc_python::bind_fluids(module);
}

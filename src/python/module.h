// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_MODULE_H
#define DSC_PYTHON_MODULE_H

#include <pybind11/pybind11.h>

namespace dsc_python {

/// Add the classes and exceptions of the package to the module.
void bind_exceptions(pybind11::module_& module);
void bind_complex_2(pybind11::module_& module);
void bind_complex_3(pybind11::module_& module);
void bind_torus_2(pybind11::module_& module); ///< with the build option DSC_PYTHON_TORI
void bind_torus_3(pybind11::module_& module);
void bind_reconstruction_3(pybind11::module_& module);
void bind_cut_loci(pybind11::module_& module);
void bind_grains(pybind11::module_& module);
void bind_segmentation(pybind11::module_& module);
void bind_film(pybind11::module_& module);
void bind_fluids(pybind11::module_& module);

} // namespace dsc_python

#endif // DSC_PYTHON_MODULE_H

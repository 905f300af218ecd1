// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's list of named parameters, followed by the list of this package. CGAL then declares all of
// them. Compilers find this file before CGAL's file of the same name if its folder is named by -I.
// The file has no include guard, since CGAL includes it several times.

#pragma GCC system_header // no warning that #include_next is an extension

#include_next <CGAL/STL_Extension/internal/parameters_interface.h>

// CGAL includes the file for the tags, for its class and for the functions. In CGAL 5.5, the last
// list lacks a function, see named_parameters.h.
#include <CGAL/version.h>
#if CGAL_VERSION_NR < 1050600000 && defined(CGAL_MESH_SUPPORT_PARAMETERS_ARE_IN_CGAL)
#define CGAL_MESH_SUPPORT_SIZING_FIELD_IS_AN_OBJECT
#endif
#include <CGAL/Mesh_support/named_parameter_list.h>
#undef CGAL_MESH_SUPPORT_SIZING_FIELD_IS_AN_OBJECT

#ifndef CGAL_MESH_SUPPORT_TAGS_ARE_IN_CGAL
#define CGAL_MESH_SUPPORT_TAGS_ARE_IN_CGAL
#elif !defined(CGAL_MESH_SUPPORT_PARAMETERS_ARE_IN_CGAL)
#define CGAL_MESH_SUPPORT_PARAMETERS_ARE_IN_CGAL
#endif

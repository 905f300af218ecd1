// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORM_INTERFACE_3_H
#define CGAL_DEFORM_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Mesh_care_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#endif // CGAL_DEFORM_INTERFACE_3_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ADVECT_INTERFACE_2_H
#define CGAL_ADVECT_INTERFACE_2_H

#include <CGAL/Deformable_simplicial_complexes/advect_interface.h>
#include <CGAL/deform_interface_2.h>

#endif // CGAL_ADVECT_INTERFACE_2_H

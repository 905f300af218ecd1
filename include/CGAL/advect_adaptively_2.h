// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ADVECT_ADAPTIVELY_2_H
#define CGAL_ADVECT_ADAPTIVELY_2_H

#include <CGAL/Curvature_size_field_2.h>
#include <CGAL/Deformable_simplicial_complexes/advect_adaptively.h>
#include <CGAL/advect_interface_2.h>
#include <CGAL/control_detail_2.h>
#include <CGAL/improve_interface_2.h>

#endif // CGAL_ADVECT_ADAPTIVELY_2_H

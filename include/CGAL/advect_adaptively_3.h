// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ADVECT_ADAPTIVELY_3_H
#define CGAL_ADVECT_ADAPTIVELY_3_H

#include <CGAL/Curvature_size_field_3.h>
#include <CGAL/Deformable_simplicial_complexes/advect_adaptively.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/control_detail_3.h>
#include <CGAL/improve_interface_3.h>

#endif // CGAL_ADVECT_ADAPTIVELY_3_H

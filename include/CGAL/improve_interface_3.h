// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMPROVE_INTERFACE_3_H
#define CGAL_IMPROVE_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/remeshing/Interface_improver_3.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>

#endif // CGAL_IMPROVE_INTERFACE_3_H

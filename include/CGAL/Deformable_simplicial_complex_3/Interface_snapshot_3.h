// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERFACE_SNAPSHOT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERFACE_SNAPSHOT_3_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERFACE_SNAPSHOT_3_H

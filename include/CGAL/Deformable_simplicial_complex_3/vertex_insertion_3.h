// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_INSERTION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_INSERTION_3_H

#include <CGAL/Deformable_simplicial_complexes/vertex_insertion.h>

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_INSERTION_3_H

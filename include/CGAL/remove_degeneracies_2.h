// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REMOVE_DEGENERACIES_2_H
#define CGAL_REMOVE_DEGENERACIES_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Own_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/remove_degeneracies.h>

#endif // CGAL_REMOVE_DEGENERACIES_2_H

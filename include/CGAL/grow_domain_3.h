// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GROW_DOMAIN_3_H
#define CGAL_GROW_DOMAIN_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Own_operations_3.h>
#include <CGAL/Deformable_simplicial_complexes/grow_domain.h>

#endif // CGAL_GROW_DOMAIN_3_H

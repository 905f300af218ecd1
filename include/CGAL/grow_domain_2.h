// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GROW_DOMAIN_2_H
#define CGAL_GROW_DOMAIN_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Own_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/grow_domain.h>

#endif // CGAL_GROW_DOMAIN_2_H

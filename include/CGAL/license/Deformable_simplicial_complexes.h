// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_LICENSE_DEFORMABLE_SIMPLICIAL_COMPLEXES_H
#define CGAL_LICENSE_DEFORMABLE_SIMPLICIAL_COMPLEXES_H

// The license of the package Deformable Simplicial Complexes. Users who define
// `CGAL_LICENSE_WARNING` or `CGAL_LICENSE_ERROR` get a warning or an error if they include a header
// of the package.

#include <CGAL/config.h>

#if defined(CGAL_LICENSE_ERROR)
#error "GPL-3.0-or-later applies to the package Deformable Simplicial Complexes."
#elif defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("GPL-3.0-or-later applies to the package Deformable Simplicial Complexes.")
#endif

#endif // CGAL_LICENSE_DEFORMABLE_SIMPLICIAL_COMPLEXES_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_LICENSE_IMAGE_SEGMENTATION_H
#define CGAL_LICENSE_IMAGE_SEGMENTATION_H

// The license of the package Image Segmentation. Users who define
// `CGAL_LICENSE_WARNING` or `CGAL_LICENSE_ERROR` get a warning or an error if they include a header
// of the package.

#include <CGAL/config.h>

#if defined(CGAL_LICENSE_ERROR)
#error "GPL-3.0-or-later applies to the package Image Segmentation."
#elif defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("GPL-3.0-or-later applies to the package Image Segmentation.")
#endif

#endif // CGAL_LICENSE_IMAGE_SEGMENTATION_H

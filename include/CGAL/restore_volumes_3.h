// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTORE_VOLUMES_3_H
#define CGAL_RESTORE_VOLUMES_3_H

#include <CGAL/Deformable_simplicial_complexes/restore_volumes.h>
#include <CGAL/deform_interface_3.h>

#endif // CGAL_RESTORE_VOLUMES_3_H

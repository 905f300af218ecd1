// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_LABEL_NAMES_H
#define CGAL_MESH_FILES_LABEL_NAMES_H

#include <CGAL/license/Mesh_files.h>

#include <map>
#include <string>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

Names of labels, such as those of the solids of a file. A label may have no name.
*/
using Label_names = std::map<int, std::string>;

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_LABEL_NAMES_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_ERROR_H
#define CGAL_MESH_SUPPORT_ERROR_H

#include <stdexcept>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshSupportRef

Base class of all exceptions that this package throws because of its input. `what()` is one line
that states the error and its remedy. Offending simplices are given as indices into the input of the
user.
*/
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_ERROR_H

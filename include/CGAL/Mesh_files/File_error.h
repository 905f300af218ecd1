// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_FILE_ERROR_H
#define CGAL_MESH_FILES_FILE_ERROR_H

#include <CGAL/Mesh_support/Error.h>

#include <string>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

Exception thrown if a file cannot be opened, read, written or understood.
*/
class File_error : public Error
{
public:
  /// Constructs the error; `path` is returned by `path()`.
  File_error(const std::string& message, std::string path)
      : Error(message), m_path(std::move(path)) {}

  /// Returns the path of the file as given by the user.
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

/*!
\ingroup PkgMeshFilesRef

Exception thrown if the array that holds the labels of a file must be chosen by its name.
*/
class Label_array_error : public File_error
{
public:
  using File_error::File_error;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_FILE_ERROR_H

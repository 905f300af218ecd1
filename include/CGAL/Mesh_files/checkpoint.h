// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_CHECKPOINT_H
#define CGAL_MESH_FILES_CHECKPOINT_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Mesh_files/internal/checkpoints/checkpoint_file.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

The content of a checkpoint file of a complex in 3D. The members are `state`, the state of the
complex, and `metadata`, a string of the program, such as time and settings.
*/
using Checkpoint_3 = Deformable_simplicial_complexes::internal::Checkpoint<3>;

/// \ingroup PkgMeshFilesRef
/// The content of a checkpoint file of a complex in 2D, see `Checkpoint_3`.
using Checkpoint_2 = Deformable_simplicial_complexes::internal::Checkpoint<2>;

/*!
\ingroup PkgMeshFilesRef

Writes the state of a complex to a file. A run that continues from the file has bitwise equal
results. Linear in the size of the state; memory for a second copy of it.

The file is binary and the same on all machines: numbers are little-endian, and a checksum covers
all of them. A temporary file in the same folder is written and renamed when complete. If the
program is stopped while writing, the previous checkpoint is thus unchanged.

\tparam d dimension of the complex, 2 or 3
\param path name of the file; its folder must exist
\param state a result of `Labeled_complex::state()`
\param metadata any sequence of bytes, returned by `read_checkpoint()`

\pre parallel arrays of `state` have the same size
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged
*/
template <int d>
void write_checkpoint(const std::string& path,
                      const Deformable_simplicial_complexes::State<d>& state,
                      const std::string& metadata = std::string()) {
  Deformable_simplicial_complexes::replace_file(path, [&](std::ostream& out) {
    Deformable_simplicial_complexes::internal::write_whole(out, state, metadata);
  });
}

/*!
\ingroup PkgMeshFilesRef

Reads a file that `write_checkpoint()` wrote. Linear in the size of the file. Memory is at most a
small multiple of the size of the file.

\tparam d dimension of the complex, 2 or 3
\param path name of the file
\return the state, for `Labeled_complex::restore()`, and the metadata, both bitwise equal to the
        written ones

\throws Deformable_simplicial_complexes::File_error if the file cannot be read, is not a checkpoint
        of this dimension, was written by another version, is truncated, or was changed since.
        Nothing is read from such a file.
*/
template <int d = 3>
Deformable_simplicial_complexes::internal::Checkpoint<d> read_checkpoint(const std::string& path) {
  Deformable_simplicial_complexes::internal::Input_file in(path, ".dsc");
  return Deformable_simplicial_complexes::internal::read_whole<d>(in, path);
}

/// \ingroup PkgMeshFilesRef
/// Does the same as `read_checkpoint<2>()`.
inline Checkpoint_2 read_checkpoint_2(const std::string& path) { return read_checkpoint<2>(path); }

/*!
\ingroup PkgMeshFilesRef

Returns the dimension of the complex in a checkpoint file; 0 if the file is not a checkpoint, or is
one of several ranks. Constant time.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened
*/
inline int checkpoint_dimension(const std::string& path) {
  using namespace Deformable_simplicial_complexes::internal;
  Input_file in(path, ".dsc");
  const std::string magic = checkpoint_magic_of(in);
  for (int d : {2, 3})
    if (magic == checkpoint_magic(Checkpoint_kind::whole, d))
      return d;
  return 0;
}

/*!
\ingroup PkgMeshFilesRef

Returns whether a file starts like a checkpoint of a distributed complex, in any version; `false` if
it cannot be read.
*/
inline bool is_distributed_checkpoint(const std::string& path) {
  using namespace Deformable_simplicial_complexes::internal;
  std::error_code error; // of a device, for example
  if (!std::filesystem::is_regular_file(path, error))
    return false;
  std::ifstream in(path, std::ios::binary);
  const std::string magic = checkpoint_magic_of(in);
  return is_old_magic_of_ranks(magic) || magic == checkpoint_magic(Checkpoint_kind::ranks, 2) ||
         magic == checkpoint_magic(Checkpoint_kind::ranks, 3);
}

/*!
\ingroup PkgMeshFilesRef

Returns the bytes of the file that `write_checkpoint()` writes. Linear in the size of the state.
*/
template <int d>
std::string checkpoint_to_bytes(const Deformable_simplicial_complexes::State<d>& state,
                                const std::string& metadata = std::string()) {
  std::ostringstream out;
  Deformable_simplicial_complexes::internal::write_whole(out, state, metadata);
  return out.str();
}

/*!
\ingroup PkgMeshFilesRef

Returns the content of a file with the given bytes. Linear in the number of bytes.

\throws Deformable_simplicial_complexes::File_error as `read_checkpoint()` does; the path of the file
        is "the checkpoint"
*/
template <int d>
Deformable_simplicial_complexes::internal::Checkpoint<d>
checkpoint_from_bytes(const std::string& bytes) {
  std::istringstream in(bytes);
  return Deformable_simplicial_complexes::internal::read_whole<d>(in, "the checkpoint");
}

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_CHECKPOINT_H

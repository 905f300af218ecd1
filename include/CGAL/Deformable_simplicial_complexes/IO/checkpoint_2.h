// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_2_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/checkpoint_file.h>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is what a checkpoint file in the plane holds: the members `state`, of a complex, and `metadata`, a
string that the program added, e.g. time and settings.
*/
using Checkpoint_2 = Deformable_simplicial_complexes::internal::Checkpoint<2>;

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes the state of a complex to a file from which a run continues to the same bits.

The file is binary and the same on all machines: numbers are little-endian, and a checksum covers
all of them. It is written beside its final place and renamed when complete, so that a program that
is stopped while writing leaves the previous checkpoint as it was.

\param path is the name of the file; its folder must exist.
\param state is what `Deformable_simplicial_complex_2::state()` returned.
\param metadata is any sequence of bytes, given back by `read_checkpoint()`.

\pre the arrays of `state` that run parallel have the same size.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.

Linear in the size of the state; takes memory for a second copy of it.
*/
inline void write_checkpoint(const std::string& path,
                             const Deformable_simplicial_complexes::State<2>& state,
                             const std::string& metadata = std::string()) {
  Deformable_simplicial_complexes::internal::write_checkpoint_file(path, state, metadata);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

reads a file written by `write_checkpoint()` for a planar complex.

\param path is the name of the file.
\return the state, to be handed to `Deformable_simplicial_complex_2::restore()`, and the metadata,
both bit for bit as they were written.

\throws Deformable_simplicial_complexes::File_error if the file cannot be read, is not a
checkpoint, was written by another version, is truncated, or was changed since. Nothing is read
from such a file, and never is more memory asked for than a small multiple of the file's size.

Linear in the size of the file.
*/
inline Checkpoint_2 read_checkpoint_2(const std::string& path) {
  return Deformable_simplicial_complexes::internal::read_checkpoint_file<2>(path);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

returns the dimension of the complex in a checkpoint file, and 0 if it is none: whether
`read_checkpoint_2()` or `read_checkpoint()` is to read it. Constant time.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened.
*/
inline int checkpoint_dimension(const std::string& path) {
  return Deformable_simplicial_complexes::internal::checkpoint_file_dimension(path);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_2_H

// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/checkpoint_file.h>

#include <string>

namespace CGAL::IO {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The content of a checkpoint file of a complex in 3D. The members are `state`, the state of the
complex, and `metadata`, a string of the program, such as time and settings.
*/
using Checkpoint_3 = Deformable_simplicial_complexes::internal::Checkpoint<3>;

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Writes the state of a complex to a file. A run that continues from the file has bitwise equal
results. Linear in the size of the state; memory for a second copy of it.

The file is binary and the same on all machines: numbers are little-endian, and a checksum covers
all of them. A temporary file in the same folder is written and renamed when complete. If the
program is stopped while writing, the previous checkpoint is thus unchanged.

\param path name of the file; its folder must exist
\param state a result of `Labelled_complex::state()`
\param metadata any sequence of bytes, returned by `read_checkpoint()`

\pre parallel arrays of `state` have the same size
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged
*/
inline void write_checkpoint(const std::string& path,
                             const Deformable_simplicial_complexes::State<3>& state,
                             const std::string& metadata = std::string()) {
  Deformable_simplicial_complexes::internal::write_checkpoint_file(path, state, metadata);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Reads a file that `write_checkpoint()` wrote for a complex in 3D. Linear in the size of the file.
Memory is at most a small multiple of the size of the file.

\param path name of the file
\return the state, for `Labelled_complex::restore()`, and the metadata, both bitwise equal to the
        written ones

\throws Deformable_simplicial_complexes::File_error if the file cannot be read, is not a checkpoint,
        was written by another version, is truncated, or was changed since. Nothing is read from
        such a file.
*/
inline Checkpoint_3 read_checkpoint(const std::string& path) {
  return Deformable_simplicial_complexes::internal::read_checkpoint_file<3>(path);
}

} // namespace CGAL::IO

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_3_H

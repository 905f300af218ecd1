// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_BYTES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_BYTES_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/internal/IO/checkpoint_file.h>

#include <string>

namespace CGAL::IO {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the bytes of the file that `write_checkpoint()` writes, with its version and checksum.
Linear in the size of the state.

\tparam d dimension of the complex, 2 or 3
\param state a result of `Labelled_complex::state()`
\param metadata any sequence of bytes, returned by `checkpoint_from_bytes()`

\pre parallel arrays of `state` have the same size
*/
template <int d>
std::string checkpoint_to_bytes(const Deformable_simplicial_complexes::State<d>& state,
                                const std::string& metadata = std::string()) {
  return Deformable_simplicial_complexes::internal::checkpoint_to_bytes(state, metadata);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the state and the metadata that `checkpoint_to_bytes()` stored, or that are in a checkpoint
file. Linear in the number of bytes.

\tparam d dimension of the complex, 2 or 3

\throws Deformable_simplicial_complexes::File_error as `read_checkpoint()` does; the path of the file
        is "the checkpoint"
*/
template <int d>
Deformable_simplicial_complexes::internal::Checkpoint<d>
checkpoint_from_bytes(const std::string& bytes) {
  return Deformable_simplicial_complexes::internal::checkpoint_from_bytes<d>(bytes,
                                                                             "the checkpoint");
}

} // namespace CGAL::IO

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_CHECKPOINT_BYTES_H

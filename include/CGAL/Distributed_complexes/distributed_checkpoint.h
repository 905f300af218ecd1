// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_CHECKPOINT_H
#define CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_CHECKPOINT_H

#include <CGAL/license/Distributed_complexes.h>

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/internal/ranks/checkpoint_blocks.h>

#include <string>

namespace CGAL::IO {

/*!
\ingroup PkgDistributedComplexesRef

Writes a distributed complex to one file. A run that continues from the file gives a bitwise
identical complex for any number of ranks. The first rank writes the file; it holds one piece of
another rank at a time. A temporary file in the same folder is written and renamed when complete, so
if a process ends while writing, the previous checkpoint is unchanged. Collective.

The file is binary and the same on all machines. Each piece has a checksum.

\param path name of the file; its folder must exist
\param complex the complex
\param metadata any sequence of bytes, on the first rank
\throws Deformable_simplicial_complexes::Error on all ranks if the file cannot be written; an older
        file of that name is then unchanged
*/
template <class Complex>
void write_checkpoint(const std::string& path,
                      const Deformable_simplicial_complexes::Distributed_complex<Complex>& complex,
                      const std::string& metadata = std::string()) {
  Deformable_simplicial_complexes::internal::write_checkpoint_blocks(path, complex.mesh(),
                                                                     metadata);
}

/*!
\ingroup PkgDistributedComplexesRef

Reads a file that `write_checkpoint()` wrote for a distributed complex, with any number of ranks.
The first rank reads the file; it holds one piece at a time. Collective.

\param path name of the file
\param complex receives the complex; it is empty after an error
\return the metadata, on all ranks
\throws Deformable_simplicial_complexes::Error on all ranks if the file cannot be read, is not such a
        checkpoint, is truncated or damaged
*/
template <class Complex>
std::string
read_checkpoint(const std::string& path,
                Deformable_simplicial_complexes::Distributed_complex<Complex>& complex) {
  return Deformable_simplicial_complexes::internal::read_checkpoint_blocks(path, complex.mesh());
}

} // namespace CGAL::IO

#endif // CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_CHECKPOINT_H

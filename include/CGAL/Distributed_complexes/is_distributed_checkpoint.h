// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_IS_DISTRIBUTED_CHECKPOINT_H
#define CGAL_DISTRIBUTED_COMPLEXES_IS_DISTRIBUTED_CHECKPOINT_H

#include <CGAL/license/Distributed_complexes.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

namespace CGAL::Deformable_simplicial_complexes::internal {
// the first bytes of a checkpoint of a complex on several ranks, in any dimension
constexpr std::string_view magic_of_several_ranks = "\211DSCR";
} // namespace CGAL::Deformable_simplicial_complexes::internal

namespace CGAL::IO {

/*!
\ingroup PkgDistributedComplexesRef

Returns whether a file starts like a checkpoint of a distributed complex; `false` if it cannot be
read.
*/
inline bool is_distributed_checkpoint(const std::string& path) {
  using Deformable_simplicial_complexes::internal::magic_of_several_ranks;
  std::ifstream file(path, std::ios::binary);
  std::array<char, magic_of_several_ranks.size()> start = {{}};
  file.read(start.data(), start.size());
  return file && std::equal(start.begin(), start.end(), magic_of_several_ranks.begin());
}

} // namespace CGAL::IO

#endif // CGAL_DISTRIBUTED_COMPLEXES_IS_DISTRIBUTED_CHECKPOINT_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_COLLECTION_H
#define DSC_COLLECTION_H

#include <string>
#include <utility>
#include <vector>

namespace dsc {

/// Time, and file of the state.
using Moment = std::pair<double, std::string>;

/// Returns the files that a collection (.pvd) lists, in their order. Paths are relative to the
/// working directory. Files need not exist. Returns nothing if the collection does not exist.
/// \throws Input_error if an entry has no file or no finite time
/// \throws CGAL::Deformable_simplicial_complexes::File_error if the collection is not XML
std::vector<Moment> moments_of_collection(const std::string& collection);

} // namespace dsc

#endif // DSC_COLLECTION_H

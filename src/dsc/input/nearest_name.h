// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_NEAREST_NAME_H
#define DSC_NEAREST_NAME_H

#include <string>
#include <vector>

namespace dsc {

/// Returns the known name nearest to a misspelt one, measured by the number of inserted, removed,
/// replaced and exchanged letters. Returns an empty string if no name is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// Returns the advice on an unknown name, for the end of a message: "; did you mean 'gravity'?" or,
/// if no name is near, "; " + `list` + " are a, b, c".
std::string advice_on_name(const std::string& name, const std::vector<std::string>& known,
                           const std::string& list);

} // namespace dsc

#endif // DSC_NEAREST_NAME_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_NEAREST_NAME_H
#define DSC_NEAREST_NAME_H

#include <string>
#include <vector>

namespace dsc {

/// The known name that a misspelt one is probably meant to be: the nearest by inserted, removed,
/// replaced and exchanged letters, if these are few. Empty if no name is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// What is to be done about an unknown name, for the end of a message: "; did you mean 'gravity'?"
/// or, if no name is near, "; " + `list` + " are a, b, c".
std::string advice_on_name(const std::string& name, const std::vector<std::string>& known,
                           const std::string& list);

} // namespace dsc

#endif // DSC_NEAREST_NAME_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABEL_TITLES_H
#define DSC_LABEL_TITLES_H

#include "programs/errors.h"

#include <CGAL/Mesh_files/Label_names.h>

#include <optional>
#include <string>
#include <vector>

namespace dsc {

using DSC::Label_names;

/// Returns the name of a label; empty if it has none.
std::string label_name(int label, const Label_names& names);

/// Returns a label with its name, such as `2 'shell'`.
std::string label_title(int label, const Label_names& names);

/// Returns the label that a text gives by its number or its name; `nullopt` if there is no such
/// name.
std::optional<int> label_of(const std::string& text, const Label_names& names);

/// Returns the first few items of a list, and the number of the others.
std::string listed(const std::vector<std::string>& items);

/// Returns the labels that have names, in one line.
std::string label_titles(const Label_names& names);

/// Prints that an output file cannot contain names of labels, if this is so.
void tell_lost_names(const std::string& path, const Label_names& names);

} // namespace dsc

#endif // DSC_LABEL_TITLES_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABEL_TITLES_H
#define DSC_LABEL_TITLES_H

#include "programs/errors.h"

#include <CGAL/Mesh_files/Label_names.h>

#include <optional>
#include <vector>

namespace dsc {

using DSC::Label_names;

/// Returns the name of a label; empty if it has none.
std::string label_name(int label, const Label_names& names);

/// Returns a label with its name, such as `2 'shell'`.
std::string label_title(int label, const Label_names& names);

/// Returns the label with a name; `nullopt` if there is no such label.
std::optional<int> label_with_name(const std::string& name, const Label_names& names);

/// Returns the message for a name that no label has.
std::string unknown_label(const std::string& name, const Label_names& names);

/// Returns the labels in the lists that are the values of an option, such as `1,shell`. A number is
/// never a name. Names may contain commas.
/// \throws Usage_error if a text is neither a number nor a name
std::vector<int> labels_of(const std::string& option, const std::vector<std::string>& lists,
                           const Label_names& names);

/// Returns the first few items of a list, and the number of the others.
std::string listed(const std::vector<std::string>& items);

/// Returns the labels that have names, in one line.
std::string label_titles(const Label_names& names);

/// Prints that an output file cannot contain names of labels, if this is so.
void tell_lost_names(const std::string& path, const Label_names& names);

} // namespace dsc

#endif // DSC_LABEL_TITLES_H

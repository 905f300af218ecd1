// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_JSON_TEXT_H
#define DSC_JSON_TEXT_H

#include "report_json.h"

#include <string>

namespace dsc {

/// Parses JSON written by users.
/// \param name name of the file, for messages
/// \throws Input_error if the text is not JSON, or an object has two fields of the same name
Json parse_json(const std::string& text, const std::string& name);

} // namespace dsc

#endif // DSC_JSON_TEXT_H

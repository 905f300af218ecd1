// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PAGE_H
#define DSC_PAGE_H

#include <string>

namespace dsc {

/// Returns the page that shows a film, with its styles, its script and the film.
/// \param film JSON; `</` within it is escaped
std::string page_with(const std::string& film);

} // namespace dsc

#endif // DSC_PAGE_H

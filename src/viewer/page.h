// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PAGE_H
#define DSC_PAGE_H

#include <cstdint>
#include <string>
#include <vector>

namespace dsc {

/// Returns the page that shows a film, with its styles, its script and the film.
/// \param film JSON; `</` within it is escaped
std::string page_with(const std::string& film);

/// Returns integers as text: numbers of seven bits in a byte with the sign last, a raw deflate
/// stream of these bytes, and base64 of the stream. Small integers take less space.
/// \throws std::bad_alloc if memory is exhausted
std::string packed(const std::vector<std::int64_t>& numbers);

} // namespace dsc

#endif // DSC_PAGE_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PACKED_NUMBERS_H
#define DSC_PACKED_NUMBERS_H

#include <cstdint>
#include <string>
#include <vector>

namespace dsc {

/// Returns integers as text: numbers of seven bits in a byte with the sign last, a raw deflate
/// stream of these bytes, and base64 of the stream. Small integers take less space.
/// \throws std::bad_alloc if memory is exhausted
std::string packed(const std::vector<std::int64_t>& numbers);

} // namespace dsc

#endif // DSC_PACKED_NUMBERS_H

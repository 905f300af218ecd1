// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_NUMBER_OF_WORD_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_NUMBER_OF_WORD_H

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The number that a word stands for, in any locale; nothing if it is anything else or too large for
// the type. Too small for a floating type is the nearest number of that type.
template <class Number> std::optional<Number> number_of_word(std::string_view word) {
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto is_whole = [&](const std::from_chars_result& result) {
    return result.ec == std::errc() && result.ptr == end;
  };
  Number number = 0; // the compiler cannot see that it is set
  if (is_whole(std::from_chars(word.data(), end, number)))
    return number;
  if constexpr (std::is_floating_point<Number>::value) {
    long double wide = 0;
    if (is_whole(std::from_chars(word.data(), end, wide)) && std::abs(wide) < 1)
      return static_cast<Number>(wide);
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_NUMBER_OF_WORD_H

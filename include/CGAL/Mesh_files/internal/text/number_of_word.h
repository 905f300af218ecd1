// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_NUMBER_OF_WORD_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_NUMBER_OF_WORD_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the number that a word represents, in any locale. Returns `nullopt` if the word is not a
// number, or the number is too large for the type. A number too small for a floating-point type is
// rounded to the nearest number of the type.
template <class Number> std::optional<Number> number_of_word(std::string_view word) {
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto is_whole = [&](const std::from_chars_result& result) {
    return result.ec == std::errc() && result.ptr == end;
  };
  Number number = 0; // initialized to avoid a compiler warning
  if (is_whole(std::from_chars(word.data(), end, number)))
    return number;
  if constexpr (std::is_floating_point<Number>::value) {
    long double wide = 0;
    if (is_whole(std::from_chars(word.data(), end, wide)) && std::abs(wide) < 1)
      return static_cast<Number>(wide);
  }
  return std::nullopt;
}

// Returns why a word is not a number of the type, and what to do, as the end of a message.
template <class Number> std::string why_no_number(std::string_view word) {
  if (const std::optional<double> real = number_of_word<double>(word)) {
    if constexpr (std::is_integral<Number>::value) {
      using Limits = std::numeric_limits<Number>;
      if (*real != std::trunc(*real))
        return "should be an integer; correct it";
      if (*real < static_cast<double>((Limits::min)()) ||
          *real > static_cast<double>((Limits::max)()))
        return "should be an integer from " + std::to_string((Limits::min)()) + " to " +
               std::to_string((Limits::max)()) + "; correct it";
      return "should be an integer without a decimal point or an exponent; correct it";
    }
    return "is too large for a 32-bit number; correct it";
  }
  if (word.find(',') != word.npos)
    return "has a comma; write a decimal point in numbers and spaces between them";
  if (word.find("0x") != word.npos || word.find("0X") != word.npos)
    return "is hexadecimal; write a decimal number";
  std::string with_e(word);
  std::replace(with_e.begin(), with_e.end(), 'd', 'e');
  std::replace(with_e.begin(), with_e.end(), 'D', 'e');
  if (number_of_word<double>(with_e))
    return "has a Fortran exponent; write e instead of d";
  double number = 0;
  const std::from_chars_result result =
      std::from_chars(word.data(), word.data() + word.size(), number);
  if (result.ec == std::errc::result_out_of_range && result.ptr == word.data() + word.size())
    return "is too large; write numbers less than 1.8e308";
  return "should be a number; correct it";
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_NUMBER_OF_WORD_H

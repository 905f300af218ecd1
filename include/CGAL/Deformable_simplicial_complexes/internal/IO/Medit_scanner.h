// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_MEDIT_SCANNER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_MEDIT_SCANNER_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The words of a MEDIT text file, without comments, and the lines they are on.
class Medit_scanner
{
public:
  // `path` is for messages only.
  Medit_scanner(std::istream& in, std::string path) : m_in(in), m_path(std::move(path)) {}

  // Goes to the next word; returns false if there is none.
  bool next() {
    constexpr char white_space[] = " \t\r\v\f";
    while ((m_begin = m_line.find_first_not_of(white_space, m_end)) == std::string::npos) {
      m_begin = m_end = 0;
      if (!std::getline(m_in, m_line)) {
        m_line.clear();
        return false;
      }
      ++m_line_number;
      m_line.erase((std::min)(m_line.find('#'), m_line.size()));
    }
    m_end = (std::min)(m_line.find_first_of(white_space, m_begin), m_line.size());
    return true;
  }

  std::string_view word() const {
    return std::string_view(m_line).substr(m_begin, m_end - m_begin);
  }

  // pre: there is a word
  bool is_keyword() const {
    const char c = word().front();
    return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z');
  }

  // Goes to the next word, which must be a number.
  template <class Number> Number number() {
    if (!next())
      fail("a number is missing at the end of the file; is the file truncated?");
    std::string_view text = word();
    if (text.front() == '+')
      text.remove_prefix(1);
    Number result;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (error != std::errc() || end != text.data() + text.size())
      fail("'" + std::string(word()) + "' should be a number; correct it");
    return result;
  }

  std::size_t line_number() const { return m_line_number; }

  [[noreturn]] void fail(const std::string& what) const { fail(what, m_line_number); }

  [[noreturn]] void fail(const std::string& what, std::size_t line_number) const {
    throw File_error(m_path + ", line " + std::to_string(line_number) + ": " + what, m_path);
  }

private:
  std::istream& m_in;
  std::string m_path;
  std::string m_line;
  std::size_t m_begin = 0, m_end = 0; // of the word in the line
  std::size_t m_line_number = 0;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_MEDIT_SCANNER_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_FILE_SCANNER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_FILE_SCANNER_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/little_endian.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/number_of_word.h>

#include <algorithm>
#include <cstddef>
#include <ios>
#include <istream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// How numbers are written into a file.
enum class Encoding { text, little_endian, big_endian };

// The words of a text file, without comments, and the lines they are on; also the numbers in binary
// form that come after a line.
class File_scanner
{
public:
  // `path` is for messages only.
  File_scanner(std::istream& in, std::string path) : m_in(in), m_path(std::move(path)) {}

  // Goes to the next word; returns false if there is none.
  bool next() {
    while (!next_on_line()) {
      m_begin = m_end = 0;
      if (!std::getline(m_in, m_line)) {
        m_line.clear();
        return false;
      }
      ++m_line_number;
      m_line.erase((std::min)(m_line.find('#'), m_line.size()));
    }
    return true;
  }

  // The same, but does not leave the line.
  bool next_on_line() {
    constexpr char white_space[] = " \t\r\v\f";
    m_begin = (std::min)(m_line.find_first_not_of(white_space, m_end), m_line.size());
    m_end = (std::min)(m_line.find_first_of(white_space, m_begin), m_line.size());
    return m_begin < m_end;
  }

  // Goes to the next word if it is this one.
  bool next_is(std::string_view expected) {
    if (next() && word() == expected)
      return true;
    back();
    return false;
  }

  // Goes back to before the word.
  void back() { m_end = m_begin; }

  // Goes to the end of the line.
  void skip_line() { m_begin = m_end = m_line.size(); }

  // Empty where there is none.
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
    const std::optional<Number> number = number_of_word<Number>(word());
    if (!number)
      fail(in_quotes(word()) + " should be a number; correct it");
    return *number;
  }

  // The same for a number that may be in binary form.
  // pre: if it is, the line has been read to its end
  template <class Number> Number number(Encoding encoding) {
    if (encoding == Encoding::text)
      return number<Number>();
    char bytes[sizeof(Number)];
    if (!m_in.read(bytes, sizeof(bytes)))
      fail("a number is missing at the end of the file; is the file truncated?");
    if (encoding == Encoding::big_endian)
      std::reverse(std::begin(bytes), std::end(bytes));
    return internal::little_endian<Number>(bytes);
  }

  // Skips bytes in binary form.
  void skip_bytes(std::size_t n) { m_in.ignore(static_cast<std::streamsize>(n)); }

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

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TEXT_FILE_SCANNER_H

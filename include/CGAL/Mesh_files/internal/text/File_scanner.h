// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_FILE_SCANNER_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_FILE_SCANNER_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>

#include <istream>
#include <iterator>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The encoding of numbers in a file.
enum class Encoding { text, little_endian, big_endian };

// A scanner for the words of a text file, without comments, and their line numbers. Also reads
// numbers in binary form that follow a line. A byte order mark is skipped. All lines must end like
// the first one: with a line feed, optionally after a carriage return, or with a carriage return
// alone.
class File_scanner
{
public:
  // `path` is used in messages only.
  File_scanner(std::istream& in, std::string path) : m_in(in), m_path(std::move(path)) {}

  // Moves to the next word. Returns false if there is none.
  bool next() {
    while (!next_on_line()) {
      m_begin = m_end = 0;
      if (!read_line(m_line)) {
        m_line.clear();
        return false;
      }
      for (std::string more; ends_with_continuation_mark() && read_line(more);)
        m_line += more;
    }
    return true;
  }

  // Sets the character that continues a line on the next line.
  void continue_lines_at(char mark) { m_continuation_mark = mark; }

  // Moves to the next word on the line. Returns false if there is none.
  bool next_on_line() {
    m_begin = (std::min)(m_line.find_first_not_of(white_space, m_end), m_line.size());
    m_end = (std::min)(m_line.find_first_of(white_space, m_begin), m_line.size());
    return m_begin < m_end;
  }

  // Moves to the next word if it equals `expected`. Returns whether it does.
  bool next_is(std::string_view expected) {
    if (next() && word() == expected)
      return true;
    back();
    return false;
  }

  // Returns the words up to the end of the line, with single spaces, and the comment after them.
  // Moves to the end of the line.
  std::string rest_of_line() {
    std::string result;
    while (next_on_line())
      result.append(result.empty() ? "" : " ").append(word());
    return result + comment();
  }

  // Returns the comment of the line with the white space before it. Files use the mark in names,
  // too.
  const std::string& comment() const { return m_comment; }

  // Moves back to before the current word.
  void back() { m_end = m_begin; }

  // Cuts the current word after its first `n` characters. The rest becomes the next word.
  void cut_word(std::size_t n) { m_end = m_begin + n; }

  // Returns the number of words between the current word and the end of the line.
  std::size_t words_left() const {
    std::size_t n = 0;
    for (std::size_t begin = m_end;
         (begin = m_line.find_first_not_of(white_space, begin)) != std::string::npos; ++n)
      begin = (std::min)(m_line.find_first_of(white_space, begin), m_line.size());
    return n;
  }

  // Moves to the end of the line.
  void skip_line() { m_begin = m_end = m_line.size(); }

  // Returns the current word; empty if there is none.
  std::string_view word() const {
    return std::string_view(m_line).substr(m_begin, m_end - m_begin);
  }

  // Returns whether the current word is a keyword.
  // \pre there is a current word
  bool is_keyword() const {
    const char c = word().front();
    return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z');
  }

  // Returns the next word as a number. Throws if it is none.
  template <class Number> Number number() {
    if (!next())
      fail("a number is missing at the end of the file; is the file truncated?");
    const std::optional<Number> number = number_of_word<Number>(word());
    if (!number)
      fail(in_quotes(word()) + ' ' + why_no_number<Number>(word()));
    return *number;
  }

  // Returns the next number, in text or binary form.
  // \pre for binary form, the line was read to its end
  template <class Number> Number number(Encoding encoding) {
    if (encoding == Encoding::text)
      return number<Number>();
    m_is_in_binary_data = true;
    char bytes[sizeof(Number)];
    if (!m_in.read(bytes, sizeof(bytes)))
      fail("a number is missing at the end of the file; is the file truncated?");
    if (encoding == Encoding::big_endian)
      std::reverse(std::begin(bytes), std::end(bytes));
    return internal::little_endian<Number>(bytes);
  }

  // Skips bytes in binary form.
  void skip_bytes(std::size_t n) { m_in.ignore(static_cast<std::streamsize>(n)); }

  // Skips all bytes to the end of the file. Returns their number; zero if all are white space.
  std::size_t skip_all_bytes() {
    std::size_t n = 0;
    bool is_blank = true;
    for (char c; m_in.get(c); ++n)
      is_blank = is_blank && std::string_view(white_space).find(c) != std::string_view::npos;
    return is_blank ? 0 : n;
  }

  // Skips all lines to the end of the file. Returns the number of lines that have words.
  // \pre the line was read to its end
  std::size_t skip_all_lines() {
    std::size_t n = 0;
    for (; next(); ++n)
      skip_line();
    return n;
  }

  const std::string& path() const { return m_path; }

  std::size_t line_number() const { return m_line_number; }

  [[noreturn]] void fail(const std::string& what) const { fail(what, m_line_number); }

  [[noreturn]] void fail(const std::string& what, std::size_t line_number) const {
    const std::string place =
        m_is_in_binary_data ? ", binary data: " : ", line " + std::to_string(line_number) + ": ";
    throw File_error(m_path + place + what, m_path);
  }

private:
  static constexpr char white_space[] = " \t\r\n\v\f";

  // Reads the next line of the file, without its comment. Returns false at the end of the file.
  bool read_line(std::string& line) {
    if (m_line_number == 0 ? !read_first_line(line) : !std::getline(m_in, line, m_line_end))
      return false;
    ++m_line_number;
    m_comment.clear();
    if (const std::size_t mark = line.find('#'); mark != std::string::npos) {
      const std::size_t end = line.substr(0, mark).find_last_not_of(white_space) + 1;
      m_comment = line.substr(end, line.find_last_not_of(white_space) + 1 - end);
      line.erase(mark);
    }
    return true;
  }

  // Reads the first line, and detects how lines end.
  bool read_first_line(std::string& line) {
    line.clear();
    char c = 0;
    while (m_in.get(c) && c != '\n' && c != '\r')
      line += c;
    if (m_in && c == '\r') {
      if (m_in.peek() == '\n')
        m_in.get();
      else
        m_line_end = '\r';
    }
    const bool is_there = m_in || !line.empty();
    remove_byte_order_mark(line);
    return is_there;
  }

  // Returns whether the line ends with the continuation mark, and replaces the mark by white space.
  bool ends_with_continuation_mark() {
    const std::size_t last = m_line.find_last_not_of(white_space);
    if (m_continuation_mark == 0 || last == std::string::npos ||
        m_line[last] != m_continuation_mark)
      return false;
    m_line[last] = ' ';
    return true;
  }

  std::istream& m_in;
  std::string m_path;
  std::string m_line, m_comment;
  std::size_t m_begin = 0, m_end = 0; // range of the current word in the line
  std::size_t m_line_number = 0;
  char m_line_end = '\n';
  char m_continuation_mark = 0; // none
  bool m_is_in_binary_data = false;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_FILE_SCANNER_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page.h"
#include "page_files.h"

#include <CGAL/Mesh_files/internal/pictures/colors.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <new>

namespace dsc {
namespace {

// Replaces a line of the page by a text.
void insert(const std::string& placeholder, const std::string& text, std::string& page) {
  page.replace(page.find(placeholder), placeholder.size(), text);
}

// Escapes `<`: after `</script` or `<!--<script`, the element with the JSON would end elsewhere.
std::string escaped(const std::string& json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

// Appends the number with its sign in the lowest bit, seven bits in a byte, the lowest ones first.
void append(std::int64_t number, std::string& bytes) {
  std::uint64_t rest = std::uint64_t(number) << 1 ^ std::uint64_t(number >> 63);
  for (; rest >= 128; rest >>= 7)
    bytes.push_back(char(rest | 128));
  bytes.push_back(char(rest));
}

std::string deflated(const std::string& bytes) {
  z_stream stream = {};
  constexpr int without_header = -MAX_WBITS, memory_level = 9;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, without_header, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&result[0]);
  stream.avail_out = uInt(result.size());
  deflate(&stream, Z_FINISH); // completes, since the output has the size of the bound
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

std::string base64(std::string bytes) {
  namespace iterators = boost::archive::iterators;
  using Iterator =
      iterators::base64_from_binary<iterators::transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string result(Iterator(bytes.cbegin()), Iterator(bytes.cend()));
  result.replace(result.size() - padding, padding, padding, '=');
  return result;
}

} // namespace

std::string page_with(const std::string& film) {
  std::string page(std::begin(page_html), std::end(page_html));
  // From the end to the beginning, so that a placeholder in an inserted text is not replaced.
  insert("/*SCRIPT*/", std::string(std::begin(page_script), std::end(page_script)), page);
  insert("[/*COLOR_MAP*/]",
         nlohmann::json(CGAL::Deformable_simplicial_complexes::internal::color_map).dump(), page);
  insert("/*FILM*/", escaped(film), page);
  insert("/*STYLE*/", std::string(std::begin(page_style), std::end(page_style)), page);
  return page;
}

std::string packed(const std::vector<std::int64_t>& numbers) {
  std::string bytes;
  bytes.reserve(2 * numbers.size());
  for (const std::int64_t number : numbers)
    append(number, bytes);
  return base64(deflated(bytes));
}

} // namespace dsc

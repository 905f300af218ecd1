// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page.h"
#include "page_files.h"

#include <CGAL/Mesh_files/internal/pictures/colors.h>

#include <nlohmann/json.hpp>

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

} // namespace dsc

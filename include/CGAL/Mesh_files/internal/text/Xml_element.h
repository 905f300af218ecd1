// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_XML_ELEMENT_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_XML_ELEMENT_H

#include <CGAL/Mesh_files/File_error.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns a text as the value of an attribute in quotes.
inline std::string xml_escaped(const std::string& text) {
  std::string result;
  for (char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

inline constexpr char xml_white_space[] = " \t\r\n";

// An element of an XML text, as views into the text.
struct Xml_element
{
  std::string_view name;
  std::string_view attributes; // text after the name in the start tag
  std::string_view content;    // text between the tags

  // Returns the value of an attribute as written; empty if there is none.
  std::string attribute(std::string_view requested) const {
    std::string_view rest = attributes;
    for (std::size_t begin; (begin = rest.find_first_of("\"'")) != rest.npos;) {
      const std::size_t end = rest.find(rest[begin], begin + 1);
      if (end == rest.npos)
        break;
      std::string_view key = rest.substr(0, rest.find_last_of('=', begin));
      key = key.substr(0, key.find_last_not_of(xml_white_space) + 1);
      key = key.substr(key.find_last_of(xml_white_space) + 1);
      if (key == requested)
        return std::string(rest.substr(begin + 1, end - begin - 1));
      rest.remove_prefix(end + 1);
    }
    return {};
  }
};

// Returns the position of the '>' of the tag that begins at `begin`. A '>' in the value of an
// attribute is skipped.
inline std::size_t end_of_xml_tag(std::string_view xml, std::size_t begin) {
  std::size_t i = xml.find_first_of(">\"'", begin);
  while (i != xml.npos && xml[i] != '>')
    if ((i = xml.find(xml[i], i + 1)) != xml.npos)
      i = xml.find_first_of(">\"'", i + 1);
  return i;
}

// Visits the top-level elements of a text with `visit_element`, and the text between them with
// `visit_text`. Nested elements are not visited. Comments, instructions, declarations and CDATA
// sections are skipped. Works without recursion, and stores the names of the open elements only.
//
// Throws File_error with the line and the path of the file if elements are not properly nested, or
// nested deeper than in any data file.
template <class Visit_element, class Visit_text>
void visit_xml(std::string_view xml, const std::string& path, const Visit_element& visit_element,
               const Visit_text& visit_text) {
  constexpr std::size_t deepest = 64;
  std::size_t begin = 0, position = 0; // begin of the tag, and position behind it
  const auto fail = [&](const std::string& what) {
    const auto line = 1 + std::count(xml.begin(), xml.begin() + begin, '\n');
    throw File_error(path + ": line " + std::to_string(line) + ": " + what +
                         "; is it a complete VTK XML file?",
                     path);
  };
  const auto skip = [&](std::string_view first, std::string_view last) {
    if (xml.compare(begin, first.size(), first) != 0)
      return false;
    const std::size_t end = xml.find(last, begin + first.size());
    if (end == xml.npos)
      fail(std::string(first) + " does not end");
    position = end + last.size();
    return true;
  };

  Xml_element element;
  std::vector<std::string_view> open;
  for (;;) {
    begin = (std::min)(xml.find('<', position), xml.size());
    if (open.empty())
      visit_text(xml.substr(position, begin - position));
    if (begin == xml.size())
      break;
    if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>") || skip("<!", ">"))
      continue;
    const std::size_t end = end_of_xml_tag(xml, begin);
    if (end == xml.npos)
      fail("a tag does not end");
    position = end + 1;

    std::string_view tag = xml.substr(begin + 1, end - (begin + 1));
    const bool is_last = !tag.empty() && tag.front() == '/',
               is_empty = !is_last && !tag.empty() && tag.back() == '/';
    if (is_last)
      tag.remove_prefix(1);
    if (is_empty)
      tag.remove_suffix(1);
    const std::string_view name = tag.substr(0, tag.find_first_of(xml_white_space));
    if (name.empty())
      fail("a tag has no name");
    if (!is_last) {
      if (open.empty())
        element = {name, tag.substr(name.size()), xml.substr(position)};
      if (open.size() == deepest)
        fail("elements are nested more than " + std::to_string(deepest) + " levels deep");
      open.push_back(name);
    } else if (open.empty() || open.back() != name)
      fail("a closing tag does not match the last open element");
    if (is_last || is_empty) {
      open.pop_back();
      if (open.empty()) {
        const auto behind_content = xml.size() - (is_last ? begin : position);
        element.content.remove_suffix(behind_content);
        visit_element(element);
      }
    }
  }
  if (!open.empty())
    fail("an element does not end");
}

// Visits the children of an element that have a name. Throws File_error as `visit_xml()` does.
template <class Visit>
void for_each_child(const Xml_element& element, std::string_view name, const std::string& path,
                    const Visit& visit) {
  visit_xml(
      element.content, path,
      [&](const Xml_element& child) {
        if (child.name == name)
          visit(child);
      },
      [](std::string_view) {});
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_XML_ELEMENT_H

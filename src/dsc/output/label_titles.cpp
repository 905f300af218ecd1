// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/label_titles.h"

#include "input/files.h"
#include "input/translations.h"

#include <CGAL/Mesh_files/internal/text/number_of_word.h>

#include <cstddef>

namespace dsc {

std::string label_name(int label, const Label_names& names) {
  const auto name = names.find(label);
  return name == names.end() ? "" : name->second;
}

std::string label_title(int label, const Label_names& names) {
  const std::string name = label_name(label, names);
  return std::to_string(label) + (name.empty() ? "" : " '" + name + "'");
}

std::optional<int> label_of(const std::string& text, const Label_names& names) {
  if (const auto number = DSC::internal::number_of_word<int>(text))
    return number;
  for (const auto& [label, name] : names)
    if (name == text)
      return label;
  return std::nullopt;
}

std::string listed(const std::vector<std::string>& items) {
  static constexpr std::size_t most = 5;
  std::string result;
  for (std::size_t i = 0; i < items.size() && i < most; ++i)
    result += (i > 0 ? ", " : "") + items[i];
  if (items.size() > most)
    result += " and " + std::to_string(items.size() - most) + " others";
  return result;
}

std::string label_titles(const Label_names& names) {
  std::vector<std::string> titles;
  for (const auto& [label, name] : names)
    titles.push_back(label_title(label, names));
  return listed(titles);
}

void tell_lost_names(const std::string& path, const Label_names& names) {
  const std::string format = extension(path);
  const bool has_names = format == "vtu" || format == "stl" || format == "obj";
  if (!names.empty() && !has_names && format != "png")
    print_note(path, "the format contains no names of labels (" + label_titles(names) + ')');
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/label_titles.h"

#include "input/files.h"
#include "input/nearest_name.h"
#include "input/translations.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/number_of_word.h>

namespace dsc {

using CGAL::Deformable_simplicial_complexes::internal::number_of_word;

std::string label_name(int label, const Label_names& names) {
  const auto name = names.find(label);
  return name == names.end() ? "" : name->second;
}

std::string label_title(int label, const Label_names& names) {
  const std::string name = printed_line(label_name(label, names)); // of any bytes
  return std::to_string(label) + (name.empty() ? "" : " '" + name + "'");
}

std::optional<int> label_with_name(const std::string& name, const Label_names& names) {
  const auto label = std::find_if(names.begin(), names.end(),
                                  [&](const auto& entry) { return entry.second == name; });
  return label == names.end() ? std::nullopt : std::make_optional(label->first);
}

std::string unknown_label(const std::string& name, const Label_names& names) {
  std::vector<std::string> known;
  for (const auto& [label, other] : names)
    known.push_back(other);
  const std::string nearest = nearest_name(name, known);
  return "no label has the name '" + name + "'" +
         (names.empty() ? ", because the labels have no names" : " (" + label_titles(names) + ')') +
         (nearest.empty() ? "; give the number of a label" : "; did you mean '" + nearest + "'?");
}

std::vector<int> labels_of(const std::string& option, const std::vector<std::string>& lists,
                           const Label_names& names) {
  std::vector<int> result;
  for (const std::string& list : lists)
    for (std::size_t begin = 0, end = 0; begin <= list.size(); begin = end + 1) {
      end = (std::min)(list.find(',', begin), list.size());
      for (const auto& [label, name] : names)
        if (const std::size_t other = begin + name.size();
            other > end && list.compare(begin, name.size(), name) == 0 &&
            (other == list.size() || list[other] == ','))
          end = other;
      const std::string text = list.substr(begin, end - begin);
      std::optional<int> label = number_of_word<int>(text);
      if (!label && !(label = label_with_name(text, names)))
        throw Usage_error(option + ": " + unknown_label(text, names));
      result.push_back(*label);
    }
  return result;
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
  if (!names.empty() && !has_names && format != "png" && format != "svg")
    print_note(path, "the format contains no names of labels (" + label_titles(names) + ')');
}

} // namespace dsc

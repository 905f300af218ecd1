// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_NAMES_OF_PARTS_H
#define DSC_FILES_NAMES_OF_PARTS_H

#include <map>
#include <string>

namespace dsc_files {

/// The labels of the parts of a file: 1, 2 and so on. Parts with the same name have the same label.
class Names_of_parts
{
public:
  /// Returns the label of a part.
  /// \param otherwise the name of a part without name
  int label_of(std::string name, const std::string& otherwise) {
    for (char& c : name)
      if (c == '\n' || c == '\r')
        c = ' ';
    if (name.empty())
      name = otherwise;
    const auto [place, is_new] = m_labels.emplace(name, int(m_labels.size()) + 1);
    if (is_new)
      m_names.emplace(place->second, name);
    return place->second;
  }

  /// Returns the names by their labels.
  const std::map<int, std::string>& names() const { return m_names; }

private:
  std::map<std::string, int> m_labels;
  std::map<int, std::string> m_names;
};

} // namespace dsc_files

#endif // DSC_FILES_NAMES_OF_PARTS_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_LABEL_NAMES_H
#define CGAL_MESH_FILES_LABEL_NAMES_H

#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

Names of labels, such as those of the solids of a file. A label may have no name.
*/
using Label_names = std::map<int, std::string>;

namespace internal {

// Collects the names of labels from a file. The results are in one line, not empty, and differ.
class Label_name_list
{
public:
  // Adds the name of a label, unless it is empty. White space becomes single blanks. If another
  // label has the name `ring`, the name becomes `ring (2)`.
  // \pre The label has no name.
  void add(int label, const std::string& given) {
    std::istringstream words(given);
    std::string name, word;
    while (words >> word)
      name += (name.empty() ? "" : " ") + word;
    if (name.empty())
      return;
    const auto place = m_numbers.emplace(name, 0);
    std::string distinct = name;
    for (bool is_new = place.second; !is_new; is_new = m_numbers.emplace(distinct, 0).second)
      distinct = name + " (" + std::to_string(++place.first->second + 1) + ')';
    names.emplace(label, std::move(distinct));
  }

  Label_names names;

private:
  std::map<std::string, int> m_numbers; // of other labels with the same name, by name
};

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_LABEL_NAMES_H

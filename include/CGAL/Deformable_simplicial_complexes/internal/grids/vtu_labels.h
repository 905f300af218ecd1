// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_VTU_LABELS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_VTU_LABELS_H

#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>
#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/Vtu_reader.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The choice of the cell array that contains the labels.
class Vtu_label_choice
{
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Vtu_label_choice(const Vtu_reader& reader, const std::vector<Mesh_array>& arrays)
      : m_reader(reader), m_arrays(arrays) {}

  // Returns the index of the array with a name. An empty name means the first array with a name
  // known for labels; "none" means no array. Returns `none` if all labels are 1. Throws
  // `File_error` if there is no array with the name, or if the name is empty and only arrays with
  // unknown names may be labels.
  std::size_t find(const std::string& name, Unused_content& unused) const {
    if (name == "none")
      return none;
    if (!name.empty()) {
      const std::size_t chosen = index_of(name);
      if (chosen == none)
        m_reader.fail("there is no cell array " + in_quotes(name) + "; " + description());
      return chosen;
    }
    std::size_t result = none;
    for (const char* known : {"label", "medit:ref", "gmsh:physical", "MaterialIDs"}) {
      const std::size_t i = index_of(known);
      if (result == none)
        result = i;
      else if (i != none && m_arrays[i].values != m_arrays[result].values)
        unused.add("other array of labels (" + in_quotes(known) + ", ignored in favor of " +
                   in_quotes(m_arrays[result].name) + ')');
    }
    if (result == none && std::any_of(m_arrays.begin(), m_arrays.end(), may_be_labels))
      m_reader.fail("no cell array has a known name for labels; " + description());
    return result;
  }

  // Returns the labels in an array. `cells` contains the indices of the cells in the file, for
  // messages. Throws `File_error` if a value is not a label.
  std::vector<int> labels(std::size_t chosen, const std::vector<std::size_t>& cells) const {
    if (chosen == none)
      return std::vector<int>(cells.size(), 1);
    const Mesh_array& array = m_arrays[chosen];
    if (array.components != 1)
      m_reader.fail("the cell array " + in_quotes(array.name) + " has " +
                    std::to_string(array.components) +
                    " numbers for each cell and cannot hold labels; " + description());
    std::vector<int> result;
    result.reserve(cells.size());
    for (const double value : array.values) {
      if (!is_label(value)) {
        std::ostringstream text;
        text.precision(std::numeric_limits<double>::max_digits10);
        text << "the label of cell " << cells[result.size()] << " is not a 32-bit integer but "
             << value << "; correct the array " << in_quotes(array.name);
        m_reader.fail(text.str());
      }
      result.push_back(static_cast<int>(value));
    }
    return result;
  }

private:
  static bool is_label(double value) {
    using Limits = std::numeric_limits<int>;
    return Limits::min() <= value && value <= Limits::max() && value == std::trunc(value);
  }

  static bool may_be_labels(const Mesh_array& array) {
    return array.components == 1 && std::all_of(array.values.begin(), array.values.end(), is_label);
  }

  std::size_t index_of(const std::string& name) const {
    const auto it = std::find_if(m_arrays.begin(), m_arrays.end(),
                                 [&](const Mesh_array& array) { return array.name == name; });
    return it == m_arrays.end() ? none : static_cast<std::size_t>(it - m_arrays.begin());
  }

  // Returns a description of all arrays, and advice how to choose one.
  std::string description() const {
    std::ostringstream text;
    text << (m_arrays.empty() ? "there are no cell arrays" : "there are ");
    for (const Mesh_array& array : m_arrays) {
      text << (&array == &m_arrays.front() ? "" : ", ") << in_quotes(array.name) << " ("
           << array.type;
      if (array.components != 1)
        text << ", " << array.components << " components";
      else if (!array.values.empty()) {
        const auto [least, largest] = std::minmax_element(array.values.begin(), array.values.end());
        text << (may_be_labels(array) ? ", integers" : ", not labels, values") << " from " << *least
             << " to " << *largest;
      }
      text << ')';
    }
    return text.str() + "; choose the array of labels by its name (in dsc: --labels NAME), or "
                        "'none' for label 1 everywhere";
  }

  const Vtu_reader& m_reader;
  const std::vector<Mesh_array>& m_arrays;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_VTU_LABELS_H

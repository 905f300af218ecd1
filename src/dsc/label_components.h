// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABEL_COMPONENTS_H
#define DSC_LABEL_COMPONENTS_H

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace dsc {

/// Tells the label at a point.
using Label_function = std::function<int(const std::array<double, 3>&)>;

/// How many connected components a label has, as samples on a grid show it: `least` if samples that
/// have a corner in common are connected, `most` if only those are that share a face.
struct Component_range
{
  std::size_t least, most;
};

/// Of each label.
using Component_ranges = std::map<int, Component_range>;

/// Counts the connected components of each label in a box.
/// \param box the least x, y and z, then the largest
/// \param samples their number along each axis
Component_ranges count_components(const std::array<double, 6>& box,
                                  const std::array<std::size_t, 3>& samples,
                                  const Label_function& label_at);

/// The number of connected components of each label of a complex.
template <class Complex> std::map<int, std::size_t> numbers_of_components(const Complex& complex) {
  std::map<int, std::size_t> result;
  for (const auto label : complex.labels())
    result[label] = complex.number_of_components(label);
  return result;
}

/// Counts them by samples that are three times as close as the edges of a complex.
Component_ranges count_components(const std::array<double, 6>& box, double edge,
                                  const Label_function& label_at);

/// Makes sure that a complex shows what a function tells: each label that has a name, and the same
/// number of connected components of each label as samples show.
/// \param edge length of edges of the complex
/// \param expected what `count_components()` tells
/// \param found number of components of each label of the complex
/// \param names of the labels but 0, for messages
/// \throws Input_error if that is not so, with the label, the numbers, and an edge length that is
/// enough
void require_resolved(const std::array<double, 6>& box, double edge, const Label_function& label_at,
                      const Component_ranges& expected, const std::map<int, std::size_t>& found,
                      std::map<int, std::string> names);

} // namespace dsc

#endif // DSC_LABEL_COMPONENTS_H

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

/// A function that returns the label at a point.
using Label_function = std::function<int(const std::array<double, 3>&)>;

/// The number of connected components of a label on a grid of samples. For `least`, samples with a
/// common corner are connected; for `most`, only samples with a common face.
struct Component_range
{
  std::size_t least, most;
};

/// The ranges of all labels.
using Component_ranges = std::map<int, Component_range>;

/// Counts the connected components of each label in a box.
/// \param box lower and then upper bounds of x, y and z
/// \param samples number of samples along each axis
Component_ranges count_components(const std::array<double, 6>& box,
                                  const std::array<std::size_t, 3>& samples,
                                  const Label_function& label_at);

/// Returns the number of connected components of each label of a complex.
template <class Complex> std::map<int, std::size_t> numbers_of_components(const Complex& complex) {
  std::map<int, std::size_t> result;
  for (const auto label : complex.labels())
    result[label] = complex.number_of_components(label);
  return result;
}

/// Counts the connected components with a sample spacing of a third of the edge length of a
/// complex.
Component_ranges count_components(const std::array<double, 6>& box, double edge,
                                  const Label_function& label_at);

/// Checks that a complex resolves a label function: it has all labels with names, and for each
/// label the number of connected components that samples show.
/// \param edge edge length of the complex
/// \param expected result of `count_components()`
/// \param found number of components of each label of the complex
/// \param names names of the labels except 0, for messages
/// \throws Input_error with the label, the numbers, and a sufficient edge length if the complex
/// does not resolve the function
void require_resolved(const std::array<double, 6>& box, double edge, const Label_function& label_at,
                      const Component_ranges& expected, const std::map<int, std::size_t>& found,
                      std::map<int, std::string> names);

} // namespace dsc

#endif // DSC_LABEL_COMPONENTS_H

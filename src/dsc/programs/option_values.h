// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OPTION_VALUES_H
#define DSC_OPTION_VALUES_H

#include "programs/errors.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CLI {
class App;
}

namespace dsc {

/// A length in one of two units.
struct Distance
{
  double value;
  bool in_mean_edges; ///< unit: mean interface edge of the input if true, otherwise the unit
                      ///< of the input coordinates
  bool operator==(const Distance& other) const {
    return value == other.value && in_mean_edges == other.in_mean_edges;
  }
};

constexpr unsigned most_threads = 1024;
constexpr int most_subdivisions = 5; ///< of a surface; each replaces a triangle by four

/// The numbers that an option accepts.
struct Number_range
{
  const char* example;                ///< for messages
  bool (*contains)(double) = nullptr; ///< accepts every finite number if null
  const char* complaint = "";         ///< about other numbers; follows the name of the option

  /// Reads a number from the text of an option.
  double operator()(const std::string& text, const std::string& option) const;
};

inline constexpr Number_range positive = {"0.01", [](double x) { return x > 0; },
                                          " is not positive; choose a number greater than 0"};

constexpr Number_range not_negative(const char* example) {
  return {example, [](double x) { return x >= 0; }, " is negative; choose 0 or more"};
}

/// Reads a length in the unit of the input or, with the suffix e, in mean edges.
struct Length_range
{
  Number_range numbers;

  Distance operator()(const std::string& text, const std::string& option) const;
};

/// The following functions read the text of an option, too. Numbers are read independently of the
/// locale. All functions throw Usage_error with the expected form.

std::array<double, 3> parse_axis(const std::string& text, const std::string& option);

/// \return lower and then upper bounds of x, y and z
std::array<double, 6> parse_domain(const std::string& text, int dimension);

/// Removes the word `grow` and the comma before it from the end of the value of `--domain`. Returns
/// whether the word was there. The rest may be empty.
bool take_growth(std::string& domain);

std::array<double, 2> parse_pair(const std::string& text, const std::string& option);

/// Parses two or three numbers.
std::vector<double> parse_point(const std::string& text, const std::string& option);

/// Parses one or more numbers between commas.
std::vector<double> parse_list(std::string text, const std::string& option);

/// A plane perpendicular to an axis.
struct Cut
{
  std::size_t axis; ///< 0 for x, 1 for y, 2 for z
  double value;     ///< coordinate of the plane on the axis
};

/// Parses a plane like x=0.5.
Cut parse_cut(const std::string& text, const std::string& option);

/// Returns the name of a value.
template <class Value>
const std::string& name_of(const std::map<std::string, Value>& names, const Value& value) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& named) { return named.second == value; })
      ->first;
}

/// Returns the number of cores, clamped to the range of the option `--threads`.
unsigned default_number_of_threads();

/// Adds the option for the number of threads.
/// \param threads receives the number; it keeps its value without the option
void add_threads_option(CLI::App& command, unsigned& threads);

} // namespace dsc

#endif // DSC_OPTION_VALUES_H

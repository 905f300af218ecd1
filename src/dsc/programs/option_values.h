// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OPTION_VALUES_H
#define DSC_OPTION_VALUES_H

#include "motions/distance.h"

#include <CGAL/Interface_flows/Corner_rule.h>
#include <CGAL/Interface_flows/Integration_scheme.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace dsc {

constexpr int most_subdivisions = 5; ///< of a surface; each replaces a triangle by four

/// The following functions parse the values of options. Numbers are read independently of the
/// locale. All functions throw Usage_error with the expected form.

std::array<double, 3> parse_axis(const std::string& text);

/// \return lower and then upper bounds of x, y and z
std::array<double, 6> parse_domain(const std::string& text, int dimension);

/// Removes the word `grow` and the comma before it from the end of the value of `--domain`. Returns
/// whether the word was there. The rest may be empty.
bool take_growth(std::string& domain);

double parse_angle(const std::string& text);

std::array<double, 2> parse_pair(const std::string& text, const std::string& option);

/// Parses two or three numbers.
std::vector<double> parse_point(const std::string& text);

/// Parses one or more numbers between commas.
std::vector<double> parse_list(std::string text, const std::string& option);

/// Parses a quality in (0, 1].
double parse_threshold(const std::string& text);

/// Parses a length in the unit of the input or, with the suffix e, in mean edges.
Distance parse_distance(const std::string& text);

/// Parses a positive length in the unit of the input or, with the suffix e, in mean edges.
Distance parse_length(const std::string& text, const std::string& option);

double parse_positive(const std::string& text, const std::string& option);

/// A plane perpendicular to an axis.
struct Cut
{
  std::size_t axis; ///< 0 for x, 1 for y, 2 for z
  double value;     ///< coordinate of the plane on the axis
};

/// Parses a plane like x=0.5.
Cut parse_cut(const std::string& text);

/// Parses the value of an option that is at least 0.
/// \param example a typical value, for messages
double parse_not_negative(const std::string& text, const std::string& option,
                          const std::string& example);

/// Parses a number in [0, 1).
double parse_aggressiveness(const std::string& text);

/// Returns the integration schemes by their names.
const std::map<std::string, CGAL::Deformable_simplicial_complexes::Integration_scheme>&
integration_schemes();

/// Returns the rules for corners of an offset by their names.
const std::map<std::string, CGAL::Deformable_simplicial_complexes::Corner_rule>& corner_rules();

void require_extension(const std::string& path, const std::initializer_list<const char*>& known);

} // namespace dsc

#endif // DSC_OPTION_VALUES_H

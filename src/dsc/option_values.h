// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OPTION_VALUES_H
#define DSC_OPTION_VALUES_H

#include "distance.h"

#include <CGAL/Interface_flows/Integration_scheme.h>

#include <array>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace dsc {

constexpr int most_subdivisions = 5; ///< of a surface: each makes four triangles of one

/// The values of options, whose numbers are read in the same way in every locale. All functions
/// throw Usage_error, with what they expect.

std::array<double, 3> parse_axis(const std::string& text);

/// \return the least x, y and z, then the largest
std::array<double, 6> parse_domain(const std::string& text, int dimension);

/// Takes the word `grow` off the end of `--domain`, and the comma before it. Returns whether it was
/// there. What is left may be empty.
bool take_growth(std::string& domain);

double parse_angle(const std::string& text);

std::array<double, 2> parse_pair(const std::string& text, const std::string& option);

/// Two or three numbers.
std::vector<double> parse_point(const std::string& text);

/// A quality in (0, 1].
double parse_threshold(const std::string& text);

/// In the unit of the input or, with an e behind it, in mean edges.
Distance parse_distance(const std::string& text);

/// A positive length, in the unit of the input or, with an e behind it, in mean edges.
Distance parse_length(const std::string& text, const std::string& option);

double parse_positive(const std::string& text, const std::string& option);

/// Not negative.
double parse_tolerance(const std::string& text);

/// In [0, 1).
double parse_aggressiveness(const std::string& text);

/// The schemes by their names.
const std::map<std::string, CGAL::Deformable_simplicial_complexes::Integration_scheme>&
integration_schemes();

void require_extension(const std::string& path, const std::initializer_list<const char*>& known);

} // namespace dsc

#endif // DSC_OPTION_VALUES_H

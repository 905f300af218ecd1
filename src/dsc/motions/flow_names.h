// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLOW_NAMES_H
#define DSC_FLOW_NAMES_H

#include <CGAL/Interface_flows/Corner_rule.h>
#include <CGAL/Interface_flows/Integration_scheme.h>

#include <map>
#include <string>

namespace dsc {

/// Returns the integration schemes by their names in the command line, in files and in Python.
inline const std::map<std::string, CGAL::Deformable_simplicial_complexes::Integration_scheme>&
integration_schemes() {
  using CGAL::Deformable_simplicial_complexes::Integration_scheme;
  static const std::map<std::string, Integration_scheme> schemes = {
      {"euler", Integration_scheme::euler},
      {"rk2", Integration_scheme::rk2},
      {"rk4", Integration_scheme::rk4},
      {"adaptive", Integration_scheme::adaptive}};
  return schemes;
}

/// Returns the rules for corners of an offset by their names.
inline const std::map<std::string, CGAL::Deformable_simplicial_complexes::Corner_rule>&
corner_rules() {
  using CGAL::Deformable_simplicial_complexes::Corner_rule;
  static const std::map<std::string, Corner_rule> rules = {{"miter", Corner_rule::miter},
                                                           {"round", Corner_rule::round}};
  return rules;
}

} // namespace dsc

#endif // DSC_FLOW_NAMES_H

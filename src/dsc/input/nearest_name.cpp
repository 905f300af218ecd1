// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/nearest_name.h"

#include <algorithm>
#include <cstddef>

namespace dsc {
namespace {

/// Returns the number of letters to insert, remove, replace or exchange with their neighbors.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& d = distance[i][j];
      if (i == 0 || j == 0) {
        d = i + j;
        continue;
      }
      d = (std::min)({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                      distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d = (std::min)(d, distance[i - 2][j - 2] + 1);
    }
  return distance[a.size()][b.size()];
}

std::string lower_case(std::string text) {
  for (char& c : text)
    c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

} // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  static constexpr std::size_t longest = 100, // letters; longer names are not compared
      letters_per_error = 3;
  if (name.size() > longest)
    return "";
  std::string result;
  std::size_t least = std::max<std::size_t>(1, (name.size() + 1) / letters_per_error) + 1;
  for (const std::string& candidate : known) {
    if (lower_case(candidate) == lower_case(name))
      return candidate;
    // A name whose letters must all change is not near.
    if (const std::size_t d = edit_distance(name, candidate);
        d < least && d < (std::max)(name.size(), candidate.size())) {
      least = d;
      result = candidate;
    }
  }
  return result;
}

std::string advice_on_name(const std::string& name, const std::vector<std::string>& known,
                           const std::string& list) {
  if (const std::string nearest = nearest_name(name, known); !nearest.empty())
    return "; did you mean '" + nearest + "'?";
  std::string names;
  for (const std::string& k : known)
    names += (names.empty() ? "" : ", ") + k;
  return "; " + list + " are " + names;
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/label_components.h"

#include "programs/errors.h"

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <cmath>
#include <sstream>

namespace dsc {
namespace {

using Counts = std::array<std::size_t, 3>;

/// Connects the samples of a grid, which are added in the order of their positions. Only two layers
/// are stored.
class Grid_components
{
public:
  Grid_components(const Counts& n, bool with_corners)
      : m_nx(n[0]), m_ny(n[1]), m_with_corners(with_corners), m_before(n[0] * n[1]),
        m_layer(n[0] * n[1]) {}

  void begin_layer() {
    std::swap(m_before, m_layer);
    m_has_before = m_has_layer;
    m_has_layer = true;
  }

  void add(std::size_t i, std::size_t j, int label) {
    Sample& sample = m_layer[i + j * m_nx];
    sample = {label, none};
    if (m_has_before)
      connect(sample, m_before, i, j, 1, 1);
    if (j > 0)
      connect(sample, m_layer, i, j - 1, 1, 0);
    if (i > 0)
      connect(sample, m_layer, i - 1, j, 0, 0);
    if (sample.set == none) {
      sample.set = m_sets.add();
      m_labels.push_back(label);
    }
  }

  /// Returns the number of connected components of each label.
  std::map<int, std::size_t> numbers() {
    std::map<int, std::size_t> result;
    for (std::size_t i = 0; i < m_labels.size(); ++i)
      if (m_sets.find(i) == i)
        ++result[m_labels[i]];
    return result;
  }

private:
  static constexpr std::size_t none = -1;
  struct Sample
  {
    int label;
    std::size_t set;
  };

  /// Connects a sample to the sample of a layer at (i, j) and, if corners count, to the samples
  /// around it.
  void connect(Sample& sample, const std::vector<Sample>& layer, std::size_t i, std::size_t j,
               std::size_t di, std::size_t dj) {
    if (!m_with_corners)
      di = dj = 0;
    for (std::size_t l = j - (std::min)(j, dj); l <= (std::min)(j + dj, m_ny - 1); ++l)
      for (std::size_t k = i - (std::min)(i, di); k <= (std::min)(i + di, m_nx - 1); ++k) {
        const Sample& other = layer[k + l * m_nx];
        if (other.label != sample.label)
          continue;
        if (sample.set == none)
          sample.set = other.set;
        else if (sample.set != other.set)
          m_sets.join(sample.set, other.set);
      }
  }

  std::size_t m_nx, m_ny;
  bool m_with_corners, m_has_before = false, m_has_layer = false;
  std::vector<Sample> m_before, m_layer;
  DSC::Disjoint_sets m_sets; // of samples
  std::vector<int> m_labels; // of the elements of the sets
};

/// Returns the numbers of samples along the axes for a spacing, all odd or all even. Odd numbers of
/// samples hit a thin sheet in the middle of the box. Even numbers of samples hit it only if it is
/// thick enough. A box without extent along an axis, as in the plane, has one sample there.
Counts samples(const std::array<double, 6>& box, double spacing, bool odd) {
  Counts result;
  for (std::size_t i = 0; i < 3; ++i)
    if (box[i + 3] > box[i])
      result[i] = 2 * std::size_t(std::ceil((box[i + 3] - box[i]) / spacing / 2)) + (odd ? 1 : 0);
    else
      result[i] = 1;
  return result;
}

bool are_equal(const Component_ranges& a, const Component_ranges& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.first == q.first && p.second.least == q.second.least && p.second.most == q.second.most;
  });
}

struct Shorter_edge
{
  double length;
  bool is_enough; ///< false if this length is also too long
};

/// Returns an edge length that resolves the components, found by repeated halving: samples at
/// different positions show the same components.
Shorter_edge shorter_edge(const std::array<double, 6>& box, double edge,
                          const Label_function& label_at, const std::map<int, std::string>& names) {
  static constexpr double most = 1e7; // samples: takes seconds
  for (double length = edge / 2;; length /= 2) {
    const Counts n = samples(box, length, true);
    if (double(n[0]) * double(n[1]) * double(n[2]) > most)
      return {2 * length, false};
    const Component_ranges odd = count_components(box, n, label_at);
    const bool has_all = std::all_of(names.begin(), names.end(),
                                     [&](const auto& name) { return odd.count(name.first) > 0; });
    if (has_all && are_equal(odd, count_components(box, samples(box, length, false), label_at)))
      return {length, true};
  }
}

} // namespace

Component_ranges count_components(const std::array<double, 6>& box, const Counts& n,
                                  const Label_function& label_at) {
  Grid_components with_corners(n, true), with_faces(n, false);
  const auto coordinate = [&](std::size_t axis, std::size_t i) {
    return box[axis] + (box[axis + 3] - box[axis]) * (double(i) + .5) / double(n[axis]);
  };
  for (std::size_t k = 0; k < n[2]; ++k) {
    with_corners.begin_layer();
    with_faces.begin_layer();
    for (std::size_t j = 0; j < n[1]; ++j) {
      DSC::Progress_scope::check();
      for (std::size_t i = 0; i < n[0]; ++i) {
        const int label = label_at({coordinate(0, i), coordinate(1, j), coordinate(2, k)});
        with_corners.add(i, j, label);
        with_faces.add(i, j, label);
      }
    }
  }
  Component_ranges result;
  for (const auto& [label, number] : with_corners.numbers())
    result[label].least = number;
  for (const auto& [label, number] : with_faces.numbers())
    result[label].most = number;
  return result;
}

Component_ranges count_components(const std::array<double, 6>& box, double edge,
                                  const Label_function& label_at) {
  static constexpr double samples_per_edge = 3;
  return count_components(box, samples(box, edge / samples_per_edge, true), label_at);
}

void require_resolved(const std::array<double, 6>& box, double edge, const Label_function& label_at,
                      const Component_ranges& expected, const std::map<int, std::size_t>& found,
                      std::map<int, std::string> names) {
  if (found.count(0) > 0 || expected.count(0) > 0)
    names.emplace(0, "label 0 (the surrounding space)");
  for (const auto& [label, name] : names) {
    const auto in_complex = found.find(label);
    const std::size_t number = in_complex == found.end() ? 0 : in_complex->second;
    const auto in_samples = expected.find(label);
    const Component_range range =
        in_samples == expected.end() ? Component_range{0, 0} : in_samples->second;
    if (number > 0 && range.least <= number && number <= range.most)
      continue;
    const Shorter_edge shorter = shorter_edge(box, edge, label_at, names);
    std::ostringstream message;
    message << name;
    if (number > 0 || range.most > 0) {
      message << " has " << number << noun(number, " connected component", " connected components")
              << " in the mesh instead of ";
      if (range.least < range.most)
        message << range.least << " to ";
      message << range.most << ": the edge length " << edge << " is too large";
    } else if (shorter.is_enough)
      message << " has no cells: the edge length " << edge << " is too large";
    else
      message << " has no cells: it is empty in the domain, or later ones cover it; remove it or "
              << "change it";
    if (shorter.is_enough)
      message << "; choose about " << shorter.length;
    else if (number > 0 || range.most > 0)
      message << "; choose much less than " << shorter.length;
    throw Input_error(message.str());
  }
}

} // namespace dsc

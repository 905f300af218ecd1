// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INEQUALITIES_H
#define DSC_INEQUALITIES_H

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace dsc {

/// Regions written down: each an inequality in x, y and z like 'x^2+y^2+z^2<1', or several with &&
/// and || between them. Copies share the parsers.
class Inequalities
{
public:
  /// \throws Usage_error if one cannot be read, with what is wrong
  explicit Inequalities(const std::vector<std::string>& expressions);

  /// The number, from 1, of the last one that holds; 0 if none does.
  int label_at(const std::array<double, 3>& p) const;

private:
  struct Parsers;
  std::shared_ptr<Parsers> m_parsers;
};

} // namespace dsc

#endif // DSC_INEQUALITIES_H

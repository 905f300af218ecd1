// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_2_H
#define DSC_TRACKED_COMPLEX_2_H

#include "motions/tracked_whole.h"

#include <CGAL/Interface_flows/compiled_2.h>

namespace dsc {

extern template class Tracked_whole<CGAL::Deformable_simplicial_complex_2<>>;

/// A complex in the plane, in the coordinates of the input.
class Tracked_complex_2 : public Tracked_whole<CGAL::Deformable_simplicial_complex_2<>>
{
public:
  using Tracked_whole::Tracked_whole;

  Step_outcome advance(const Step_options& options, double time, unsigned threads) override;
  Statistics statistics() const override;
  void write(const std::string& path) const override;
  void write_subdivided(const std::string& path, int subdivisions) const override;
  void write_picture(const std::string& stem) const override;
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_2_H

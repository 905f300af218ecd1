// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_2_H
#define DSC_TRACKED_COMPLEX_2_H

#include "output_arrays.h"
#include "tracked_complex.h"

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// A complex in the plane, in the coordinates of the input.
class Tracked_complex_2 : public Tracked_complex
{
public:
  using Complex = CGAL::Deformable_simplicial_complex_2<>;

  Tracked_complex_2() = default;
  explicit Tracked_complex_2(Complex&& built) : complex(std::move(built)) {}

  int dimension() const override { return 2; }
  double time_step(const Motion& motion) const override;
  Step_outcome advance(const Step_options& options, double time, unsigned threads) override;
  bool has_room() const override;
  void grow_domain() override;
  void keep() override { m_kept = complex.state(); }
  void forget() override { m_kept.reset(); }
  void go_back() override;
  std::size_t missing_facets(double edge_per_thickness) const override;
  Statistics statistics() const override;
  double worst_quality() const override;
  std::vector<Surface_point> interface_points() const override;
  double mean_edge() const override { return complex.mean_interface_edge(); }
  double sweep_seconds() const override;
  void write(const std::string& path) const override;
  void write_subdivided(const std::string& path, int subdivisions) const override;
  void write_interface_vtu(const std::string& path) const override;
  void write_volume_vtu(const std::string& path) const override;
  void write_picture(const std::string& stem) const override;
  void write_checkpoint(const std::string& path, const std::string& metadata) const override;

  Complex complex;
  Output_arrays arrays; ///< of the output files

private:
  std::optional<DSC::State<2>> m_kept;
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_2_H

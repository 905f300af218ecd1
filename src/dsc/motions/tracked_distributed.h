// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_DISTRIBUTED_H
#define DSC_TRACKED_DISTRIBUTED_H

#include "motions/tracked_complex_3.h"

#include <CGAL/Distributed_complexes/Distributed_complex.h>

namespace dsc {

/// A complex that is distributed among processes. All functions are collective. A file is written
/// by the first process, or a piece of it by each process.
class Tracked_distributed : public Tracked_complex
{
public:
  using Complex = Tracked_complex_3::Complex;
  using Distributed = DSC::Distributed_complex<Complex>;

  /// \param divide divides the complex again if the work of the processes differs; called before each
  /// step
  Tracked_distributed(DSC::Communicator& communicator, void (*divide)(Distributed&))
      : complex(communicator), m_divide(divide) {}

  void run_once(const std::function<void()>& function) const override;
  double agreed(double number) const override;
  std::string grid_extension() const override { return ".pvtu"; }
  int dimension() const override { return 3; }
  Step_outcome advance(const Step_options& options, double time, unsigned threads) override;
  bool has_room() const override { return true; }
  void grow_domain() override {}
  void keep() override { m_kept = complex.state(); }
  void forget() override { m_kept.reset(); }
  void go_back() override;
  std::size_t missing_facets(double) const override { return 0; } // not known
  Statistics statistics() const override;
  double worst_quality() const override;
  /// Returns the points on the first process, and none on the others.
  std::vector<Surface_point> interface_points() const override;
  double mean_edge() const override;
  double sweep_seconds() const override;
  void write(const std::string& path) const override;
  void write_subdivided(const std::string& path, int subdivisions) const override;
  void write_interface_vtu(const std::string& path) const override;
  void write_volume_vtu(const std::string& path) const override;
  void write_checkpoint(const std::string& path, const std::string& metadata) const override;

  Distributed complex;

private:
  bool is_first() const { return complex.communicator().rank() == 0; }
  void write_whole(const std::function<void(const Tracked_complex_3&)>& write) const;

  void (*m_divide)(Distributed&);
  std::optional<Distributed::State> m_kept;
};

} // namespace dsc

#endif // DSC_TRACKED_DISTRIBUTED_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_WHOLE_H
#define DSC_TRACKED_WHOLE_H

#include "motions/tracked_complex.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/Mesh_arrays.h>

namespace dsc {

/// The functions that compute the arrays of output files, such as the velocities of a fluid.
struct Output_arrays
{
  using Mesh_arrays = DSC::Mesh_arrays;

  /// Returns the arrays for write_VTU().
  std::function<Mesh_arrays()> of_cells = [] { return Mesh_arrays(); };
  /// Returns the arrays for write_interface_VTU(). The first array on points, if there is one,
  /// contains velocities in space. Smooth surfaces have them, too.
  std::function<Mesh_arrays()> of_interface = [] { return Mesh_arrays(); };
};

/// A complex of either dimension that one process holds. tracked_whole_impl.h defines the
/// functions.
template <class Complex_> class Tracked_whole : public Tracked_complex
{
public:
  using Complex = Complex_;

  Tracked_whole() = default;
  explicit Tracked_whole(Complex&& built) : complex(std::move(built)) {}

  int dimension() const override { return Complex::dimension; }
  bool has_room() const override;
  void grow_domain() override;
  void keep() override { m_kept = complex.state(); }
  void forget() override { m_kept.reset(); }
  void go_back() override;
  std::size_t missing_facets(double edge_per_thickness) const override;
  double worst_quality() const override;
  std::vector<Surface_point> interface_points() const override;
  double mean_edge() const override {
    return complex.mean_interface_edge() * complex.normalization().scale;
  }
  double sweep_seconds() const override;
  void write_interface_vtu(const std::string& path) const override;
  void write_volume_vtu(const std::string& path) const override;
  void write_checkpoint(const std::string& path, const std::string& metadata) const override;

  Complex complex;
  Output_arrays arrays; ///< of the output files

protected:
  /// Adds the names of the labels to arrays.
  DSC::Mesh_arrays with_names(DSC::Mesh_arrays arrays) const {
    arrays.label_names = label_names;
    return arrays;
  }

private:
  std::optional<typename Complex::State> m_kept;
};

} // namespace dsc

#endif // DSC_TRACKED_WHOLE_H

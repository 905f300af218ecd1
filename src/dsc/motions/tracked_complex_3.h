// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_3_H
#define DSC_TRACKED_COMPLEX_3_H

#include "motions/tracked_whole.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/compiled_3.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>

namespace dsc {

extern template class Tracked_whole<CGAL::Deformable_simplicial_complex_3<>>;

/// A complex in space.
class Tracked_complex_3 : public Tracked_whole<CGAL::Deformable_simplicial_complex_3<>>
{
public:
  using Tracked_whole::Tracked_whole;

  Step_outcome advance(const Step_options& options, double time, unsigned threads) override;
  void grow_domain() override;
  void keep() override;
  void forget() override;
  void go_back() override;
  Statistics statistics() const override;
  void write_interface_vtu(const std::string& path) const override;
  void write_checkpoint(const std::string& path, const std::string& metadata) const override;
  void write(const std::string& path) const override;
  void write_subdivided(const std::string& path, int subdivisions) const override;

  /// Carries arrays through all changes of the complex, and writes them to its files.
  /// \param carried by increasing time stamps of the vertices and cells
  void carry(DSC::Mesh_arrays carried);
  bool carries_arrays() const { return !m_carried.points.empty() || !m_carried.cells.empty(); }

private:
  DSC::Mesh_arrays m_carried;
  std::optional<DSC::Mesh_arrays> m_kept_arrays; // for go_back()
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_3_H

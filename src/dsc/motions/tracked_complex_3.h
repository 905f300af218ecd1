// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_3_H
#define DSC_TRACKED_COMPLEX_3_H

#include "input/mesh_content.h"
#include "motions/tracked_whole.h"
#include "programs/threads_option.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/compiled_3.h>

#include <memory>
#include <optional>
#include <string>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// The options of the improvement of tetrahedra.
struct Improvement_options
{
  bool aggressive = false;         ///< whether more expensive operations are used
  std::optional<double> threshold; ///< in (0, 1]; the library's default if not set
  unsigned threads = default_number_of_threads();
};

extern template class Tracked_whole<CGAL::Deformable_simplicial_complex_3<>>;

/// A complex in space.
class Tracked_complex_3 : public Tracked_whole<CGAL::Deformable_simplicial_complex_3<>>
{
public:
  using Tracked_whole::Tracked_whole;

  /// Returns the complex of the labeled tetrahedra of a file.
  /// \throws Input_error if the tetrahedra do not define a complex
  static std::unique_ptr<Tracked_complex_3> from_mesh(const std::string& path,
                                                      const Labeled_tetrahedra& mesh);

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
  void carry(Mesh_arrays carried);
  bool carries_arrays() const { return !m_carried.points.empty() || !m_carried.cells.empty(); }

  /// Improves the tetrahedra. The interface and the boundary keep their shape.
  /// \param content the content of the vertices and cells, which is updated: entities are
  /// preserved, averages over cells keep their integrals, values at vertices are interpolated, and
  /// integers of cells keep their regions
  Improvement_outcome improve(const Improvement_options& options, Mesh_content& content);

  /// Writes the tetrahedra (.mesh, .vtu) with their content.
  void write(const std::string& path, const Mesh_content& content) const;

private:
  Mesh_arrays m_carried;
  std::optional<Mesh_arrays> m_kept_arrays; // for go_back()
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_3_H

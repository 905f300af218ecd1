// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_3_H
#define DSC_TRACKED_COMPLEX_3_H

#include "mesh_content.h"
#include "output_arrays.h"
#include "threads_option.h"
#include "tracked_complex.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// The options of the improvement of tetrahedra.
struct Improvement_options
{
  bool aggressive = false;         ///< whether more expensive operations are used
  std::optional<double> threshold; ///< in (0, 1]; the library's default if not set
  unsigned threads = default_number_of_threads();
};

class Tracked_complex_3 : public Tracked_complex
{
public:
  using Complex = CGAL::Deformable_simplicial_complex_3<>;

  Tracked_complex_3() = default;
  explicit Tracked_complex_3(Complex&& built) : complex(std::move(built)) {}

  /// Returns the complex of the labelled tetrahedra of a file.
  /// \throws Input_error if the tetrahedra do not define a complex
  static std::unique_ptr<Tracked_complex_3> from_mesh(const std::string& path,
                                                      const Labelled_tetrahedra& mesh);

  int dimension() const override { return 3; }
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
  double mean_edge() const override;
  double sweep_seconds() const override;
  void write(const std::string& path) const override;
  void write_subdivided(const std::string& path, int subdivisions) const override;
  void write_interface_vtu(const std::string& path) const override;
  void write_volume_vtu(const std::string& path) const override;
  void write_picture(const std::string&) const override {}
  void write_checkpoint(const std::string& path, const std::string& metadata) const override;

  /// Improves the tetrahedra. The interface and the boundary keep their shape.
  /// \param content the content of the vertices and cells, which is updated: entities are
  /// preserved, averages over cells keep their integrals, values at vertices are interpolated, and
  /// integers of cells keep their regions
  Improvement_outcome improve(const Improvement_options& options, Mesh_content& content);

  /// Writes the tetrahedra (.mesh, .vtu) with their content.
  void write(const std::string& path, const Mesh_content& content) const;

  Complex complex;
  Output_arrays arrays; ///< of the output files

private:
  std::optional<DSC::State<3>> m_kept;
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_3_H

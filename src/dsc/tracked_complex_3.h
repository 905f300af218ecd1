// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_COMPLEX_3_H
#define DSC_TRACKED_COMPLEX_3_H

#include "mesh_content.h"
#include "tracked_complex.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// How tetrahedra are improved.
struct Improvement_options
{
  bool aggressive = false;         ///< takes minutes instead of seconds
  std::optional<double> threshold; ///< of the quality, in (0, 1]; that of the library if not set
};

class Tracked_complex_3 : public Tracked_complex
{
public:
  using Complex = CGAL::Deformable_simplicial_complex_3<>;

  Tracked_complex_3() = default;
  explicit Tracked_complex_3(Complex&& built) : complex(std::move(built)) {}

  /// The labelled tetrahedra of a file.
  /// \throws Input_error if they make no complex
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
  Statistics statistics() const override;
  std::vector<Surface_point> interface_points() const override;
  double mean_edge() const override;
  double sweep_seconds() const override;
  void write(const std::string& path) const override;
  void write_subdivided(const std::string& path, int subdivisions) const override;
  void write_interface_vtu(const std::string& path) const override;
  void write_volume_vtu(const std::string& path) const override;
  void write_picture(const std::string&) const override {}
  void write_checkpoint(const std::string& path, const std::string& metadata) const override;

  /// Improves the tetrahedra; neither the interface nor the boundary changes its shape.
  /// \param content of the vertices and cells follows: entities stay as they are, averages over
  /// cells keep their integral, values at vertices are interpolated, and integers of cells stay
  /// where they are
  Improvement_outcome improve(const Improvement_options& options, Mesh_content& content);

  /// Writes the tetrahedra (.mesh, .vtu) with what follows them.
  void write(const std::string& path, const Mesh_content& content) const;

  Complex complex;
  /// What `write_volume_vtu()` tells of vertices; both are set or none.
  std::function<CGAL::Simple_cartesian<double>::Vector_3(Complex::Vertex_handle)> velocity_at;
  std::function<double(Complex::Vertex_handle)> pressure_at;

private:
  std::optional<DSC::State<3>> m_kept;
};

} // namespace dsc

#endif // DSC_TRACKED_COMPLEX_3_H

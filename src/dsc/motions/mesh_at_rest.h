// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MESH_AT_REST_H
#define DSC_MESH_AT_REST_H

#include "input/mesh_content.h"
#include "output/statistics.h"
#include "programs/option_values.h"

#include <CGAL/Deformable_simplicial_complexes/State.h>

namespace dsc {

/// The options of the improvement of tetrahedra.
struct Improvement_options
{
  bool aggressive = false;         ///< whether more expensive operations are used
  std::optional<double> threshold; ///< in (0, 1]; the library's default if not set
  unsigned threads = default_number_of_threads();
};

/// Labeled tetrahedra, for example of a file, which do not move. They are the domain and can have
/// any shape.
class Mesh_at_rest
{
public:
  /// \param path file of the tetrahedra, for messages
  /// \param mesh the tetrahedra; points at which the domain touches itself are copied
  /// \throws Input_error if the tetrahedra do not define a complex
  Mesh_at_rest(const std::string& path, Labeled_tetrahedra& mesh);

  /// Copies the tetrahedra of a complex, which has the state, and the names of its labels.
  Mesh_at_rest(const DSC::State<3>& state, const DSC::Label_names& names);

  /// Returns the content of the mesh that changes of the complex preserve, see content_of().
  Mesh_content content(Labeled_tetrahedra mesh, const std::string& format,
                       Unused_content& unused) const;

  Statistics statistics() const;

  /// Improves the tetrahedra. The interface and the boundary keep their shape.
  /// \param content the content of the vertices and cells, which is updated: entities are
  /// preserved, averages over cells keep their integrals, values at vertices are interpolated, and
  /// integers of cells keep their regions
  Improvement_outcome improve(const Improvement_options& options, Mesh_content& content);

  /// Writes the tetrahedra (.mesh, .vtu) with their content, or the interface, in the format of the
  /// extension, with the names of the labels. Points at which the domain touches itself are written
  /// once.
  void write(const std::string& path, Mesh_content content) const;

private:
  Solid_complex m_complex;
  std::vector<Solid_complex::Vertex_handle> m_vertices; ///< of the points of the file
  DSC::Label_names m_names;
};

} // namespace dsc

#endif // DSC_MESH_AT_REST_H

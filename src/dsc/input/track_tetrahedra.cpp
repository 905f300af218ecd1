// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/domain_box.h"
#include "input/labeled_tetrahedra.h"
#include "input/mesh_content.h"
#include "input/start_complex.h"
#include "input/tetrahedralizer.h"
#include "input/translations.h"
#include "motions/arrays_on.h"
#include "motions/tracked_complex_3.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
namespace parameters = CGAL::parameters;

/// Returns whether all tetrahedra at the boundary have label 0, so that there is room around the
/// interface.
bool has_room_around(const Complex& complex) {
  const auto& triangulation = complex.triangulation();
  const auto all = triangulation.all_cell_handles();
  return std::all_of(all.begin(), all.end(), [&](Complex::Cell_handle c) {
    return !triangulation.is_infinite(c) ||
           c->neighbor(c->index(triangulation.infinite_vertex()))->subdomain_index() == 0;
  });
}

/// Returns the complex whose domain is the mesh of a file; null if the domain is to be a box around
/// the mesh.
/// \throws Input_error if the user asks for this domain, and the mesh does not define a complex, or
/// if there is no interface
std::unique_ptr<Tracked_complex_3>
track_in_mesh(const std::string& path, const Labeled_tetrahedra& mesh, const Run_start& start) {
  auto result = std::make_unique<Tracked_complex_3>();
  try {
    result->complex = DSC::make_deformable_simplicial_complex_3<Complex>(
        mesh.points, mesh.tetrahedra, mesh.labels,
        parameters::improve(false).edge_per_thickness(0.));
  } catch (const DSC::Invalid_cells_error& error) {
    if (!start.mesh_is_domain)
      return nullptr;
    throw Input_error(path + ": " + error.what() + place_of(error, mesh) +
                      ", or leave out --domain mesh");
  }
  if (!start.mesh_is_domain && !has_room_around(result->complex))
    return nullptr;
  if (result->complex.interface_facets().empty())
    throw Input_error(path + ": all tetrahedra have the same label, so there is no interface; give "
                             "a --domain around them, or other --labels");
  DSC::refine_thin_parts(result->complex, start.thin_parts);
  return result;
}

/// Returns the complex of tetrahedra in a box with tetrahedra of label 0 around them.
std::unique_ptr<Tracked_complex_3>
track_in_box(const std::string& path, const Labeled_tetrahedra& mesh, const Run_options& options) {
  try {
    auto result =
        std::make_unique<Tracked_complex_3>(DSC::make_deformable_simplicial_complex_3<Complex>(
            mesh.points, mesh.tetrahedra, mesh.labels, Tetrahedralizer(),
            normalized(options.domain, options.start.thin_parts)));
    if (result->complex.interface_facets().empty())
      throw Input_error(path + ": all tetrahedra have the label 0, so there is no interface; give "
                               "other --labels");
    return result;
  } catch (const DSC::Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  } catch (const DSC::Invalid_surface_error& error) {
    if (error.reason() == DSC::Invalid_surface_error::Reason::outside_enclosing_box)
      throw Input_error(path +
                        ": the tetrahedra are not strictly inside the domain; enlarge --domain");
    throw Input_error(path + ": the boundary of the tetrahedra is invalid: " + message_of(error));
  }
}

} // namespace

std::unique_ptr<Tracked_complex> track_tetrahedra(const std::string& path,
                                                  const Run_options& options) {
  Labeled_tetrahedra mesh = read_tetrahedra(path, options.start.labels);
  mesh.leave_out_entities();
  mesh.arrays = carried_arrays(std::move(mesh.arrays), mesh.unused);
  print_unused(path, mesh.unused);
  std::unique_ptr<Tracked_complex_3> result;
  if (!options.domain)
    result = track_in_mesh(path, mesh, options.start);
  if (!result)
    result = track_in_box(path, mesh, options);
  result->label_names = mesh.arrays.label_names;
  result->carry(arrays_on(result->complex, mesh));
  return result;
}

} // namespace dsc

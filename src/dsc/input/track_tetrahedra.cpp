// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/domain_box.h"
#include "input/labeled_tetrahedra.h"
#include "input/start_complex.h"
#include "input/unused.h"
#include "motions/tracked_complex_3.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

/// Returns whether all tetrahedra at the boundary have label 0, so that there is room around the
/// interface.
bool has_room_around(const Complex& complex) {
  const auto& triangulation = complex.triangulation();
  const auto all = triangulation.all_cell_handles();
  return std::all_of(all.begin(), all.end(), [&](Complex::Cell_handle c) {
    return !triangulation.is_infinite(c) ||
           c->neighbor(c->index(triangulation.infinite_vertex()))->label() == 0;
  });
}

} // namespace

std::unique_ptr<Tracked_complex_3> Tracked_complex_3::from_mesh(const std::string& path,
                                                                const Labeled_tetrahedra& mesh) {
  try {
    auto result =
        std::make_unique<Tracked_complex_3>(DSC::make_deformable_simplicial_complex_3<Complex>(
            mesh.points, mesh.tetrahedra, mesh.labels,
            parameters::improve(false).edge_per_thickness(0.)));
    result->label_names = mesh.arrays.label_names;
    return result;
  } catch (const Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  }
}

std::unique_ptr<Tracked_complex> track_tetrahedra(const std::string& path,
                                                  const Run_options& options) {
  Labeled_tetrahedra mesh = read_tetrahedra(path, options.start.labels);
  mesh.leave_out_arrays();
  mesh.leave_out_entities();
  print_unused(path, mesh.unused);
  if (!options.domain) {
    try {
      auto complex = Tracked_complex_3::from_mesh(path, mesh);
      if (has_room_around(complex->complex)) {
        DSC::refine_thin_parts(complex->complex, options.start.thin_parts);
        return complex;
      }
    } catch (const Input_error&) { // not a ball, or invalid
    }
  }
  try {
    auto result =
        std::make_unique<Tracked_complex_3>(DSC::make_deformable_simplicial_complex_3<Complex>(
            mesh.points, mesh.tetrahedra, mesh.labels, CGAL::Tetgen_tetrahedralizer_3(),
            normalized(options.domain, options.start.thin_parts)));
    result->label_names = mesh.arrays.label_names;
    return result;
  } catch (const Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  } catch (const Invalid_surface_error& error) {
    throw Input_error(path + ": the boundary of the tetrahedra is invalid: " + error.what());
  }
}

} // namespace dsc

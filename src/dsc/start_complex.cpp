// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "start_complex.h"

#include "domain_box.h"
#include "errors.h"
#include "inequalities.h"
#include "label_components.h"
#include "labelled_tetrahedra.h"
#include "remove_fragments.h"
#include "start_curves.h"
#include "surface.h"
#include "tracked_complex_3.h"
#include "unused.h"

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using CGAL::Deformable_simplicial_complexes::Tetrahedralization_error;
using Domain = std::optional<std::array<double, 6>>;

std::unique_ptr<Tracked_complex> track(Complex&& complex) {
  return std::make_unique<Tracked_complex_3>(std::move(complex));
}

std::unique_ptr<Tracked_complex> track_inequalities(const Run_start& start,
                                                    const std::array<double, 6>& d) {
  const Inequalities inequalities(start.inputs);
  static constexpr double edges_of_side = 40;
  const double side = std::max({d[3] - d[0], d[4] - d[1], d[5] - d[2]});
  const double edge = start.edge > 0 ? start.edge : side / edges_of_side;
  const Label_function label_at = [&](const std::array<double, 3>& p) {
    return inequalities.label_at(p);
  };
  auto complex =
      DSC::make_deformable_simplicial_complex_3<Complex>(box(d), edge, [&](const auto& p) {
        return label_at({p.x(), p.y(), p.z()});
      });
  if (complex.interface_facets().empty())
    throw Input_error("the inequalities define no interface in the domain; choose another "
                      "--domain or a smaller --edge");
  std::map<int, std::string> names;
  for (std::size_t i = 0; i < start.inputs.size(); ++i)
    names[int(i) + 1] = "the inequality '" + start.inputs[i] + "'";
  const Component_ranges expected = count_components(d, edge, label_at);
  remove_fragments(complex, expected);
  require_resolved(d, edge, label_at, expected, numbers_of_components(complex), names);
  return track(std::move(complex));
}

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

std::unique_ptr<Tracked_complex> track_tetrahedra(const std::string& path,
                                                  const std::string& labels, const Domain& domain) {
  using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
  Labelled_tetrahedra mesh = read_tetrahedra(path, labels);
  mesh.leave_out_arrays();
  mesh.leave_out_entities();
  print_unused(path, mesh.unused);
  if (!domain) {
    try {
      auto complex = Tracked_complex_3::from_mesh(path, mesh);
      if (has_room_around(complex->complex))
        return complex;
    } catch (const Input_error&) { // not a ball, or invalid
    }
  }
  try {
    return track(DSC::make_deformable_simplicial_complex_3<Complex>(
        mesh.points, mesh.tetrahedra, mesh.labels, CGAL::Tetgen_tetrahedralizer_3(),
        normalized(domain)));
  } catch (const Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  } catch (const CGAL::Deformable_simplicial_complexes::Invalid_surface_error& error) {
    throw Input_error(path + ": the boundary of the tetrahedra is invalid: " + error.what());
  }
}

/// Returns whether a tetrahedralizer may succeed with another surface of the same size.
bool is_of_surface(const Tetrahedralization_error& error) {
  static constexpr int out_of_memory = 1; // exit code of TetGen
  return error.code() != out_of_memory;
}

/// Builds the complex from surfaces. If TetGen fails for surfaces that bound solids, they are
/// repaired further, provided that repairs are permitted.
std::unique_ptr<Tracked_complex> track_surfaces_of_run(const Run_options& options,
                                                       const std::vector<std::string>& names,
                                                       Repairs& repairs) {
  std::vector<Surface> surfaces = start_surfaces(options.start, &repairs);
  std::ostream* notes = options.output.quiet ? nullptr : &std::cout;
  try {
    return track_surfaces(surfaces, names, options.domain, notes);
  } catch (const Tetrahedralization_error& error) {
    if (!options.start.repairs && is_of_surface(error))
      throw Input_error(std::string(error.what()) +
                        "; try --repair, which merges close vertices or wraps the surface");
    if (!is_of_surface(error))
      throw;
  }
  try {
    if (merge_near_vertices(surfaces, names, repairs))
      return track_surfaces(surfaces, names, options.domain, notes);
  } catch (const Tetrahedralization_error& error) {
    if (!is_of_surface(error))
      throw;
  }
  wrap(surfaces, names, repairs);
  return track_surfaces(surfaces, names, options.domain, notes);
}

} // namespace

std::unique_ptr<Tracked_complex> start_complex(const Run_options& options, Repairs& repairs) {
  const Run_start& start = options.start;
  if (dimension_of(start) == 2)
    return track_figure(start, options.domain);
  switch (input_kind(start)) {
  case Input_kind::inequalities:
    return track_inequalities(start, *options.domain);
  case Input_kind::image:
    return track_image(start.inputs.front(), start.edge, options.domain);
  case Input_kind::tetrahedra:
    return track_tetrahedra(start.inputs.front(), start.labels, options.domain);
  case Input_kind::surfaces:
    break;
  }
  std::vector<std::string> names = start.inputs;
  if (names.empty())
    names = {"the ball"};
  return track_surfaces_of_run(options, names, repairs);
}

} // namespace dsc

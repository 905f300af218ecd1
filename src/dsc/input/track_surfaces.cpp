// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/domain_box.h"
#include "input/start_complex.h"
#include "input/surface.h"
#include "input/surface_errors.h"
#include "motions/tracked_complex_3.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/make_patches_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Patches = DSC::Patches_of_surfaces_3<Surface_point>;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;

/// Returns the complex of the space inside and around surfaces.
/// \param boundaries surfaces or patches
template <class Boundaries>
std::unique_ptr<Tracked_complex_3> fill(const Boundaries& boundaries, const Run_options& options) {
  return std::make_unique<Tracked_complex_3>(DSC::make_deformable_simplicial_complex_3<Complex>(
      boundaries, CGAL::Tetgen_tetrahedralizer_3(),
      normalized(options.domain, options.start.thin_parts)));
}

bool may_have_walls(Reason reason) {
  return reason == Reason::non_manifold_edge || reason == Reason::self_intersection ||
         reason == Reason::crossing_surfaces;
}

const char* hint(Reason reason) {
  switch (reason) {
  case Reason::degenerate_facet:
  case Reason::open:
  case Reason::non_manifold_edge:
  case Reason::self_intersection:
    return "; or use --repair";
  case Reason::outside_enclosing_box:
    return "; enlarge --domain";
  default:
    return "";
  }
}

[[noreturn]] void refuse(const Invalid_surface_error& error,
                         const std::vector<std::string>& names) {
  std::string message = names[error.surface()];
  if (error.other_surface() != error.surface())
    message += " and " + names[error.other_surface()];
  if (error.reason() == Reason::crossing_surfaces)
    throw Input_error(message +
                      ": the surfaces intersect; separate them (surfaces may be nested or "
                      "share walls), or unite parts of a file by --labels none --repair");
  throw Input_error(message + ": " + message_of(error) + hint(error.reason()));
}

std::optional<Patches> patches_of(const std::vector<Surface>& surfaces) {
  try {
    return DSC::make_patches_3(surfaces);
  } catch (const Invalid_surface_error&) {
    return std::nullopt;
  }
}

void tell_labels(const Patches& patches, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<int>& labels = patches.labels[i];
    if (labels.size() == 1)
      continue;
    std::cout << "dsc: " << names[i] << ": internal walls divide the solid into " << labels.size()
              << " regions with the labels " << labels.front();
    for (auto label = labels.begin() + 1; label != labels.end(); ++label)
      std::cout << ", " << *label;
    std::cout << '\n';
  }
}

/// Returns the complex of the space inside and around surfaces, which may share walls.
std::unique_ptr<Tracked_complex_3> fill(const std::vector<Surface>& surfaces,
                                        const std::vector<std::string>& names,
                                        const Run_options& options) {
  try {
    return fill(surfaces, options);
  } catch (const Invalid_surface_error& error) {
    const auto patches = may_have_walls(error.reason()) ? patches_of(surfaces) : std::nullopt;
    if (!patches)
      refuse(error, names);
    if (!options.output.quiet)
      tell_labels(*patches, names);
    return fill(patches->patches, options);
  }
}

/// Returns the lengths of the edges of the interface, longest first. An edge occurs once for each
/// of its facets.
std::vector<double> edge_lengths(const Complex& complex) {
  std::vector<double> result;
  for (const auto& facet : complex.interface_facets()) {
    const auto v = complex.facet_vertices(facet);
    for (int i = 0; i < 3; ++i)
      result.push_back(std::sqrt(complex.displacement(v[i], v[(i + 1) % 3]).squared_length()));
  }
  std::sort(result.begin(), result.end(), std::greater<>());
  return result;
}

/// Splits the longest edges of the interface until it has about the given number of triangles, and
/// improves the tetrahedra. The shape of the interface does not change.
void refine(Complex& complex, std::size_t triangles, unsigned threads) {
  const CGAL::Deformable_simplicial_complexes::Progress_phase phase("refining the interface");
  const double enough = .95 * static_cast<double>(triangles);
  if (static_cast<double>(complex.interface_facets().size()) >= enough)
    return; // the surface was decimated

  static constexpr double shortest = .667; // edge that a round splits, relative to the longest edge
  DSC::Detail_options<Complex> options;
  options.change_interface = true;
  options.interface_split_length = 1;
  options.interface_collapse_length = 0;
  options.split_length = std::numeric_limits<double>::infinity();
  options.collapse_length = 0;
  options.number_of_iterations = 1;
  for (;;) {
    const std::vector<double> lengths = edge_lengths(complex);
    const std::size_t present = lengths.size() / 3;
    if (static_cast<double>(present) >= enough)
      break;
    // The split of an edge with two facets, which is listed twice, makes two triangles.
    const std::size_t number = std::min(triangles - present, lengths.size() - 1);
    const double length = std::max(lengths[number], shortest * lengths.front());
    options.sizing_field = [length](const Complex::Approximate_point_3&) { return length; };
    if (DSC::control_detail(complex, options).split == 0)
      break;
  }
  DSC::Mesh_improvement_options<Complex> improvement;
  improvement.number_of_threads = threads;
  DSC::improve_mesh(complex, improvement);
  complex.sort_storage();
}

} // namespace

std::unique_ptr<Tracked_complex> track_surfaces(const Surfaces& surfaces,
                                                const Run_options& options) {
  auto result = fill(surfaces.all, surfaces.titles, options);
  result->label_names = surfaces.names;
  const std::size_t triangles = options.start.triangles;
  if (!options.start.inputs.empty() && triangles > most_triangles_to_fill)
    refine(result->complex, triangles, options.threads);
  return result;
}

} // namespace dsc

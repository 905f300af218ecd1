// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/domain_box.h"
#include "input/start_complex.h"
#include "input/surface.h"
#include "input/tetrahedralizer.h"
#include "motions/tracked_complex_3.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/fill_solids_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/make_patches_3.h>

#include <iostream>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Patches = DSC::Patches_of_surfaces_3<Surface_point>;
using DSC::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;

constexpr double tolerance = .05; // of the number of triangles

const char* hint(Reason reason) {
  switch (reason) {
  case Reason::open:
  case Reason::self_intersection:
    return "; or use --repair";
  case Reason::outside_enclosing_box:
    return "; enlarge --domain";
  default:
    return "";
  }
}

/// Throws an error that calls surfaces by their names instead of their numbers.
[[noreturn]] void refuse(const Invalid_surface_error& error,
                         const std::vector<std::string>& names) {
  std::string message = names[error.surface()];
  if (error.other_surface() != error.surface())
    message += " and " + names[error.other_surface()];
  throw Input_error(message + ": " + message_of(error) + hint(error.reason()));
}

/// Returns the names of the surfaces at each patch.
std::vector<std::string> names_of(const Patches& patches, const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const auto& patch : patches.patches) {
    std::string& name = result.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i)
      for (const int label : patches.labels[i])
        if (label == patch.label_behind || label == patch.label_in_front)
          name += (name.empty() ? "" : " and ") + names[i];
  }
  return result;
}

/// Returns the largest coordinate of surfaces, without sign.
double largest_coordinate(const std::vector<Surface>& surfaces) {
  double result = 0;
  for (const Surface& surface : surfaces)
    for (const Surface_point& p : surface.points)
      result = (std::max)({result, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  return result;
}

/// \param extent the largest coordinate
void tell_labels(const Patches& patches, const std::vector<std::string>& names, double extent) {
  static constexpr double told_distance = 1e-8; // a larger part of the extent can be seen
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<int>& labels = patches.labels[i];
    if (labels.size() < 2)
      continue;
    std::cout << "dsc: " << names[i] << ": internal walls divide the solid into " << labels.size()
              << " regions with the labels " << labels.front();
    for (auto label = labels.begin() + 1; label != labels.end(); ++label)
      std::cout << ", " << *label;
    std::cout << '\n';
  }
  if (patches.weld_distance > told_distance * extent)
    std::cout << "dsc: places nearer to each other than " << patches.weld_distance
              << " were merged, since coordinates have few digits\n";
  for (const auto& [earlier, later] : patches.overlaps)
    std::cout << "dsc: " << names[later] << " covers " << names[earlier] << " where they overlap\n";
  for (const std::size_t i : patches.covered)
    std::cout << "dsc: nothing is left of " << names[i] << '\n';
}

/// Returns the names of the labels of surfaces. The other regions of a named part, which internal
/// walls divide, are called like `ring (2)`.
Label_names names_of_labels(const Surfaces& surfaces, const std::optional<Patches>& patches) {
  DSC::internal::Label_name_list result;
  for (const auto& [label, name] : surfaces.names)
    result.add(label, name);
  for (std::size_t i = 0; patches && i < surfaces.all.size(); ++i)
    if (const auto part = surfaces.names.find(surfaces.all[i].label); part != surfaces.names.end())
      for (const int label : patches->labels[i])
        if (label != part->first)
          result.add(label, part->second);
  return result.names;
}

/// Returns the complex of the space inside and around surfaces, which may share walls and overlap.
/// \param patches receives the patches if the surfaces were divided
std::unique_ptr<Tracked_complex_3> fill(const std::vector<Surface>& surfaces,
                                        const std::vector<std::string>& names,
                                        const Run_options& options,
                                        std::optional<Patches>& patches) {
  try {
    auto result = std::make_unique<Tracked_complex_3>(
        DSC::fill_solids_3<Complex>(surfaces, Tetrahedralizer(), patches,
                                    normalized(options.domain, options.start.thin_parts)));
    if (patches && !options.output.quiet)
      tell_labels(*patches, names, largest_coordinate(surfaces));
    return result;
  } catch (const Invalid_surface_error& error) {
    const auto of_patches = patches ? names_of(*patches, names) : names;
    refuse(error, error.surface() < of_patches.size() ? of_patches : names);
  } catch (const DSC::Tetrahedralization_error&) {
    throw;
  } catch (const DSC::Error& error) {
    throw Input_error(listed(names) + ": " + error.what() + "; or use --repair");
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

/// Returns options to change edges of the interface with a target length for all edges. No edges
/// are changed unless lengths are set.
DSC::Detail_options<Complex> interface_options(double length) {
  DSC::Detail_options<Complex> result;
  result.sizing_field = [length](const Complex::Point_3&) { return length; };
  result.change_interface = true;
  result.interface_split_length = std::numeric_limits<double>::infinity();
  result.interface_collapse_length = 0;
  result.split_length = std::numeric_limits<double>::infinity();
  result.collapse_length = 0;
  result.number_of_iterations = 1;
  return result;
}

/// Splits the longest edges of the interface until it has about the given number of triangles, and
/// improves the tetrahedra. The shape of the interface does not change.
void refine(Complex& complex, std::size_t triangles) {
  const DSC::Progress_phase phase("refining the interface");
  const double enough = (1 - tolerance) * static_cast<double>(triangles);
  static constexpr double shortest = .667; // edge that a round splits, relative to the longest edge
  for (;;) {
    const std::vector<double> lengths = edge_lengths(complex);
    const std::size_t present = lengths.size() / 3;
    if (static_cast<double>(present) >= enough)
      break;
    // The split of an edge with two facets, which is listed twice, makes two triangles.
    const std::size_t number = (std::min)(triangles - present, lengths.size() - 1);
    const double length = (std::max)(lengths[number], shortest * lengths.front());
    auto options = interface_options(length);
    options.interface_split_length = 1;
    if (DSC::control_detail(complex, options).split == 0)
      break;
  }
}

/// Collapses edges of the interface, the short ones first, until it has about the given number of
/// triangles, or edges are twice as long as those of so many equal triangles would be.
void coarsen(Complex& complex, std::size_t triangles) {
  const DSC::Progress_phase phase("coarsening the interface");
  static constexpr double first = .25, last = 2, factor = 1.05; // lengths
  static constexpr double least_quality = .05; // of cells, which are improved later
  double area = 0;
  for (const auto& facet : complex.interface_facets()) {
    const auto v = complex.facet_vertices(facet);
    area += std::sqrt(CGAL::cross_product(complex.displacement(v[0], v[1]),
                                          complex.displacement(v[0], v[2]))
                          .squared_length()) /
            2;
  }
  const double length = std::sqrt(4 / std::sqrt(3.) * area / static_cast<double>(triangles));
  for (double collapsed = first; collapsed < last; collapsed *= factor) {
    if (static_cast<double>(complex.interface_facets().size()) <=
        (1 + tolerance) * static_cast<double>(triangles))
      break;
    auto options = interface_options(length);
    options.interface_collapse_length = collapsed;
    options.collapse_quality = least_quality;
    options.number_of_iterations = 2;
    DSC::control_detail(complex, options);
  }
}

/// Refines or coarsens the interface to about the given number of triangles, and improves the
/// tetrahedra.
void resample(Complex& complex, std::size_t triangles, unsigned threads) {
  if (complex.interface_facets().size() < triangles)
    refine(complex, triangles);
  else
    coarsen(complex, triangles);
  DSC::Mesh_improvement_options<Complex> improvement;
  improvement.number_of_threads = threads;
  DSC::improve_mesh(complex, improvement);
  complex.sort_storage();
}

} // namespace

std::unique_ptr<Tracked_complex> track_surfaces(const Surfaces& surfaces,
                                                const Run_options& options) {
  std::optional<Patches> patches;
  auto result = fill(surfaces.all, surfaces.titles, options, patches);
  result->label_names = names_of_labels(surfaces, patches);
  const std::size_t triangles = options.start.triangles;
  // Separate surfaces were decimated, or refined up to the number of triangles that may be filled.
  const auto present = static_cast<double>(result->complex.interface_facets().size()),
             target = static_cast<double>(triangles);
  if (!options.start.inputs.empty() && triangles > 0 &&
      ((present < (1 - tolerance) * target && (patches || triangles > most_triangles_to_fill)) ||
       (present > (1 + tolerance) * target && patches)))
    resample(result->complex, triangles, options.threads);
  if (const std::size_t number = result->complex.interface_facets().size();
      patches && triangles > 0 && number > (1 + tolerance) * target && !options.output.quiet)
    std::cout << "dsc: the interface has " << number
              << " triangles: with fewer ones, its shape would change\n";
  return result;
}

} // namespace dsc

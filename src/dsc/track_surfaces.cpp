// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "domain_box.h"
#include "errors.h"
#include "surface.h"
#include "tracked_complex_3.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/make_patches_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
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
std::unique_ptr<Tracked_complex> fill(const Boundaries& boundaries,
                                      const std::optional<std::array<double, 6>>& domain) {
  return std::make_unique<Tracked_complex_3>(DSC::make_deformable_simplicial_complex_3<Complex>(
      boundaries, CGAL::Tetgen_tetrahedralizer_3(), normalized(domain)));
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
                      "share walls)");
  throw Input_error(message + ": " + error.what() + hint(error.reason()));
}

std::optional<Patches> patches_of(const std::vector<Surface>& surfaces) {
  try {
    return DSC::make_patches_3(surfaces);
  } catch (const Invalid_surface_error&) {
    return std::nullopt;
  }
}

void tell_labels(const Patches& patches, const std::vector<std::string>& names,
                 std::ostream& notes) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<int>& labels = patches.labels[i];
    if (labels.size() == 1)
      continue;
    notes << "dsc: " << names[i] << ": internal walls divide the solid into " << labels.size()
          << " regions with the labels " << labels.front();
    for (auto label = labels.begin() + 1; label != labels.end(); ++label)
      notes << ", " << *label;
    notes << '\n';
  }
}

} // namespace

std::unique_ptr<Tracked_complex> track_surfaces(const std::vector<Surface>& surfaces,
                                                const std::vector<std::string>& names,
                                                const std::optional<std::array<double, 6>>& domain,
                                                std::ostream* notes) {
  try {
    return fill(surfaces, domain);
  } catch (const Invalid_surface_error& error) {
    const auto patches = may_have_walls(error.reason()) ? patches_of(surfaces) : std::nullopt;
    if (!patches)
      refuse(error, names);
    if (notes)
      tell_labels(*patches, names, *notes);
    return fill(patches->patches, domain);
  }
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/tracked_complex_2.h"

#include "input/domain_box.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/start_complex.h"
#include "input/start_curves.h"
#include "input/translations.h"
#include "motions/tracked_whole_impl.h"
#include "output/angle_statistics.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Mesh_files/SVG_2.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_files/labeled_PNG_2.h>
#include <CGAL/Mesh_files/labeled_curves_2.h>
#include <CGAL/Mesh_files/labeled_image_2.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

namespace dsc {
namespace {

using Complex = Tracked_complex_2::Complex;

DSC::Construction_options<2> options_of(const Run_start& start,
                                        const std::optional<std::array<double, 6>>& domain) {
  DSC::Construction_options<2> result;
  if (domain)
    result.enclosing_box = box_of_dimension<2>(*domain);
  result.thin_parts = start.thin_parts;
  return result;
}

std::unique_ptr<Tracked_complex> track_image_2(const Run_start& start, const std::string& format,
                                               const DSC::Construction_options<2>& options) {
  static constexpr double default_edge = 2.5; // in pixels, as for voxels
  const std::string& path = start.inputs[0];
  Unused_content unused;
  const auto image = format == "png" ? CGAL::IO::read_labeled_PNG(path, &unused)
                                     : CGAL::IO::read_labeled_image(path, &unused);
  print_unused(path, unused);
  const double edge = start.edge > 0 ? start.edge : default_edge;
  try {
    auto result = std::make_unique<Tracked_complex_2>(
        DSC::make_deformable_simplicial_complex_2<Complex>(image, edge, options));
    if (result->complex.interface_facets().empty())
      throw Input_error(path + ": all pixels have the same label, so there is no interface; give a "
                               "larger --domain, which has label 0 around the image");
    return result;
  } catch (const DSC::Error& error) {
    throw Input_error(path + ": " + error.what());
  }
}

/// Reports segments with the same label on both sides, and curves that later curves cover.
/// \throws Input_error if there is no interface
void check_bounds(const Curves& curves, const std::string& input, const Complex& complex) {
  const std::size_t facets = complex.interface_facets().size();
  if (facets == 0)
    throw Input_error(input + ": each segment has the same label on both sides, so there is no "
                              "interface; close the segments or correct the regions");
  std::map<std::string, Unused_content> unused; // by file
  // Segments are divided only where they cross.
  if (curves.seeded && curves.seeded->segments.size() > facets) {
    const std::size_t inside = curves.seeded->segments.size() - facets;
    unused[input].add(std::string(noun(inside, "segment", "segments")) +
                          " with the same label on both sides",
                      inside);
  }
  std::map<std::string, std::size_t> covered; // number of curves, by file
  for (std::size_t i = 0; i < curves.closed.size(); ++i)
    covered[curves.names[i]] += complex.number_of_cells(curves.closed[i].label) == 0;
  for (const auto& [path, number] : covered)
    unused[path].add(
        noun(number, "curve covered by later curves", "curves covered by later curves"), number);
  for (const auto& [path, content] : unused)
    print_unused(path, content);
}

} // namespace

std::unique_ptr<Tracked_complex> track_figure(const Run_start& start,
                                              const std::optional<std::array<double, 6>>& domain) {
  const std::string format = start.inputs.size() == 1 ? extension(start.inputs[0]) : "";
  const DSC::Construction_options<2> options = options_of(start, domain);
  if (format == "pgm" || format == "png")
    return track_image_2(start, format, options);
  const Curves curves = start_curves(start);
  try {
    auto result = std::make_unique<Tracked_complex_2>(
        curves.seeded ? DSC::make_deformable_simplicial_complex_2<Complex>(*curves.seeded, options)
                      : DSC::make_deformable_simplicial_complex_2<Complex>(curves.closed, options));
    check_bounds(curves, start.inputs.empty() ? "the figure" : start.inputs[0], result->complex);
    return result;
  } catch (const DSC::Invalid_surface_error& error) {
    std::string place = start.inputs.empty() ? "the figure" : start.inputs[0];
    if (!curves.seeded && !start.inputs.empty())
      place = curves.names[error.surface()] + ", region with the label " +
              std::to_string(error.surface() + 1);
    throw Input_error(place + ": " + (curves.seeded ? error.what() : message_of(error)));
  } catch (const DSC::Error& error) {
    throw Input_error((start.inputs.empty() ? "the figure" : start.inputs[0]) + std::string(": ") +
                      error.what());
  }
}

std::unique_ptr<Tracked_complex> track_checkpoint(const std::string& path, std::string& metadata) {
  if (checkpoint_dimension(path) == 2)
    return restored<Tracked_complex_2>(path, CGAL::IO::read_checkpoint_2(path), metadata);
  return track_checkpoint_3(path, metadata);
}

Statistics Tracked_complex_2::statistics() const {
  Statistics statistics = {};
  statistics.dimension = 2;
  statistics.vertices = complex.number_of_vertices();
  statistics.cells = complex.number_of_cells();
  statistics.interface_facets = complex.interface_facets().size();
  for (const auto& [label, length, euler_characteristic] : complex.label_regions())
    statistics.labels.push_back({label, complex.number_of_cells(label), complex.area(label), length,
                                 complex.number_of_components(label), euler_characteristic,
                                 label_name(label, label_names)});
  set_angles(complex, statistics);
  statistics.min_quality = worst_quality();
  return statistics;
}

void Tracked_complex_2::write(const std::string& path) const {
  require_format(path, Use::write, content::regions);
  tell_lost_names(path, label_names);
  const std::string format = extension(path);
  if (format == "wkt")
    CGAL::IO::write_WKT(path, complex);
  else if (format == "poly")
    CGAL::IO::write_poly(path, complex);
  else if (format == "svg")
    CGAL::IO::write_SVG(path, complex);
  else
    write_volume_vtu(path);
}

void Tracked_complex_2::write_subdivided(const std::string&, int) const {
  throw Usage_error("--subdivide applies only in space; leave it out");
}

void Tracked_complex_2::write_picture(const std::string& stem) const {
  CGAL::IO::write_SVG(stem + ".svg", complex);
}

template class Tracked_whole<Complex>;

} // namespace dsc

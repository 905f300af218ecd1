// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Complex_object.h"
#include "Space.h"
#include "module.h"
#include "options.h"

#include <CGAL/Solid_reconstruction_3/compiled_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_sheet_3.h>

namespace dsc_python {
namespace {

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Report = DSC::Reconstruction_report_3<Complex>;
using Normal = CGAL::Epick::Vector_3;

/// \param array coordinates of vectors, shape (n, 3), or None
std::vector<Normal> normals_of(const py::object& array, std::size_t points) {
  std::vector<Normal> result;
  if (array.is_none())
    return result;
  for (const auto& row : rows_of<double, 3>(array.cast<Array<double>>(), "normals"))
    result.emplace_back(row[0], row[1], row[2]);
  if (result.size() != points)
    throw py::value_error("there are " + std::to_string(result.size()) + " normals for " +
                          std::to_string(points) + " points");
  return result;
}

/// Returns the indices of the facets without points, in the order of `interface_facets()`.
std::vector<std::size_t> facets_without_points(const Report& report, const Complex& complex) {
  std::vector<std::size_t> result;
  const auto facets = complex.interface_facets();
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (result.size() < report.facets_without_points.size() &&
        facets[i] == report.facets_without_points[result.size()])
      result.push_back(i);
  return result;
}

/// Returns the entries that the reports of solids and sheets share. Points are in units of the user
/// already.
template <class Any_report> py::dict common_entries(const Any_report& report) {
  py::dict result;
  result["complete"] = report.is_complete;
  result["used_points"] = report.number_of_points;
  result["duplicates"] = report.number_of_duplicates;
  result["outliers"] = report.number_of_outliers;
  result["spacing"] = report.spacing;
  result["noise"] = report.noise;
  result["root_mean_square"] = report.root_mean_square;
  result["maximum_distance"] = report.maximum_distance;
  result["unfit_points"] = array_of_indices(report.unfit_points);
  result["doubtful_places"] = array_of_vectors(report.doubtful_places, 3);
  return result;
}

DSC::internal::Collected_points points_of(const Array<double>& array) {
  DSC::internal::Collected_points result;
  for (const auto& row : rows_of<double, 3>(array, "points"))
    result.points.emplace_back(row[0], row[1], row[2]);
  return result;
}

py::tuple reconstruct(const Array<double>& points, const py::object& normals,
                      const py::dict& options, const py::object& progress) {
  DSC::Reconstruction_options_3<Complex> reconstruction;
  Options(options).read_all(
      reconstruction, {{"fit_tolerance", "tolerance"}, {"number_of_iterations", "maximum_steps"}});
  reconstruction.check();
  DSC::internal::Collected_points cloud = points_of(points);
  cloud.normals = normals_of(normals, cloud.points.size());
  Report report;
  reconstruction.report = &report;
  std::unique_ptr<Complex_object<Complex>> result;
  {
    const Long_function function(progress);
    const DSC::Progress_phase phase("reconstructing a surface");
    result = std::make_unique<Complex_object<Complex>>(
        DSC::internal::reconstruct_collected(cloud, reconstruction));
  }
  py::dict dictionary = common_entries(report);
  dictionary["steps"] = report.number_of_steps;
  dictionary["facets_without_points"] =
      array_of_indices(facets_without_points(report, result->read()));
  return py::make_tuple(py::cast(std::move(result)), dictionary);
}

py::dict reconstruct_sheet(const Array<double>& points, const py::dict& options,
                           const py::object& progress) {
  DSC::Sheet_options_3 reconstruction;
  Options(options).read_all(reconstruction, {});
  const DSC::internal::Collected_points cloud = points_of(points);
  DSC::Sheet_report_3 report;
  reconstruction.report = &report;
  DSC::Reconstructed_sheet_3 sheet;
  {
    const Long_function function(progress);
    sheet = DSC::internal::reconstruct_sheet(cloud, reconstruction);
  }
  py::dict result = common_entries(report);
  result["points"] = array_of_vectors(sheet.points, 3);
  result["triangles"] =
      array_of<std::int64_t>(sheet.triangles.size(), 3,
                             [&](std::size_t i, std::size_t j) { return sheet.triangles[i][j]; });
  result["components"] = report.number_of_components;
  result["euler_characteristic"] = report.euler_characteristic;
  result["boundaries"] = report.number_of_boundaries;
  result["boundary_length"] = report.boundary_length;
  result["orientable"] = report.is_orientable;
  return result;
}

} // namespace

void bind_reconstruction_3(py::module_& module) {
  module.def("reconstruct", &reconstruct);
  module.def("reconstruct_sheet", &reconstruct_sheet);
}

} // namespace dsc_python

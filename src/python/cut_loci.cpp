// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Geodesic_source.h"
#include "Guarded.h"
#include "arrays.h"
#include "callbacks.h"
#include "input/functions_of_points.h"
#include "module.h"
#include "programs/errors.h"

namespace dsc_python {
namespace {

namespace DSC = CGAL::Deformable_simplicial_complexes;

/// A surface that a Python function gives: `function(points)` returns points of shape (n, 3).
class Surface_function : private Shared_function
{
public:
  using Shared_function::Shared_function;

  /// \tparam Coordinates of u and v, or of a direction
  template <class Coordinates>
  dsc::Space_samples
  operator()(const std::array<Coordinates, dsc::samples_of_metric>& points) const {
    static constexpr std::size_t columns = std::tuple_size_v<Coordinates>;
    const py::gil_scoped_acquire lock;
    const py::array array(call(array_of<double>(
        points.size(), columns, [&](std::size_t i, std::size_t j) { return points[i][j]; })));
    if (!is_of_real_numbers(array))
      throw py::type_error("the points of the surface must be an array of real numbers");
    const auto rows = rows_of<double, 3>(Array<double>(array), "the points of the surface");
    if (rows.size() != points.size())
      throw py::value_error("the surface function returned " + std::to_string(rows.size()) +
                            " points for " + std::to_string(points.size()) + " points");
    dsc::Space_samples result;
    std::copy(rows.begin(), rows.end(), result.begin());
    return result;
  }
};

/// Returns the source of geodesics on a surface that is given by a function or by expressions.
/// \param point u and v, or a direction
template <class Surface>
std::unique_ptr<dsc::Geodesic_source> source_of(const Surface& images,
                                                const std::vector<double>& point,
                                                const std::array<double, 2>& periods) {
  if (point.size() == 2) {
    const dsc::Chart_surface surface = dsc::sampled_chart_surface(images, periods);
    if (!dsc::lengths_repeat(surface.image, periods))
      throw DSC::Error("the surface is not periodic with these periods; choose others");
    return dsc::source_in_chart(surface, periods, {point[0], point[1]});
  }
  return dsc::source_on_sphere(dsc::sampled_sphere_surface(images),
                               {point.at(0), point.at(1), point.at(2)});
}

/// Expressions of the coordinates, as a surface.
class Surface_text
{
public:
  Surface_text(const std::string& text, bool is_of_sphere) : m_expressions(read(text)) {
    if (m_expressions.is_of_sphere() != is_of_sphere)
      throw py::value_error(is_of_sphere
                                ? "the surface depends on u and v, but point is a direction"
                                : "the surface depends on x, y and z, so point must be a "
                                  "direction");
  }

  template <class Points> dsc::Space_samples operator()(const Points& points) const {
    return m_expressions.images(points);
  }

private:
  static dsc::Surface_expressions read(const std::string& text) {
    try {
      return dsc::Surface_expressions(text, "surface", "");
    } catch (const dsc::Usage_error& error) {
      throw py::value_error(error.what());
    }
  }

  dsc::Surface_expressions m_expressions;
};

/// \param surface a function, or three expressions
/// \param periods of a chart
py::dict cut_locus(const py::object& surface, const std::vector<double>& point,
                   const std::array<double, 2>& periods, double spacing, double step,
                   const py::object& progress) {
  const bool is_text = py::isinstance<py::str>(surface);
  std::optional<Surface_text> text;
  std::optional<Surface_function> images;
  if (is_text)
    text.emplace(surface.cast<std::string>(), point.size() == 3);
  else
    images.emplace(surface.cast<py::function>());
  std::unique_ptr<dsc::Geodesic_source> source;
  dsc::Found_cut_locus found;
  std::vector<std::array<double, 3>> positions;
  {
    const Long_function function(progress);
    source = is_text ? source_of(*text, point, periods) : source_of(*images, point, periods);
    found = dsc::find_cut_locus(*source, spacing, step);
    for (const auto& vertex : found.locus.vertices)
      positions.push_back(source->image(vertex.point));
  }
  const auto& vertices = found.locus.vertices;
  py::list arcs;
  for (const auto& arc : found.locus.polylines)
    arcs.append(array_of_indices(arc));
  py::dict result;
  result["parameters"] = array_of<double>(
      vertices.size(), 2, [&](std::size_t i, std::size_t j) { return vertices[i].point[int(j)]; });
  result["points"] = array_of_vectors(positions, 3);
  result["distances"] =
      array_of<double>(vertices.size(), [&](std::size_t i) { return vertices[i].distance; });
  result["multiplicities"] = array_of<std::int64_t>(
      vertices.size(), [&](std::size_t i) { return vertices[i].multiplicity; });
  result["arcs"] = arcs;
  result["complete"] = found.locus.is_complete;
  result["doubtful"] = array_of_indices(found.locus.doubtful);
  result["spacing"] = found.spacing;
  result["step"] = found.step;
  return result;
}

} // namespace

void bind_cut_loci(py::module_& module) { module.def("cut_locus", &cut_locus); }

} // namespace dsc_python

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Geodesic_source.h"
#include "Guarded.h"
#include "arrays.h"
#include "callbacks.h"
#include "module.h"

#include <memory>
#include <string>
#include <utility>

namespace dsc_python {
namespace {

/// A surface that a Python function gives: `function(points)` returns points of shape (n, 3).
class Surface_function
{
public:
  explicit Surface_function(py::function function) : m_function(std::move(function)) {}

  /// \tparam Points std::vector of arrays: of u and v, or of directions
  template <class Points> dsc::Space_points operator()(const Points& points) const {
    static constexpr std::size_t columns = std::tuple_size_v<typename Points::value_type>;
    const py::gil_scoped_acquire lock;
    const py::array array(m_function(array_of<double>(
        points.size(), columns, [&](std::size_t i, std::size_t j) { return points[i][j]; })));
    if (!is_of_real_numbers(array))
      throw py::type_error("the points of the surface must be an array of real numbers");
    dsc::Space_points result =
        rows_of<double, 3>(Array<double>(array), "the points of the surface");
    if (result.size() != points.size())
      throw py::value_error("the surface function returned " + std::to_string(result.size()) +
                            " points for " + std::to_string(points.size()) + " points");
    return result;
  }

private:
  Shared_function m_function;
};

/// \param periods None for the image of a sphere
py::dict cut_locus(const py::function& surface, const std::vector<double>& point,
                   const py::object& periods, double spacing, double step,
                   const py::object& progress) {
  const Surface_function images(surface);
  const auto box =
      periods.is_none() ? std::array<double, 2>() : periods.cast<std::array<double, 2>>();
  std::unique_ptr<dsc::Geodesic_source> source;
  dsc::Found_cut_locus found;
  dsc::Space_points positions;
  {
    const Long_function function(progress);
    source = point.size() == 2
                 ? dsc::source_in_chart(images, box, {point.at(0), point.at(1)})
                 : dsc::source_on_sphere({images}, {point.at(0), point.at(1), point.at(2)});
    found = dsc::find_cut_locus(*source, spacing, step);
    for (const auto& vertex : found.locus.vertices)
      positions.push_back(source->image(vertex.point));
  }
  const auto& vertices = found.locus.vertices;
  const auto indices = [](const std::vector<std::size_t>& values) {
    return array_of<std::int64_t>(values.size(), [&](std::size_t i) { return values[i]; });
  };
  py::list arcs;
  for (const auto& arc : found.locus.polylines)
    arcs.append(indices(arc));
  py::dict result;
  result["parameters"] = array_of<double>(
      vertices.size(), 2, [&](std::size_t i, std::size_t j) { return vertices[i].point[int(j)]; });
  result["points"] = array_of<double>(
      vertices.size(), 3, [&](std::size_t i, std::size_t j) { return positions[i][j]; });
  result["distances"] =
      array_of<double>(vertices.size(), [&](std::size_t i) { return vertices[i].distance; });
  result["multiplicities"] = array_of<std::int64_t>(
      vertices.size(), [&](std::size_t i) { return vertices[i].multiplicity; });
  result["arcs"] = arcs;
  result["complete"] = found.locus.is_complete;
  result["doubtful"] = indices(found.locus.doubtful);
  result["spacing"] = found.spacing;
  result["step"] = found.step;
  return result;
}

} // namespace

void bind_cut_loci(py::module_& module) { module.def("cut_locus", &cut_locus); }

} // namespace dsc_python

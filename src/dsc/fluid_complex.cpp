// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_complex.h"

#include "domain_box.h"
#include "errors.h"
#include "fluid_boxes.h"
#include "fluid_curves.h"
#include "fluid_files.h"
#include "fluid_shapes.h"
#include "label_components.h"
#include "remove_fragments.h"
#include "surface.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

/// Calls the function of the library that makes a complex of either dimension.
template <class Complex, class... Arguments> Complex make_complex(Arguments&&... arguments) {
  if constexpr (Complex::dimension == 2)
    return DSC::make_deformable_simplicial_complex_2<Complex>(
        std::forward<Arguments>(arguments)...);
  else
    return DSC::make_deformable_simplicial_complex_3<Complex>(
        std::forward<Arguments>(arguments)...);
}

/// Returns the boundary of a shape in space; nothing for a shape without its own boundary.
std::optional<Surface> surface_of_shape(const Fluid_shape& shape, double edge,
                                        const std::string& folder) {
  if (const auto* ball = std::get_if<Ball_shape>(&shape))
    return surface_of(*ball, edge);
  if (const auto* column = std::get_if<Cylinder_shape>(&shape))
    return surface_of(*column, edge);
  if (const auto* file = std::get_if<File_shape>(&shape)) {
    Run_start start;
    start.inputs = {place_of(file->file, folder)};
    start.ball = file->ball;
    start.triangles = file->triangles;
    return start_surfaces(start).front();
  }
  return std::nullopt;
}

/// Returns the boundary of a shape in the plane; nothing for a shape without its own boundary.
std::optional<Curve> curve_of_shape(const Fluid_shape& shape, double edge,
                                    const std::string& folder) {
  if (const auto* disk = std::get_if<Ball_shape>(&shape))
    return curve_of(*disk, edge);
  if (const auto* file = std::get_if<File_shape>(&shape))
    return curve_of(*file, place_of(file->file, folder), edge);
  return std::nullopt;
}

/// Returns the boundaries of all shapes in their order. A group of boxes is at the place of its
/// first box.
template <class Boundary, class Boundary_of, class Boundaries_of_boxes>
std::vector<Boundary> boundaries(const Fluid_scene& scene, const Boundary_of& boundary_of,
                                 const Boundaries_of_boxes& boundaries_of_boxes) {
  std::vector<Boundary> result;
  const auto groups = groups_of_boxes(scene);
  std::size_t done = 0; // groups
  for (const auto& [label, shape] : shapes_of(scene)) {
    const auto* box = std::get_if<Box_shape>(shape);
    if (box && done < groups.size() && groups[done].front().box.from == box->from &&
        groups[done].front().box.to == box->to) {
      for (Boundary& boundary : boundaries_of_boxes(groups[done++], scene.edge))
        result.push_back(std::move(boundary));
    } else if (std::optional<Boundary> boundary = boundary_of(*shape)) {
      boundary->label = label;
      result.push_back(std::move(*boundary));
    }
  }
  if (result.empty())
    throw Input_error(
        "all liquids and gases of the scene have the shape 'surroundings'; add another shape");
  return result;
}

template <class Complex>
Complex complex_of_boundaries(const Fluid_scene& scene, const std::string& folder) {
  const auto domain = parameters::enclosing_box(box_of_dimension<Complex::dimension>(scene.domain));
  if constexpr (Complex::dimension == 2)
    return make_complex<Complex>(
        boundaries<Curve>(
            scene,
            [&](const Fluid_shape& shape) { return curve_of_shape(shape, scene.edge, folder); },
            curves_of_boxes),
        domain);
  else
    return make_complex<Complex>(
        boundaries<Surface>(
            scene,
            [&](const Fluid_shape& shape) { return surface_of_shape(shape, scene.edge, folder); },
            surfaces_of_boxes),
        CGAL::Tetgen_tetrahedralizer_3(), domain);
}

void require_inside(const Fluid_scene& scene, const Pool_shape& pool) {
  const auto last = std::size_t(scene.dimension - 1);
  if (!(pool.level > scene.domain[last] && pool.level < scene.domain[last + 3]))
    throw Input_error("the level of the pool is outside the domain; correct 'level' or 'domain'");
}

/// A grid of squares or cubes. A line or plane between two layers of cells is at the level of a
/// pool.
template <class Complex> class Grid_of_pool
{
public:
  static constexpr std::size_t dimension = Complex::dimension;
  using Simplex = std::array<std::size_t, dimension + 1>;

  Grid_of_pool(const Fluid_scene& scene, double level) : m_domain(scene.domain), m_level(level) {
    const auto number = [&](double length) { return number_of_parts(length / scene.edge); };
    double cells = 1;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      m_size[axis] = number(m_domain[axis + 3] - m_domain[axis]);
      if (axis == last) {
        m_below = number(level - m_domain[axis]);
        m_size[axis] = m_below + number(m_domain[axis + 3] - level);
      }
      cells *= double(m_size[axis]);
    }
    number_of_parts(cells);
    m_stride[0] = 1;
    for (std::size_t axis = 1; axis < dimension; ++axis)
      m_stride[axis] = m_stride[axis - 1] * (m_size[axis - 1] + 1);
  }

  std::vector<typename Complex::Point> points() const;

  /// Divides the cells into simplices. `labels` receives a label for each simplex: `label` below
  /// the level and 0 above it.
  std::vector<Simplex> simplices(int label, std::vector<int>& labels) const;

private:
  static constexpr std::size_t last = dimension - 1;
  using Place = std::array<std::size_t, 3>;

  /// Calls f(place) for all places whose numbers are less than those of `size`, x first.
  template <class Function> static void for_each_place(const Place& size, const Function& f) {
    Place at;
    for (at[2] = 0; at[2] < size[2]; ++at[2])
      for (at[1] = 0; at[1] < size[1]; ++at[1])
        for (at[0] = 0; at[0] < size[0]; ++at[0])
          f(at);
  }

  double coordinate(std::size_t axis, std::size_t i) const {
    const double least = m_domain[axis], largest = m_domain[axis + 3];
    if (axis != last)
      return least + (largest - least) * double(i) / double(m_size[axis]);
    if (i == m_below)
      return m_level;
    return i < m_below ? least + (m_level - least) * double(i) / double(m_below)
                       : m_level + (largest - m_level) * double(i - m_below) /
                                       double(m_size[axis] - m_below);
  }

  std::array<double, 6> m_domain;
  double m_level;
  Place m_size = {1, 1, 1}; // numbers of cells
  std::size_t m_below = 0;  // layers of cells below the level
  Place m_stride = {};      // differences of the indices of neighboring points
};

template <class Complex>
std::vector<typename Complex::Point> Grid_of_pool<Complex>::points() const {
  Place size = m_size;
  for (std::size_t axis = 0; axis < dimension; ++axis)
    ++size[axis];
  std::vector<typename Complex::Point> result;
  for_each_place(size, [&](const Place& at) {
    std::array<double, 3> p = {};
    for (std::size_t axis = 0; axis < dimension; ++axis)
      p[axis] = coordinate(axis, at[axis]);
    result.push_back(from_coordinates<typename Complex::Point>(p));
  });
  return result;
}

template <class Complex>
auto Grid_of_pool<Complex>::simplices(int label, std::vector<int>& labels) const
    -> std::vector<Simplex> {
  std::vector<Simplex> result;
  for_each_place(m_size, [&](const Place& at) {
    std::size_t first = 0;
    std::array<std::size_t, dimension> axes;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      first += at[axis] * m_stride[axis];
      axes[axis] = axis;
    }
    do { // one simplex for each order of the axes: a path from corner to corner
      Simplex t;
      t[0] = first;
      for (std::size_t a = 0; a < dimension; ++a)
        t[a + 1] = t[a] + m_stride[axes[a]];
      result.push_back(t);
      labels.push_back(at[last] < m_below ? label : 0);
    } while (std::next_permutation(axes.begin(), axes.end()));
  });
  return result;
}

/// Returns a complex of squares or cubes that are divided into simplices.
template <class Complex>
Complex complex_of_pool(const Fluid_scene& scene, int label, const Pool_shape& pool) {
  require_inside(scene, pool);
  const Grid_of_pool<Complex> grid(scene, pool.level);
  std::vector<int> labels;
  auto simplices = grid.simplices(label, labels);
  Complex complex = make_complex<Complex>(grid.points(), std::move(simplices), labels,
                                          parameters::improve(false));
  if (pool.height)
    DSC::deform_interface(complex, [&](typename Complex::Vertex_handle v) {
      const auto p = complex.position(v);
      if constexpr (Complex::dimension == 2)
        return typename Complex::Point(p.x(), *pool.height->at({p.x()}));
      else
        return typename Complex::Point(p.x(), p.y(), *pool.height->at({p.x(), p.y()}));
    });
  return complex;
}

/// Throws if the label of a point in a shape cannot be found by `is_about()`.
void require_shape_of_places(const Fluid_scene& scene, const Fluid_shape& shape) {
  const auto* ball = std::get_if<Ball_shape>(&shape);
  const auto* column = std::get_if<Cylinder_shape>(&shape);
  if (const auto* pool = std::get_if<Pool_shape>(&shape)) {
    require_inside(scene, *pool);
    if (pool->height)
      throw Input_error(
          "a pool with a 'height' cannot be combined with other shapes; remove 'height'");
  }
  if (std::holds_alternative<File_shape>(shape) || (column && column->amplitude != 0) ||
      (ball && (ball->mode > 0 || ball->triangles > 0)))
    throw Input_error("a pool can be combined only with boxes, balls and cylinders; remove shapes "
                      "of type 'file' and the fields 'mode', 'amplitude' and 'triangles'");
}

/// Returns a complex for a pool beside other shapes, built from the labels of points.
template <class Complex> Complex complex_of_places(const Fluid_scene& scene) {
  double cells = 1;
  for (std::size_t axis = 0; axis < Complex::dimension; ++axis)
    cells *= (scene.domain[axis + 3] - scene.domain[axis]) / scene.edge;
  number_of_parts(cells);
  const auto shapes = shapes_of(scene);
  for (const auto& filling : shapes)
    require_shape_of_places(scene, *filling.second);
  const auto label_at = [&](const std::array<double, 3>& p) {
    int result = 0;
    for (const auto& [label, shape] : shapes)
      if (!std::holds_alternative<Surroundings>(*shape) && is_about(*shape, p, Complex::dimension))
        result = label;
    return result;
  };
  auto result = make_complex<Complex>(
      box_of_dimension<Complex::dimension>(scene.domain), scene.edge,
      [&](const typename Complex::Approximate_point& p) { return label_at(coordinates_of(p)); });
  std::map<int, std::string> names;
  for (const auto& filling : shapes)
    if (filling.first != 0)
      names[filling.first] = "label " + std::to_string(filling.first) + " of the scene";
  const Component_ranges expected = count_components(scene.domain, scene.edge, label_at);
  remove_fragments(result, expected);
  require_resolved(scene.domain, scene.edge, label_at, expected, numbers_of_components(result),
                   names);
  return result;
}

} // namespace

template <class Complex>
Complex start_of_scene(const Fluid_scene& scene, const std::string& folder) {
  const Pool_shape* pool = nullptr;
  int label_of_pool = 0;
  std::size_t others = 0;
  for (const auto& [label, shape] : shapes_of(scene))
    if (const auto* found = std::get_if<Pool_shape>(shape); found && !pool) {
      pool = found;
      label_of_pool = label;
    } else {
      others += !std::holds_alternative<Surroundings>(*shape);
    }
  if (!pool)
    return complex_of_boundaries<Complex>(scene, folder);
  return others == 0 ? complex_of_pool<Complex>(scene, label_of_pool, *pool)
                     : complex_of_places<Complex>(scene);
}

template Tracked_complex_2::Complex start_of_scene(const Fluid_scene&, const std::string&);
template Tracked_complex_3::Complex start_of_scene(const Fluid_scene&, const std::string&);

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_start.h"

#include "fluids/fluid_holes.h"
#include "fluids/fluid_shapes.h"
#include "input/domain_box.h"
#include "input/label_components.h"
#include "motions/remove_fragments.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

namespace dsc {
namespace {

namespace parameters = CGAL::parameters;

/// Calls the function of the library that makes a complex of either dimension.
template <class Complex, class... Arguments> Complex make_complex(Arguments&&... arguments) {
  if constexpr (Complex::dimension == 2)
    return DSC::make_deformable_simplicial_complex_2<Complex>(
        std::forward<Arguments>(arguments)...);
  else
    return DSC::make_deformable_simplicial_complex_3<Complex>(
        std::forward<Arguments>(arguments)...);
}

void require_inside(const Fluid_scene& scene, const Pool_shape& pool) {
  const auto last = std::size_t(scene.dimension - 1);
  if (!(pool.level > scene.domain[last] && pool.level < scene.domain[last + 3]))
    throw Input_error("the level of the pool is outside the domain; correct 'level' or 'domain'");
}

/// The shapes of a scene and their holes.
class Labels_of_places
{
public:
  /// \param holes holes that meet no liquid are left out
  Labels_of_places(const Fluid_scene& scene, const std::vector<Hole>& holes)
      : m_scene(scene), m_shapes(shapes_of(scene)), m_label_of_holes(label_of_holes(scene)) {
    for (const Hole& hole : holes)
      if (std::any_of(m_shapes.begin(), m_shapes.end(), [&](const auto& filling) {
            return is_liquid(scene, filling.first) && may_meet(hole, *filling.second, scene);
          }))
        m_holes.push_back(hole);
  }

  const std::vector<Hole>& holes() const { return m_holes; }

  /// Returns whether all shapes except pools, and all holes, are boxes.
  bool are_boxes() const {
    return std::all_of(m_shapes.begin(), m_shapes.end(),
                       [](const auto& filling) {
                         return std::holds_alternative<Box_shape>(*filling.second) ||
                                std::holds_alternative<Pool_shape>(*filling.second) ||
                                std::holds_alternative<Surroundings>(*filling.second);
                       }) &&
           std::all_of(m_holes.begin(), m_holes.end(), [](const Hole& hole) {
             return std::holds_alternative<Box_shape>(hole.shape);
           });
  }

  /// Returns the label at a point. Later shapes cover earlier ones, and holes cover liquids.
  int operator()(const std::array<double, 3>& p) const {
    int result = 0;
    for (const auto& [label, shape] : m_shapes)
      if (!std::holds_alternative<Surroundings>(*shape) && is_about(*shape, p, m_scene.dimension))
        result = label;
    return is_in_hole(p) && is_liquid(m_scene, result) ? m_label_of_holes : result;
  }

  bool is_in_hole(const std::array<double, 3>& p) const {
    return std::any_of(m_holes.begin(), m_holes.end(), [&](const Hole& hole) {
      return nearest_boundary(hole, p, m_scene.dimension).distance < 0;
    });
  }

  /// Calls f(box) for all boxes.
  template <class Function> void for_each_box(const Function& f) const {
    for (const auto& filling : m_shapes)
      if (const auto* box = std::get_if<Box_shape>(filling.second))
        f(*box);
    for (const Hole& hole : m_holes)
      if (const auto* box = std::get_if<Box_shape>(&hole.shape))
        f(*box);
  }

private:
  const Fluid_scene& m_scene;
  std::vector<std::pair<int, const Fluid_shape*>> m_shapes;
  std::vector<Hole> m_holes;
  int m_label_of_holes;
};

/// A grid of rectangles or boxes. The levels of pools and the faces of boxes are lines or planes
/// between layers of cells.
template <class Complex> class Grid_of_pool
{
public:
  static constexpr std::size_t dimension = Complex::dimension;
  using Simplex = std::array<std::size_t, dimension + 1>;

  Grid_of_pool(const Fluid_scene& scene, const Labels_of_places& labels) {
    double cells = 1;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      m_points[axis] = divided_lines(lines(scene, labels, axis), scene.edge);
      cells *= double(m_points[axis].size() - 1);
    }
    number_of_parts(cells);
    m_stride[0] = 1;
    for (std::size_t axis = 1; axis < dimension; ++axis)
      m_stride[axis] = m_stride[axis - 1] * m_points[axis - 1].size();
  }

  std::vector<typename Complex::Point> points() const;

  /// Divides the cells into simplices. `labels` receives the label of each simplex: the label at
  /// the middle of its cell.
  std::vector<Simplex> simplices(const Labels_of_places& label_at, std::vector<int>& labels) const;

private:
  static constexpr std::size_t last = dimension - 1;
  using Indices = std::array<std::size_t, 3>;

  /// Calls f(at) for all indices that are less than those of `size`, x first.
  template <class Function> static void for_each_place(const Indices& size, const Function& f) {
    Indices at;
    for (at[2] = 0; at[2] < size[2]; ++at[2])
      for (at[1] = 0; at[1] < size[1]; ++at[1])
        for (at[0] = 0; at[0] < size[0]; ++at[0])
          f(at);
  }

  /// Returns the coordinates of the sides of the domain, of levels and of the faces of boxes.
  static std::set<double> lines(const Fluid_scene& scene, const Labels_of_places& labels,
                                std::size_t axis) {
    const double least = scene.domain[axis], largest = scene.domain[axis + 3];
    std::set<double> result = {least, largest};
    const auto add = [&](double line) {
      if (line > least && line < largest)
        result.insert(line);
    };
    labels.for_each_box([&](const Box_shape& box) {
      add(box.from[axis]);
      add(box.to[axis]);
    });
    if (axis == last)
      for (const auto& filling : shapes_of(scene))
        if (const auto* pool = std::get_if<Pool_shape>(filling.second))
          add(pool->level);
    return result;
  }

  std::array<std::vector<double>, dimension> m_points; // coordinates of the layers
  Indices m_stride = {};                               // differences of indices of neighbors
};

template <class Complex>
std::vector<typename Complex::Point> Grid_of_pool<Complex>::points() const {
  Indices size = {1, 1, 1};
  for (std::size_t axis = 0; axis < dimension; ++axis)
    size[axis] = m_points[axis].size();
  std::vector<typename Complex::Point> result;
  for_each_place(size, [&](const Indices& at) {
    std::array<double, 3> p = {};
    for (std::size_t axis = 0; axis < dimension; ++axis)
      p[axis] = m_points[axis][at[axis]];
    result.push_back(from_coordinates<typename Complex::Point>(p));
  });
  return result;
}

template <class Complex>
auto Grid_of_pool<Complex>::simplices(const Labels_of_places& label_at,
                                      std::vector<int>& labels) const -> std::vector<Simplex> {
  Indices size = {1, 1, 1};
  for (std::size_t axis = 0; axis < dimension; ++axis)
    size[axis] = m_points[axis].size() - 1;
  std::vector<Simplex> result;
  for_each_place(size, [&](const Indices& at) {
    std::size_t first = 0;
    std::array<std::size_t, dimension> axes;
    std::array<double, 3> middle = {};
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      first += at[axis] * m_stride[axis];
      axes[axis] = axis;
      middle[axis] = (m_points[axis][at[axis]] + m_points[axis][at[axis] + 1]) / 2;
    }
    const int label = label_at(middle);
    do { // one simplex for each order of the axes: a path from corner to corner
      Simplex t;
      t[0] = first;
      for (std::size_t a = 0; a < dimension; ++a)
        t[a + 1] = t[a] + m_stride[axes[a]];
      result.push_back(t);
      labels.push_back(label);
    } while (std::next_permutation(axes.begin(), axes.end()));
  });
  return result;
}

/// Returns a complex of rectangles or boxes that are divided into simplices.
template <class Complex>
Complex complex_of_grid(const Fluid_scene& scene, const Labels_of_places& label_at) {
  const Grid_of_pool<Complex> grid(scene, label_at);
  std::vector<int> labels;
  auto simplices = grid.simplices(label_at, labels);
  bool has_boxes = false;
  label_at.for_each_box([&](const Box_shape&) { has_boxes = true; });
  return make_complex<Complex>(grid.points(), std::move(simplices), labels,
                               parameters::improve(has_boxes).edge_per_thickness(0.));
}

/// Moves the interface of a complex to the height of a pool.
template <class Complex> void move_to_height(const Expression& height, Complex& complex) {
  DSC::deform_interface(complex, [&](typename Complex::Vertex_handle v) {
    const auto p = complex.position(v);
    if constexpr (Complex::dimension == 2)
      return typename Complex::Point(p.x(), *height.at({p.x()}));
    else
      return typename Complex::Point(p.x(), p.y(), *height.at({p.x(), p.y()}));
  });
}

/// Throws if the label of a point in a shape cannot be found by `is_about()`.
void require_shape_of_places(const Fluid_shape& shape) {
  const auto* ball = std::get_if<Ball_shape>(&shape);
  const auto* column = std::get_if<Cylinder_shape>(&shape);
  if (std::holds_alternative<File_shape>(shape) || (column && column->amplitude != 0) ||
      (ball && (ball->mode > 0 || ball->triangles > 0)))
    throw Input_error("a pool can be combined only with boxes, balls and cylinders; remove shapes "
                      "of type 'file' and the fields 'mode', 'amplitude' and 'triangles'");
}

/// Moves vertices of liquids at holes to the boundaries of the holes.
template <class Complex>
void move_to_holes(const Labels_of_places& labels, const Fluid_scene& scene, Complex& complex) {
  using Vertex_handle = typename Complex::Vertex_handle;
  std::set<Vertex_handle> at_holes;
  for (const auto c : complex.cells())
    if (!is_liquid(scene, c->subdomain_index()) && labels.is_in_hole(middle_of(complex, c)))
      for (int i = 0; i < Complex::corners; ++i)
        at_holes.insert(c->vertex(i));
  if (at_holes.empty())
    return;
  DSC::deform_interface(complex, [&](Vertex_handle v) {
    auto place = coordinates_of(complex.position(v));
    if (at_holes.count(v) == 0)
      return from_coordinates<typename Complex::Point>(place);
    std::array<double, 3> nearest = {};
    double least = std::numeric_limits<double>::infinity(); // squared length
    for (const Hole& hole : labels.holes()) {
      const auto d = nearest_boundary(hole, place, Complex::dimension).offset;
      const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (squared < least) {
        least = squared;
        nearest = d;
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
      place[i] += nearest[i];
    return from_coordinates<typename Complex::Point>(place);
  });
}

/// Returns a complex for a pool beside other shapes, built from the labels of points.
template <class Complex>
Complex complex_of_places(const Fluid_scene& scene, const Labels_of_places& label_at) {
  double cells = 1;
  for (std::size_t axis = 0; axis < Complex::dimension; ++axis)
    cells *= (scene.domain[axis + 3] - scene.domain[axis]) / scene.edge;
  number_of_parts(cells);
  const auto shapes = shapes_of(scene);
  for (const auto& filling : shapes)
    require_shape_of_places(*filling.second);
  auto result = make_complex<Complex>(
      box_of_dimension<Complex::dimension>(scene.domain), scene.edge,
      [&](const typename Complex::Point& p) { return label_at(coordinates_of(p)); });
  std::map<int, std::string> names;
  for (const auto& filling : shapes)
    if (filling.first != 0)
      names[filling.first] = "label " + std::to_string(filling.first) + " of the scene";
  if (!label_at.holes().empty() && label_of_holes(scene) != 0)
    names[label_of_holes(scene)] = "the inside of the solids";
  const Component_ranges expected = count_components(scene.domain, scene.edge, label_at);
  remove_fragments(result, expected);
  require_resolved(scene.domain, scene.edge, label_at, expected, numbers_of_components(result),
                   names);
  move_to_holes(label_at, scene, result);
  return result;
}

} // namespace

template <class Complex> Complex start_with_pool(const Fluid_scene& scene) {
  const Labels_of_places label_at(scene, holes_of(scene));
  const Expression* height = nullptr;
  std::size_t pools = 0, others = label_at.holes().size();
  for (const auto& filling : shapes_of(scene)) {
    const auto* pool = std::get_if<Pool_shape>(filling.second);
    others += !pool && !std::holds_alternative<Surroundings>(*filling.second);
    if (!pool)
      continue;
    ++pools;
    require_inside(scene, *pool);
    if (pool->height)
      height = &*pool->height;
  }
  if (height && pools + others > 1)
    throw Input_error("a pool with a 'height' cannot be combined with other shapes, or with solids "
                      "in liquids; remove 'height'");
  if (!label_at.are_boxes())
    return complex_of_places<Complex>(scene, label_at);
  Complex result = complex_of_grid<Complex>(scene, label_at);
  if (height)
    move_to_height(*height, result);
  return result;
}

template Tracked_complex_2::Complex start_with_pool(const Fluid_scene&);
template Tracked_complex_3::Complex start_with_pool(const Fluid_scene&);

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_start.h"

#include "fluids/fluid_holes.h"
#include "fluids/fluid_scene.h"
#include "fluids/fluid_shapes.h"
#include "input/domain_box.h"
#include "input/start_complex.h"
#include "input/start_curves.h"
#include "input/surface.h"
#include "input/tetrahedralizer.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>

namespace dsc {
namespace {

/// Returns the closed curve of a disk in the plane. No edge is much longer than `edge`. A
/// disk without `amplitude` becomes a polygon of the same area.
/// \throws Input_error if there would be too many edges
Curve curve_of(const Ball_shape& disk, double edge) {
  static constexpr std::size_t least = 8;
  const std::size_t n = (std::max)(least, number_of_parts(2 * CGAL_PI * disk.radius / edge));
  const double step = 2 * CGAL_PI / double(n),
               radius = disk.radius * std::sqrt(step / std::sin(step));
  std::vector<Curve_point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = double(i) * step,
                 r = radius *
                     (1 +
                      (disk.mode > 0 ? disk.amplitude * std::cos(double(disk.mode) * angle) : 0));
    points.emplace_back(disk.center[0] + r * std::cos(angle), disk.center[1] + r * std::sin(angle));
  }
  Curve curve;
  curve.add_polyline(points);
  return curve;
}

/// Moves and scales a curve, so that it touches a disk from inside. The center of its bounding box
/// is moved to the center of the disk.
void fit(Curve& curve, const Ball& disk) {
  CGAL::Bbox_2 box;
  for (const Curve_point& p : curve.points)
    box += p.bbox();
  const Curve_point middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2);
  double farthest = 0;
  for (const Curve_point& p : curve.points)
    farthest = (std::max)(farthest, CGAL::squared_distance(p, middle));
  const double scale = disk.radius / std::sqrt(farthest);
  for (Curve_point& p : curve.points)
    p = Curve_point(disk.center[0], disk.center[1]) + scale * (p - middle);
}

/// Returns the closed curve of a shape from a file.
/// \param path the file, in place of the name in the shape
/// \throws Input_error if there would be too many edges, or the file cannot be read
Curve curve_of(const File_shape& shape, const std::string& path, double edge) {
  Run_start start;
  start.inputs = {path};
  Curve result;
  for (const Curve& curve : start_curves(start).closed) {
    const std::size_t first = result.points.size();
    result.points.insert(result.points.end(), curve.points.begin(), curve.points.end());
    for (const auto& [a, b] : curve.segments)
      result.segments.push_back({first + a, first + b});
  }
  fit(result, shape.ball);
  number_of_parts(double(result.segments.size()) * shape.ball.radius / edge);
  divide(edge, result);
  return result;
}

namespace parameters = CGAL::parameters;

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
    const std::string& path = start.inputs.front();
    return start_surfaces(start, {{read_part(path, file->part)}, {path}, {}}).all.front();
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

/// Returns whether a ball of liquid touches a ball of the scene from inside everywhere.
bool fills_solid(const Ball_shape& ball, const Fluid_scene& scene) {
  return ball.mode == 0 &&
         std::any_of(scene.solids.begin(), scene.solids.end(), [&](const Scene_solid& solid) {
           return solid.kind == Scene_solid::Kind::ball && solid.contains_liquid &&
                  solid.point == ball.center && solid.radius == ball.radius;
         });
}

/// The boundaries of the shapes of a scene. Boundary is Curve or Surface.
template <class Boundary> class Scene_boundaries
{
public:
  using Boundary_of = std::function<std::optional<Boundary>(const Fluid_shape&)>;
  using Boundaries_of_boxes = std::vector<Boundary> (*)(const std::vector<Labeled_box>&, double);

  /// \param boundary_of returns the boundary of a shape that is no box; nothing for a shape without
  /// its own boundary
  /// \param boundaries_of_boxes returns the boundaries of a group of boxes
  Scene_boundaries(const Fluid_scene& scene, Boundary_of boundary_of,
                   Boundaries_of_boxes boundaries_of_boxes)
      : m_scene(scene), m_boundary_of(std::move(boundary_of)),
        m_boundaries_of_boxes(boundaries_of_boxes) {}

  /// Returns the boundaries of all shapes in their order, and then of the holes. A group of boxes
  /// is at the place of its first box.
  std::vector<Boundary> all() const;

private:
  std::optional<Boundary> boundary_of(const Fluid_shape& shape) const;
  /// Returns the boundary of a hole. It is coarse if the hole is a large box.
  Boundary boundary_of(const Hole& hole) const;
  std::vector<Box_hole> box_holes(const std::vector<Hole>& holes) const;

  const Fluid_scene& m_scene;
  Boundary_of m_boundary_of;
  Boundaries_of_boxes m_boundaries_of_boxes;
};

template <class Boundary>
std::optional<Boundary> Scene_boundaries<Boundary>::boundary_of(const Fluid_shape& shape) const {
  std::optional<Boundary> result = m_boundary_of(shape);
  const auto* ball = std::get_if<Ball_shape>(&shape);
  if (ball && fills_solid(*ball, m_scene))
    put_on_ball(*ball, *result);
  return result;
}

template <class Boundary> Boundary Scene_boundaries<Boundary>::boundary_of(const Hole& hole) const {
  const int label = label_of_holes(m_scene);
  if (const auto* box = std::get_if<Box_shape>(&hole.shape)) {
    static constexpr double parts = 16; // largest number in the mesh of a side
    double edge = m_scene.edge;
    for (std::size_t i = 0; i < 3; ++i)
      edge = (std::max)(edge, (box->to[i] - box->from[i]) / parts);
    return m_boundaries_of_boxes({{label, *box}}, edge).front();
  }
  Boundary result = *m_boundary_of(hole.shape);
  put_on_ball(std::get<Ball_shape>(hole.shape), result);
  result.label = label;
  return result;
}

/// Returns the holes that are boxes, and whether each is in a liquid that is no box.
template <class Boundary>
std::vector<Box_hole> Scene_boundaries<Boundary>::box_holes(const std::vector<Hole>& holes) const {
  std::vector<Boundary> others; // boundaries of shapes that are no boxes
  std::vector<Box_hole> result;
  if (std::none_of(holes.begin(), holes.end(),
                   [](const Hole& hole) { return std::holds_alternative<Box_shape>(hole.shape); }))
    return result;
  for (const auto& [label, shape] : shapes_of(m_scene))
    if (!std::holds_alternative<Box_shape>(*shape))
      if (std::optional<Boundary> boundary = m_boundary_of(*shape)) {
        boundary->label = label;
        others.push_back(std::move(*boundary));
      }
  for (const Hole& hole : holes)
    if (const auto* box = std::get_if<Box_shape>(&hole.shape))
      result.push_back({*box, others.empty()
                                  ? is_liquid(m_scene, 0)
                                  : is_in_liquid(m_scene, hole, boundary_of(hole), others)});
  return result;
}

template <class Boundary> std::vector<Boundary> Scene_boundaries<Boundary>::all() const {
  std::vector<Boundary> result;
  const auto holes = holes_of(m_scene);
  const auto groups = groups_of_boxes(m_scene, box_holes(holes));
  std::size_t done = 0; // groups
  const auto add_group = [&] {
    for (Boundary& boundary : m_boundaries_of_boxes(groups[done++], m_scene.edge))
      result.push_back(std::move(boundary));
  };
  for (const auto& [label, shape] : shapes_of(m_scene)) {
    const auto* box = std::get_if<Box_shape>(shape);
    if (box && done < groups.size() && groups[done].front().box.from == box->from &&
        groups[done].front().box.to == box->to) {
      add_group();
    } else if (std::optional<Boundary> boundary = box ? std::nullopt : boundary_of(*shape)) {
      boundary->label = label;
      result.push_back(std::move(*boundary));
    }
  }
  while (done < groups.size()) // of holes only
    add_group();
  for (const Hole& hole : holes)
    if (std::holds_alternative<Ball_shape>(hole.shape)) {
      Boundary boundary = boundary_of(hole);
      if (is_in_liquid(m_scene, hole, boundary, result))
        result.push_back(std::move(boundary));
    }
  if (result.empty())
    throw Input_error(
        "all liquids and gases of the scene have the shape 'surroundings'; add another shape");
  return result;
}

/// Throws an error that names the label and the files of a boundary.
template <class Boundary>
[[noreturn]] void refuse(const Fluid_scene& scene, const std::vector<Boundary>& boundaries,
                         const DSC::Invalid_surface_error& error) {
  const int label = boundaries[error.surface()].label;
  std::string name = "the boundary of label " + label_title(label, scene.names) + " of the scene";
  for (const auto& [other, shape] : shapes_of(scene))
    if (const auto* const file = std::get_if<File_shape>(shape); file && other == label)
      name += ", '" + file->file + "'";
  throw Input_error(name + ": " + message_of(error));
}

/// Throws if a shape is too large for the domain, or far outside. The mesh of such a boundary could
/// take hours before its vertices are compared with the domain.
void require_near_domain(const Fluid_scene& scene) {
  const auto d = std::size_t(scene.dimension);
  double size = 0; // largest side of the domain
  for (std::size_t i = 0; i < d; ++i)
    size = (std::max)(size, scene.domain[i + 3] - scene.domain[i]);
  const auto is_near = [&](const std::array<double, 3>& p, double margin) {
    for (std::size_t i = 0; i < d; ++i)
      if (!(p[i] > scene.domain[i] - margin && p[i] < scene.domain[i + 3] + margin))
        return false;
    return true;
  };
  // The center of a round shape is inside its boundary, which is wider than its least radius.
  const auto fits = [&](const std::array<double, 3>& center, double radius, double amplitude = 0) {
    return is_near(center, 0) && radius * (1 - std::abs(amplitude)) < size;
  };
  const auto shapes = shapes_of(scene);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto* ball = std::get_if<Ball_shape>(shapes[i].second);
    const auto* column = std::get_if<Cylinder_shape>(shapes[i].second);
    const auto* file = std::get_if<File_shape>(shapes[i].second);
    const auto* box = std::get_if<Box_shape>(shapes[i].second);
    // Solids can cut off what is outside of a box.
    if ((ball && !fits(ball->center, ball->radius, ball->amplitude)) ||
        (column && !(fits(column->from, column->radius, column->amplitude) &&
                     fits(column->to, column->radius, column->amplitude))) ||
        (file && !fits(file->ball.center, file->ball.radius)) ||
        (box && !(is_near(box->from, size) && is_near(box->to, size))))
      throw Input_error(name_of_shape(scene, i) +
                        " of the scene is not inside the domain; make it smaller, move it or "
                        "enlarge 'domain'");
  }
}

template <class Complex>
Complex complex_of_boundaries(const Fluid_scene& scene, const std::string& folder) {
  require_near_domain(scene);
  // Scenes give the length of edges.
  const auto domain = parameters::enclosing_box(box_of_dimension<Complex::dimension>(scene.domain))
                          .edge_per_thickness(0.);
  if constexpr (Complex::dimension == 2) {
    const auto boundaries =
        Scene_boundaries<Curve>(
            scene, [&](const auto& shape) { return curve_of_shape(shape, scene.edge, folder); },
            curves_of_boxes)
            .all();
    try {
      return DSC::make_deformable_simplicial_complex_2<Complex>(
          boundaries, domain.spacing_per_segment(DSC::Construction_options<2>::fine_spacing));
    } catch (const DSC::Invalid_surface_error& error) {
      refuse(scene, boundaries, error);
    }
  } else {
    const auto boundaries =
        Scene_boundaries<Surface>(
            scene, [&](const auto& shape) { return surface_of_shape(shape, scene.edge, folder); },
            surfaces_of_boxes)
            .all();
    try {
      return DSC::make_deformable_simplicial_complex_3<Complex>(boundaries, Tetrahedralizer(),
                                                                domain);
    } catch (const DSC::Invalid_surface_error& error) {
      refuse(scene, boundaries, error);
    }
  }
}

} // namespace

template <class Complex>
Complex start_of_scene(const Fluid_scene& scene, const std::string& folder) {
  for (const auto& filling : shapes_of(scene))
    if (std::holds_alternative<Pool_shape>(*filling.second))
      return start_with_pool<Complex>(scene);
  return complex_of_boundaries<Complex>(scene, folder);
}

template Tracked_complex_2::Complex start_of_scene(const Fluid_scene&, const std::string&);
template Tracked_complex_3::Complex start_of_scene(const Fluid_scene&, const std::string&);

} // namespace dsc

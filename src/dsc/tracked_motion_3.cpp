// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"
#include "motion_options.h"
#include "tracked_complex_3.h"
#include "velocity_expressions.h"

#include <CGAL/Deformable_simplicial_complexes/Curvature_sizing_field.h>
#include <CGAL/Deformable_simplicial_complexes/grow_domain.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_flows/velocity_fields_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <variant>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Options = DSC::Adaptive_advection_options<Complex>;
using Point = Complex::Approximate_point_3;
using Vector = Complex::Approximate_vector_3;

Point centre_of_domain(const Complex& complex) {
  CGAL::Bbox_3 box;
  for (const Complex::Vertex_handle v : complex.vertices())
    box += complex.position(v).bbox();
  return CGAL::midpoint(Point(box.xmin(), box.ymin(), box.zmin()),
                        Point(box.xmax(), box.ymax(), box.zmax()));
}

double mean_edge(const Complex& complex) {
  return complex.mean_interface_edge() * complex.normalization().scale;
}

/// A visitor that returns the length of a time step of each motion, in the time unit of the input.
struct Time_step
{
  const Complex& complex;

  double operator()(const Rotation&) const { return 1; }
  double operator()(const Offset&) const { return 1; }
  double operator()(const Zalesak& zalesak) const { return zalesak.dt; }
  double operator()(const Advection& advection) const { return advection.dt; }
  double operator()(const Curvature_flow& flow) const {
    return flow.dt > 0 ? flow.dt : mean_edge(complex) * mean_edge(complex);
  }
};

/// A visitor that does a step of each motion.
struct Step
{
  Complex& complex;
  double time;
  unsigned threads;
  const Step_options& options;

  using Report = DSC::Deformation_report<Complex>;

  Report operator()(const Zalesak&) const {
    throw Usage_error("dsc zalesak applies only in the plane; use dsc rotate in space");
  }

  Report operator()(const Rotation& rotation) const {
    if (rotation.axis == std::array<double, 3>())
      throw Usage_error("--axis is required in space; see dsc rotate --help");
    const auto [x, y, z] = rotation.axis;
    return advect(DSC::Rigid_rotation_3(centre_of_domain(complex), Vector(x, y, z),
                                        rotation.degrees * (CGAL_PI / 180)),
                  time, 1);
  }

  Report operator()(const Offset& offset) const {
    const double unit = offset.distance.in_mean_edges ? complex.mean_interface_edge()
                                                      : 1 / complex.normalization().scale;
    const double speed = offset.distance.value * unit;
    if (!offset.moves_faces)
      return advect(DSC::Normal_offset{speed, offset.corners}, time, 1);
    make_room(complex);
    return advect(DSC::Face_offset_3(speed), time, 1);
  }

  Report operator()(const Advection& advection) const {
    switch (advection.field) {
    case Advection::Field::enright:
      return follow(Field(DSC::Enright_velocity_3(advection.period)), advection);
    case Advection::Field::vortex:
      return follow(Field(DSC::Single_vortex_velocity_3(advection.period)), advection);
    default: {
      const Velocity_expressions velocity(advection.expressions, 3);
      return follow(Field([&](const Point& p, double t) {
                      const auto [x, y, z] = velocity.at({p.x(), p.y(), p.z()}, t);
                      const double factor =
                          advection.period > 0 ? std::cos(CGAL_PI * t / advection.period) : 1;
                      return factor * Vector(x, y, z);
                    }),
                    advection);
    }
    }
  }

  Report operator()(const Curvature_flow& flow) const {
    const double scale = complex.normalization().scale;
    Report report =
        follow(DSC::Mean_curvature_flow(flow.keeps_volumes), time / (scale * scale),
               Time_step{complex}(flow) / (scale * scale), flow.tolerance, Options(true));
    if (flow.keeps_volumes)
      restore_start_volumes(complex, flow.volumes, scale * scale * scale, threads, report);
    return report;
  }

private:
  // One type for all velocity fields, so that the advection is instantiated once.
  using Field = std::function<Vector(const Point&, double)>;

  Report follow(const Field& field, const Advection& advection) const {
    const DSC::Velocity_in_user_coordinates_3<Complex, Field> velocity(complex, field);
    Options chosen;
    chosen.advection.scheme = advection.scheme;
    return follow(velocity, time, advection.dt, advection.tolerance, chosen);
  }

  template <class Velocity>
  Report follow(const Velocity& velocity, double t, double dt,
                const std::optional<double>& tolerance, Options chosen) const {
    complete(chosen, tolerance, options, threads);
    return DSC::advect_adaptively(complex, velocity, t, dt, chosen);
  }

  template <class Flow> Report advect(const Flow& flow, double t, double dt) const {
    return DSC::advect_interface(complex, flow, t, dt,
                                 advection_options<Complex>(options, threads));
  }
};

/// Improves the interface. Its triangles are adapted to the curvature, so that a smooth interface
/// stays smooth under compression. Sharp edges are preserved.
void improve_interface(Complex& complex, const std::optional<double>& aggressiveness) {
  const double edge = complex.mean_interface_edge();
  static constexpr double feature_angle = 85; // below cube edges, above rims of sheets
  const DSC::Curvature_sizing_field<3> size(complex, .05 * edge, .2 * edge, edge, .5,
                                            feature_angle);
  DSC::Interface_improvement_options<Complex> options;
  options.sizing_field = std::cref(size);
  options.feature_angle = feature_angle;
  options.interface_split_length = 1.5;
  options.interface_collapse_length = .5;
  options.curved_splits = true;
  options.aggressiveness = aggressiveness.value_or(options.aggressiveness);
  DSC::improve_interface(complex, options);
}

} // namespace

double Tracked_complex_3::mean_edge() const { return dsc::mean_edge(complex); }

double Tracked_complex_3::time_step(const Motion& motion) const {
  return std::visit(Time_step{complex}, motion);
}

Step_outcome Tracked_complex_3::advance(const Step_options& options, double time,
                                        unsigned threads) {
  const auto start = Clock::now();
  if (options.improves_interface)
    improve_interface(complex, options.aggressiveness);
  const auto report = std::visit(Step{complex, time, threads, options}, options.motion);
  return step_outcome(seconds_since(start), complex, report);
}

bool Tracked_complex_3::has_room() const { return DSC::has_room_around_interface(complex); }

void Tracked_complex_3::grow_domain() { DSC::grow_domain(complex); }

} // namespace dsc

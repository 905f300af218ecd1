// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"
#include "motion_options.h"
#include "tracked_complex_2.h"
#include "velocity_expressions.h"

#include <CGAL/Deformable_simplicial_complexes/Curvature_sizing_field.h>
#include <CGAL/Deformable_simplicial_complexes/grow_domain.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_2.h>
#include <CGAL/Interface_flows/velocity_fields_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <functional>
#include <optional>
#include <variant>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Complex = Tracked_complex_2::Complex;
using Options = DSC::Adaptive_advection_options<Complex>;
using Point = Complex::Approximate_point_2;
using Vector = Complex::Approximate_vector_2;

Point centre_of_domain(const Complex& complex) {
  CGAL::Bbox_2 box;
  for (const Complex::Vertex_handle v : complex.vertices())
    box += complex.position(v).bbox();
  return CGAL::midpoint(Point(box.xmin(), box.ymin()), Point(box.xmax(), box.ymax()));
}

/// A visitor that returns the length of a time step of each motion.
struct Time_step
{
  const Complex& complex;

  double operator()(const Rotation&) const { return 1; }
  double operator()(const Offset&) const { return 1; }
  double operator()(const Zalesak& zalesak) const { return zalesak.dt; }
  double operator()(const Advection& advection) const { return advection.dt; }
  double operator()(const Curvature_flow& flow) const {
    const double edge = complex.mean_interface_edge();
    return flow.dt > 0 ? flow.dt : edge * edge;
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

  Report operator()(const Rotation& rotation) const {
    return advect(
        DSC::Rigid_rotation_2(centre_of_domain(complex), rotation.degrees * (CGAL_PI / 180)), 1);
  }

  Report operator()(const Zalesak& zalesak) const {
    return advect(DSC::Rigid_rotation_2(Point(50, 50), 2 * CGAL_PI / Zalesak::period), zalesak.dt);
  }

  Report operator()(const Offset& offset) const {
    if (offset.moves_faces)
      throw Usage_error("--move-faces applies only in space; leave it out");
    const double unit = offset.distance.in_mean_edges ? complex.mean_interface_edge() : 1;
    make_room(complex);
    return advect(DSC::Normal_offset{offset.distance.value * unit, offset.corners}, 1);
  }

  Report operator()(const Advection& advection) const {
    switch (advection.field) {
    case Advection::Field::enright:
      throw Usage_error("dsc enright applies only in space; use dsc vortex in the plane");
    case Advection::Field::vortex:
      return follow(Field(DSC::Single_vortex_velocity_2(advection.period)), advection);
    default: {
      const Velocity_expressions velocity(advection.expressions, 2);
      return follow(Field([&](const Point& p, double t) {
                      const auto v = velocity.at({p.x(), p.y(), 0}, t);
                      const double factor =
                          advection.period > 0 ? std::cos(CGAL_PI * t / advection.period) : 1;
                      return factor * Vector(v[0], v[1]);
                    }),
                    advection);
    }
    }
  }

  Report operator()(const Curvature_flow& flow) const {
    Report report = follow(DSC::Mean_curvature_flow(flow.keeps_volumes), Time_step{complex}(flow),
                           flow.tolerance, Options(true));
    if (flow.keeps_volumes)
      restore_start_volumes(complex, flow.volumes, 1, threads, report);
    return report;
  }

private:
  // One type for all velocity fields, so that the advection is instantiated once.
  using Field = std::function<Vector(const Point&, double)>;

  Report follow(const Field& field, const Advection& advection) const {
    Options chosen;
    chosen.advection.scheme = advection.scheme;
    return follow(field, advection.dt, advection.tolerance, chosen);
  }

  template <class Velocity>
  Report follow(const Velocity& velocity, double dt, const std::optional<double>& tolerance,
                Options chosen) const {
    complete(chosen, tolerance, options, threads);
    return DSC::advect_adaptively(complex, velocity, time, dt, chosen);
  }

  template <class Flow> Report advect(const Flow& flow, double dt) const {
    return DSC::advect_interface(complex, flow, time, dt,
                                 advection_options<Complex>(options, threads));
  }
};

/// Improves the interface. Its segments are adapted to the curvature, so that a smooth interface
/// stays smooth under compression. Corners are preserved. The tolerance is smaller than in space,
/// because curves have few segments.
void improve_interface(Complex& complex, const std::optional<double>& aggressiveness) {
  const double edge = complex.mean_interface_edge();
  static constexpr double feature_angle = 60, tolerance = .005, shortest = .2, longest = 4;
  const DSC::Curvature_sizing_field<2> size(complex, tolerance * edge, shortest * edge,
                                            longest * edge, .5, feature_angle);
  DSC::Interface_improvement_options<Complex> options;
  options.sizing_field = std::cref(size);
  options.feature_angle = feature_angle;
  options.interface_split_length = 1.5;
  options.interface_collapse_length = .5;
  options.swept_volume = .01;
  options.curved_splits = true;
  options.aggressiveness = aggressiveness.value_or(0);
  DSC::improve_interface(complex, options);
}

} // namespace

double Tracked_complex_2::time_step(const Motion& motion) const {
  return std::visit(Time_step{complex}, motion);
}

Step_outcome Tracked_complex_2::advance(const Step_options& options, double time,
                                        unsigned threads) {
  const auto start = Clock::now();
  if (options.improves_interface)
    improve_interface(complex, options.aggressiveness);
  const auto report = std::visit(Step{complex, time, threads, options}, options.motion);
  return step_outcome(seconds_since(start), complex, report);
}

bool Tracked_complex_2::has_room() const { return DSC::has_room_around_interface(complex); }

void Tracked_complex_2::grow_domain() { DSC::grow_domain(complex); }

} // namespace dsc

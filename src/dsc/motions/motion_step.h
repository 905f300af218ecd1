// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_STEP_H
#define DSC_MOTION_STEP_H

#include "input/functions_of_points.h"
#include "motions/motion.h"
#include "motions/tracked_complex.h"
#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_flows/interface_flows_2.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_flows/velocity_fields_2.h>
#include <CGAL/Interface_flows/velocity_fields_3.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace dsc {

/// Sets the options of all motions. The run itself lets the domain grow.
template <class Complex>
void complete(DSC::Advection_options<Complex>& options, const Step_options& step,
              unsigned threads) {
  options.deformation.number_of_threads = threads;
  options.deformation.domain_rule = DSC::Domain_rule::stop;
  options.largest_displacement = step.largest_displacement.value_or(options.largest_displacement);
}

/// Returns the options of a motion that does not adapt the interface.
template <class Complex>
DSC::Advection_options<Complex> advection_options(const Step_options& step, unsigned threads) {
  DSC::Advection_options<Complex> result;
  complete(result, step, threads);
  return result;
}

/// Completes the options of an adaptive motion. An interface that is improved before each step
/// needs mesh adaptation in each step, but no other changes of the interface.
/// \param tolerance of the interface; the default of the library if not set
template <class Complex>
void complete(DSC::Adaptive_advection_options<Complex>& options,
              const std::optional<double>& tolerance, const Step_options& step, unsigned threads) {
  complete(options.advection, step, threads);
  options.interface_tolerance =
      step.improves_interface ? 0 : tolerance.value_or(options.interface_tolerance);
  if (step.improves_interface)
    options.adaptation_interval = 1;
}

/// Moves the interface by a little until each label has the volume that it had at the start of the
/// run. The smallest label takes the rest.
/// \param volumes in the unit of the input, of labels that may have vanished since
/// \param unit volume of the unit of the complex, in the unit of the input
/// \param visitor visitor of the changes; none if null
/// \param report of the step, which tells of the changes
template <class Complex>
void restore_start_volumes(Complex& complex, const std::map<int, double>& volumes, double unit,
                           unsigned threads, DSC::Deformation_visitor<Complex>* visitor,
                           DSC::Deformation_report<Complex>& report) {
  std::map<typename Complex::Label, double> kept;
  for (const auto& [label, volume] : volumes)
    if (complex.number_of_cells(label) > 0)
      kept.emplace(label, volume / unit);
  if (!kept.empty() && kept.begin()->first == complex.labels().front())
    kept.erase(kept.begin());
  DSC::Volume_restoration_options<Complex> options;
  options.deformation.number_of_threads = threads;
  options.deformation.forbid_topology_changes();
  options.deformation.visitor = visitor;
  options.volume_tolerance = 1e-6; // errors of steps do not add up
  const unsigned parts = report.steps;
  for (const auto& next : restore_volumes(complex, kept, options).deformations)
    report.append(next);
  report.steps = parts;
}

/// Adapts the mesh before an offset in the plane or of whole faces, which stretches the interface.
template <class Complex>
void make_room(Complex& complex, DSC::Deformation_visitor<Complex>* visitor) {
  DSC::Detail_options<Complex> options;
  options.collapse_length = 2;
  options.visitor = visitor;
  DSC::control_detail(complex, options);
}

/// The types and places that a motion needs of a complex; specialized for a distributed one.
template <class Complex> struct Motion_of
{
  using Whole = Complex; ///< a complex that one process holds
  using Part = Complex;  ///< the complex that options refer to
  using Report = DSC::Deformation_report<Complex>;

  /// Returns a complex with the same user coordinates.
  static const Complex& frame(const Complex& complex) { return complex; }

  /// Returns the lower and the upper corner of the box around the complex.
  static std::array<typename Complex::Point, 2> box(const Complex& complex) {
    decltype(typename Complex::Point().bbox()) box;
    for (const typename Complex::Vertex_handle v : complex.vertices())
      box += complex.position(v).bbox();
    std::array<double, Complex::dimension> lower, upper;
    for (int axis = 0; axis < Complex::dimension; ++axis) {
      lower[axis] = (box.min)(axis);
      upper[axis] = (box.max)(axis);
    }
    return {DSC::point_at<Complex>(lower), DSC::point_at<Complex>(upper)};
  }
};

/// A visitor that does a step of each motion, in space or in the plane.
template <class Complex> struct Motion_step
{
  using Of = Motion_of<Complex>;
  using Whole = typename Of::Whole;
  using Report = typename Of::Report;
  using Options = DSC::Adaptive_advection_options<typename Of::Part>;
  using Point = typename Whole::Point;
  using Vector = typename Whole::Vector;
  static constexpr int d = Whole::dimension;
  static constexpr bool is_distributed = !std::is_same<Whole, Complex>::value;

  Complex& complex;
  double time;
  unsigned threads;
  const Step_options& options;
  DSC::Deformation_visitor<typename Of::Part>* visitor = nullptr; ///< of all changes

  Report operator()(const Rotation& rotation) const {
    const std::array<Point, 2> box = Of::box(complex);
    const Point center = CGAL::midpoint(box[0], box[1]);
    const double angle = rotation.degrees * (CGAL_PI / 180);
    if constexpr (d == 2) {
      return advect(DSC::Rigid_rotation_2(center, angle), time, 1);
    } else {
      if (rotation.axis == std::array<double, 3>())
        throw Usage_error("--axis is required in space; see dsc rotate --help");
      const auto [x, y, z] = rotation.axis;
      return advect(DSC::Rigid_rotation_3(center, Vector(x, y, z), angle), time, 1);
    }
  }

  Report operator()([[maybe_unused]] const Zalesak& zalesak) const {
    if constexpr (d == 2)
      return advect(DSC::Rigid_rotation_2(Point(50, 50), 2 * CGAL_PI / Zalesak::period), time,
                    zalesak.dt);
    else
      throw Usage_error("dsc zalesak applies only in the plane; use dsc rotate in space");
  }

  Report operator()(const Offset& offset) const {
    if (d == 2 && offset.moves_faces)
      throw Usage_error("--move-faces applies only in space; leave it out");
    const double unit = offset.distance.in_mean_edges ? complex.mean_interface_edge()
                                                      : 1 / complex.normalization().scale;
    const double speed = offset.distance.value * unit;
    if constexpr (!is_distributed)
      if (d == 2 || offset.moves_faces)
        make_room(complex, visitor);
    if constexpr (!is_distributed && d == 3)
      if (offset.moves_faces)
        return advect(DSC::Face_offset_3(speed), time, 1);
    return advect(DSC::Normal_offset{speed, offset.corners}, time, 1);
  }

  Report operator()(const Advection& advection) const {
    switch (advection.field) {
    case Advection::Field::enright:
      if constexpr (d == 3)
        return follow(Field(DSC::Enright_velocity_3(advection.period.value_or(0))), advection);
      else
        throw Usage_error("dsc enright applies only in space; use dsc vortex in the plane");
    case Advection::Field::vortex:
      return follow(Field(Vortex(advection.period.value_or(0))), advection);
    default: {
      const Velocity_expressions velocity(advection.expressions, d);
      return follow(Field([&](const Point& p, double t) {
                      const auto values = velocity.at({p.x(), p.y(), d == 3 ? p[d - 1] : 0}, t);
                      std::array<double, d> v;
                      std::copy_n(values.begin(), d, v.begin());
                      const double factor =
                          advection.period ? std::cos(CGAL_PI * t / *advection.period) : 1;
                      return factor * DSC::vector_of<Whole>(v);
                    }),
                    advection);
    }
    }
  }

  Report operator()(const Curvature_flow& flow) const {
    const double scale = complex.normalization().scale, square = scale * scale;
    const double dt = time_step(flow, complex.mean_interface_edge() * scale) / square;
    Report report = follow(DSC::Mean_curvature_flow(flow.keeps_volumes), time / square, dt,
                           flow.tolerance, Options(true));
    if constexpr (!is_distributed)
      if (flow.keeps_volumes)
        restore_start_volumes(complex, flow.volumes, d == 3 ? square * scale : square, threads,
                              visitor, report);
    return report;
  }

private:
  // One type for all velocity fields, so that the advection is instantiated once.
  using Field = std::function<Vector(const Point&, double)>;
  using Vortex =
      std::conditional_t<d == 2, DSC::Single_vortex_velocity_2, DSC::Single_vortex_velocity_3>;

  Report follow(const Field& field, const Advection& advection) const {
    Options chosen;
    chosen.advection.scheme = advection.scheme;
    if constexpr (d == 2) {
      return follow(field, time, advection.dt, advection.tolerance, chosen);
    } else {
      const Whole& frame = Of::frame(complex);
      return follow(DSC::Velocity_in_user_coordinates_3<Whole, Field>(frame, field), time,
                    advection.dt, advection.tolerance, chosen);
    }
  }

  template <class Velocity>
  Report follow(const Velocity& velocity, double t, double dt,
                const std::optional<double>& tolerance, Options chosen) const {
    complete(chosen, tolerance, options, threads);
    chosen.advection.deformation.visitor = visitor;
    return advect_adaptively(complex, velocity, t, dt, chosen);
  }

  template <class Flow> Report advect(const Flow& flow, double t, double dt) const {
    auto chosen = advection_options<typename Of::Part>(options, threads);
    chosen.deformation.visitor = visitor;
    if constexpr (is_distributed)
      return advect_interface(complex, flow, t, dt, chosen.deformation);
    else
      return advect_interface(complex, flow, t, dt, chosen);
  }
};

/// Improves the interface. Its facets are adapted to the curvature, so that a smooth interface
/// stays smooth under compression. Sharp edges are preserved. Curves have few segments, so the
/// tolerance is smaller in the plane.
template <class Complex>
void improve_before_step(Complex& complex, const std::optional<double>& aggressiveness,
                         DSC::Deformation_visitor<Complex>* visitor) {
  static constexpr bool is_planar = Complex::dimension == 2;
  static constexpr double feature_angle = is_planar ? 60 : 85, // below cubes, above rims of sheets
      tolerance = is_planar ? .005 : .05, shortest = .2, longest = is_planar ? 4 : 1;
  const double edge = complex.mean_interface_edge();
  const DSC::Curvature_sizing_field<Complex::dimension> size(
      complex, tolerance * edge, shortest * edge, longest * edge, .5, feature_angle);
  DSC::Interface_improvement_options<Complex> options;
  options.sizing_field = std::cref(size);
  options.feature_angle = feature_angle;
  options.interface_split_length = 1.5;
  options.interface_collapse_length = .5;
  options.swept_volume = is_planar ? .01 : options.swept_volume;
  options.curved_splits = true;
  options.aggressiveness = aggressiveness.value_or(is_planar ? 0 : options.aggressiveness);
  options.visitor = visitor;
  DSC::improve_interface(complex, options);
}

/// Does a step of a complex that one process holds.
/// \param visitor visitor of all changes; none if null
template <class Complex>
Step_outcome do_step(Complex& complex, const Step_options& options, double time, unsigned threads,
                     DSC::Deformation_visitor<Complex>* visitor = nullptr) {
  const auto start = Clock::now();
  if (options.improves_interface)
    improve_before_step(complex, options.aggressiveness, visitor);
  const auto report =
      std::visit(Motion_step<Complex>{complex, time, threads, options, visitor}, options.motion);
  return step_outcome(seconds_since(start), complex, report);
}

} // namespace dsc

#endif // DSC_MOTION_STEP_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/tracked_distributed.h"

#include "motions/motion_step.h"
#include "output/angle_statistics.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Distributed_complexes/PVTU.h>
#include <CGAL/Distributed_complexes/advect_distributed_adaptively.h>
#include <CGAL/Distributed_complexes/advect_distributed_interface.h>
#include <CGAL/Distributed_complexes/distributed_checkpoint.h>

namespace dsc {
namespace {

using Complex = Tracked_distributed::Complex;
using Distributed = Tracked_distributed::Distributed;
using Point = Complex::Point_3;
using Operation = DSC::Communicator::Operation;

[[noreturn]] void refuse(const char* what) {
  throw Usage_error(std::string(what) +
                    " is not available on several processes; run dsc without mpirun");
}

} // namespace

template <> struct Motion_of<Distributed>
{
  using Whole = Complex;
  using Part = Distributed::Part;
  using Report = DSC::Distributed_report<Complex>;

  static Complex frame(const Distributed& complex) {
    Complex result;
    result.set_normalization(complex.normalization());
    return result;
  }
  static std::array<Point, 2> box(const Distributed& complex) { return complex.bounding_box(); }
};

void Tracked_distributed::run_once(const std::function<void()>& function) const {
  complex.communicator().call_together([&] {
    if (is_first())
      function();
  });
}

double Tracked_distributed::agreed(double number) const {
  return DSC::internal::maximum_of_ranks(complex.communicator(), is_first() ? number : 0);
}

double Tracked_distributed::mean_edge() const {
  return complex.mean_interface_edge() * complex.normalization().scale;
}

Step_outcome Tracked_distributed::advance(const Step_options& options, double time,
                                          unsigned threads) {
  if (options.improves_interface)
    refuse("--improve-interface");
  if (options.grows_domain)
    refuse("--domain grow");
  if (options.largest_displacement.value_or(0) > 0)
    refuse("--largest-displacement");
  const auto* const offset = std::get_if<Offset>(&options.motion);
  if (offset != nullptr && offset->moves_faces)
    refuse("--move-faces");
  if (offset != nullptr && offset->corners != DSC::Corner_rule::miter)
    refuse("--corners");
  const auto* const flow = std::get_if<Curvature_flow>(&options.motion);
  if (flow != nullptr && flow->keeps_volumes)
    refuse("--keep-volumes");
  const auto start = Clock::now();
  m_divide(complex);
  const auto report =
      std::visit(Motion_step<Distributed>{complex, time, threads, options}, options.motion);
  Step_outcome outcome;
  outcome.seconds = seconds_since(start);
  outcome.complete = report.complete;
  outcome.unfinished_vertices = std::size_t(report.unfinished);
  outcome.stopped_at_boundary = std::size_t(report.stopped_at_boundary);
  outcome.flat_cells = std::size_t(report.flat);
  outcome.passes = report.passes;
  outcome.split = std::size_t(report.split);
  outcome.collapsed = std::size_t(report.collapsed);
  outcome.flipped = std::size_t(report.flipped);
  outcome.relabeled = std::size_t(report.relabeled);
  outcome.events = step_events(complex, report);
  return outcome;
}

void Tracked_distributed::go_back() {
  if (m_kept)
    complex.restore(*m_kept);
  m_kept.reset();
}

Statistics Tracked_distributed::statistics() const {
  const double scale = complex.normalization().scale;
  const auto& mesh = complex.mesh();
  Statistics statistics = {};
  statistics.dimension = 3;
  statistics.vertices = complex.number_of_vertices();
  statistics.cells = complex.number_of_cells();
  for (const auto& m : complex.label_measures())
    statistics.labels.push_back({m.label, m.cells, m.measure * scale * scale * scale,
                                 m.interface_measure * scale * scale, m.components,
                                 int(m.euler_characteristic), label_name(m.label, label_names)});
  Angle_statistics angles;
  std::int64_t facets = 0;
  for (std::uint32_t c : mesh.own_cells()) {
    std::array<Point, 4> p;
    for (int i = 0; i < 4; ++i)
      p[i] = mesh.position(mesh.piece.cell(c).vertices[i]);
    angles.add(p);
  }
  const auto interface_ = complex.interface_here();
  for (const auto& facet : interface_.snapshot.facets())
    facets += complex.owns(interface_, facet);
  std::vector<std::int64_t> numbers(angles.histogram.begin(), angles.histogram.end());
  numbers.push_back(std::int64_t(angles.outside));
  numbers.push_back(facets);
  DSC::Communicator& communicator = complex.communicator();
  communicator.reduce(Operation::sum, numbers);
  statistics.interface_facets = std::size_t(numbers.back());
  std::copy_n(numbers.begin(), statistics.angle_histogram.size(),
              statistics.angle_histogram.begin());
  statistics.angles_outside_6_171 = double(numbers[angles.histogram.size()]) /
                                    (6 * double(std::max<std::size_t>(1, statistics.cells)));
  statistics.min_angle = 180 - DSC::internal::maximum_of_ranks(communicator, 180 - angles.least);
  statistics.max_angle = DSC::internal::maximum_of_ranks(communicator, angles.largest);
  statistics.min_quality = worst_quality();
  return statistics;
}

double Tracked_distributed::worst_quality() const {
  double worst = 1;
  for (std::uint32_t c : complex.mesh().own_cells())
    worst = (std::min)(worst, complex.mesh().quality(c));
  // Rounding can make a quality slightly larger than 1.
  return 1 - DSC::internal::maximum_of_ranks(complex.communicator(), (std::max)(0., 1 - worst));
}

std::vector<Surface_point> Tracked_distributed::interface_points() const {
  const auto interface_ = complex.interface_here();
  struct Numbered_point
  {
    std::uint64_t id;
    std::array<double, 3> point;
  };
  std::map<int, std::vector<Numbered_point>> lists;
  for (std::size_t i = 0; i < interface_.positions.size(); ++i)
    if (complex.mesh().is_own(interface_.indices[i])) {
      const Point p = complex.normalization().in_user_coordinates(interface_.positions[i]);
      lists[0].push_back(
          {complex.mesh().piece.vertex(interface_.indices[i]).id, {p.x(), p.y(), p.z()}});
    }
  std::vector<Numbered_point> all;
  DSC::internal::exchange_lists(complex.communicator(), lists, [&](int, const auto& points) {
    all.insert(all.end(), points.begin(), points.end());
  });
  // Sums over the points must not depend on the partition.
  std::sort(all.begin(), all.end(),
            [](const Numbered_point& a, const Numbered_point& b) { return a.id < b.id; });
  std::vector<Surface_point> result;
  for (const Numbered_point& p : all)
    result.emplace_back(p.point[0], p.point[1], p.point[2]);
  return result;
}

double Tracked_distributed::sweep_seconds() const {
  const auto& mesh = complex.mesh();
  const auto own = mesh.own_cells();
  const std::vector<std::uint32_t> cells(own.begin(), own.end());
  return seconds_of_sweep(cells, [&](std::uint32_t c) {
    return double(mesh.is_positive(c, [&](auto v) { return mesh.position(v); })) + mesh.quality(c);
  });
}

// Writes a file of the whole complex, which the first process must be able to hold.
void Tracked_distributed::write_whole(
    const std::function<void(const Tracked_complex_3&)>& write) const {
  Tracked_complex_3 whole(complex.gather());
  whole.label_names = label_names;
  run_once([&] { write(whole); });
}

void Tracked_distributed::write(const std::string& path) const {
  write_whole([&](const Tracked_complex_3& whole) { whole.write(path); });
}

void Tracked_distributed::write_subdivided(const std::string& path, int subdivisions) const {
  write_whole([&](const Tracked_complex_3& whole) { whole.write_subdivided(path, subdivisions); });
}

void Tracked_distributed::write_interface_vtu(const std::string& path) const {
  CGAL::IO::write_interface_PVTU(path, complex);
}

void Tracked_distributed::write_volume_vtu(const std::string& path) const {
  CGAL::IO::write_PVTU(path, complex);
}

void Tracked_distributed::write_checkpoint(const std::string& path,
                                           const std::string& metadata) const {
  CGAL::IO::write_checkpoint(path, complex, metadata);
}

} // namespace dsc

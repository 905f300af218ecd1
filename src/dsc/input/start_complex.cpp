// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/start_complex.h"

#include "input/domain_box.h"
#include "input/functions_of_points.h"
#include "input/label_components.h"
#include "motions/remove_fragments.h"
#include "motions/tracked_complex_3.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_files/checkpoint.h>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;

std::unique_ptr<Tracked_complex> track_inequalities(const Run_start& start,
                                                    const std::array<double, 6>& d) {
  const Inequalities inequalities(start.inputs);
  static constexpr double edges_of_side = 40;
  const double side = (std::max)({d[3] - d[0], d[4] - d[1], d[5] - d[2]});
  const double edge = start.edge > 0 ? start.edge : side / edges_of_side;
  const Label_function label_at = [&](const std::array<double, 3>& p) {
    return inequalities.label_at(p);
  };
  auto complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      box_of_dimension<3>(d), edge, [&](const auto& p) {
        return label_at({p.x(), p.y(), p.z()});
      });
  if (complex.interface_facets().empty())
    throw Input_error("the inequalities define no interface in the domain; choose another "
                      "--domain or a smaller --edge");
  std::map<int, std::string> names;
  for (std::size_t i = 0; i < start.inputs.size(); ++i)
    names[int(i) + 1] = "the inequality '" + start.inputs[i] + "'";
  const Component_ranges expected = count_components(d, edge, label_at);
  remove_fragments(complex, expected);
  require_resolved(d, edge, label_at, expected, numbers_of_components(complex), names);
  return std::make_unique<Tracked_complex_3>(std::move(complex));
}

/// Builds the complex from surfaces that bound solids.
std::unique_ptr<Tracked_complex> track_surfaces_of_run(const Run_options& options) {
  try {
    return track_surfaces(start_surfaces(options.start, most_triangles_to_fill), options);
  } catch (const DSC::Tetrahedralization_error& error) {
    if (is_out_of_memory(error))
      throw;
    throw Input_error(std::string(error.what()) +
                      "; try --repair, which merges close vertices or wraps the surface");
  }
}

} // namespace

bool is_out_of_memory(const DSC::Tetrahedralization_error& error) {
  static constexpr int out_of_memory = 1; // exit code of TetGen
  return error.code() == out_of_memory;
}

std::unique_ptr<Tracked_complex> track_in_space(const Run_options& options) {
  const Run_start& start = options.start;
  if (input_kind(start) == Input_kind::inequalities)
    return track_inequalities(start, *options.domain);
  return track_surfaces_of_run(options);
}

std::string message_of(const DSC::Invalid_surface_error& error) {
  std::string text = error.what();
  for (const std::string kind : {"surface ", "curve "})
    for (const std::size_t i : {error.surface(), error.other_surface()}) {
      const std::string name = kind + std::to_string(i) + ' ';
      if (const std::size_t at = text.find(name); at != std::string::npos)
        text.replace(at, name.size(), (i == error.surface() ? "the " : "another ") + kind);
    }
  return text;
}

int checkpoint_dimension(const std::string& path) {
  if (CGAL::IO::is_distributed_checkpoint(path))
    throw Input_error(path + " was written by several processes: resume it with mpirun, such as "
                             "mpirun -n 1 dsc");
  return CGAL::IO::checkpoint_dimension(path);
}

std::unique_ptr<Tracked_complex> track_checkpoint_3(const std::string& path,
                                                    std::string& metadata) {
  auto checkpoint = CGAL::IO::read_checkpoint(path);
  DSC::Mesh_arrays arrays = take_arrays(checkpoint.metadata);
  auto tracked = restored<Tracked_complex_3>(path, std::move(checkpoint), metadata);
  tracked->carry(std::move(arrays));
  return tracked;
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "errors.h"
#include "files.h"
#include "interrupt.h"
#include "mesh_content.h"
#include "report_json.h"
#include "tracked_complex_3.h"
#include "unused.h"

#include <cstdio>
#include <optional>
#include <string>
#include <utility>

namespace dsc {
namespace {

Json parameters_json(const Improve_options& options) {
  return {{"command", "improve"},
          {"output", options.output},
          {"aggressive", options.aggressive},
          {"threshold", options.threshold ? Json(*options.threshold) : Json()}};
}

Json state_json(const Statistics& statistics, const Improvement_outcome& outcome) {
  Json json = statistics_json(statistics);
  json.update({{"split", outcome.changes.split},
               {"collapsed", outcome.changes.collapsed},
               {"flipped", outcome.changes.flipped},
               {"smoothed", outcome.changes.smoothed},
               {"inserted", outcome.changes.inserted}});
  return json;
}

void print_summary(const Statistics& before, const Statistics& after, double seconds) {
  std::printf("dsc: %zu -> %zu tetrahedra, dihedral angles %.3g to %.4g -> %.3g to %.4g degrees; "
              "%.3g s\n",
              before.cells, after.cells, before.min_angle, before.max_angle, after.min_angle,
              after.max_angle, seconds);
}

/// What OUT can hold of the content of the input. The rest is told, or refused where OUT replaces
/// the input.
Mesh_content content_to_carry(const Improve_options& options, Labelled_tetrahedra mesh,
                              const Tracked_complex_3::Complex& complex) {
  if (extension(options.output) == "vtu")
    mesh.leave_out_entities();
  else
    mesh.leave_out_arrays();
  Unused_content unused = mesh.unused;
  Mesh_content content = content_of(std::move(mesh), complex, unused);
  if (!unused.empty() && is_same_file(options.input, options.output))
    throw Input_error("'" + options.output + "' would lose what cannot be carried over: " +
                      unused.text() + "; choose another file for the output");
  print_unused(options.input, unused);
  return content;
}

} // namespace

int execute(const Improve_options& options) {
  // What cannot work is refused before anything is computed.
  require_place("--report", options.report, {options.input, options.output});
  require_writable(options.output);

  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  Labelled_tetrahedra mesh = read_tetrahedra(options.input, options.labels);
  const auto complex = Tracked_complex_3::from_mesh(options.input, mesh);
  Mesh_content content = content_to_carry(options, std::move(mesh), complex->complex);
  const Statistics before = complex->statistics();
  const Improvement_outcome outcome = complex->improve(options, content);
  const Statistics after = complex->statistics();
  interruptible.reset();
  complex->write(options.output, content);
  if (!options.report.empty())
    write_json(options.report, {{"input", options.input},
                                {"parameters", parameters_json(options)},
                                {"seconds", outcome.seconds},
                                {"before", state_json(before, Improvement_outcome())},
                                {"after", state_json(after, outcome)}});
  if (!options.quiet)
    print_summary(before, after, outcome.seconds);
  return 0;
}

} // namespace dsc

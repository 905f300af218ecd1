// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "errors.h"
#include "files.h"
#include "interrupt.h"
#include "report_json.h"
#include "tracked_complex_3.h"

#include <cstdio>
#include <optional>
#include <string>

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

} // namespace

int execute(const Improve_options& options) {
  // What cannot work is refused before anything is computed.
  if (!options.report.empty())
    require_place_of_report(options.report, {options.input, options.output});
  require_writable(options.output);

  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  const auto complex = Tracked_complex_3::from_mesh(options.input);
  const Statistics before = complex->statistics();
  const Improvement_outcome outcome = complex->improve(options);
  const Statistics after = complex->statistics();
  interruptible.reset();
  complex->write(options.output);
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

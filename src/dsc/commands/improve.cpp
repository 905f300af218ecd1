// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/start_options.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/mesh_content.h"
#include "input/translations.h"
#include "motions/mesh_at_rest.h"
#include "output/report_json.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <cstdio>
#include <memory>

namespace dsc {
namespace {

struct Improve_options
{
  std::string input;  ///< labeled tetrahedra
  std::string output; ///< may equal the input
  std::string labels; ///< as in `Run_start`
  Improvement_options improvement;
  std::string report; ///< file; empty for none
  bool quiet = false;
};

Json parameters_json(const Improve_options& options) {
  return {{"command", "improve"},
          {"output", options.output},
          {"aggressive", options.improvement.aggressive},
          {"threshold", value_or_null(options.improvement.threshold)}};
}

/// `worst` is the least quality by the measure that is improved.
Json state_json(const Statistics& statistics, double worst,
                const DSC::Improvement_report& changes) {
  Json json = statistics_json(statistics);
  json.update({{"min_quality", worst},
               {"split", changes.split},
               {"collapsed", changes.collapsed},
               {"flipped", changes.flipped},
               {"smoothed", changes.smoothed},
               {"inserted", changes.inserted}});
  return json;
}

void print_summary(const Statistics& before, const Statistics& after, double seconds) {
  std::printf("dsc: %zu -> %zu tetrahedra, dihedral angles %.3g to %.4g -> %.3g to %.4g degrees; "
              "%.3g s\n",
              before.cells, after.cells, before.min_angle, before.max_angle, after.min_angle,
              after.max_angle, seconds);
}

/// Returns the content of the input that the output can store. The rest is reported; it is an error
/// if the output replaces the input.
Mesh_content content_to_carry(const Improve_options& options, Labeled_tetrahedra mesh,
                              const Mesh_at_rest& complex) {
  Unused_content unused;
  Mesh_content content = complex.content(std::move(mesh), extension(options.output), unused);
  if (!unused.empty() && is_same_file(options.input, options.output))
    throw Input_error("'" + options.output + "' would lose content that cannot be copied: " +
                      unused.text() + "; choose another output file");
  print_unused(options.input, unused);
  return content;
}

int execute(const Improve_options& options) {
  if (options.quiet)
    keep_silent_about_unused();
  // Fails before the computation starts if the output cannot be written.
  require_place("--report", options.report, {options.input, options.output});
  require_writable(options.output);

  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  const std::string input = native_file(options.input, options.labels);
  if (!has_format(input, Use::read, content::tetrahedra, 0))
    throw Input_error(options.input + " contains no tetrahedra; name a file with tetrahedra");
  if (input != options.input && is_same_file(options.input, options.output))
    throw Input_error("'" + options.output +
                      "' was written by another program and would lose "
                      "content; choose another output file");
  Labeled_tetrahedra mesh = read_tetrahedra(input, options.labels);
  Mesh_at_rest complex(input, mesh);
  Mesh_content content = content_to_carry(options, std::move(mesh), complex);
  const Statistics before = complex.statistics();
  const Improvement_outcome outcome = complex.improve(options.improvement, content);
  const Statistics after = complex.statistics();
  interruptible.reset();
  complex.write(options.output, content);
  if (!options.report.empty())
    write_json(options.report,
               {{"input", options.input},
                {"parameters", parameters_json(options)},
                {"seconds", outcome.seconds},
                {"before", state_json(before, outcome.worst_before, {})},
                {"after", state_json(after, outcome.worst_after, outcome.changes)}});
  if (!options.quiet)
    print_summary(before, after, outcome.seconds);
  return 0;
}

void check(const Improve_options& options) {
  require_format(options.input, Use::read, content::tetrahedra, content::tetrahedra);
  require_format(options.output, Use::write, content::tetrahedra);
  require_file_with_arrays(options.input, options.labels);
}

} // namespace

void add_improve(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Improve_options>();
  CLI::App* command = app.add_subcommand("improve", description_of_improve);
  add_input(*command, "INPUT", options->input,
            "Labeled tetrahedra (" +
                formats_with(Use::read, content::tetrahedra, content::tetrahedra) +
                "); - for standard input")
      ->required();
  add_output(*command, "-o,--output", options->output,
             "Output file (" + formats_with(Use::write, content::tetrahedra) +
                 "); may be INPUT; - for standard output")
      ->required();
  add_labels_option(*command, options->labels);
  add_threads_option(*command, options->improvement.threads);
  command->add_flag("--aggressive", options->improvement.aggressive,
                    "Use more operations: minutes instead of seconds, and better tetrahedra");
  constexpr Number_range above_0_to_1 = {
      "0.4", [](double x) { return 0 < x && x <= 1; },
      " is out of range; choose a number greater than 0 and at most 1"};
  add_value(*command, "--threshold", options->improvement.threshold, above_0_to_1,
            "Optimize only tetrahedra of lower quality. The quality is the least sine of a "
            "dihedral angle relative to the regular tetrahedron; sines of obtuse angles "
            "are multiplied by 0.7 (default: 0.25, with --aggressive 0.46)");
  add_output(*command, "--report", options->report, "JSON file with the state before and after",
             "json");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = execute(*options);
  });
}

} // namespace dsc

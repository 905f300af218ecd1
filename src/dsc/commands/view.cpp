// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "input/files.h"
#include "output/film_of_run.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"

#include <CGAL/Mesh_files/replace_file.h>

#include <CLI/CLI.hpp>

#include <climits>
#include <iostream>
#include <memory>
#include <string>

namespace dsc {
namespace {

struct View_options
{
  Film_options film;
  std::string output;
  bool quiet = false;
};

int execute(const View_options& options) {
  require_place("--output", options.output, {options.film.run, options.film.report});
  const Interruptible interruptible(options.quiet);
  const std::string html = film_of_run(options.film);
  CGAL::Deformable_simplicial_complexes::replace_file_by_stream(
      options.output, [&](std::ostream& out) { out << html; });
  if (!options.quiet)
    std::cout << "dsc: wrote " << options.output << " (" << (html.size() + 999) / 1000
              << " kB); open it in a browser\n";
  return 0;
}

} // namespace

void add_view(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<View_options>();
  CLI::App* command =
      app.add_subcommand("view", "Write the states of a run as a page for a browser");
  command
      ->add_option("RUN", options->film.run,
                   "Folder of a run (its --output), collection (.pvd) or mesh (.vtu)")
      ->required();
  command->add_option("-o,--output", options->output, "Page (.html)")->required();
  command->add_option("--report", options->film.report,
                      "Report of the run (its --report), for charts and events");
  command->add_option("--every", options->film.every, "Show every N-th state and the last one")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  command
      ->add_option("--without", options->film.without,
                   "Labels, by number or name, whose cells are left out, like 1,shell")
      ->allow_extra_args(false);
  command->add_flag("--surface", options->film.is_surface,
                    "Show the interface only; the page is smaller");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([options, &exit_code] {
    require_extension(options->output, {"html"});
    exit_code = execute(*options);
  });
}

} // namespace dsc

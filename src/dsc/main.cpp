// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"
#include "commands/commands.h"
#include "errors.h"
#include "interrupt.h"

#include <CGAL/assertions.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

enum Exit_code { bad_input = 1, bad_usage = 2, stopped = dsc::exit_code_of_interrupt };

int fail(std::string message, Exit_code code) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "dsc: " << message << '\n';
  return code;
}

// Suppresses the output of CGAL before it throws: the exception contains the message.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

/// Flushes the output. Returns whether all output was written.
bool flush_output() {
  std::cout.flush();
  std::fflush(stdout);
  return std::cout.good() && std::ferror(stdout) == 0;
}

/// Adds the commands, in the order of the help.
void add_commands(CLI::App& app, int& exit_code) {
  dsc::add_info(app, exit_code);
  dsc::add_rotate(app, exit_code);
  dsc::add_offset(app, exit_code);
  dsc::add_enright(app, exit_code);
  dsc::add_vortex(app, exit_code);
  dsc::add_advect(app, exit_code);
  dsc::add_mean_curvature(app, exit_code);
  dsc::add_zalesak(app, exit_code);
  dsc::add_convert(app, exit_code);
  dsc::add_improve(app, exit_code);
  dsc::add_cut_locus(app, exit_code);
  dsc::add_reconstruct(app, exit_code);
  dsc::add_fluid(app, exit_code);
}

} // namespace

int main(int argc, char** argv) {
  dsc::catch_signals();
  CGAL::set_error_handler(print_nothing);
  CGAL::set_warning_handler(print_nothing);
  try {
    CLI::App app("Deformable simplicial complexes: moving interfaces with topology changes", "dsc");
    app.require_subcommand(1);
    int exit_code = 0;
    add_commands(app, exit_code);
    dsc::run_command_line(app, argc, argv);
    if (!flush_output())
      return fail("cannot write to standard output; check that its disk has space left and that "
                  "its reader is there",
                  bad_input);
    return exit_code;
  } catch (const dsc::Usage_error& error) {
    return fail(error.what(), bad_usage);
  } catch (const CGAL::Deformable_simplicial_complexes::Interrupted_error&) {
    return fail("interrupted; nothing is written", stopped);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory; choose fewer --triangles or a smaller mesh",
                bad_input);
  } catch (const std::exception& error) {
    return fail(error.what(), bad_input);
  } catch (...) {
    return fail("something unknown went wrong; check the input", bad_input);
  }
}

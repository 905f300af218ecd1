// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/program.h"

#include "input/translations.h"
#include "programs/command_line.h"
#include "programs/errors.h"
#include "programs/interrupt.h"

#include <CGAL/assertions.h>

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

namespace {

enum Exit_code { bad_input = 1, bad_usage = 2, stopped = dsc::exit_code_of_interrupt };

int fail(std::string message, Exit_code code) {
  message = dsc::with_user_names(message);
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "dsc: " << message << '\n';
  return code;
}

// Suppresses the output of CGAL before it throws: the exception contains the message.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

/// Replaces the process by another program in the same folder, with the same arguments. Returns an
/// error message if this fails.
std::string execute(const dsc::Other_program& other, char** argv) {
  std::string program;
  try {
    program = dsc::path_of_program(other.name);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  dsc::remove_temporary_files();
  execv(program.c_str(), argv);
  return "cannot execute " + program + ", which contains " + other.content + ": " +
         std::strerror(errno) + "; build or install it";
}

/// Flushes the output. Returns whether all output was written.
bool flush_output() {
  std::cout.flush();
  std::fflush(stdout);
  return std::cout.good() && std::ferror(stdout) == 0;
}

struct Temporary_file_remover
{
  ~Temporary_file_remover() { dsc::remove_temporary_files(); }
};

} // namespace

bool dsc::is_started_by_mpi() {
  // variables of Open MPI, of MPICH and its relatives, and of PMIx
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr ||
         std::getenv("PMIX_RANK") != nullptr;
}

int dsc::run_program(int argc, char** argv,
                     const std::function<void(CLI::App&, int&)>& add_commands) {
  const Temporary_file_remover temporary_files; // removed after messages, which may name them
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
      return fail("cannot write to standard output; check that the disk is not full and that the "
                  "program that reads the output is running",
                  bad_input);
    return exit_code;
  } catch (const dsc::Other_program& other) {
    if (dsc::interrupted()) // the other program would not know
      return fail("interrupted; no result was written", stopped);
    std::cout.flush();
    return fail(execute(other, argv), bad_usage);
  } catch (const dsc::Usage_error& error) {
    return fail(error.what(), bad_usage);
  } catch (const CGAL::Deformable_simplicial_complexes::Interrupted_error&) {
    return fail("interrupted; no result was written", stopped);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory; choose fewer --triangles or a smaller mesh", bad_input);
  } catch (const std::exception& error) {
    return fail(error.what(), bad_input);
  } catch (...) {
    return fail("unknown error; check the input", bad_input);
  }
}

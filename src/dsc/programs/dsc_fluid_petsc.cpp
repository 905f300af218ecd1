// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of `dsc fluid --solver petsc`, which the program `dsc-fluid` executes. It can be
// started by mpirun as several processes. All processes run the same steps on the same complex and
// solve linear systems together. Only the first process writes files and messages.

#include "../commands/commands.h"
#include "../fluid_processes.h"
#include "../interrupt.h"
#include "../program.h"

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Incompressible_fluids_3/Petsc_saddle_point_solver.h>

#include <CLI/CLI.hpp>

#include <petscsys.h>

#include <cctype>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace DSC = CGAL::Deformable_simplicial_complexes;

int rank_of_process() {
  int result = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

/// Returns whether an argument is an option of PETSc: a dash and at least two letters or digits.
bool is_petsc_option(const std::string& argument) {
  return argument.size() > 2 && argument[0] == '-' &&
         std::isalpha(static_cast<unsigned char>(argument[1])) != 0;
}

/// The arguments of this program, and those of PETSc.
struct Arguments
{
  Arguments(int argc, char** argv) {
    own.push_back(argv[0]);
    of_petsc.push_back(argv[0]);
    // The values of an option of PETSc follow it.
    bool are_of_petsc = false;
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (is_petsc_option(argument))
        are_of_petsc = true;
      else if (argument.rfind("--", 0) == 0)
        are_of_petsc = false;
      (are_of_petsc ? of_petsc : own).push_back(argv[i]);
    }
  }

  std::vector<char*> own, of_petsc;
};

/// Names the options that PETSc did not use, which can be misspelled.
void print_unused_options(const std::vector<char*>& of_petsc) {
  for (const char* argument : of_petsc)
    if (is_petsc_option(argument)) {
      PetscBool is_used = PETSC_TRUE;
      PetscOptionsUsed(nullptr, argument + 1, &is_used); // names have no dash here
      if (!is_used)
        std::cerr << "dsc: PETSc did not use the option " << argument << "; check its name\n";
    }
}

/// A scope in which PETSc and MPI can be used.
class Processes
{
public:
  explicit Processes(std::vector<char*> arguments) {
    int argc = int(arguments.size());
    arguments.push_back(nullptr);
    char** argv = arguments.data();
    // The program handles signals itself.
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
    m_has_begun = PetscInitialize(&argc, &argv, nullptr, nullptr) == 0;
    if (m_has_begun)
      MPI_Comm_dup(MPI_COMM_WORLD, &m_ends);
  }

  bool has_begun() const { return m_has_begun; }

  /// Waits until all processes end. If this process fails and others do not end, ends all of them
  /// after printing the messages of this process.
  /// \param code the exit code of this process
  void end(int code, const std::string& messages) {
    // The first process prints its message itself. It can take long to write files after an error
    // that all processes meet.
    const auto patience = std::chrono::seconds(rank_of_process() == 0 ? 5 : 300);
    const auto begin = std::chrono::steady_clock::now();
    MPI_Request request;
    MPI_Ibarrier(m_ends, &request);
    for (int have_ended = 0;;) {
      MPI_Test(&request, &have_ended, MPI_STATUS_IGNORE);
      if (have_ended != 0)
        break;
      if (code != 0 && code != dsc::exit_code_of_interrupt &&
          std::chrono::steady_clock::now() - begin > patience) {
        std::fputs(messages.c_str(), stderr);
        MPI_Abort(MPI_COMM_WORLD, code);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    MPI_Comm_free(&m_ends);
    PetscFinalize();
  }

private:
  bool m_has_begun = false;
  MPI_Comm m_ends = MPI_COMM_NULL; // other messages of the processes do not reach it
};

bool any(bool value) {
  int result = value;
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return result != 0;
}

/// A solver that all processes leave at the same call after an interrupt.
class Interruptible_solver
{
public:
  using System = DSC::Saddle_point_system;
  using Vector = System::Vector;

  void factorize(System&& system, unsigned number_of_threads) {
    check();
    m_solver.factorize(std::move(system), number_of_threads);
  }
  void update(System&& system) { m_solver.update(std::move(system)); }
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    check();
    return m_solver.solve(f, s, v, p, tolerance);
  }

private:
  static void check() {
    dsc::agree_on_interrupts();
    if (dsc::interrupted())
      throw DSC::Interrupted_error();
  }

  DSC::Petsc_saddle_point_solver m_solver;
};

} // namespace

bool dsc::is_first_process() { return rank_of_process() == 0; }

unsigned dsc::processes_of_machine() {
  MPI_Comm machine = MPI_COMM_NULL;
  int result = 1;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &result);
  MPI_Comm_free(&machine);
  return unsigned(result);
}

void dsc::use_petsc(DSC::Saddle_point_solver& solver) { solver.use<Interruptible_solver>(); }

int main(int argc, char** argv) {
  Arguments arguments(argc, argv);
  Processes processes(arguments.of_petsc);
  if (!processes.has_begun()) {
    std::cerr << "dsc: PETSc does not start; check its options and the installation of MPI\n";
    return 1;
  }
  int processes_in_all = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &processes_in_all);
  if (processes_in_all > 1)
    dsc::share_interrupts(any);
  // Other processes print nothing, unless they alone fail.
  std::ostringstream messages;
  std::streambuf* const terminal = std::cerr.rdbuf();
  if (!dsc::is_first_process()) {
    std::cerr.rdbuf(messages.rdbuf());
    if (std::freopen("/dev/null", "w", stdout) == nullptr)
      std::fclose(stdout);
  }
  const int own = int(arguments.own.size());
  arguments.own.push_back(nullptr);
  const int code = dsc::run_program(own, arguments.own.data(), dsc::add_fluid);
  if (code == 0)
    print_unused_options(arguments.of_petsc);
  std::cerr.rdbuf(terminal);
  processes.end(code, messages.str());
  return code;
}

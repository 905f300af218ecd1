// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of `dsc fluid --solver petsc`, which the program `dsc-fluid` executes. It can be
// started by mpirun as several processes. All processes run the same steps on the same complex and
// solve linear systems together. Only the first process writes files and messages.

#include "commands/commands.h"
#include "fluids/fluid_processes.h"
#include "programs/interrupt.h"
#include "programs/mpi_processes.h"
#include "programs/program.h"

#include <CGAL/Incompressible_fluids_3/Petsc_saddle_point_solver.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CLI/CLI.hpp>

#include <petscsys.h>

#include <cctype>

namespace {

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

  /// Returns whether an own option is given.
  bool has(const std::string& option) const {
    for (std::size_t i = 1; i < own.size(); ++i)
      if (own[i] == option || std::string(own[i]).rfind(option + "=", 0) == 0)
        return true;
    return false;
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

bool dsc::is_first_process() { return dsc::rank_of_process() == 0; }

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
  int petsc_argc = int(arguments.of_petsc.size());
  arguments.of_petsc.push_back(nullptr);
  char** petsc_argv = arguments.of_petsc.data();
  // The program handles signals itself.
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
  if (PetscInitialize(&petsc_argc, &petsc_argv, nullptr, nullptr) != 0) {
    std::cerr << "dsc: PETSc does not start; check its options and the installation of MPI\n";
    return 1;
  }
  arguments.of_petsc.pop_back();
  int code = 0;
  {
    dsc::Mpi_processes processes(false);
    int number = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    static char solver[] = "--solver=petsc";
    if (number > 1 && !arguments.has("--solver"))
      arguments.own.push_back(solver); // the built-in solver would do the same on all processes
    const int own = int(arguments.own.size());
    arguments.own.push_back(nullptr);
    code = dsc::run_program(own, arguments.own.data(), [&](CLI::App& app, int& exit_code) {
      processes.require_same_command(argc, argv);
      dsc::add_fluid(app, exit_code);
    });
    if (code == 0)
      print_unused_options(arguments.of_petsc);
    processes.end(code);
  }
  PetscFinalize();
  return code;
}

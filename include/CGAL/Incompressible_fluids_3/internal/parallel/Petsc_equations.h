// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_PARALLEL_PETSC_EQUATIONS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_PARALLEL_PETSC_EQUATIONS_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/parallel/Petsc_object.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/pressure_matrix.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/relative_residual.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

static_assert(std::is_same_v<PetscScalar, double>,
              "PETSc must use real numbers in double precision");

// The rows of a distributed matrix that belong to this process.
class Petsc_rows
{
public:
  void add(Eigen::Index column, double value) {
    m_columns.push_back(PetscInt(column));
    m_values.push_back(value);
  }
  void end_row() { m_ends.push_back(PetscInt(m_columns.size())); }

  // Creates the matrix. The columns are distributed like the entries of a vector of which this
  // process has `own_columns` entries.
  void create(MPI_Comm communicator, Eigen::Index own_columns, Petsc_matrix& matrix) const {
    check_petsc(MatCreateMPIAIJWithArrays(
        communicator, PetscInt(m_ends.size() - 1), PetscInt(own_columns), PETSC_DETERMINE,
        PETSC_DETERMINE, m_ends.data(), m_columns.data(), m_values.data(), matrix.replace()));
  }

private:
  std::vector<PetscInt> m_ends = {0}, m_columns;
  std::vector<PetscScalar> m_values;
};

// A saddle point system that is distributed over processes, see `Petsc_saddle_point_solver`. The
// equations are multiplied by W^1/2, and the unknowns by W^-1/2, where W are the weights of
// `Residual_norm`. The matrix is

//     a  b^T
//     b   c - d

// with the signs of the matrices b and c that are created here. Constrained velocities have the
// equations (I - P) v = 0.
class Petsc_equations
{
public:
  using System = Saddle_point_system;
  using Vector = System::Vector;

  // Creates the matrices and the preconditioner.
  // \throws Convergence_error if the preconditioner does not exist
  // \throws Error if PETSc reports an error
  Petsc_equations(MPI_Comm communicator, System&& system) : m_communicator(communicator) {
    const Petsc_errors_scope scope;
    int rank = 0, size = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    m_vertices.distribute(system.nodal.rows(), 3, rank, size);
    m_pressures.distribute(system.c.rows(), 1, rank, size);
    const PetscInt own_velocities = PetscInt(3 * m_vertices.size()),
                   own_pressures = PetscInt(m_pressures.size()),
                   own = own_velocities + own_pressures;
    check_petsc(VecCreateMPI(communicator, own, PETSC_DETERMINE, m_right.replace()));
    check_petsc(VecDuplicate(m_right, m_solution.replace()));
    check_petsc(VecDuplicate(m_right, m_residual.replace()));
    for (Petsc_parts* parts : {&m_in, &m_out, &m_given, &m_result})
      parts->create(communicator, own_velocities, own_pressures);
    check_petsc(VecCreateMPI(communicator, own_velocities, PETSC_DETERMINE, m_force.replace()));
    check_petsc(VecCreateMPI(communicator, own_pressures, PETSC_DETERMINE, m_change.replace()));
    check_petsc(VecDuplicate(m_change, m_level.replace()));
    set_system(std::move(system));
    create_preconditioner();
    create_method(own);
  }

  // Replaces the system, and keeps the preconditioner.
  // \throws Error if PETSc reports an error
  void update(System&& system) {
    const Petsc_errors_scope scope;
    set_system(std::move(system));
  }

  // Solves for v and p, see `Petsc_saddle_point_solver::solve()`.
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    const Petsc_errors_scope scope;
    write(f, -s, false, m_right);
    write(v, p, true, m_solution);
    PetscReal norm_of_right = 0;
    check_petsc(VecNorm(m_right, NORM_2, &norm_of_right));
    if (!std::isfinite(norm_of_right))
      throw Convergence_error("the equations of the flow are not finite: the time step may be too "
                              "short or too long, or cells may be flat",
                              infinite, (std::max)(tolerance, rounding));
    if (norm_of_right == 0) {
      v.setZero();
      p.setZero();
      return 0;
    }
    const unsigned result = iterate(tolerance, norm_of_right);
    Vector velocities(v.size()), pressures(p.size());
    read(velocities, pressures);
    m_system.project(velocities);
    const double bound = (std::max)(tolerance, largest_residual),
                 residual = relative_residual(m_system, f, s, velocities, pressures);
    if (!(residual <= bound))
      throw Convergence_error("the equations of the flow have no accurate solution: the time step "
                              "may be too short or too long, or cells may be flat",
                              residual, bound);
    v = std::move(velocities);
    p = std::move(pressures);
    return result;
  }

private:
  using Row = System::Matrix::InnerIterator;

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double rounding = 1e-9; // relative to the right side
  // The method stagnates if a restart does not reduce the true residual by this factor.
  static constexpr double less = .5;

  // The indices that belong to this process, and the distribution over all processes.
  struct Block
  {
    void distribute(Eigen::Index n, int numbers, int rank, int size) {
      const auto begin_of = [&](int k) { return n * k / size; };
      begin = begin_of(rank);
      end = begin_of(rank + 1);
      for (int k = 0; k < size; ++k) {
        begins.push_back(int(numbers * begin_of(k)));
        sizes.push_back(int(numbers * (begin_of(k + 1) - begin_of(k))));
      }
    }
    Eigen::Index size() const { return end - begin; }

    Eigen::Index begin = 0, end = 0;
    std::vector<int> begins, sizes; // of each process, in numbers
  };

  // The pressures of a closed set that belong to this process, without the begin of the block.
  struct Own_closed_set
  {
    std::vector<std::size_t> pressures;
    double number, weight; // of all pressures of the set; of the mean
  };

  void set_system(System&& system) {
    m_system = std::move(system);
    const Residual_norm norm(m_system);
    m_scale_of_velocities = norm.weights_of_velocities().cwiseSqrt();
    m_scale_of_pressures = norm.weights_of_pressures().cwiseSqrt();
    for (double& scale : m_scale_of_pressures)
      if (scale == 0)
        scale = 1;
    m_projections.assign(std::size_t(m_system.nodal.rows()), nullptr);
    for (const auto& h : m_system.constrained)
      m_projections[std::size_t(h.vertex)] = &h.projection;
    m_closed.clear();
    for (const auto& set : m_system.closed) {
      Own_closed_set own{{}, double(set.pressures.size()), set.weight};
      for (Eigen::Index p : set.pressures)
        if (m_pressures.begin <= p && p < m_pressures.end)
          own.pressures.push_back(std::size_t(p - m_pressures.begin));
      m_closed.push_back(std::move(own));
    }
    m_sums.resize(m_closed.size());
    create_a();
    create_b_and_c();
  }

  // Creates W^1/2 P a P W^1/2 + I - P.
  void create_a() {
    const Eigen::Index n = m_system.nodal.rows();
    std::vector<Eigen::Matrix3d> sums(std::size_t(n), Eigen::Matrix3d::Zero());
    std::vector<char> is_met(std::size_t(n), false);
    std::vector<Eigen::Index> met;
    const auto sum = [&](Eigen::Index j) -> Eigen::Matrix3d& {
      if (!is_met[std::size_t(j)]) {
        is_met[std::size_t(j)] = true;
        met.push_back(j);
      }
      return sums[std::size_t(j)];
    };
    Petsc_rows rows;
    for (Eigen::Index i = m_vertices.begin; i < m_vertices.end; ++i) {
      for (Row k(m_system.nodal, i); k; ++k)
        sum(k.col()).diagonal().array() += k.value();
      if (m_system.coupling.rows() > 0)
        for (int axis = 0; axis < 3; ++axis)
          for (Row k(m_system.coupling, 3 * i + axis); k; ++k)
            sum(k.col() / 3)(axis, k.col() % 3) += k.value();
      std::sort(met.begin(), met.end());
      const Eigen::Matrix3d* const p = m_projections[std::size_t(i)];
      for (Eigen::Index j : met) {
        Eigen::Matrix3d& block = sums[std::size_t(j)];
        block *= m_scale_of_velocities(i) * m_scale_of_velocities(j);
        if (p != nullptr)
          block = (*p * block).eval();
        if (const Eigen::Matrix3d* q = m_projections[std::size_t(j)])
          block = (block * *q).eval();
        if (p != nullptr && i == j)
          block += Eigen::Matrix3d::Identity() - *p;
      }
      for (int axis = 0; axis < 3; ++axis) {
        for (Eigen::Index j : met)
          for (int other = 0; other < 3; ++other) {
            const double value = sums[std::size_t(j)](axis, other);
            if (value != 0)
              rows.add(3 * j + other, value);
          }
        rows.end_row();
      }
      for (Eigen::Index j : met) {
        sums[std::size_t(j)].setZero();
        is_met[std::size_t(j)] = false;
      }
      met.clear();
    }
    rows.create(m_communicator, 3 * m_vertices.size(), m_a);
  }

  // Creates -W^1/2 b P W^1/2 and -W^1/2 c W^1/2.
  void create_b_and_c() {
    Petsc_rows of_b, of_c;
    for (Eigen::Index p = m_pressures.begin; p < m_pressures.end; ++p) {
      const double scale = m_scale_of_pressures(p);
      for (Row k(m_system.b, p); k;) {
        const Eigen::Index v = k.col() / 3;
        Eigen::Vector3d gradient;
        for (int axis = 0; axis < 3; ++axis, ++k)
          gradient(axis) = k.value();
        if (m_projections[std::size_t(v)] != nullptr)
          gradient = (*m_projections[std::size_t(v)] * gradient).eval();
        for (int axis = 0; axis < 3; ++axis)
          if (gradient(axis) != 0)
            of_b.add(3 * v + axis, -scale * m_scale_of_velocities(v) * gradient(axis));
      }
      for (Row k(m_system.c, p); k; ++k)
        of_c.add(k.col(), -scale * m_scale_of_pressures(k.col()) * k.value());
      of_b.end_row();
      of_c.end_row();
    }
    of_b.create(m_communicator, 3 * m_vertices.size(), m_b);
    of_c.create(m_communicator, m_pressures.size(), m_c);
  }

  // Creates the preconditioners of velocities and of pressures.
  void create_preconditioner() {
    create_method_of_block("velocity_", m_a, m_of_velocities);
    use_incomplete_cholesky();
    const Saddle_point_operator<double> all(For_each_index(), m_system);
    const Pressure_rows matrix(m_system, all);
    Sum_of_row sum(m_system.c.rows());
    Petsc_rows rows;
    for (Eigen::Index p = m_pressures.begin; p < m_pressures.end; ++p) {
      matrix.add_row(p, 0, [&sum](Eigen::Index q, double value) { sum.add(q, value); });
      sum.scale(p, above_singular);
      sum.take([&rows](Eigen::Index q, double value) { rows.add(q, value); });
      rows.end_row();
    }
    rows.create(m_communicator, m_pressures.size(), m_schur);
    set_multigrid_defaults();
    create_method_of_block("pressure_", m_schur, m_of_pressures);
    for (KSP method : {KSP(m_of_velocities), KSP(m_of_pressures)}) {
      PC pc = nullptr;
      PCFailedReason reason = PC_NOERROR;
      check_petsc(KSPGetPC(method, &pc));
      check_petsc(PCGetFailedReason(pc, &reason));
      int has_failed = reason != PC_NOERROR;
      MPI_Allreduce(MPI_IN_PLACE, &has_failed, 1, MPI_INT, MPI_MAX, m_communicator);
      if (has_failed != 0)
        throw Convergence_error("the equations of the flow are singular: cells may be flat",
                                infinite, largest_residual);
    }
  }

  // Creates a method that applies a preconditioner once, unless options of PETSc change it.
  void create_method_of_block(const char* prefix, Mat matrix, Petsc_method& method) {
    PC pc = nullptr;
    check_petsc(KSPCreate(m_communicator, method.replace()));
    check_petsc(KSPSetOptionsPrefix(method, prefix));
    check_petsc(KSPSetOperators(method, matrix, matrix));
    check_petsc(KSPSetType(method, KSPPREONLY));
    check_petsc(KSPGetPC(method, &pc));
    check_petsc(PCSetType(pc, &method == &m_of_velocities ? PCBJACOBI : multigrid));
    check_petsc(KSPSetFromOptions(method));
    check_petsc(KSPSetUp(method));
  }

  // Uses incomplete Cholesky factorizations for the blocks of velocities, unless options of PETSc
  // choose another method.
  void use_incomplete_cholesky() {
    PC pc = nullptr;
    PetscBool has_blocks = PETSC_FALSE;
    check_petsc(KSPGetPC(m_of_velocities, &pc));
    check_petsc(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCBJACOBI, &has_blocks));
    if (has_blocks) {
      PetscInt number = 0;
      KSP* blocks = nullptr;
      check_petsc(PCBJacobiGetSubKSP(pc, &number, nullptr, &blocks));
      for (PetscInt k = 0; k < number; ++k) {
        PC of_block = nullptr;
        check_petsc(KSPGetPC(blocks[k], &of_block));
        check_petsc(PCSetType(of_block, PCICC));
        check_petsc(KSPSetFromOptions(blocks[k]));
      }
    }
    check_petsc(PCSetUpOnBlocks(pc));
  }

#ifdef PETSC_HAVE_HYPRE
  static constexpr const char* multigrid = PCHYPRE;
#else
  static constexpr const char* multigrid = PCGAMG;
#endif

  // Sets the default options of multigrid. The stencil of the matrix is wide, so coarse grids must
  // be much smaller than with the defaults of the libraries.
  static void set_multigrid_defaults() {
    static constexpr const char* defaults[][2] = {
        {"-pressure_pc_hypre_boomeramg_strong_threshold", "0.9"},
        {"-pressure_pc_hypre_boomeramg_agg_nl", "2"},
        {"-pressure_pc_hypre_boomeramg_coarsen_type", "PMIS"},
        {"-pressure_pc_hypre_boomeramg_interp_type", "ext+i"},
        {"-pressure_pc_hypre_boomeramg_P_max", "4"},
        {"-pressure_pc_hypre_boomeramg_relax_type_all", "SOR/Jacobi"},
        {"-pressure_pc_gamg_threshold", "0.02"}};
    for (const auto& option : defaults) {
      PetscBool is_set = PETSC_FALSE;
      check_petsc(PetscOptionsHasName(nullptr, nullptr, option[0], &is_set));
      if (!is_set)
        check_petsc(PetscOptionsSetValue(nullptr, option[0], option[1]));
    }
  }

  // Creates the method for the whole system.
  void create_method(PetscInt own) {
    static constexpr PetscInt most = 3000; // iterations
    static constexpr PetscInt stored = 60; // directions, between restarts
    PC pc = nullptr;
    check_petsc(MatCreateShell(m_communicator, own, own, PETSC_DETERMINE, PETSC_DETERMINE, this,
                               m_matrix.replace()));
    check_petsc(MatShellSetOperation(
        m_matrix, MATOP_MULT, reinterpret_cast<void (*)()>(&Petsc_equations::call_multiply)));
    check_petsc(KSPCreate(m_communicator, m_method.replace()));
    check_petsc(KSPSetOperators(m_method, m_matrix, m_matrix));
    check_petsc(KSPSetType(m_method, KSPFGMRES));
    check_petsc(KSPGMRESSetRestart(m_method, stored));
    check_petsc(KSPSetInitialGuessNonzero(m_method, PETSC_TRUE));
    check_petsc(KSPSetTolerances(m_method, PETSC_DEFAULT, 0, infinite, most));
    check_petsc(KSPGetPC(m_method, &pc));
    check_petsc(PCSetType(pc, PCSHELL));
    check_petsc(PCShellSetContext(pc, this));
    check_petsc(PCShellSetApply(pc, &Petsc_equations::call_precondition));
    check_petsc(PCShellSetView(pc, &Petsc_equations::view));
    check_petsc(KSPSetFromOptions(m_method));
  }

  // Iterates from `m_solution` until the true residual is small enough. Returns the number of
  // iterations.
  unsigned iterate(double tolerance, double norm_of_right) {
    PetscInt most = 0;
    check_petsc(KSPGetTolerances(m_method, nullptr, nullptr, nullptr, &most));
    check_petsc(KSPSetTolerances(m_method, tolerance, 0, infinite, most));
    unsigned iterations = 0;
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    for (double last = infinite;;) {
      PetscReal norm = 0;
      check_petsc(MatMult(m_matrix, m_solution, m_residual));
      check_petsc(VecAYPX(m_residual, -1, m_right));
      check_petsc(VecNorm(m_residual, NORM_2, &norm));
      const double residual = norm / norm_of_right, bound = (std::max)(tolerance, rounding);
      if (!std::isfinite(residual))
        throw Convergence_error("the equations of the flow have no finite solution: cells may be "
                                "too flat",
                                infinite, bound);
      if (residual <= tolerance || (residual > less * last && residual <= bound))
        return iterations;
      if (residual > less * last || reason == KSP_DIVERGED_ITS)
        throw Convergence_error("the iterative solver of the equations of the flow does not "
                                "converge: cells may be too flat, or the time step may be too long",
                                residual, bound);
      last = residual;
      PetscInt done = 0;
      check_petsc(KSPSolve(m_method, m_right, m_solution));
      check_petsc(KSPGetIterationNumber(m_method, &done));
      check_petsc(KSPGetConvergedReason(m_method, &reason));
      iterations += unsigned(done);
    }
  }

  // Writes numbers of all processes into a distributed vector, scaled as unknowns or as equations.
  void write(const Vector& of_velocities, const Vector& of_pressures, bool are_unknowns,
             Vec result) const {
    PetscScalar* next = nullptr;
    check_petsc(VecGetArrayWrite(result, &next));
    PetscScalar* const begin = next;
    const auto scaled = [are_unknowns](double scale, double value) {
      return are_unknowns ? value / scale : value * scale;
    };
    for (Eigen::Index i = m_vertices.begin; i < m_vertices.end; ++i) {
      Eigen::Vector3d value = of_velocities.segment<3>(3 * i);
      if (const Eigen::Matrix3d* p = m_projections[std::size_t(i)])
        value = (*p * value).eval();
      for (int axis = 0; axis < 3; ++axis)
        *next++ = scaled(m_scale_of_velocities(i), value(axis));
    }
    for (Eigen::Index i = m_pressures.begin; i < m_pressures.end; ++i)
      *next++ = scaled(m_scale_of_pressures(i), of_pressures(i));
    next = begin;
    check_petsc(VecRestoreArrayWrite(result, &next));
  }

  // Reads the solution, the same on all processes.
  void read(Vector& velocities, Vector& pressures) const {
    const PetscScalar* own = nullptr;
    check_petsc(VecGetArrayRead(m_solution, &own));
    MPI_Allgatherv(own, int(3 * m_vertices.size()), MPI_DOUBLE, velocities.data(),
                   m_vertices.sizes.data(), m_vertices.begins.data(), MPI_DOUBLE, m_communicator);
    MPI_Allgatherv(own + 3 * m_vertices.size(), int(m_pressures.size()), MPI_DOUBLE,
                   pressures.data(), m_pressures.sizes.data(), m_pressures.begins.data(),
                   MPI_DOUBLE, m_communicator);
    check_petsc(VecRestoreArrayRead(m_solution, &own));
    for (Eigen::Index i = 0; i < velocities.size(); ++i)
      velocities(i) *= m_scale_of_velocities(i / 3);
    pressures.array() *= m_scale_of_pressures.array();
  }

  // Computes the mean of each closed set, in `m_sums`. The numbers of a pressure are multiplied by
  // `scale(pressure)`, where 0 is the first pressure of this process.
  template <class Scale>
  PetscErrorCode compute_means(const PetscScalar* numbers, const Scale& scale) {
    PetscFunctionBeginUser;
    for (std::size_t k = 0; k < m_closed.size(); ++k) {
      m_sums[k] = 0;
      for (std::size_t p : m_closed[k].pressures)
        m_sums[k] += numbers[p] * scale(p) / m_closed[k].number;
    }
    PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, m_sums.data(), int(m_sums.size()), MPI_DOUBLE, MPI_SUM,
                               m_communicator));
    PetscFunctionReturn(0);
  }

  double scale_of_own(std::size_t p) const {
    return m_scale_of_pressures(m_pressures.begin + Eigen::Index(p));
  }

  // Multiplies the matrix and a vector. PETSc calls the function.
  static PetscErrorCode call_multiply(Mat matrix, Vec in, Vec out) {
    PetscFunctionBeginUser;
    void* context = nullptr;
    PetscCall(MatShellGetContext(matrix, &context));
    PetscCall(static_cast<Petsc_equations*>(context)->multiply(in, out));
    PetscFunctionReturn(0);
  }

  PetscErrorCode multiply(Vec in, Vec out) {
    PetscFunctionBeginUser;
    const PetscScalar* x = nullptr;
    PetscScalar* y = nullptr;
    PetscCall(VecGetArrayRead(in, &x));
    PetscCall(VecGetArray(out, &y));
    PetscCall(m_in.place(x));
    PetscCall(m_out.place(y));
    PetscCall(MatMult(m_a, m_in.v, m_out.v));
    PetscCall(MatMultTransposeAdd(m_b, m_in.p, m_out.v, m_out.v));
    PetscCall(MatMult(m_b, m_in.v, m_out.p));
    PetscCall(MatMultAdd(m_c, m_in.p, m_out.p, m_out.p));
    PetscCall(m_in.reset());
    PetscCall(m_out.reset());
    if (!m_closed.empty()) {
      const auto scale = [this](std::size_t p) { return scale_of_own(p); };
      PetscScalar* const y_of_pressures = y + 3 * m_vertices.size();
      PetscCall(compute_means(x + 3 * m_vertices.size(), scale));
      for (std::size_t k = 0; k < m_closed.size(); ++k)
        for (std::size_t p : m_closed[k].pressures)
          y_of_pressures[p] -= scale(p) * m_closed[k].weight * m_sums[k];
    }
    PetscCall(VecRestoreArray(out, &y));
    PetscCall(VecRestoreArrayRead(in, &x));
    PetscFunctionReturn(0);
  }

  // Applies the preconditioner. PETSc calls the function.
  static PetscErrorCode call_precondition(PC pc, Vec in, Vec out) {
    PetscFunctionBeginUser;
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    PetscCall(static_cast<Petsc_equations*>(context)->precondition(in, out));
    PetscFunctionReturn(0);
  }

  // Solves the upper triangular system with approximate inverses of a and of the Schur complement.
  PetscErrorCode precondition(Vec in, Vec out) {
    PetscFunctionBeginUser;
    const PetscScalar* x = nullptr;
    PetscScalar* y = nullptr;
    PetscCall(VecGetArrayRead(in, &x));
    PetscCall(VecGetArray(out, &y));
    PetscCall(m_given.place(x));
    PetscCall(m_result.place(y));
    PetscCall(precondition_pressures(x + 3 * m_vertices.size(), y + 3 * m_vertices.size()));
    PetscCall(MatMultTranspose(m_b, m_result.p, m_force));
    PetscCall(VecAYPX(m_force, -1, m_given.v));
    PetscCall(KSPSolve(m_of_velocities, m_force, m_result.v));
    PetscCall(m_given.reset());
    PetscCall(m_result.reset());
    PetscCall(VecRestoreArray(out, &y));
    PetscCall(VecRestoreArrayRead(in, &x));
    PetscFunctionReturn(0);
  }

  // Computes the pressures of the preconditioner. Multigrid uses pressures without scaling: it
  // needs constants as the smoothest vectors. The means of closed sets are scaled separately.
  PetscErrorCode precondition_pressures(const PetscScalar* x, PetscScalar* y) {
    PetscFunctionBeginUser;
    const std::size_t n = std::size_t(m_pressures.size());
    const auto no_scale = [](std::size_t) { return 1.; };
    PetscScalar *change = nullptr, *level = nullptr;
    PetscCall(VecGetArray(m_change, &change));
    for (std::size_t p = 0; p < n; ++p)
      change[p] = -x[p] / scale_of_own(p);
    PetscCall(compute_means(change, no_scale));
    const std::vector<double> means = m_sums;
    add_to_sets(-1, means, change);
    PetscCall(VecRestoreArray(m_change, &change));
    PetscCall(KSPSolve(m_of_pressures, m_change, m_level));
    PetscCall(VecGetArray(m_change, &change));
    PetscCall(VecGetArray(m_level, &level));
    for (std::size_t p = 0; p < n; ++p)
      level[p] += m_system.viscosity(m_pressures.begin + Eigen::Index(p)) * change[p];
    PetscCall(compute_means(level, no_scale));
    add_to_sets(-1, m_sums, level);
    for (std::size_t k = 0; k < m_closed.size(); ++k)
      m_sums[k] = means[k] / m_closed[k].weight;
    add_to_sets(1, m_sums, level);
    for (std::size_t p = 0; p < n; ++p)
      y[p] = level[p] / scale_of_own(p);
    PetscCall(VecRestoreArray(m_level, &level));
    PetscCall(VecRestoreArray(m_change, &change));
    PetscFunctionReturn(0);
  }

  // Adds a value of each closed set, times a factor, to its pressures.
  void add_to_sets(double factor, const std::vector<double>& values, PetscScalar* numbers) const {
    for (std::size_t k = 0; k < m_closed.size(); ++k)
      for (std::size_t p : m_closed[k].pressures)
        numbers[p] += factor * values[k];
  }

  // Shows the preconditioners of the two blocks. PETSc calls the function.
  static PetscErrorCode view(PC pc, PetscViewer viewer) {
    PetscFunctionBeginUser;
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    const auto* equations = static_cast<Petsc_equations*>(context);
    PetscCall(KSPView(equations->m_of_velocities, viewer));
    PetscCall(KSPView(equations->m_of_pressures, viewer));
    PetscFunctionReturn(0);
  }

  MPI_Comm m_communicator;
  Block m_vertices, m_pressures;
  System m_system;
  Vector m_scale_of_velocities, m_scale_of_pressures; // W^1/2
  std::vector<const Eigen::Matrix3d*> m_projections;  // null for free velocities
  std::vector<Own_closed_set> m_closed;
  std::vector<double> m_sums;
  Petsc_matrix m_a, m_b, m_c, m_schur, m_matrix;
  Petsc_vector m_right, m_solution, m_residual, m_force, m_change, m_level;
  Petsc_parts m_in, m_out, m_given, m_result;
  Petsc_method m_of_velocities, m_of_pressures, m_method;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_PARALLEL_PETSC_EQUATIONS_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_PARALLEL_PETSC_OBJECT_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_PARALLEL_PETSC_OBJECT_H

#include <CGAL/Mesh_support/Error.h>

#include <petscksp.h>

#include <string>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Throws an error if a function of PETSc failed.
// \throws Error
inline void check_petsc(PetscErrorCode code) {
  if (code == 0)
    return;
  const char* general = nullptr;
  char* specific = nullptr;
  PetscErrorMessage(code, &general, &specific);
  std::string message = "PETSc: ";
  message += general != nullptr ? general : "error " + std::to_string(int(code));
  if (specific != nullptr && specific[0] != '\0')
    message += std::string(": ") + specific;
  throw Error(message);
}

// A scope in which PETSc returns errors, and neither prints them nor ends the program.
class Petsc_errors_scope
{
public:
  Petsc_errors_scope() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  ~Petsc_errors_scope() { PetscPopErrorHandler(); }
  Petsc_errors_scope(const Petsc_errors_scope&) = delete;
  Petsc_errors_scope& operator=(const Petsc_errors_scope&) = delete;
};

// An owned object of PETSc.
template <class Object, PetscErrorCode (*destroy)(Object*)> class Petsc_object
{
public:
  Petsc_object() = default;
  ~Petsc_object() { destroy(&m_object); }
  Petsc_object(const Petsc_object&) = delete;
  Petsc_object& operator=(const Petsc_object&) = delete;

  operator Object() const { return m_object; }

  // Destroys the object. Returns the address for a function that creates a new one.
  Object* replace() {
    check_petsc(destroy(&m_object));
    return &m_object;
  }

private:
  Object m_object = nullptr;
};

using Petsc_matrix = Petsc_object<Mat, MatDestroy>;
using Petsc_vector = Petsc_object<Vec, VecDestroy>;
using Petsc_method = Petsc_object<KSP, KSPDestroy>;

// Two vectors that share the memory of one vector: the velocities and the pressures.
class Petsc_parts
{
public:
  // The numbers of own velocities and pressures are those of this process.
  void create(MPI_Comm communicator, PetscInt velocities, PetscInt pressures) {
    m_velocities = velocities;
    check_petsc(
        VecCreateMPIWithArray(communicator, 1, velocities, PETSC_DETERMINE, nullptr, v.replace()));
    check_petsc(
        VecCreateMPIWithArray(communicator, 1, pressures, PETSC_DETERMINE, nullptr, p.replace()));
  }

  // Lets the parts refer to a vector. The functions are called from PETSc, so they return errors.
  PetscErrorCode place(const PetscScalar* array) {
    PetscFunctionBeginUser;
    PetscCall(VecPlaceArray(v, array));
    PetscCall(VecPlaceArray(p, array + m_velocities));
    PetscFunctionReturn(0);
  }
  PetscErrorCode reset() {
    PetscFunctionBeginUser;
    PetscCall(VecResetArray(v));
    PetscCall(VecResetArray(p));
    PetscFunctionReturn(0);
  }

  Petsc_vector v, p;

private:
  PetscInt m_velocities = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_PARALLEL_PETSC_OBJECT_H

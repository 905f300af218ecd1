// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_RUN_H
#define DSC_FLUID_RUN_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"

namespace dsc {

/// A run of a scene: its complex and its fluid.
template <int dimension> struct Fluid_run
{
  using Tracked = Tracked_complex_of<dimension>;
  using Complex = typename Tracked::Complex;

  Fluid_scene scene;
  std::unique_ptr<Tracked> complex;
  std::unique_ptr<Fluid<Complex>> fluid;

  /// Returns the length of the next step of a run until a time.
  double next_step(double end) const;

  /// Returns the scene and the state of the fluid, for a checkpoint.
  std::string metadata() const;
};

/// Starts a scene of this dimension, with the relaxation of the scene.
/// \param folder folder of the files of the scene
/// \param uses_petsc whether PETSc solves the linear systems
/// \throws Input_error if the scene cannot be built
template <int dimension>
Fluid_run<dimension> start_fluid(const Fluid_scene& scene, const std::string& folder,
                                 unsigned threads, bool quiet, bool uses_petsc);

/// Resumes a run from a checkpoint of this dimension.
/// \throws Input_error if the checkpoint contains no fluid
template <int dimension>
Fluid_run<dimension> resume_fluid(const std::string& checkpoint, const std::string& folder,
                                  bool uses_petsc);

} // namespace dsc

#endif // DSC_FLUID_RUN_H

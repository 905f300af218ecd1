// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_POSITION_H
#define DSC_RUN_POSITION_H

#include "input/run_start.h"
#include "motions/motion.h"
#include "output/report_json.h"

#include <CGAL/Mesh_files/Label_names.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>

namespace dsc {

/// The current position of a run.
struct Run_position
{
  unsigned step = 0;
  double time = 0;
  Run_start start;
};

/// The data of a checkpoint other than the complex.
struct Saved_run
{
  Run_position position;
  Step_options step;
};

/// Returns the metadata of a checkpoint, as JSON text.
std::string to_metadata(const Run_position& position, const Step_options& step,
                        const DSC::Label_names& names);

/// Returns the metadata of a checkpoint of no run, with the names of its labels; empty without
/// them.
std::string to_metadata(const DSC::Label_names& names);

/// Returns the run described by the metadata of a checkpoint; `nullopt` if another program wrote
/// the checkpoint.
std::optional<Saved_run> from_metadata(const std::string& metadata);

/// Returns names of labels as the value of "labels" in metadata.
Json label_names_json(const CGAL::Deformable_simplicial_complexes::Label_names& names);

/// Returns the names of labels in the metadata of a checkpoint, which any program may have written.
DSC::Label_names label_names_of(const std::string& metadata);

/// Appends arrays to the metadata of a checkpoint, a line of JSON text, as binary data.
std::string with_arrays(const std::string& metadata, const DSC::Mesh_arrays& arrays);

/// Removes the arrays from the metadata of a checkpoint and returns them; none if there are none.
DSC::Mesh_arrays take_arrays(std::string& metadata);

} // namespace dsc

#endif // DSC_RUN_POSITION_H

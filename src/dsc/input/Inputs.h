// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INPUTS_H
#define DSC_INPUTS_H

#include "input/surface.h"
#include "motions/tracked_complex.h"

namespace dsc {

struct Run_options;
class Start_distance;

/// The inputs that a program reads. The program `dsc` is a `Surface_inputs`. It leaves other inputs
/// to the program `dsc-full`, an `All_inputs`, by throwing Other_program. All functions throw
/// std::runtime_error if an input cannot be read, or does not define a complex.
class Inputs
{
public:
  virtual ~Inputs() = default;

  /// Calls a function in the first of all processes. An error is thrown in all of them.
  virtual void run_once(const std::function<void()>& function) const { function(); }

  /// Throws Other_program unless this program reads the files of all formats.
  virtual void require_all() const = 0;

  /// Returns a file that this program reads, see native_file().
  virtual std::string native(const std::string& path, const std::string& labels,
                             const std::string& thresholds) const = 0;

  /// Returns the initial complex of a run.
  /// \param repairs receives the repairs of the surfaces
  virtual std::unique_ptr<Tracked_complex> start(const Run_options& options,
                                                 Repairs& repairs) const = 0;

  /// Reads the complex and the metadata of a checkpoint.
  virtual std::unique_ptr<Tracked_complex> resume(const std::string& path,
                                                  std::string& metadata) const = 0;

  /// Returns the distance measurement from the initial surfaces or curves of a run.
  virtual Start_distance distance_from(const Run_start& start) const = 0;

  /// Converts a file that is no checkpoint: a surface into another surface format, tetrahedra into
  /// tetrahedra or their interface, an image into another image format, curves into regions.
  /// \param labels, thresholds as in `Run_start`
  /// \throws Usage_error if the format of the output does not fit the content
  virtual void convert(const std::string& input, const std::string& output,
                       const std::string& labels, const std::string& thresholds) const = 0;

  /// Writes the labels of a complex in a checkpoint as an image.
  /// \param grid image with the voxels
  virtual void convert_to_image(const std::string& checkpoint, const std::string& output,
                                const std::string& grid) const = 0;
};

/// All inputs, in space and in the plane.
class All_inputs : public Inputs
{
public:
  void require_all() const override {}
  std::string native(const std::string& path, const std::string& labels,
                     const std::string& thresholds) const override;
  std::unique_ptr<Tracked_complex> start(const Run_options& options,
                                         Repairs& repairs) const override;
  std::unique_ptr<Tracked_complex> resume(const std::string& path,
                                          std::string& metadata) const override;
  Start_distance distance_from(const Run_start& start) const override;
  void convert(const std::string& input, const std::string& output, const std::string& labels,
               const std::string& thresholds) const override;
  void convert_to_image(const std::string& checkpoint, const std::string& output,
                        const std::string& grid) const override;
};

/// Returns the inputs of the program `dsc`: surfaces that bound solids, and inequalities, in space.
const Inputs& surface_inputs();

} // namespace dsc

#endif // DSC_INPUTS_H

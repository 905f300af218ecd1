// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_STATISTICS_H
#define DSC_STATISTICS_H

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// One label of a complex; lengths in the units of the input.
struct Label_statistics
{
  int label;
  std::size_t cells;
  double volume; ///< in the plane, area
  double area;   ///< of the label's part of the interface; in the plane, its length
  std::size_t components;
  int euler_characteristic; ///< of the label's part of the interface; in the plane, of its region
};

/// The state of a complex in numbers; angles in degrees.
struct Statistics
{
  int dimension;
  std::size_t vertices;
  std::size_t cells;
  std::size_t interface_facets;
  std::vector<Label_statistics> labels;
  double min_angle; ///< dihedral in space
  double max_angle;
  std::array<std::size_t, 18> angle_histogram; ///< bins of 10 degrees
  double angles_outside_6_171;                 ///< fraction of all angles
  double min_quality;
};

/// Distances in mean interface edges of the input.
struct Distance_statistics
{
  double mean;
  double maximum;
};

/// What one step did; the state before the first step has all zeros.
struct Step_outcome
{
  double seconds = 0; ///< of the deformation, and of preparing the mesh and the interface for it
  bool complete = true;
  std::size_t unfinished_vertices = 0;
  std::size_t stopped_at_boundary = 0; ///< vertices whose destinations lay outside the domain
  std::size_t flat_cells = 0;          ///< cells that the step left below the floor of quality
  unsigned passes = 0;
  std::size_t split = 0;
  std::size_t collapsed = 0;
  std::size_t flipped = 0;
  std::size_t relabeled = 0;
  std::optional<Distance_statistics> distance_to_start; ///< of the interface, at whole periods
};

/// What improving the tetrahedra did; the state before has all zeros.
struct Improvement_outcome
{
  double seconds = 0; ///< of the improvement alone
  DSC::Improvement_report changes;
};

/// A surface in numbers, whether or not it bounds anything; angles in degrees.
struct Surface_statistics
{
  std::size_t vertices; ///< those that are used
  std::size_t triangles;
  std::size_t boundary_edges; ///< edges of a single triangle; 0 means closed
  std::size_t components;     ///< connected through vertices
  long euler_characteristic;  ///< V - E + F
  double area;
  double volume; ///< inside, if the surface is closed and oriented
  double min_angle;
  double max_angle;
};

/// \throws std::runtime_error if the surface cannot be read
Surface_statistics surface_statistics(const std::string& path);

} // namespace dsc

#endif // DSC_STATISTICS_H

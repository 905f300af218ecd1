// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_STATISTICS_H
#define DSC_STATISTICS_H

#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>

#include <array>
#include <optional>
#include <utility>

namespace dsc {

/// The statistics of a label of a complex. Lengths are in the unit of the input.
struct Label_statistics
{
  int label;
  std::size_t cells;
  double volume; ///< area in the plane
  double area;   ///< of the interface of the label; its length in the plane
  std::size_t components;
  int euler_characteristic; ///< of the interface of the label; in the plane, of its region
  std::string name;         ///< from the input; may be empty
};

/// The statistics of a complex. Angles are in degrees.
struct Statistics
{
  int dimension;
  std::size_t vertices;
  std::size_t cells;
  std::size_t interface_facets;
  std::vector<Label_statistics> labels;
  double min_angle; ///< dihedral angle in space
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

/// A change of connected components, in coordinates of the user. The last coordinate of the place
/// is 0 in the plane.
struct Step_event
{
  DSC::Component_event change;
  std::array<double, 3> where;
};

/// The balance of the volume of a label, in the plane of its area, in a step or in a whole run. See
/// `Deformation_report::Label_change`.
struct Label_balance
{
  int label;
  std::size_t components_before, components_after;
  double before, after;
  double swept;       ///< by the interface
  double overlaps;    ///< explained by changes of topology
  double unexplained; ///< the rest
};

/// The outcome of a step. All values are zero before the first step.
struct Step_outcome
{
  double seconds = 0; ///< time of the deformation, and of the preparation of mesh and interface
  bool complete = true;
  std::size_t unfinished_vertices = 0;
  double estimated_error = 0;          ///< due to the length of the step, in the unit of the input
  std::size_t stopped_at_boundary = 0; ///< vertices with destinations outside the domain
  std::size_t flat_cells = 0;          ///< cells below the quality floor after the step
  unsigned parts = 1;                  ///< into which a long step was divided
  unsigned passes = 0;
  std::size_t split = 0;
  std::size_t collapsed = 0;
  std::size_t flipped = 0;
  std::size_t relabeled = 0;
  std::vector<Step_event> events;
  std::vector<Label_balance> balances; ///< by increasing label; empty if they are not known
  std::optional<Distance_statistics> distance_to_start; ///< of the interface, after whole periods
};

/// The outcome of a mesh improvement.
struct Improvement_outcome
{
  double seconds = 0;                       ///< time of the improvement alone
  double worst_before = 0, worst_after = 0; ///< least quality, by the measure that is improved
  DSC::Improvement_report changes;
};

/// The statistics of a surface, which may be open. Angles are in degrees.
struct Surface_statistics
{
  std::size_t vertices; ///< used vertices
  std::size_t triangles;
  std::size_t boundary_edges; ///< edges with a single triangle; 0 for a closed surface
  std::size_t components;     ///< connected components, through vertices
  long euler_characteristic;  ///< V - E + F
  double area;
  double volume; ///< volume inside, if the surface is closed and oriented
  double min_angle;
  double max_angle;
  /// names of the parts, and their numbers of triangles
  std::vector<std::pair<std::string, std::size_t>> parts;
};

/// Returns the statistics of the surface of a file.
/// \throws std::runtime_error if the surface cannot be read
Surface_statistics surface_statistics(const std::string& path);

} // namespace dsc

#endif // DSC_STATISTICS_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_REPORTS_H
#define DSC_PYTHON_REPORTS_H

#include "Space.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>

#include <pybind11/stl.h>

namespace dsc_python {

namespace DSC = CGAL::Deformable_simplicial_complexes;

template <class Complex>
py::dict event_to_dict(const DSC::Topology_event<Complex>& event, const Space<Complex>& space) {
  const auto volumes = [&](const auto& components) {
    py::list result;
    for (const auto& component : components)
      result.append(space.measure(component.volume));
    return result;
  };
  const auto where = space.to_user(event.where);
  py::dict result;
  result["kind"] = DSC::Component_event::name_of(event.kind);
  result["label"] = event.label;
  result["volumes_before"] = volumes(event.before);
  result["volumes_after"] = volumes(event.after);
  result["where"] = array_of<double>(std::size_t(Complex::dimension),
                                     [&](std::size_t i) { return where[int(i)]; });
  result["pass_number"] = event.pass;
  return result;
}

/// Adds the numbers of changes of a mesh to the dictionary of a report.
template <class Report> void add_changes(const Report& report, py::dict& result) {
  result["split_edges"] = report.split;
  result["collapsed_edges"] = report.collapsed;
  result["flipped"] = report.flipped;
  result["smoothed_vertices"] = report.smoothed;
  result["inserted_vertices"] = report.inserted;
}

/// Returns the report of a deformation, in units of the user.
template <class Complex>
py::dict report_to_dict(const DSC::Deformation_report<Complex>& report, const Complex& complex) {
  const Space<Complex> space(complex);
  std::vector<typename Complex::Point> positions;
  for (const auto& vertex : report.unfinished)
    positions.push_back(complex.position(vertex.vertex));
  py::list labels, events;
  for (const auto& change : report.labels) {
    py::dict entry;
    entry["label"] = change.label;
    entry["components_before"] = change.before;
    entry["components_after"] = change.after;
    entry["merged"] = change.merged;
    entry["split"] = change.split;
    entry["vanished"] = change.vanished;
    entry["appeared"] = change.appeared;
    entry["volume_before"] = space.measure(change.volume_before);
    entry["volume_after"] = space.measure(change.volume_after);
    entry["volume_swept"] = space.measure(change.volume_swept);
    entry["volume_of_overlaps"] = space.measure(change.volume_of_overlaps);
    entry["volume_unexplained"] = space.measure(change.volume_unexplained());
    labels.append(entry);
  }
  for (const auto& event : report.events)
    events.append(event_to_dict(event, space));
  py::dict result;
  result["complete"] = report.complete;
  result["unfinished_points"] = space.array(positions);
  result["unfinished_distances"] = array_of<double>(report.unfinished.size(), [&](std::size_t i) {
    return report.unfinished[i].distance * space.scale();
  });
  result["flat_cells"] = report.flat.size();
  result["vanished_vertices"] = report.vanished;
  result["merged_vertices"] = report.merged;
  result["estimated_error"] = report.estimated_error * space.scale();
  result["stopped_at_boundary"] = report.stopped_at_boundary;
  result["steps"] = report.steps;
  result["passes"] = report.passes;
  add_changes(report, result);
  result["relocated_vertices"] = report.relocated;
  result["relabeled_cells"] = report.relabeled;
  result["labels"] = labels;
  result["events"] = events;
  return result;
}

/// Returns the numbers of changes of a mesh.
inline py::dict report_to_dict(const DSC::Improvement_report& report) {
  py::dict result;
  add_changes(report, result);
  return result;
}

} // namespace dsc_python

#endif // DSC_PYTHON_REPORTS_H

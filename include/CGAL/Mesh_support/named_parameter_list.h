// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

// List of the named parameters of the package, in the form of CGAL's list
// <CGAL/STL_Extension/internal/parameters_interface.h>, to which a merge into CGAL appends these
// lines. The list has no include guard, since it is included several times.

// clang-format off
CGAL_add_named_parameter(normalize_t, normalize, normalize)
CGAL_add_named_parameter(enclosing_box_t, enclosing_box, enclosing_box)
CGAL_add_named_parameter(box_subdivision_t, box_subdivision, box_subdivision)
CGAL_add_named_parameter(spacing_per_segment_t, spacing_per_segment, spacing_per_segment)
CGAL_add_named_parameter(improve_t, improve, improve)
CGAL_add_named_parameter(quality_threshold_t, quality_threshold, quality_threshold)
CGAL_add_named_parameter(relabeling_threshold_t, relabeling_threshold, relabeling_threshold)
CGAL_add_named_parameter(maximum_number_of_passes_t, maximum_number_of_passes, maximum_number_of_passes)
CGAL_add_named_parameter(scheme_t, scheme, scheme)
CGAL_add_named_parameter(integration_tolerance_t, integration_tolerance, integration_tolerance)
CGAL_add_named_parameter(interface_tolerance_t, interface_tolerance, interface_tolerance)
CGAL_add_named_parameter(adaptation_interval_t, adaptation_interval, adaptation_interval)
CGAL_add_named_parameter(number_of_threads_t, number_of_threads, number_of_threads)
CGAL_add_named_parameter(flow_t, flow, flow)
CGAL_add_named_parameter(minimum_angle_t, minimum_angle, minimum_angle)
CGAL_add_named_parameter(topology_control_t, topology_control, topology_control)
CGAL_add_named_parameter(manifold_interface_t, manifold_interface, manifold_interface)
CGAL_add_named_parameter(collision_order_t, collision_order, collision_order)
CGAL_add_named_parameter(smooth_interface_t, smooth_interface, smooth_interface)
CGAL_add_named_parameter(aggressive_t, aggressive, aggressive)
#ifndef CGAL_MESH_SUPPORT_SIZING_FIELD_IS_AN_OBJECT
CGAL_add_named_parameter(sizing_field_t, sizing_field, sizing_field)
#endif
CGAL_add_named_parameter(split_length_t, split_length, split_length)
CGAL_add_named_parameter(collapse_length_t, collapse_length, collapse_length)
CGAL_add_named_parameter(collapse_quality_t, collapse_quality, collapse_quality)
CGAL_add_named_parameter(where_t, where, where)
CGAL_add_named_parameter(change_interface_t, change_interface, change_interface)
CGAL_add_named_parameter(interface_split_length_t, interface_split_length, interface_split_length)
CGAL_add_named_parameter(interface_collapse_length_t, interface_collapse_length, interface_collapse_length)
CGAL_add_named_parameter(aggressiveness_t, aggressiveness, aggressiveness)
CGAL_add_named_parameter(feature_angle_t, feature_angle, feature_angle)
CGAL_add_named_parameter(flip_angle_t, flip_angle, flip_angle)
CGAL_add_named_parameter(curved_splits_t, curved_splits, curved_splits)
CGAL_add_named_parameter(split_junctions_t, split_junctions, split_junctions)
CGAL_add_named_parameter(interface_energy_t, interface_energy, interface_energy)
CGAL_add_named_parameter(swept_volume_t, swept_volume, swept_volume)
CGAL_add_named_parameter(minimum_facet_angle_t, minimum_facet_angle, minimum_facet_angle)
CGAL_add_named_parameter(volume_tolerance_t, volume_tolerance, volume_tolerance)
CGAL_add_named_parameter(degenerate_quality_t, degenerate_quality, degenerate_quality)
CGAL_add_named_parameter(degenerate_cosine_t, degenerate_cosine, degenerate_cosine)
CGAL_add_named_parameter(degenerate_length_t, degenerate_length, degenerate_length)
CGAL_add_named_parameter(fit_tolerance_t, fit_tolerance, fit_tolerance)
CGAL_add_named_parameter(largest_hole_t, largest_hole, largest_hole)
CGAL_add_named_parameter(wrap_alpha_t, wrap_alpha, wrap_alpha)
CGAL_add_named_parameter(wrap_offset_t, wrap_offset, wrap_offset)
CGAL_add_named_parameter(largest_displacement_t, largest_displacement, largest_displacement)
CGAL_add_named_parameter(edge_per_thickness_t, edge_per_thickness, edge_per_thickness)
CGAL_add_named_parameter(most_new_facets_t, most_new_facets, most_new_facets)
CGAL_add_named_parameter(domain_rule_t, domain_rule, domain_rule)
CGAL_add_named_parameter(implicitness_t, implicitness, implicitness)
CGAL_add_named_parameter(observer_t, observer, observer)
CGAL_add_named_parameter(report_t, report, report)

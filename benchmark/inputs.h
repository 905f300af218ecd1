// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_INPUTS_H
#define DSC_BENCHMARK_INPUTS_H

#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = DSC::Labeled_surface_3<Kernel::Point_3>;

/// Appends the unit sphere about `centre`: an icosahedron whose faces are subdivided into n^2
/// triangles each. Common points of triangles are bitwise equal, because nonzero terms are summed
/// in the same order.
void append_sphere(Surface& surface, const Kernel::Vector_3& centre, std::size_t n);

/// Appends the surface of revolution of a polygon (x, r) about the x axis, with n equal parts.
/// Where r is zero, there is one vertex on the axis. Common points of triangles are bitwise equal.
void append_revolved(Surface& surface, const std::vector<std::array<double, 2>>& polygon,
                     std::size_t n);

/// Returns a sphere about the origin of 20 n^2 triangles.
Surface sphere(double radius, std::size_t n);

/// Returns a torus about the x axis of 30 n^2 triangles. The center line of its tube is at distance
/// 1 from the axis.
Surface torus(double tube_radius, std::size_t n);

/// Returns balls of radius 0.5 about (-1, 0, 0) and (1, 0, 0), connected by a bar.
Surface dumbbell(std::size_t n);
constexpr double dumbbell_bar_radius = .25;

/// Appends the triangles of another surface.
void append(Surface& surface, const Surface& other);

/// Returns `sphere` with about this number of triangles, or `two_spheres`, or the surface in a
/// file. The surface is decimated if it has more than `triangles` triangles and `triangles` is not
/// zero.
Surface read_input(const std::string& input, std::size_t triangles);

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_INPUTS_H

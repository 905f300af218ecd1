// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_INPUTS_H
#define DSC_BENCHMARK_INPUTS_H

#include <CGAL/Deformable_simplicial_complexes/Labelled_surface_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = DSC::Labelled_surface_3<Kernel::Point_3>;

/// Appends the unit sphere about `centre`: an icosahedron each face of which is cut into n^2
/// triangles. Points that triangles share are equal: what is not zero is summed in the same order.
void append_sphere(Surface& surface, const Kernel::Vector_3& centre, std::size_t n);

/// Appends what a polygon (x, r) becomes around the x axis: a surface of n equal parts, with
/// corners on the axis where r is zero. Points that triangles share are equal.
void append_revolved(Surface& surface, const std::vector<std::array<double, 2>>& polygon,
                     std::size_t n);

/// A sphere about the origin, of 20 n^2 triangles.
Surface sphere(double radius, std::size_t n);

/// A torus about the x axis, whose tube has its centre at a distance of 1 from it, of 30 n^2
/// triangles.
Surface torus(double tube_radius, std::size_t n);

/// Balls of radius 0.5 about (-1, 0, 0) and (1, 0, 0) and a bar between them.
Surface dumbbell(std::size_t n);
constexpr double dumbbell_bar_radius = .25;

/// Appends the triangles of another surface.
void append(Surface& surface, const Surface& other);

/// `sphere`, of about so many triangles; or the surface in a file, or `two_spheres`, decimated if
/// it has more than `triangles` triangles and these are not zero.
Surface read_input(const std::string& input, std::size_t triangles);

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_INPUTS_H

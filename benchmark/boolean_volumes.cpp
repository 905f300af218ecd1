// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the integrals of 1, x, y and z over the part of each solid that it has if later solids
// cover earlier ones, and solids inside another one cover it. Uses corefinement with exact numbers.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh read(const std::string& path) {
  Mesh result;
  if (!PMP::IO::read_polygon_mesh(path, result) || !CGAL::is_closed(result))
    throw std::runtime_error(path + " is not a closed surface");
  return result;
}

Mesh difference(Mesh a, Mesh b) {
  Mesh result;
  if (!PMP::corefine_and_compute_difference(a, b, result))
    throw std::runtime_error("a difference is not manifold");
  return result;
}

bool is_inside(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b) {
  return b.xmin() <= a.xmin() && b.ymin() <= a.ymin() && b.zmin() <= a.zmin() &&
         a.xmax() <= b.xmax() && a.ymax() <= b.ymax() && a.zmax() <= b.zmax();
}

bool is_inside(const Mesh& a, const Mesh& b) {
  return is_inside(PMP::bbox(a), PMP::bbox(b)) && difference(a, b).is_empty();
}

std::array<double, 4> moments(const Mesh& mesh) {
  std::array<Kernel::FT, 4> result = {0, 0, 0, 0};
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto p = mesh.point(mesh.source(h)) - CGAL::ORIGIN,
               q = mesh.point(mesh.target(h)) - CGAL::ORIGIN,
               r = mesh.point(mesh.target(mesh.next(h))) - CGAL::ORIGIN;
    const Kernel::FT volume = CGAL::determinant(p, q, r) / 6;
    result[0] += volume;
    for (int k = 0; k < 3; ++k)
      result[k + 1] += volume * (p[k] + q[k] + r[k]) / 4;
  }
  return {CGAL::to_double(result[0]), CGAL::to_double(result[1]), CGAL::to_double(result[2]),
          CGAL::to_double(result[3])};
}

// Takes away from each solid the ones inside it, and then the later ones.
std::vector<Mesh> visible_parts(const std::vector<Mesh>& solids) {
  std::vector<Mesh> parts = solids;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t j = 0; j < solids.size(); ++j)
      if (i != j && is_inside(solids[j], solids[i]))
        parts[i] = difference(parts[i], solids[j]);
  std::vector<Mesh> result = parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      if (CGAL::do_overlap(PMP::bbox(result[i]), PMP::bbox(parts[j])))
        result[i] = difference(result[i], parts[j]);
  return result;
}

} // namespace

int main(int count, char** arguments) {
  try {
    std::vector<Mesh> solids;
    for (int i = 1; i < count; ++i)
      solids.push_back(read(arguments[i]));
    for (const Mesh& part : visible_parts(solids)) {
      const auto m = moments(part);
      std::printf("%.17g %.17g %.17g %.17g\n", m[0], m[1], m[2], m[3]);
    }
  } catch (const std::exception& error) {
    std::cerr << "boolean_volumes: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/Triangle_soup_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <vector>

// When TetGen 1.5 gives up, this function of its header frees the mesh and throws; the destructor
// of the mesh then frees it once more and crashes. The library calls the definition below instead.
#define terminatetetgen terminatetetgen_that_frees_twice
#include <tetgen.h>
#undef terminatetetgen

void terminatetetgen(tetgenmesh*, int code) { throw code; }

namespace CGAL {
namespace {

using Deformable_simplicial_complexes::Error;
using Deformable_simplicial_complexes::Tetrahedralization_error;
namespace internal = Deformable_simplicial_complexes::internal;
using Points = std::vector<internal::Coordinates_3>;
using Triangles = std::vector<internal::Triangle_indices>;

const char* explanation(int code) {
  switch (code) {
  case 1:
    return "memory is exhausted: use larger bounds for the tetrahedra or a coarser surface";
  case 2:
    return "internal error: use other bounds for the tetrahedra, or remesh the surfaces";
  case 3:
    return "triangles intersect, or nearly do: separate surfaces that are very close";
  case 4:
    return "a detail is too small: remove very short edges and very thin triangles";
  case 5:
    return "two triangles are too close: separate surfaces that are very close";
  case 10:
    return "the input is invalid: give distinct points, and triangles that meet in common edges";
  default:
    return "unknown error: remesh the surfaces";
  }
}

Tetrahedralization_error tetgen_error(int code) {
  return Tetrahedralization_error(
      "TetGen failed with code " + std::to_string(code) + ", " + explanation(code), code);
}

// A power of two that brings the largest extent of the points to [1, 2): TetGen fails far from 1.
// Such scaling is exact but for numbers that are tiny compared to the extent.
int scale_exponent(const Points& points) {
  Bbox_3 box;
  for (const internal::Coordinates_3& p : points)
    box += internal::exact_point(p).bbox();
  return -std::ilogb((std::max)({box.x_span(), box.y_span(), box.z_span()}));
}

void set_input(tetgenio& input, const Points& points, const Triangles& triangles, int exponent) {
  input.pointlist = new REAL[3 * points.size()];
  input.numberofpoints = int(points.size());
  REAL* coordinate = input.pointlist;
  for (const internal::Coordinates_3& p : points)
    for (double x : p)
      *coordinate++ = std::ldexp(x, exponent);

  // The input frees what its counters count, so they follow each allocation.
  input.facetlist = new tetgenio::facet[triangles.size()];
  for (const internal::Triangle_indices& t : triangles) {
    tetgenio::facet& facet = input.facetlist[input.numberoffacets];
    tetgenio::init(&facet);
    ++input.numberoffacets;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    facet.numberofpolygons = 1;
    polygon.vertexlist = new int[3];
    polygon.numberofvertices = 3;
    for (std::size_t i = 0; i < 3; ++i)
      polygon.vertexlist[i] = int(t[i]);
  }
}

// The points that were passed in, those that TetGen added, and the tetrahedra.
Tetrahedralization_3 get_output(const tetgenio& output, const Points& points, int exponent) {
  Tetrahedralization_3 mesh{points, {}};
  for (int i = int(points.size()); i < output.numberofpoints; ++i) {
    const REAL* p = output.pointlist + 3 * i;
    mesh.points.push_back(
        {std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent), std::ldexp(p[2], -exponent)});
  }
  for (int t = 0; t < output.numberoftetrahedra; ++t) {
    const int* v = output.tetrahedronlist + t * output.numberofcorners;
    mesh.tetrahedra.push_back(
        {std::size_t(v[0]), std::size_t(v[1]), std::size_t(v[2]), std::size_t(v[3])});
  }
  return mesh;
}

// Makes tetrahedra positive; false if one is flat.
bool orient(Tetrahedralization_3& mesh) {
  return std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&mesh](auto& v) {
    const auto point = [&](std::size_t i) { return internal::exact_point(mesh.points[v[i]]); };
    const Orientation sign = orientation(point(0), point(1), point(2), point(3));
    if (sign == NEGATIVE)
      std::swap(v[2], v[3]);
    return sign != COPLANAR;
  });
}

bool has_facets(const Tetrahedralization_3& mesh, Triangles triangles) {
  for (internal::Triangle_indices& t : triangles)
    std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  std::vector<char> is_found(triangles.size(), 0);
  for (const auto& v : mesh.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i) {
      internal::Triangle_indices facet = {v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]};
      std::sort(facet.begin(), facet.end());
      const auto t = std::lower_bound(triangles.begin(), triangles.end(), facet);
      if (t != triangles.end() && *t == facet)
        is_found[t - triangles.begin()] = 1;
    }
  return std::find(is_found.begin(), is_found.end(), 0) == is_found.end();
}

Tetrahedralization_3 tetrahedralize_once(const Points& points, const Triangles& triangles,
                                         int exponent, tetgenbehavior behavior) {
  tetgenio input, output;
  try {
    set_input(input, points, triangles, exponent);
    tetrahedralize(&behavior, &input, &output);
  } catch (int code) {
    throw tetgen_error(code);
  } catch (const std::bad_alloc&) {
    throw tetgen_error(1);
  }
  Tetrahedralization_3 mesh = get_output(output, points, exponent);
  if (!has_facets(mesh, triangles))
    throw Tetrahedralization_error("TetGen lost triangles: separate vertices and surfaces that are "
                                   "very close, or remesh the surfaces");
  if (!orient(mesh))
    throw Tetrahedralization_error("TetGen made flat tetrahedra: use other bounds for them, or "
                                   "remesh the surfaces");
  return mesh;
}

} // namespace

Tetgen_tetrahedralizer_3::Tetgen_tetrahedralizer_3(double radius_edge_ratio,
                                                   double minimum_dihedral_angle,
                                                   double maximum_volume)
    : m_radius_edge_ratio(radius_edge_ratio), m_minimum_dihedral_angle(minimum_dihedral_angle),
      m_maximum_volume(maximum_volume) {
  if (!(radius_edge_ratio >= 1.2))
    throw Error("the radius-edge ratio of tetrahedra is too small: use 1.2 or more");
  if (!(minimum_dihedral_angle >= 0 && minimum_dihedral_angle <= 18))
    throw Error("the minimum dihedral angle of tetrahedra is out of range: use 0 to 18 degrees");
  if (!(maximum_volume > 0))
    throw Error("the maximum volume of tetrahedra is not positive: use more than 0");
}

Tetrahedralization_3 Tetgen_tetrahedralizer_3::operator()(const Points& points,
                                                          const Triangles& triangles) const {
  const int exponent = scale_exponent(points);
  // p: triangles are given, Y: keep them, q: bound the quality, Q: be quiet.
  char switches[] = "pYqQ";
  tetgenbehavior behavior;
  behavior.parse_commandline(switches);
  behavior.minratio = m_radius_edge_ratio;
  behavior.mindihedral = m_minimum_dihedral_angle;
  if (std::isfinite(m_maximum_volume)) {
    behavior.fixedvolume = 1;
    behavior.maxvolume = std::ldexp(m_maximum_volume, 3 * exponent);
  }

  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  try {
    return tetrahedralize_once(points, triangles, exponent, behavior);
  } catch (const Tetrahedralization_error&) {
    // TetGen takes what is closer than 1e-8 of the extent for equal. It is less robust with a
    // smaller tolerance, which therefore is the second choice.
    behavior.epsilon = 1e-14;
    return tetrahedralize_once(points, triangles, exponent, behavior);
  }
}

} // namespace CGAL

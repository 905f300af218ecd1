// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"
#include "surface.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>

namespace dsc {
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace {

using Mesh = CGAL::Surface_mesh<Surface_point>;

Mesh closed_mesh(Surface surface, const std::string& name) {
  Mesh mesh;
  const bool manifold = PMP::orient_polygon_soup(surface.points, surface.triangles) &&
                        PMP::is_polygon_soup_a_polygon_mesh(surface.triangles);
  if (manifold)
    PMP::polygon_soup_to_polygon_mesh(surface.points, surface.triangles, mesh);
  if (!manifold || !CGAL::is_closed(mesh))
    throw Input_error(name + " is not a closed manifold surface; repair it, or leave out "
                             "--triangles to see where it is not");
  return mesh;
}

void decimate(Mesh& mesh, std::size_t triangles) {
  const std::size_t edges = 3 * triangles / 2;
  SMS::edge_collapse(mesh, SMS::Count_stop_predicate<Mesh>(edges + 1), // it stops below
                     CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                         .get_placement(SMS::LindstromTurk_placement<Mesh>())
                         .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
}

// Bisects the longest edge of all again and again. It is the longest of both its triangles, so that
// no angle falls below half the smallest of the input.
void refine(Mesh& mesh, std::size_t triangles) {
  struct Item
  {
    double squared_length;
    Mesh::Edge_index edge;
    bool operator<(const Item& other) const {
      return std::tie(squared_length, other.edge) < std::tie(other.squared_length, edge);
    }
  };
  std::priority_queue<Item> queue;
  const auto push = [&](Mesh::Edge_index e) {
    const Surface_point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    queue.push({CGAL::squared_distance(p, q), e});
  };
  for (const Mesh::Edge_index e : mesh.edges())
    push(e);

  while (mesh.number_of_faces() < triangles) {
    const Mesh::Halfedge_index to_target = mesh.halfedge(queue.top().edge);
    queue.pop();
    const Surface_point middle =
        CGAL::midpoint(mesh.point(mesh.source(to_target)), mesh.point(mesh.target(to_target)));
    const Mesh::Halfedge_index from_source = CGAL::Euler::split_edge(to_target, mesh);
    mesh.point(mesh.target(from_source)) = middle;
    const Mesh::Halfedge_index to_source = mesh.opposite(from_source);
    const Mesh::Halfedge_index left =
        CGAL::Euler::split_face(from_source, mesh.next(to_target), mesh);
    const Mesh::Halfedge_index right =
        CGAL::Euler::split_face(mesh.prev(to_source), mesh.next(to_source), mesh);
    for (const Mesh::Halfedge_index h : {from_source, to_target, left, right})
      push(mesh.edge(h));
  }
}

void assign(Surface& surface, const Mesh& mesh) {
  surface.points.assign(mesh.points().begin(), mesh.points().end());
  surface.triangles.clear();
  for (const Mesh::Face_index f : mesh.faces()) {
    std::array<std::size_t, 3> triangle;
    std::size_t i = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangle[i++] = v;
    surface.triangles.push_back(triangle);
  }
}

} // namespace

void resample(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
              std::size_t triangles) {
  double total = 0;
  for (const Surface& surface : surfaces)
    total += static_cast<double>(surface.triangles.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const double share = static_cast<double>(surfaces[i].triangles.size()) / total;
    const std::size_t wanted =
        std::max<std::size_t>(4, std::llround(share * static_cast<double>(triangles)));
    Mesh mesh = closed_mesh(surfaces[i], names[i]);
    if (mesh.number_of_faces() > wanted) {
      decimate(mesh, wanted);
      if (PMP::does_self_intersect(mesh))
        throw Input_error(names[i] + " with " + std::to_string(mesh.number_of_faces()) +
                          " triangles intersects itself; choose more --triangles");
    } else
      refine(mesh, wanted);
    assign(surfaces[i], mesh);
  }
}

} // namespace dsc

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/surface.h"
#include "programs/errors.h"

#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <queue>
#include <set>
#include <tuple>

namespace dsc {
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace {

using Mesh = CGAL::Surface_mesh<Surface_point>;

// Returns whether each edge has an even number of triangles, and no vertex occurs twice in a
// triangle.
bool is_closed(const std::vector<std::array<std::size_t, 3>>& triangles) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const std::array<std::size_t, 3>& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back(std::minmax({t[i], t[(i + 1) % 3]}));
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if ((next - edge) % 2 == 1 || edge->first == edge->second)
      return false;
    edge = next;
  }
  return true;
}

// Returns whether triangles form an oriented surface without a border: around each vertex, the
// opposite edges of its triangles form one cycle.
bool is_closed_manifold(const std::vector<std::array<std::size_t, 3>>& triangles) {
  struct Edge
  {
    std::size_t apex, from, to; // opposite edge of a vertex in a triangle
    bool operator<(const Edge& other) const {
      return std::tie(apex, from) < std::tie(other.apex, other.from);
    }
  };
  std::vector<Edge> edges;
  for (const std::array<std::size_t, 3>& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
  std::sort(edges.begin(), edges.end());
  for (auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end) {
    end = std::find_if(begin, edges.end(), [&](const Edge& e) { return e.apex != begin->apex; });
    const Edge* at = &*begin;
    for (auto steps = end - begin; steps > 0; --steps) {
      const auto next = std::lower_bound(begin, end, Edge{begin->apex, at->to, 0});
      if (next == end || next->from != at->to || at->from == at->to ||
          (next == begin) != (steps == 1))
        return false;
      at = &*next;
    }
  }
  return true;
}

// Returns a closed surface as a mesh. Where the surface touches itself, the mesh has several
// vertices at the same point. The mesh has border edges at edges with four or more triangles.
Mesh closed_mesh(Surface surface, const std::string& name) {
  PMP::merge_duplicate_points_in_polygon_soup(surface.points, surface.triangles);
  const auto is_mesh = [&] { return PMP::is_polygon_soup_a_polygon_mesh(surface.triangles); };
  bool is_ready = is_closed_manifold(surface.triangles);
  if (!is_ready && is_closed(surface.triangles)) {
    is_ready = is_mesh();
    if (!is_ready) {
      PMP::orient_polygon_soup(surface.points, surface.triangles);
      is_ready = is_mesh();
    }
  }
  if (!is_ready)
    throw Input_error(name + " is not a closed surface; use --repair, or leave out --triangles to "
                             "locate the defect");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.triangles, mesh);
  return mesh;
}

using Touching_points = std::set<Surface_point>;

// Returns the points with several vertices.
Touching_points touching_points(const std::vector<Mesh>& meshes) {
  std::vector<Surface_point> points;
  for (const Mesh& mesh : meshes)
    points.insert(points.end(), mesh.points().begin(), mesh.points().end());
  std::sort(points.begin(), points.end());
  Touching_points result;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i - 1] == points[i])
      result.insert(points[i]);
  return result;
}

// Returns, for each mesh, whether it has an edge in common with another mesh.
std::vector<bool> share_edges(const std::vector<Mesh>& meshes, const Touching_points& touching) {
  std::vector<bool> result(meshes.size(), false);
  std::map<std::pair<Surface_point, Surface_point>, std::size_t> owners;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (const Mesh::Edge_index e : meshes[i].edges()) {
      const Surface_point p = meshes[i].point(meshes[i].vertex(e, 0)),
                          q = meshes[i].point(meshes[i].vertex(e, 1));
      if (touching.count(p) == 0 || touching.count(q) == 0)
        continue;
      const std::size_t owner = owners.emplace(std::minmax(p, q), i).first->second;
      if (owner != i)
        result[i] = result[owner] = true;
    }
  return result;
}

// The placement of Lindstrom and Turk, except that points where the surface touches itself are
// fixed.
struct Placement : SMS::LindstromTurk_placement<Mesh>
{
  using Base = SMS::LindstromTurk_placement<Mesh>;

  explicit Placement(const Touching_points& points) : touching(points) {}

  template <class Profile>
  auto operator()(const Profile& profile) const -> decltype(Base::operator()(profile)) {
    const bool first_stays = touching.count(profile.p0()) > 0,
               second_stays = touching.count(profile.p1()) > 0;
    if (first_stays && second_stays)
      return {};
    if (first_stays || second_stays)
      return first_stays ? profile.p0() : profile.p1();
    return Base::operator()(profile);
  }

  const Touching_points& touching;
};

void decimate(Mesh& mesh, std::size_t triangles, const Touching_points& touching) {
  // Border edges, along which the surface touches itself, are not collapsed.
  const auto border = std::count_if(mesh.halfedges().begin(), mesh.halfedges().end(),
                                    [&](Mesh::Halfedge_index h) { return mesh.is_border(h); });
  const std::size_t edges = (3 * triangles + static_cast<std::size_t>(border)) / 2;
  SMS::edge_collapse(mesh, DSC::Edge_count_stop_predicate<Mesh>(edges + 1), // it stops below
                     CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                         .get_placement(Placement(touching))
                         .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
}

// Bisects the longest edge repeatedly. It is the longest edge of both its triangles, so that no
// angle becomes smaller than half the smallest angle of the input. Edges along which the surface
// touches itself are also bisected beyond the number of triangles if edges of equal length are
// bisected, so that coincident edges stay equal.
void refine(Mesh& mesh, std::size_t triangles, Touching_points touching) {
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

  double squared_length = 0;
  while (mesh.number_of_faces() < triangles ||
         (squared_length > 0 && queue.top().squared_length == squared_length)) {
    squared_length = queue.top().squared_length;
    const Mesh::Halfedge_index to_target = mesh.halfedge(queue.top().edge);
    queue.pop();
    const Surface_point source = mesh.point(mesh.source(to_target)),
                        target = mesh.point(mesh.target(to_target)),
                        middle = CGAL::midpoint(source, target);
    if (touching.count(source) > 0 && touching.count(target) > 0)
      touching.insert(middle);
    else if (mesh.number_of_faces() >= triangles)
      continue;
    const Mesh::Halfedge_index from_source = CGAL::Euler::split_edge(to_target, mesh);
    mesh.point(mesh.target(from_source)) = middle;
    const Mesh::Halfedge_index to_source = mesh.opposite(from_source);
    if (!mesh.is_border(from_source))
      push(mesh.edge(CGAL::Euler::split_face(from_source, mesh.next(to_target), mesh)));
    if (!mesh.is_border(to_source))
      push(mesh.edge(CGAL::Euler::split_face(mesh.prev(to_source), mesh.next(to_source), mesh)));
    push(mesh.edge(from_source));
    push(mesh.edge(to_target));
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

// Returns whether the surface intersects itself. Unlike Polygon_mesh_processing, accepts touching
// parts.
bool does_self_intersect(const Surface& surface) {
  namespace internal = DSC::internal;
  internal::Triangle_soup_3 soup;
  for (const Surface_point& p : surface.points)
    soup.points.push_back(internal::coordinates(p));
  soup.triangles = surface.triangles;
  soup = internal::merge_points(soup);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (internal::exact_triangle(soup, t).is_degenerate())
      return true;
  return !internal::crossing_triangles(soup).empty();
}

} // namespace

void resample(Surfaces& given, std::size_t triangles) {
  std::vector<Surface>& surfaces = given.all;
  const std::vector<std::string>& names = given.titles;
  double total = 0;
  for (const Surface& surface : surfaces)
    total += static_cast<double>(surface.triangles.size());
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    meshes.push_back(closed_mesh(surfaces[i], names[i]));
  const Touching_points touching = touching_points(meshes);
  const std::vector<bool> shares_edges = share_edges(meshes, touching);

  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const double share = static_cast<double>(surfaces[i].triangles.size()) / total;
    const std::size_t target_number =
        std::max<std::size_t>(4, std::llround(share * static_cast<double>(triangles)));
    Mesh& mesh = meshes[i];
    const bool has_more = mesh.number_of_faces() > target_number;
    if (has_more)
      decimate(mesh, target_number, touching);
    else if (shares_edges[i])
      throw Input_error(names[i] + " shares edges with another surface, which would be split "
                                   "differently; leave out --triangles");
    else
      refine(mesh, target_number, touching);
    assign(surfaces[i], mesh);
    if (has_more && does_self_intersect(surfaces[i]))
      throw Input_error(names[i] + " intersects itself after its simplification to " +
                        std::to_string(mesh.number_of_faces()) +
                        " triangles; choose more --triangles");
  }
}

} // namespace dsc

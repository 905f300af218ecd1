// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include "child_process.h"

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/internal/building/points_in_space_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <tetgen.h>

#include <new>
#include <optional>
#include <random>
#include <system_error>

namespace CGAL {
namespace {

using Deformable_simplicial_complexes::Error;
using Deformable_simplicial_complexes::Tetrahedralization_3;
using Deformable_simplicial_complexes::Tetrahedralization_error;
namespace internal = Deformable_simplicial_complexes::internal;
using internal::Child_process;
using Points = std::vector<internal::Coordinates_3>;
using Triangles = std::vector<internal::Triangle_indices>;

// Error codes of TetGen.
constexpr int out_of_memory = 1;
constexpr int internal_error = 2;

const char* explanation(int code) {
  switch (code) {
  case out_of_memory:
    return "memory is exhausted: use larger bounds for the tetrahedra or a coarser surface";
  case internal_error:
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

// The cause of the failure of an attempt.
enum class Cause {
  INPUT,  // reported as invalid
  RESULT, // missing or invalid
  CRASH,  // crash of TetGen
  TIME,   // exceeded
  MEMORY  // exceeded
};

class Failed_attempt : public Tetrahedralization_error
{
public:
  Failed_attempt(Cause cause, const std::string& message, int code = 0)
      : Tetrahedralization_error(message, code), cause(cause) {}

  Cause cause;
};

Failed_attempt tetgen_failure(int code) {
  Cause cause = Cause::RESULT;
  if (code == out_of_memory)
    cause = Cause::MEMORY;
  else if (code == 3 || code == 4 || code == 5 || code == 10)
    cause = Cause::INPUT;
  return {cause, "TetGen failed with code " + std::to_string(code) + ", " + explanation(code),
          code};
}

Failed_attempt failure(const Child_process::Outcome& outcome) {
  switch (outcome.end) {
  case Child_process::End::CRASHED:
    return {Cause::CRASH,
            "TetGen crashed with signal " + std::to_string(outcome.code) +
                ": remesh the surfaces, or separate vertices and surfaces that are very close"};
  case Child_process::End::KILLED:
    return {Cause::MEMORY, "TetGen was killed, probably because memory is exhausted: use larger "
                           "bounds for the tetrahedra or a coarser surface"};
  case Child_process::End::TIMED_OUT:
    return {Cause::TIME, "TetGen reached its time limit: use a longer time limit, larger bounds "
                         "for the tetrahedra or a coarser surface"};
  default:
    return tetgen_failure(outcome.code);
  }
}

// Returns the exponent of a power of two that scales the largest extent of the points to [1, 2).
// TetGen fails for extents far from 1. The scaling is exact except for numbers that are tiny
// relative to the extent.
int scale_exponent(const Points& points) {
  Bbox_3 box;
  for (const internal::Coordinates_3& p : points)
    box += internal::exact_point(p).bbox();
  return -std::ilogb((std::max)({box.x_span(), box.y_span(), box.z_span()}));
}

// The input of TetGen. Its point i is point `order[i]` of `points`.
struct Job
{
  Points points; // the given ones, then those in space
  const Triangles& triangles;
  int exponent;
  tetgenbehavior behavior;
  std::vector<int> order, order_of_triangles;
};

void set_input(tetgenio& input, const Job& job) {
  input.pointlist = new REAL[3 * job.points.size()];
  input.numberofpoints = int(job.points.size());
  REAL* coordinate = input.pointlist;
  std::vector<int> position(job.points.size());
  for (int i = 0; i < input.numberofpoints; ++i) {
    position[job.order[i]] = i;
    for (double x : job.points[job.order[i]])
      *coordinate++ = std::ldexp(x, job.exponent);
  }

  // The destructor of the input frees arrays according to their counters. So each counter is set
  // after its allocation.
  input.facetlist = new tetgenio::facet[job.triangles.size()];
  for (int i : job.order_of_triangles) {
    const internal::Triangle_indices& t = job.triangles[i];
    tetgenio::facet& facet = input.facetlist[input.numberoffacets];
    tetgenio::init(&facet);
    ++input.numberoffacets;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    facet.numberofpolygons = 1;
    polygon.vertexlist = new int[3];
    polygon.numberofvertices = 3;
    for (std::size_t k = 0; k < 3; ++k)
      polygon.vertexlist[k] = position[t[k]];
  }
}

// The header of the data sent by the child. The points added by TetGen and the corners of all
// tetrahedra follow.
struct Counts
{
  int added_points, tetrahedra;
};

using Corners = std::array<int, 4>;

// Runs TetGen and sends the result. Throws the error codes of TetGen.
void run_tetgen(const Job& job, const Child_process::Send& send) {
  try {
    tetgenio input, output;
    set_input(input, job);
    tetgenbehavior behavior = job.behavior;
    tetrahedralize(&behavior, &input, &output);
    const Counts counts = {output.numberofpoints - input.numberofpoints, output.numberoftetrahedra};
    if (counts.added_points < 0)
      throw internal_error;
    send(&counts, sizeof(counts));
    send(output.pointlist + 3 * job.points.size(), 3 * sizeof(REAL) * counts.added_points);
    send(output.tetrahedronlist, sizeof(Corners) * counts.tetrahedra);
  } catch (const std::bad_alloc&) {
    throw out_of_memory;
  }
}

// Receives the mesh. Returns false unless the data is complete and consistent: a faulty process may
// send anything.
bool receive(Tetrahedralization_3& mesh, const Job& job, Child_process& child) {
  Counts counts;
  if (!child.read(&counts, sizeof(counts)) || counts.added_points < 0 || counts.tetrahedra < 0)
    return false;

  mesh.points = job.points;
  for (int i = 0; i < counts.added_points; ++i) {
    internal::Coordinates_3 p;
    if (!child.read(&p, sizeof(p)))
      return false;
    for (double& x : p)
      x = std::ldexp(x, -job.exponent);
    mesh.points.push_back(p);
  }

  mesh.tetrahedra.reserve(counts.tetrahedra);
  for (int t = 0; t < counts.tetrahedra; ++t) {
    Corners corners;
    if (!child.read(&corners, sizeof(corners)))
      return false;
    std::array<std::size_t, 4> v;
    for (std::size_t i = 0; i < 4; ++i) {
      if (corners[i] < 0 || std::size_t(corners[i]) >= mesh.points.size())
        return false;
      v[i] = corners[i] < int(job.order.size()) ? job.order[corners[i]] : corners[i];
    }
    mesh.tetrahedra.push_back(v);
  }
  return true;
}

// Removes points that no tetrahedron uses, except the first `kept` ones.
void remove_unused_points(Tetrahedralization_3& mesh, std::size_t kept) {
  static constexpr std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> place(mesh.points.size(), unused);
  std::iota(place.begin(), place.begin() + std::ptrdiff_t(kept), std::size_t(0));
  Points used(mesh.points.begin(), mesh.points.begin() + std::ptrdiff_t(kept));
  for (auto& tetrahedron : mesh.tetrahedra)
    for (std::size_t& v : tetrahedron) {
      if (place[v] == unused) {
        place[v] = used.size();
        used.push_back(mesh.points[v]);
      }
      v = place[v];
    }
  mesh.points = std::move(used);
}

// Orients tetrahedra positively. Returns false if one is flat.
bool orient(Tetrahedralization_3& mesh) {
  return std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&mesh](auto& v) {
    const auto point = [&](std::size_t i) { return internal::exact_point(mesh.points[v[i]]); };
    const Orientation sign = orientation(point(0), point(1), point(2), point(3));
    if (sign == NEGATIVE)
      std::swap(v[2], v[3]);
    return sign != COPLANAR;
  });
}

// Throws unless positively oriented tetrahedra fill space without overlaps, and contain the
// triangles: each side of a facet belongs to one tetrahedron at most.
void check(const Tetrahedralization_3& mesh, const Triangles& triangles) {
  const auto facets = internal::sorted_facets(mesh.tetrahedra);
  for (const internal::Triangle_indices& t : triangles) {
    const internal::Triangle_indices corners = internal::sorted(t);
    const auto found =
        std::lower_bound(facets.begin(), facets.end(), corners,
                         [](const auto& f, const auto& c) { return f.vertices < c; });
    if (found == facets.end() || found->vertices != corners)
      throw Failed_attempt(Cause::RESULT,
                           "TetGen lost triangles: separate vertices and surfaces that are very "
                           "close, or remesh the surfaces");
  }
  for (std::size_t i = 1; i < facets.size(); ++i)
    if (facets[i].vertices == facets[i - 1].vertices &&
        (!facets[i].fits(facets[i - 1]) || (i > 1 && facets[i].vertices == facets[i - 2].vertices)))
      throw Failed_attempt(Cause::RESULT,
                           "TetGen created tetrahedra that overlap: separate vertices and surfaces "
                           "that are very close, or remesh the surfaces");
}

Tetrahedralization_3 tetrahedralize_once(const Job& job, std::size_t given, double seconds,
                                         double processor_seconds) try {
  Child_process child([&](const Child_process::Send& send) { run_tetgen(job, send); }, seconds,
                      processor_seconds);
  Tetrahedralization_3 mesh;
  const bool is_complete = receive(mesh, job, child);
  const Child_process::Outcome outcome = child.wait();
  if (outcome.end != Child_process::End::EXITED || outcome.code != 0)
    throw failure(outcome);
  if (!is_complete)
    throw tetgen_failure(internal_error);
  if (!orient(mesh))
    throw Failed_attempt(Cause::RESULT, "TetGen created flat tetrahedra: use other bounds for the "
                                        "tetrahedra, or remesh the surfaces");
  check(mesh, job.triangles);
  remove_unused_points(mesh, given);
  return mesh;
} catch (const std::system_error& e) {
  throw Failed_attempt(Cause::MEMORY, std::string("TetGen could not be started, ") + e.what() +
                                          ": free memory, or end other programs");
}

struct Attempt
{
  double tolerance;         // relative to the extent; TetGen treats closer points as equal
  bool has_bounds;          // on the shapes of tetrahedra
  unsigned seed;            // of the order of the points and triangles
  double end;               // fraction of the time limit at which the attempt ends
  bool adds_points = false; // `points_instead_of_bounds()`
};

// The attempts, in their order. The first one adds points in space instead of bounds, if there are
// many triangles. TetGen is less robust with a tolerance below its default, which comes first.
// Crashes and infinite loops occur where triangles of a flat side are rounded, mostly while points
// are inserted to satisfy the shape bounds; another order changes the inserted points.
constexpr Attempt attempts[] = {{1e-8, false, 0, 1. / 3, true},
                                {1e-8, true, 0, 1. / 3},
                                {1e-14, true, 0, 1. / 3},
                                {1e-8, true, 1, 2. / 3},
                                {1e-8, true, 2, 2. / 3},
                                {1e-8, true, 3, 2. / 3},
                                {1e-8, false, 0, 1},
                                {1e-8, false, 1, 1},
                                {1e-8, false, 2, 1}};

// Returns points in space that replace bounds on shapes. Returns no points if there are few
// triangles, which TetGen fills fast, if no bounds are given, or if they are stricter than usual.
Points points_instead_of_bounds(const Job& job) {
  static constexpr std::size_t many_triangles = 5000;
  static constexpr double size = 5, distance = .4; // of leaves of an octree
  const tetgenbehavior& bounds = job.behavior;
  const Tetgen_tetrahedralizer_3 usual;
  const bool has_bounds = std::isfinite(bounds.minratio) || bounds.mindihedral > 0;
  if (job.triangles.size() < many_triangles || !has_bounds || bounds.fixedvolume ||
      bounds.minratio < usual.radius_edge_ratio() ||
      bounds.mindihedral > usual.minimum_dihedral_angle())
    return {};
  const auto scaled = [](Points points, int exponent) {
    for (internal::Coordinates_3& p : points)
      for (double& x : p)
        x = std::ldexp(x, exponent);
    return points;
  };
  return scaled(internal::points_in_space(scaled(job.points, job.exponent), job.triangles, size,
                                          distance, job.triangles.size()),
                -job.exponent);
}

// Returns the processor time after which an attempt is taken for an infinite loop, in seconds:
// about twenty times the usual one. If volumes are bounded, the time does not follow from the
// input.
double longest_processor_time(const Job& job) {
  static constexpr double at_least = 5, for_triangle = 2e-3;
  return job.behavior.fixedvolume ? std::numeric_limits<double>::infinity()
                                  : at_least + for_triangle * double(job.triangles.size());
}

// Returns whether an attempt may succeed after a failure.
bool may_help(const Attempt& attempt, Cause cause) {
  switch (cause) {
  case Cause::INPUT:
    return attempt.has_bounds && attempt.seed == 0;
  case Cause::RESULT:
    return true;
  case Cause::CRASH:
  case Cause::TIME:
    return !attempt.has_bounds || attempt.seed != 0;
  default:
    return false;
  }
}

// Returns the input order for seed 0, otherwise a pseudorandom order that is the same on all
// systems.
std::vector<int> order_of_items(std::size_t size, unsigned seed) {
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(seed);
  if (seed != 0)
    for (std::size_t i = size; i > 1; --i)
      std::swap(order[i - 1], order[random() % i]);
  return order;
}

} // namespace

Tetgen_tetrahedralizer_3::Tetgen_tetrahedralizer_3(double radius_edge_ratio,
                                                   double minimum_dihedral_angle,
                                                   double maximum_volume, double time_limit)
    : m_radius_edge_ratio(radius_edge_ratio), m_minimum_dihedral_angle(minimum_dihedral_angle),
      m_maximum_volume(maximum_volume), m_time_limit(time_limit) {
  if (!(radius_edge_ratio >= 1.2))
    throw Error("the radius-edge ratio of tetrahedra is too small: use 1.2 or more");
  if (!(minimum_dihedral_angle >= 0 && minimum_dihedral_angle <= 18))
    throw Error("the minimum dihedral angle of tetrahedra is out of range: use 0 to 18 degrees");
  if (!(maximum_volume > 0))
    throw Error("the maximum volume of tetrahedra is not positive: use more than 0");
  if (!(time_limit > 0))
    throw Error("the time limit of the tetrahedralizer is not positive: use more than 0 seconds");
}

Tetrahedralization_3 Tetgen_tetrahedralizer_3::operator()(const Points& points,
                                                          const Triangles& triangles) const {
  const auto start = std::chrono::steady_clock::now();
  Job job = {points, triangles, scale_exponent(points), {}, {}, {}};
  // p: tetrahedralize the triangles, Y: keep them, q: bound the quality, J: keep unused points, Q:
  // quiet.
  char switches[] = "pYqJQ";
  job.behavior.parse_commandline(switches);
  job.behavior.minratio = m_radius_edge_ratio;
  job.behavior.mindihedral = m_minimum_dihedral_angle;
  if (std::isfinite(m_maximum_volume)) {
    job.behavior.fixedvolume = 1;
    job.behavior.maxvolume = std::ldexp(m_maximum_volume, 3 * job.exponent);
  }

  const Points in_space = points_instead_of_bounds(job);
  std::optional<Failed_attempt> failure;
  for (const Attempt& attempt : attempts) {
    if (failure ? !may_help(attempt, failure->cause) : attempt.adds_points && in_space.empty())
      continue;
    job.behavior.epsilon = attempt.tolerance;
    job.behavior.quality = attempt.has_bounds;
    job.behavior.fixedvolume = attempt.has_bounds && std::isfinite(m_maximum_volume);
    job.points = points;
    if (attempt.adds_points)
      job.points.insert(job.points.end(), in_space.begin(), in_space.end());
    job.order = order_of_items(job.points.size(), attempt.seed);
    job.order_of_triangles = order_of_items(triangles.size(), attempt.seed);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    try {
      return tetrahedralize_once(job, points.size(), attempt.end * m_time_limit - elapsed.count(),
                                 longest_processor_time(job));
    } catch (const Failed_attempt& e) {
      if (!attempt.adds_points || e.cause == Cause::MEMORY)
        failure = e;
    }
  }
  throw *failure;
}

} // namespace CGAL

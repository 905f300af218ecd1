// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/arrays_on.h"

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

namespace dsc {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Space = Complex::Space;
using Position = Complex::Point;
using Corners = std::array<Position, 4>;
using Simplex = DSC::internal::Clipping_simplex<Space>;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

std::vector<Box> boxes_of(const std::vector<Simplex>& simplices) {
  std::vector<Box> result;
  for (std::size_t i = 0; i < simplices.size(); ++i)
    result.emplace_back(simplices[i].bbox(), i);
  return result;
}

/// The transfer of the arrays of a mesh to a complex.
class Array_transfer
{
public:
  Array_transfer(const Complex& complex, const Labeled_tetrahedra& mesh)
      : m_complex(complex), m_mesh(mesh), m_tetrahedra(mesh.tetrahedra) {
    for (auto& tetrahedron : m_tetrahedra) {
      if (DSC::internal::signed_measure<Space>(corners(tetrahedron)) < 0)
        std::swap(tetrahedron[2], tetrahedron[3]);
      m_old.emplace_back(corners(tetrahedron));
    }
    for (const auto v : complex.vertices())
      m_positions.push_back(complex.user_position(v));
  }

  Mesh_arrays operator()() {
    Mesh_arrays result = m_mesh.arrays;
    if (!result.cells.empty())
      find_overlaps();
    for (Mesh_array& array : result.cells)
      array = on_cells(array);
    if (!result.points.empty())
      locate_vertices();
    for (Mesh_array& array : result.points)
      array = on_vertices(array);
    return result;
  }

private:
  struct Overlap
  {
    std::size_t from, to;
    double measure;
  };

  /// The place of a vertex: a tetrahedron and barycentric coordinates.
  struct Place
  {
    std::size_t tetrahedron = none;
    std::array<double, 4> weights = {};
    double depth = -1e-6; // least weight; smaller ones are outside
  };

  Corners corners(const std::array<std::size_t, 4>& tetrahedron) const {
    Corners result;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& p = m_mesh.points[tetrahedron[i]];
      result[i] = Position(p.x(), p.y(), p.z());
    }
    return result;
  }

  void find_overlaps() {
    const DSC::Vertex_numbers numbers(m_complex, m_complex.vertices());
    std::vector<Simplex> now;
    std::vector<int> labels;
    for (const auto c : m_complex.cells()) {
      Corners p;
      for (int i = 0; i < 4; ++i)
        p[std::size_t(i)] = m_positions[numbers(c->vertex(i))];
      now.emplace_back(p);
      m_measures.push_back(DSC::internal::signed_measure<Space>(p));
      labels.push_back(c->subdomain_index());
    }
    std::vector<Box> from = boxes_of(m_old), to = boxes_of(now);
    CGAL::box_intersection_d(
        from.begin(), from.end(), to.begin(), to.end(), [&](const Box& a, const Box& b) {
          DSC::Progress_scope::check();
          if (m_mesh.labels[a.info()] != labels[b.info()])
            return;
          const double measure = DSC::internal::overlap_measure(m_old[a.info()], now[b.info()]);
          if (measure > 0)
            m_overlaps.push_back({a.info(), b.info(), measure});
        });
    std::sort(m_overlaps.begin(), m_overlaps.end(), [](const Overlap& a, const Overlap& b) {
      return std::tie(a.from, a.to) < std::tie(b.from, b.to);
    });
  }

  Mesh_array on_cells(const Mesh_array& array) const {
    Mesh_array result{array.name, array.type, array.components, {}};
    result.values.resize(m_measures.size() * array.components, 0);
    return array.is_integer() ? with_integers(array, std::move(result))
                              : with_averages(array, std::move(result));
  }

  Mesh_array with_integers(const Mesh_array& array, Mesh_array result) const {
    std::vector<double> largest(m_measures.size(), 0);
    for (const Overlap& overlap : m_overlaps)
      if (overlap.measure > largest[overlap.to]) {
        largest[overlap.to] = overlap.measure;
        std::copy_n(array.values.begin() + std::ptrdiff_t(overlap.from * array.components),
                    array.components,
                    result.values.begin() + std::ptrdiff_t(overlap.to * array.components));
      }
    return result;
  }

  Mesh_array with_averages(const Mesh_array& array, Mesh_array result) const {
    std::vector<double> sums(m_old.size(), 0);
    for (const Overlap& overlap : m_overlaps)
      sums[overlap.from] += overlap.measure;
    for (const Overlap& overlap : m_overlaps) {
      const double volume = DSC::internal::signed_measure<Space>(m_old[overlap.from].corners());
      const double factor = overlap.measure / sums[overlap.from] * volume / m_measures[overlap.to];
      for (std::size_t i = 0; i < array.components; ++i)
        result.values[overlap.to * array.components + i] +=
            factor * array.values[overlap.from * array.components + i];
    }
    return result;
  }

  void locate_vertices() {
    m_places.resize(m_positions.size());
    CGAL::Bbox_3 all;
    for (const Simplex& simplex : m_old)
      all += simplex.bbox();
    const double margin = 1e-9 * (std::max)({all.x_span(), all.y_span(), all.z_span()});
    std::vector<Box> from, to;
    for (std::size_t i = 0; i < m_old.size(); ++i) {
      const CGAL::Bbox_3 b = m_old[i].bbox();
      from.emplace_back(CGAL::Bbox_3(b.xmin() - margin, b.ymin() - margin, b.zmin() - margin,
                                     b.xmax() + margin, b.ymax() + margin, b.zmax() + margin),
                        i);
    }
    for (std::size_t i = 0; i < m_positions.size(); ++i)
      to.emplace_back(m_positions[i].bbox(), i);
    CGAL::box_intersection_d(from.begin(), from.end(), to.begin(), to.end(),
                             [&](const Box& a, const Box& b) {
                               DSC::Progress_scope::check();
                               look_into(a.info(), m_positions[b.info()], m_places[b.info()]);
                             });
    find_origins();
  }

  // Replaces a place if the point is farther inside another tetrahedron; the first one counts.
  void look_into(std::size_t t, const Position& p, Place& place) const {
    Place other{t, {}, 0};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      Corners moved = m_old[t].corners();
      moved[i] = p;
      sum += other.weights[i] = DSC::internal::signed_measure<Space>(moved);
    }
    if (!(sum > 0))
      return;
    for (double& weight : other.weights)
      weight /= sum;
    other.depth = *std::min_element(other.weights.begin(), other.weights.end());
    if (other.depth > place.depth || (other.depth == place.depth && t < place.tetrahedron))
      place = other;
  }

  // Finds, for each vertex, a vertex near it in a tetrahedron, by a search along edges.
  void find_origins() {
    const auto vertices = m_complex.vertices();
    const DSC::Vertex_numbers numbers(m_complex, vertices);
    m_origins.assign(vertices.size(), none);
    std::vector<std::size_t> queue;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (m_places[i].tetrahedron != none) {
        m_origins[i] = i;
        queue.push_back(i);
      }
    std::vector<Complex::Cell_handle> star;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      star.clear();
      m_complex.star(vertices[queue[k]], star);
      for (const auto c : star)
        for (int i = 0; i < 4; ++i) {
          if (m_complex.is_infinite(c->vertex(i)))
            continue;
          const std::size_t v = numbers(c->vertex(i));
          if (m_origins[v] == none) {
            m_origins[v] = m_origins[queue[k]];
            queue.push_back(v);
          }
        }
    }
  }

  Mesh_array on_vertices(const Mesh_array& array) const {
    static constexpr double certain = 1 - 1e-9; // the vertex is a corner, up to rounding
    Mesh_array result{array.name, array.type, array.components, {}};
    for (const std::size_t origin : m_origins) {
      const Place& place = m_places[origin];
      const auto& tetrahedron = m_tetrahedra[place.tetrahedron];
      const auto nearest = std::max_element(place.weights.begin(), place.weights.end());
      const std::size_t corner = tetrahedron[std::size_t(nearest - place.weights.begin())];
      const bool is_corner = array.is_integer() || *nearest > certain;
      for (std::size_t i = 0; i < array.components; ++i) {
        const auto value = [&](std::size_t p) { return array.values[p * array.components + i]; };
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k)
          sum += place.weights[k] * value(tetrahedron[k]);
        result.values.push_back(is_corner ? value(corner) : sum);
      }
    }
    return result;
  }

  const Complex& m_complex;
  const Labeled_tetrahedra& m_mesh;
  std::vector<std::array<std::size_t, 4>> m_tetrahedra; // positively oriented
  std::vector<Simplex> m_old;
  std::vector<Position> m_positions; // of the vertices
  std::vector<double> m_measures;    // of the cells
  std::vector<Overlap> m_overlaps;   // of cells with equal labels
  std::vector<Place> m_places;       // of the vertices
  std::vector<std::size_t> m_origins;
};

} // namespace

Mesh_arrays arrays_on(const Complex& complex, const Labeled_tetrahedra& mesh) {
  const Mesh_arrays& arrays = mesh.arrays;
  return arrays.points.empty() && arrays.cells.empty() ? arrays : Array_transfer(complex, mesh)();
}

Labeled_tetrahedra tetrahedra_of(const Complex& complex, const Mesh_arrays& arrays) {
  Labeled_tetrahedra result;
  result.arrays = arrays;
  const auto vertices = complex.vertices();
  const DSC::Vertex_numbers numbers(complex, vertices);
  for (const auto v : vertices) {
    const Position p = complex.user_position(v);
    result.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto c : complex.cells()) {
    auto& tetrahedron = result.tetrahedra.emplace_back();
    for (int i = 0; i < 4; ++i)
      tetrahedron[std::size_t(i)] = numbers(c->vertex(i));
    result.labels.push_back(c->subdomain_index());
  }
  return result;
}

} // namespace dsc

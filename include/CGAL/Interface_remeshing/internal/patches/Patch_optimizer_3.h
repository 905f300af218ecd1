// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_PATCH_OPTIMIZER_3_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_PATCH_OPTIMIZER_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <CGAL/Random.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A set of finite cells of a complex. Operations can change a copy of the patch before it replaces
// the cells. The boundary of the patch and the interface inside it do not change.
template <class Complex> class Patch_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // The cells must stay in the complex during the lifetime of the patch.
  Patch_3(const Complex& complex, const std::vector<Cell_handle>& cells) {
    add_by_components(complex, cells);
    m_origins = vertices_of(complex, m_replaced);
    const Vertex_numbers numbers(complex, m_origins);
    for (Vertex_handle v : m_origins)
      m_points.push_back(v->point());
    for (Cell_handle c : m_replaced)
      m_tetrahedra.push_back(corners_of(c, numbers));
  }

  // Makes `copy` a complex of the patch alone, with a separate label for each connected component
  // of equal label. Returns whether the patch is a ball; there is no copy otherwise.
  bool copy_to(Complex& copy) {
    try {
      m_copied = copy.assign(m_points, m_tetrahedra, m_components);
    } catch (const Invalid_cells_error&) {
      return false;
    }
    m_time_stamps.clear();
    for (Vertex_handle v : m_copied) {
      m_time_stamps.push_back(v->time_stamp());
      if (copy.is_boundary(v))
        Simplex_access::set_boundary_class(v, Boundary_class::fixed);
    }
    return true;
  }

  // Replaces the content of the patch by the modified copy.
  void take(const Complex& copy) {
    std::vector<Vertex_handle> vertices, origins;
    for (std::size_t i = 0; i < m_copied.size(); ++i)
      if (copy.is_alive(m_copied[i], m_time_stamps[i])) {
        vertices.push_back(m_copied[i]);
        origins.push_back(m_origins[i]);
      }
    Vertex_numbers numbers(copy, vertices);
    for (Vertex_handle v : copy.vertices())
      numbers.add(v, vertices);
    origins.resize(vertices.size()); // null for new vertices
    m_origins = std::move(origins);
    m_points.clear();
    for (Vertex_handle v : vertices)
      m_points.push_back(v->point());
    m_tetrahedra.clear();
    m_components.clear();
    for (Cell_handle c : copy.cells()) {
      m_tetrahedra.push_back(corners_of(c, numbers));
      m_components.push_back(c->subdomain_index());
    }
  }

  // Plans the replacement of the cells by the patch.
  void propose(Cavity<Complex>& cavity) const {
    cavity.begin(Proposal_kind::replacement);
    for (Cell_handle c : m_replaced)
      cavity.remove(c);
    std::vector<typename Cavity<Complex>::Index> indices;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      indices.push_back(m_origins[i] == Vertex_handle()
                            ? cavity.add(m_points[i], Boundary_class::inside)
                            : cavity.add(m_origins[i], m_points[i]));
    for (std::size_t t = 0; t < m_tetrahedra.size(); ++t) {
      const auto& v = m_tetrahedra[t];
      cavity.create({indices[v[0]], indices[v[1]], indices[v[2]], indices[v[3]]},
                    m_parents[m_components[t]]);
    }
  }

private:
  using Indices = std::array<std::size_t, 4>;

  static Indices corners_of(Cell_handle c, const Vertex_numbers& numbers) {
    const auto index = [&](int i) { return std::size_t(numbers(c->vertex(i))); };
    return {index(0), index(1), index(2), index(3)};
  }

  // Adds the cells, component by component. A component is a set of cells of one label that are
  // connected through facets. The first cell of a component becomes the parent of the new cells.
  void add_by_components(const Complex& complex, const std::vector<Cell_handle>& cells) {
    Marks unseen = cell_marks(complex);
    for (Cell_handle c : cells)
      unseen.add(c);
    for (Cell_handle seed : cells) {
      if (!unseen.has(seed))
        continue;
      const auto add = [&](Cell_handle c) {
        unseen.remove(c);
        m_replaced.push_back(c);
        m_components.push_back(typename Complex::Label(m_parents.size()));
      };
      std::size_t next = m_replaced.size();
      for (add(seed); next < m_replaced.size(); ++next)
        for (int i = 0; i < 4; ++i) {
          const Cell_handle n = m_replaced[next]->neighbor(i);
          if (unseen.has(n) && n->subdomain_index() == seed->subdomain_index())
            add(n);
        }
      m_parents.push_back(seed);
    }
  }

  std::vector<Cell_handle> m_replaced, m_parents;
  std::vector<Vertex_handle> m_origins; // origin of each vertex; null for a new vertex
  std::vector<typename Complex::Point_3> m_points;
  std::vector<Indices> m_tetrahedra;
  std::vector<typename Complex::Label> m_components; // component of each tetrahedron
  std::vector<Vertex_handle> m_copied;               // vertices of the last copy
  std::vector<std::size_t> m_time_stamps;            // time stamps of `m_copied`
};

// The objective of the optimization of a patch.
struct Patch_goal
{
  double threshold;   // quality below which a cell is bad
  double emphasis;    // exponent of the deficit of a cell
  int rings;          // layers of cells around a bad cell
  unsigned rounds;    // maximum for each improvement of a copy
  unsigned variation; // selects the random changes
};

// Returns whether a cell is below a threshold and no dihedral angle of the cell is fixed by the
// interface.
template <class Complex>
bool is_bad_at_rest(const Complex& complex, typename Complex::Cell_handle c, double threshold) {
  return c->quality() < threshold && !has_dictated_angle(complex, c);
}

// A search for better patches around bad cells. A copy of the patch is disturbed and improved
// again, several times. The complex is only read, so that several optimizers can run concurrently.
// The result depends on the cell, the complex and the goal only.
template <class Complex> class Patch_optimizer_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Vector = typename Complex::Vector_3;

  explicit Patch_optimizer_3(const Complex& complex)
      : m_complex(complex), m_copy(complex.geom_traits(), complex.quality_measure()),
        m_copy_cavity(m_copy) {}

  // Returns a better patch around the cell. If this patch is not a ball, the patches around the
  // vertices of the cell are tried. Returns `nullopt` if no better patch is found.
  std::optional<Patch_3<Complex>> run(Cell_handle c, const Patch_goal& goal) {
    static constexpr unsigned variations = 16;
    m_goal = goal;
    m_random = Random(unsigned(c->time_stamp()) * variations + goal.variation);
    m_seen.clear();
    const std::vector<Cell_handle> cells = cells_around({c}, goal.rings);
    for (Cell_handle d : cells)
      m_seen.push(d);
    bool is_ball = true;
    auto result = better_patch(cells, is_ball);
    for (int i = 0; i < 4 && !is_ball; ++i) {
      const std::vector<Vertex_handle> center(1, c->vertex(i));
      result =
          better_patch(cells_around(sorted_star_union(m_complex, center), goal.rings - 1), is_ball);
    }
    return result;
  }

  // Returns whether all cells that the last run has read are still in the complex.
  bool is_up_to_date() const {
    return std::all_of(m_seen.begin(), m_seen.end(), [&](const auto& item) {
      return m_complex.is_alive(item.cell, item.time_stamp);
    });
  }

private:
  // Returns a better patch for the cells; `nullopt` if none is found or the cells do not form a
  // ball.
  std::optional<Patch_3<Complex>> better_patch(const std::vector<Cell_handle>& cells,
                                               bool& is_ball) {
    static constexpr int tries = 10, attempts = 1;
    static constexpr double less = 1 - 1e-6; // a reduction above rounding errors
    Patch_3<Complex> patch(m_complex, cells);
    Deformation_visitor<Complex> nobody;
    double best = deficit(cells);
    const double worst = worst_quality(cells);
    bool is_better = false;
    for (int i = 0; i < tries; ++i) {
      is_ball = patch.copy_to(m_copy);
      if (!is_ball)
        return {};
      if (i > 0)
        disturb();
      Mesh_improver<Complex> improver(m_copy, nobody, m_goal.threshold, m_sequential, true);
      improver.improve_all(m_goal.threshold, m_goal.rounds, attempts);
      const auto copied = m_copy.cells();
      const double now = deficit(copied);
      if (!(now < less * best) || worst_quality(copied) < worst)
        continue;
      best = now;
      is_better = true;
      patch.take(m_copy);
      if (std::none_of(copied.begin(), copied.end(),
                       [&](Cell_handle d) { return is_bad_at_rest(m_copy, d, m_goal.threshold); }))
        break;
    }
    if (is_better)
      return patch;
    return {};
  }

  // Returns the cells and the given number of layers around them.
  std::vector<Cell_handle> cells_around(std::vector<Cell_handle> cells, int rings) const {
    for (int i = 0; i < rings; ++i)
      cells = sorted_star_union(m_complex, vertices_of(m_complex, cells));
    return cells;
  }

  // Returns the sum of the deficits of the cells to the threshold, each raised to the power
  // `emphasis`.
  double deficit(const std::vector<Cell_handle>& cells) const {
    double result = 0;
    for (Cell_handle c : cells)
      result += std::pow((std::max)(0., m_goal.threshold - c->quality()), m_goal.emphasis);
    return result;
  }

  static double worst_quality(const std::vector<Cell_handle>& cells) {
    double result = std::numeric_limits<double>::infinity();
    for (Cell_handle c : cells)
      result = (std::min)(result, c->quality());
    return result;
  }

  // Applies one or two random changes to the copy.
  void disturb() {
    const int changes = m_random.get_int(1, 3);
    for (int i = 0; i < changes; ++i)
      switch (m_random.get_int(0, 3)) {
      case 0:
        change_edge([&](Cell_handle c, int a, int b) {
          return !c->vertex(a)->is_interface() &&
                 propose_edge_collapse(m_copy, c, a, b, 0, m_copy_cavity);
        });
        break;
      case 1:
        change_edge([&](Cell_handle c, int a, int b) {
          return !m_copy.is_interface(typename Complex::Edge(c, a, b)) &&
                 propose_edge_split(m_copy, c, a, b, .5, m_copy_cavity) &&
                 m_copy_cavity.vertices().back().boundary_class == Boundary_class::inside;
        });
        break;
      default:
        move_vertices();
      }
  }

  template <class Propose> void change_edge(const Propose& propose) {
    static constexpr int tries = 8;
    const auto cells = m_copy.cells();
    for (int i = 0; i < tries; ++i) {
      const Cell_handle c = cells[m_random.get_int(0, int(cells.size()))];
      const int a = m_random.get_int(0, 4), b = (a + m_random.get_int(1, 4)) % 4;
      if (propose(c, a, b)) {
        m_copy.replace(m_copy_cavity);
        return;
      }
    }
  }

  // Moves all free vertices randomly, by a fraction of their shortest edges.
  void move_vertices() {
    static constexpr double farthest = .4, nearest = .02;
    for (Vertex_handle v : m_copy.vertices()) {
      if (v->is_interface() || m_copy.is_boundary(v))
        continue;
      m_copy.star(v, m_star);
      const auto p = m_copy.position(v);
      double shortest = std::numeric_limits<double>::infinity(); // squared
      for (Cell_handle c : m_star)
        for (int i = 0; i < 4; ++i)
          if (c->vertex(i) != v)
            shortest = (std::min)(shortest, (m_copy.position(c->vertex(i)) - p).squared_length());
      for (double part = farthest; part > nearest; part /= 2) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        const auto q = p + part * std::sqrt(shortest) * Vector(x, y, z);
        if (m_copy.is_positive_star(v, m_star, q)) {
          m_copy.set_point(v, m_star, q);
          break;
        }
      }
    }
  }

  double coordinate() { return m_random.get_double(-1, 1); }

  const Complex& m_complex;
  Patch_goal m_goal = {};
  Work_list<Cell_handle> m_seen;
  Complex m_copy;
  Cavity<Complex> m_copy_cavity;
  For_each_index m_sequential;
  Random m_random = Random(0);
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_PATCH_OPTIMIZER_3_H

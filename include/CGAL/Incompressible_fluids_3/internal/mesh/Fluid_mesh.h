// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_MESH_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_MESH_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Slip_transform.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>

#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The liquid cells of a complex, with numbered vertices. A vertex carries a velocity. It also
// carries one pressure for each liquid around it, because pressures are discontinuous between
// liquids. Where two liquids slip along each other, velocities are discontinuous, too: the vertex
// occurs twice in the mesh, once for each liquid.
template <class Complex> struct Fluid_mesh
{
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Index = std::uint32_t;
  static constexpr int dimension = Complex::dimension;
  static constexpr int corners = Complex::corners;                   // of a cell
  static constexpr bool is_periodic = !Complex::Domain::has_outside; // whether space is a torus

  struct Cell
  {
    std::array<Index, corners> vertices;
    std::array<Index, corners> pressures;
    const Liquid* liquid;
    int label;
    std::uint32_t component;
  };

  // A facet of the interface with a liquid on at least one side.
  struct Facet
  {
    std::array<Index, dimension> vertices; // as `Interface_vertices::Facet` defines
    double tension;       // energy of a unit of area: 0 until `set_tensions()` sets it
    bool is_free;         // between a liquid and void or a gas
    Index gas;            // the index of the gas, or `no_gas`
    bool is_gas_in_front; // also if it is void
    int label_behind, label_in_front;
    double friction; // of two viscous liquids: force per unit of area and of relative velocity
  };
  static constexpr Index no_gas = Index(-1);

  // A connected component of a gas.
  struct Gas_component
  {
    std::uint32_t component;
    int label;
    double volume;
  };

  // The first occurrences are along the x axis, so neighbors are near in memory. The second
  // occurrences are at the end, in the order of `slips`.
  std::vector<Vertex_handle> vertices;
  std::vector<Slip> slips; // by first occurrence
  // By vertex: the label of the only liquid that has this velocity. There is none if several
  // liquids have a common velocity.
  std::vector<std::optional<int>> labels;
  std::vector<Cell> cells;          // by their first vertices
  std::vector<Facet> facets;        // in the order of `interface_facets()`
  std::vector<Gas_component> gases; // by component
  std::vector<Index> vertex_of_pressure;
  std::vector<int> label_of_pressure;
  std::vector<char> is_on_interface; // by vertex
  // Coordinates of the sides of the domain, in the order of `Boundary_class`. They are infinite
  // where no vertex lies on a side, in particular if the domain is not a box.
  std::array<double, 6> sides;

  // Constructs the mesh. Takes O(n log n) time.
  // \pre The components are up to date.
  Fluid_mesh(const Complex& complex, const Fluid_properties& properties)
      : m_domain(complex.domain()) {
    sides.fill(std::numeric_limits<double>::infinity());
    for (Vertex_handle v : complex.finite_vertices()) {
      for (std::size_t side = 0; side < sides.size(); ++side)
        if (v->boundary_class() >> side & 1)
          sides[side] = complex.position(v)[int(side / 2)];
    }
    std::vector<Cell_handle> liquid;
    for (Cell_handle c : complex.finite_cells())
      if (properties.liquid(c->subdomain_index()))
        liquid.push_back(c);
    vertices = vertices_of(complex, liquid);
    sort_along_axis(complex);
    const Vertex_numbers numbers(complex, vertices);
    for (Vertex_handle v : vertices)
      is_on_interface.push_back(v->is_interface());
    add_cells(liquid, numbers, properties);
    if (!properties.gases().empty())
      add_gases(complex, properties);
    add_facets(complex, numbers, properties);
    add_slips(complex);
    number_pressures();
  }

  // Returns the occurrence of a vertex for the liquid with a label, given its first occurrence.
  // Returns the first one if there is only one.
  Index occurrence(Index first, int label) const {
    const Index second = m_second[first];
    return second != 0 && labels[second] == label ? second : first;
  }

  // Returns the pressure of the liquid with a label at an occurrence of a vertex.
  // \pre The occurrence belongs to the liquid.
  Index pressure(Index v, int label) const {
    Index p = m_pressure_of_vertex[v];
    while (label_of_pressure[p] != label)
      ++p;
    return p;
  }

  std::size_t number_of_vertices() const { return vertices.size() - slips.size(); }

  // Returns whether the liquid behind a facet has the first occurrences of its vertices.
  bool is_first_behind(const Facet& facet) const {
    return std::any_of(facet.vertices.begin(), facet.vertices.end(),
                       [&](Index v) { return labels[v] == facet.label_behind; });
  }

  // Returns the first occurrence of a vertex.
  Index first(Index v) const {
    return v < number_of_vertices() ? v : slips[v - number_of_vertices()].first;
  }

  // Returns the velocities or accelerations with which vertices move. Both occurrences of a vertex
  // have the same.
  Vectors_3 common(Vectors_3 vectors) const {
    for (const Slip& slip : slips)
      vectors[slip.first] = vectors[slip.second] =
          (1 - slip.share) * vectors[slip.first] + slip.share * vectors[slip.second];
    return vectors;
  }

  Vectors_3 positions(const Complex& complex) const {
    Vectors_3 result;
    for (Vertex_handle v : vertices)
      result.push_back(eigen_vector(complex.position(v)));
    return result;
  }

  // Returns the image of q that is nearest to p. Except on a torus, this is q.
  Eigen::Vector3d nearest_image(const Eigen::Vector3d& p, const Eigen::Vector3d& q) const {
    if constexpr (is_periodic) {
      using Point = typename Complex::Point;
      return eigen_vector(m_domain.nearest_image(from_eigen<Point>(p), from_eigen<Point>(q)));
    } else
      return q;
  }

  // Returns the positions of the corners of a cell, a facet or an edge. On a torus, these are the
  // images that are nearest to the first corner.
  template <std::size_t n>
  Corners_3<n> corners_at(const std::array<Index, n>& vertices_of_simplex,
                          const Vectors_3& positions) const {
    Corners_3<n> result;
    result[0] = positions[vertices_of_simplex[0]];
    for (std::size_t i = 1; i < n; ++i)
      result[i] = nearest_image(result[0], positions[vertices_of_simplex[i]]);
    return result;
  }

  // Returns the barycenter of a cell. On a torus, this is the image in the box.
  Eigen::Vector3d barycenter(std::size_t cell, const Vectors_3& positions) const {
    if constexpr (is_periodic) {
      Eigen::Vector3d result = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& p : corners_at(cells[cell].vertices, positions))
        result += p / corners;
      using Point = typename Complex::Point;
      return eigen_vector(m_domain.canonical(from_eigen<Point>(result)));
    } else
      return middle(cell, positions);
  }

  // Returns whether liquids can move. On a torus, this includes a liquid that fills the torus.
  bool can_move() const { return is_periodic ? !cells.empty() : !facets.empty(); }

  // The fraction of the mass of a cell that is located at its barycenter, and moves with the mean
  // velocity of its vertices. The remaining mass is located at the vertices. With 0.8, the mass
  // matrix is that of linear elements, and short waves are too fast. With 0, they are too slow (G.
  // L. Goudreau and R. L. Taylor, "Evaluation of numerical integration methods in elastodynamics",
  // 1973). The value was chosen so that the speed of waves with a length of eight edges is most
  // accurate on regular meshes.
  static constexpr double part_at_middle = dimension == 2 ? .65 : .7;

  // Returns the mean of the vectors at the vertices of a cell.
  Eigen::Vector3d middle(std::size_t cell, const Vectors_3& vectors) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (Index v : cells[cell].vertices)
      result += vectors[v] / corners;
    return result;
  }

  // Sets the components of velocities or accelerations to 0 that would move vertices off the sides
  // of the domain.
  void keep_on_sides(Vectors_3& vectors) const {
    for (std::size_t v = 0; v < vectors.size(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (Boundary_class::fixes(vertices[v]->boundary_class(), axis))
          vectors[v][axis] = 0;
  }

private:
  // Sorts the vertices by their x coordinates, and then by time stamp.
  void sort_along_axis(const Complex& complex) {
    // All time stamps are different, so the order is unique.
    std::vector<std::tuple<double, std::size_t, Vertex_handle>> keys;
    for (Vertex_handle v : vertices)
      keys.emplace_back(complex.position(v)[0], v->time_stamp(), v);
    std::sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) {
      return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    vertices.clear();
    for (const auto& key : keys)
      vertices.push_back(std::get<2>(key));
  }

  // Adds cells by their first vertices, and then by time stamp. Sorts by counting, because the
  // cells of a large complex are far apart in memory: each one is visited once.
  void add_cells(const std::vector<Cell_handle>& liquid, const Vertex_numbers& numbers,
                 const Fluid_properties& properties) {
    struct Stamped
    {
      std::size_t stamp;
      Index first;
      Cell cell;
    };
    std::vector<Stamped> unordered;
    unordered.reserve(liquid.size());
    std::vector<std::size_t> begin(vertices.size() + 1, 0); // of the cells of each first vertex
    for (Cell_handle c : liquid) {
      Cell cell{
          {}, {}, properties.liquid(c->subdomain_index()), c->subdomain_index(), c->component()};
      for (std::size_t i = 0; i < corners; ++i)
        cell.vertices[i] = numbers(c->vertex(int(i)));
      const Index first = *std::min_element(cell.vertices.begin(), cell.vertices.end());
      unordered.push_back({c->time_stamp(), first, cell});
      ++begin[first + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::pair<std::size_t, std::size_t>> order(liquid.size()); // stamps and places
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t k = 0; k < unordered.size(); ++k)
      order[next[unordered[k].first]++] = {unordered[k].stamp, k};
    cells.reserve(liquid.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      std::sort(order.begin() + std::ptrdiff_t(begin[v]),
                order.begin() + std::ptrdiff_t(begin[v + 1]));
      for (std::size_t k = begin[v]; k < begin[v + 1]; ++k)
        cells.push_back(unordered[order[k].second].cell);
    }
  }

  void add_gases(const Complex& complex, const Fluid_properties& properties) {
    std::map<std::uint32_t, Gas_component> components;
    for (auto c : complex.cells())
      if (properties.gas(c->subdomain_index())) {
        const auto component = components.emplace(
            c->component(), Gas_component{c->component(), c->subdomain_index(), 0.});
        component.first->second.volume += complex.measure(c);
      }
    for (const auto& component : components)
      gases.push_back(component.second);
  }

  // Returns the index of the gas of a cell, or `no_gas`.
  Index gas_of(Cell_handle c) const {
    const auto found =
        std::lower_bound(gases.begin(), gases.end(), c->component(),
                         [](const Gas_component& a, std::uint32_t b) { return a.component < b; });
    return found != gases.end() && found->component == c->component() ? Index(found - gases.begin())
                                                                      : no_gas;
  }

  void add_facets(const Complex& complex, const Vertex_numbers& numbers,
                  const Fluid_properties& properties) {
    for (const auto& f : complex.interface_facets()) {
      const int behind = f.first->subdomain_index(),
                in_front = f.first->neighbor(f.second)->subdomain_index();
      const bool is_behind = properties.liquid(behind), is_in_front = properties.liquid(in_front);
      if (!is_behind && !is_in_front)
        continue;
      const bool is_free = is_behind != is_in_front;
      const Index gas =
          !is_free ? no_gas : gas_of(is_behind ? f.first->neighbor(f.second) : f.first);
      Facet facet{{},        0,      is_free,  gas,
                  is_behind, behind, in_front, is_free ? 0 : friction(complex, f, properties)};
      const auto ends = complex.facet_vertices(f);
      for (std::size_t i = 0; i < dimension; ++i)
        facet.vertices[i] = numbers(ends[i]);
      facets.push_back(facet);
    }
  }

  // Returns the friction of two liquids at a facet. It is zero unless both are viscous. The layers
  // of the liquids that resist the relative velocity are thinner than their cells. So the liquids
  // stick to each other where the mesh resolves their viscosity, and slip elsewhere.
  static double friction(const Complex& complex, const typename Complex::Facet& f,
                         const Fluid_properties& properties) {
    static constexpr double layers = 20; // number in a cell; only one of them resists
    double resistance = 0;               // of the layers on both sides
    const auto ends = complex.facet_vertices(f);
    const auto first = complex.position(ends[0]);
    Corners_3<std::size_t(dimension)> positions;
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] = eigen_vector(complex.position_near(first, ends[i]));
    const double area = area_vector(positions).norm();
    for (Cell_handle c : {f.first, f.first->neighbor(f.second)}) {
      const double viscosity = properties.liquid(c->subdomain_index())->viscosity;
      if (!(viscosity > 0))
        return 0;
      const double height = dimension * complex.measure(c) / area;
      resistance += height / viscosity;
    }
    return resistance > 0 ? layers / resistance : 0;
  }

  // The liquids around a vertex.
  struct Around
  {
    static constexpr int nothing = (std::numeric_limits<int>::max)();

    int least = nothing, largest = nothing; // labels
    bool is_shared = false;                 // by more than two media
    std::array<double, 2> masses{};         // of the liquids with these labels
  };

  // Finds the vertices that belong to two liquids and to no other medium, and adds their second
  // occurrences, for the liquid with the larger label.
  void add_slips(const Complex& complex) {
    constexpr int nothing = Around::nothing;
    std::vector<Around> around(vertices.size());
    for (const Cell& cell : cells)
      for (Index v : cell.vertices) {
        Around& a = around[v];
        const bool is_known = cell.label == a.least || cell.label == a.largest;
        if (a.least == nothing) {
          a.least = a.largest = cell.label;
        } else if (!is_known) {
          a.is_shared = a.is_shared || a.least != a.largest;
          a.least = (std::min)(a.least, cell.label);
          a.largest = (std::max)(a.largest, cell.label);
        }
      }
    for (const Facet& facet : facets)
      if (facet.is_free)
        for (Index v : facet.vertices)
          around[v].is_shared = true;
    const auto is_mixed = [&](Index v) { return around[v].least != around[v].largest; };
    const Vectors_3 at = positions(complex);
    for (const Cell& cell : cells) {
      if (std::none_of(cell.vertices.begin(), cell.vertices.end(), is_mixed))
        continue;
      const double mass = cell.liquid->density * volume(corners_at(cell.vertices, at));
      for (Index v : cell.vertices)
        around[v].masses[cell.label != around[v].least] += mass;
    }
    m_second.assign(vertices.size(), 0);
    for (Index v = 0; v < around.size(); ++v) {
      const Around& a = around[v];
      labels.push_back(a.least == a.largest ? std::optional<int>(a.least) : std::nullopt);
      const double mass = a.masses[0] + a.masses[1];
      if (a.least == a.largest || a.is_shared || !(a.masses[0] > 0) || !(a.masses[1] > 0))
        continue;
      m_second[v] = Index(vertices.size());
      slips.push_back({v, m_second[v], a.masses[1] / mass});
      labels[v] = a.least;
      vertices.push_back(vertices[v]);
    }
    for (const Slip& slip : slips) {
      labels.push_back(around[slip.first].largest);
      is_on_interface.push_back(true);
    }
    for (Cell& cell : cells)
      for (Index& v : cell.vertices)
        if (m_second[v] != 0 && cell.label != around[v].least)
          v = m_second[v];
  }

  // Numbers the pressures in the order of vertices. Most vertices have only one pressure.
  void number_pressures() {
    std::vector<char> has_first(vertices.size(), false);
    std::vector<int> first_label(vertices.size());
    std::set<std::pair<Index, int>> others;
    for (const Cell& cell : cells)
      for (Index v : cell.vertices)
        if (!has_first[v]) {
          has_first[v] = true;
          first_label[v] = cell.label;
        } else if (first_label[v] != cell.label)
          others.emplace(v, cell.label);
    auto other = others.begin();
    for (Index v = 0; v < vertices.size(); ++v) {
      m_pressure_of_vertex.push_back(Index(vertex_of_pressure.size()));
      vertex_of_pressure.push_back(v);
      label_of_pressure.push_back(first_label[v]);
      for (; other != others.end() && other->first == v; ++other) {
        vertex_of_pressure.push_back(v);
        label_of_pressure.push_back(other->second);
      }
    }
    for (Cell& cell : cells)
      for (std::size_t i = 0; i < corners; ++i)
        cell.pressures[i] = pressure(cell.vertices[i], cell.label);
  }

  typename Complex::Domain m_domain;
  std::vector<Index> m_second;             // the second occurrence, by the first; 0 if none
  std::vector<Index> m_pressure_of_vertex; // the first one
};

// The mesh of the liquids, and the positions and the motion of its vertices.
template <class Complex> struct Liquid_flow
{
  Fluid_mesh<Complex> mesh;
  Vectors_3 positions, velocities, accelerations;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_MESH_H

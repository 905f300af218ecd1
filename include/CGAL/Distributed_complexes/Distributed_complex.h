// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_COMPLEX_H
#define CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_COMPLEX_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/hilbert_order.h>
#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/Distributed_graph.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_components.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Placement.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

A deformable simplicial complex that is distributed among ranks. Each vertex has an owner. A rank
holds all cells around its vertices, and a cell is owned by the owner of its vertex with the least
id. Vertices have ids that do not depend on the ranks.

The functions of this package give a bitwise identical complex for any number of ranks and any
partition. Equal complexes have equal checksums.

All member functions are collective unless they say otherwise: all ranks call them in the same
order.

\tparam Complex_ the type of a complex in a ball on one rank, such as
        `Deformable_simplicial_complex_3<Traits>`
*/
template <class Complex_> class Distributed_complex
{
public:
  using Complex = Complex_; ///< complex on one rank
  /// Part of the complex that a rank improves, see `Part_domain`.
  using Part = typename internal::Part_of<Complex>::Type;
  using Point = typename Complex::Point;               ///< position
  using Label = typename Complex::Label;               ///< name of a phase
  using size_type = std::uint64_t;                     ///< number of simplices
  static constexpr int dimension = Complex::dimension; ///< dimension of space
  /// Returns the rank that owns the vertex `i` of a complex of n vertices, in their order.
  using Owner = std::function<int(std::size_t i)>;

  /// Constructs an empty complex.
  /// \param communicator the ranks; it must outlive the complex
  explicit Distributed_complex(Communicator& communicator) : m_mesh(communicator) {}

  /// Returns the communicator. Not collective.
  Communicator& communicator() const { return *m_mesh.communicator; }

  /*!
  Distributes a complex of the first rank. Vertices are divided along a Hilbert curve into parts of
  equal size.

  \param complex the complex, on the first rank; other ranks give any complex

  n log n in the number of cells, on the first rank.
  */
  void distribute(const Complex& complex) {
    std::vector<int> owners;
    communicator().call_together([&] {
      if (m_mesh.rank() != 0)
        return;
      std::vector<Point> positions;
      for (auto v : complex.vertices())
        positions.push_back(complex.position(v));
      const std::size_t n = positions.size(), size = std::size_t(communicator().size());
      owners.resize(n);
      const auto order = internal::hilbert_order<typename Complex::Space>(positions);
      for (std::size_t i = 0; i < n; ++i)
        owners[order[i]] = int(i * size / n);
    });
    distribute(complex, [&](std::size_t i) { return owners[i]; });
  }

  /*!
  Distributes a complex of the first rank.

  \param complex the complex, on the first rank; other ranks give any complex
  \param owner function object `int owner(i)` that returns the owner of the vertex `i` of
         `complex.vertices()`; called on the first rank only. It must not throw.
  \throws Error on all ranks if `owner` returns a number outside [0, `communicator().size()`); the
          complex is then unchanged

  n log n in the number of cells, on the first rank.
  */
  void distribute(const Complex& complex, const Owner& owner);

  /// Gives each vertex a new owner. The vertices and their cells are sent to the new owners. n log
  /// n in the number of cells of a rank.
  /// \param owner function object `int owner(id, position)`; called for the vertices of this rank, in
  ///        the order of `graph()`
  /// \pre `owner` returns a number in [0, size()) and does not throw
  template <class New_owner> void migrate(const New_owner& owner);

  /// Returns the work of the rank with the most work, relative to the mean of all ranks: 1 if the
  /// ranks are balanced. The work of a rank is the sum of the weights in `graph()`.
  double imbalance() const;

  /// Returns the graph of the vertices, for partitioners. The weight of a vertex grows with the
  /// number of recent improvements of the cells around it.
  Distributed_graph<Complex_::dimension> graph() const;

  /*!
  Repartitions the complex if `imbalance()` exceeds a limit.

  \param partitioner function object that returns the new owner of each own vertex, such as
         `Curve_partitioner` or `Scotch_partitioner`
  \param limit the limit, at least 1
  \return whether the complex was repartitioned
  \throws what the partitioner throws; the complex is then unchanged
  */
  template <class Partitioner = Curve_partitioner>
  bool rebalance(const Partitioner& partitioner = Partitioner(), double limit = 1.2) {
    if (!(imbalance() > limit))
      return false;
    const std::vector<int> owners = partitioner(communicator(), graph());
    std::size_t next = 0; // own vertices are visited in the order of the graph
    migrate([&](internal::Global_id, const Point&) { return owners[next++]; });
    return true;
  }

  /// Returns the whole complex on the first rank, and an empty complex on the others. Points,
  /// cells, labels and normalization are kept; the state of remeshing is not. n log n in the number
  /// of cells, on the first rank.
  /// \throws Error on all ranks if the complex cannot be assembled; the distributed complex is
  ///         unchanged
  Complex gather() const;

  /// Returns a hash of the vertices and cells of all ranks, including ids, labels and the state of
  /// remeshing. It does not depend on the partition. Linear in the number of cells of a rank.
  std::uint64_t checksum() const;

  /// Returns the number of cells of all ranks.
  size_type number_of_cells() const { return total(number_of_own_cells()); }
  /// Returns the number of vertices of all ranks.
  size_type number_of_vertices() const { return total(number_of_own_vertices()); }
  /// Returns the number of cells that this rank owns. Not collective.
  size_type number_of_own_cells() const { return size_type(m_mesh.own_cells().size()); }
  /// Returns the number of vertices that this rank owns. Not collective.
  size_type number_of_own_vertices() const { return size_type(m_mesh.own_vertices().size()); }
  /// Returns the number of cells that this rank holds. Not collective.
  size_type number_of_held_cells() const { return size_type(m_mesh.piece.cells().size()); }
  /// Returns the approximate number of bytes that this rank uses for the complex. Not collective.
  std::size_t memory() const { return m_mesh.piece.memory(); }

  /// Returns the number of connected components of a label. Not collective.
  std::size_t number_of_components(Label label) const {
    std::size_t result = 0;
    for (const auto& [number, component] : m_mesh.components)
      result += component.label == label;
    return result;
  }

  /// Returns the mean length of the interface edges when the complex was built. `refine_3()` halves
  /// it. Not collective.
  double mean_interface_edge() const { return m_mesh.mean_interface_edge; }

  /// Returns the map to user coordinates, see `Labeled_complex::Normalization`. Not collective.
  const typename Complex::Normalization& normalization() const { return m_mesh.normalization; }

  /// Returns the lower and the upper corner of the box around the complex.
  std::array<Point, 2> bounding_box() const {
    const auto box = m_mesh.extent();
    std::array<std::array<double, dimension>, 2> corners;
    for (int k = 0; k < dimension; ++k)
      for (int side : {0, 1})
        corners[side][k] = side == 0 ? box.lower(k) : box.upper(k);
    return {point_at<Complex>(corners[0]), point_at<Complex>(corners[1])};
  }

  /*!
  The part of the interface on this rank: all interface vertices that it holds, and all interface
  facets around its own vertices. Interface velocities receive the snapshot. Vertices are ordered by
  their ids; handles in the snapshot are null.
  */
  struct Interface
  {
    Interface_snapshot<Complex> snapshot = Interface_snapshot<Complex>(Complex()); ///< the facets
    std::vector<Point> positions;       ///< of the vertices
    std::vector<std::uint32_t> indices; ///< internal numbers of the vertices
  };

  /// Returns the interface that this rank holds.
  Interface interface_here() const;

  /// Returns whether this rank owns a facet. The owner of its vertex with the least id owns the
  /// facet. Not collective.
  bool owns(const Interface& interface_,
            const typename Interface_snapshot<Complex>::Facet& facet) const {
    const auto first = *std::min_element(facet.vertices.begin(), facet.vertices.end());
    return m_mesh.is_own(interface_.indices[first]);
  }

  /// Replaces the values of vertices of other ranks by the values of their owners. Linear in the
  /// number of vertices here.
  /// \param interface_ the interface
  /// \param values a value for each vertex of the interface: a trivially copyable one, or a point or
  ///        a vector
  template <class Value> void share(const Interface& interface_, std::vector<Value>& values) const {
    std::vector<Value> of_index(m_mesh.piece.vertex_bound());
    for (std::size_t i = 0; i < values.size(); ++i)
      of_index[interface_.indices[i]] = values[i];
    m_mesh.ghosts.update(of_index);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = of_index[interface_.indices[i]];
  }

  /// Measures of a label, equal on all ranks.
  struct Label_measures
  {
    Label label;              ///< the label
    size_type cells;          ///< number of cells
    double measure;           ///< volume; area in the plane
    double interface_measure; ///< area of the interface of the label; length in the plane
    std::size_t components;   ///< number of connected components
    /// V - E + F of the interface of the label; V - E in the plane
    std::int64_t euler_characteristic;
  };
  /// Returns the measures of all labels, by increasing label. n log n in the size of the interface
  /// here, and linear in the number of cells.
  std::vector<Label_measures> label_measures() const;

  /// The vertices, cells and components of this rank, which a motion changes.
  class State
  {
    friend Distributed_complex;
    internal::Distributed_state<dimension> m_state;
  };
  /// Returns the state on this rank. Not collective.
  State state() const {
    State result;
    result.m_state = m_mesh;
    return result;
  }
  /// Restores the state of this rank. All ranks must restore states of the same time before the
  /// next collective call. Not collective.
  /// \pre `distribute()`, `refine_3()` and `read_checkpoint()` were not called since
  void restore(const State& state) {
    static_cast<internal::Distributed_state<dimension>&>(m_mesh) = state.m_state;
    m_mesh.find_ghosts();
  }

  /// The distributed mesh, for the functions of this package.
  using Mesh = internal::Distributed_mesh<Complex>;
  /// Returns the mesh, for the functions of this package. Not collective.
  Mesh& mesh() { return m_mesh; }
  /// Returns the mesh, for the functions of this package. Not collective.
  const Mesh& mesh() const { return m_mesh; }

private:
  static constexpr int d = dimension;
  using Index = typename Mesh::Index;
  using Vertex = internal::Piece_vertex<d>;
  using Cell = internal::Sent_cell<d>;

  // What all ranks know about the complex.
  struct Common
  {
    std::array<double, d> translation;
    double scale, mean_interface_edge, minimum_interface_edge, domain_measure;
    internal::Global_id next_id;
  };

  size_type total(size_type number) const {
    return size_type(communicator().reduced(Communicator::Operation::sum, std::int64_t(number)));
  }

  void set_common(Common common) {
    internal::Message_writer writer;
    if (m_mesh.rank() == 0)
      writer.write(common);
    const auto all = communicator().all_gather(writer.take());
    common = internal::Message_reader(all[0]).template read<Common>();
    m_mesh.normalization = {vector_of<Complex>(common.translation), common.scale};
    m_mesh.mean_interface_edge = common.mean_interface_edge;
    m_mesh.minimum_interface_edge = common.minimum_interface_edge;
    m_mesh.domain_measure = common.domain_measure;
    m_mesh.next_id = common.next_id;
  }

  // Replaces the piece by the cells that arrive.
  void place(internal::Placement<d>& placement) {
    m_mesh.piece = internal::Piece<d>();
    placement.send(communicator(), m_mesh.piece);
    m_mesh.find_ghosts();
  }

  // Numbers the components of a new complex.
  void find_components() {
    m_mesh.components.clear();
    internal::Distributed_components<Complex>(m_mesh).update();
    m_mesh.are_components_known = true;
  }

  Mesh m_mesh;
};

template <class Complex>
void Distributed_complex<Complex>::distribute(const Complex& complex, const Owner& owner) {
  Common common = {};
  internal::Placement<d> placement;
  communicator().call_together([&] {
    if (m_mesh.rank() != 0)
      return;
    const auto handles = complex.vertices();
    std::vector<Vertex> vertices(handles.size());
    internal::Extent<d> box;
    for (std::size_t i = 0; i < handles.size(); ++i) {
      Vertex& v = vertices[i];
      v = Vertex{};
      v.id = i;
      v.owner = owner(i);
      if (v.owner < 0 || v.owner >= communicator().size())
        throw Error("the owner of a vertex is not one of the ranks: use 0 to size - 1");
      v.point = coordinates_of<d>(complex.position(handles[i]));
      box.add(v.point);
      v.spacing = handles[i]->spacing();
      v.boundary_class = handles[i]->boundary_class();
    }
    const Vertex_numbers numbers(complex, handles);
    std::vector<Cell> cells;
    for (auto c : complex.cells()) {
      cells.push_back(Cell{});
      for (int i = 0; i <= d; ++i)
        cells.back().vertices[i] = numbers(c->vertex(i));
      cells.back().vertices = internal::canonical_cell(cells.back().vertices);
      cells.back().data.label = c->subdomain_index();
      cells.back().data.noted_quality = c->noted_quality();
      cells.back().data.failures = c->failures();
    }
    placement.add(vertices, cells);
    common = {coordinates_of<d>(complex.normalization().translation),
              complex.normalization().scale,
              complex.mean_interface_edge(),
              complex.minimum_interface_edge(),
              box.measure(),
              internal::Global_id(handles.size())};
  });
  set_common(common);
  place(placement);
  find_components();
}

template <class Complex>
template <class New_owner>
void Distributed_complex<Complex>::migrate(const New_owner& owner) {
  std::vector<int> owners(m_mesh.piece.vertex_bound(), 0);
  for (Index v : m_mesh.own_vertices())
    owners[v] = owner(m_mesh.piece.vertex(v).id, m_mesh.position(v));
  m_mesh.ghosts.update(owners);
  std::vector<Vertex> vertices;
  std::vector<Cell> cells;
  for (Index v : m_mesh.piece.vertices()) {
    vertices.push_back(m_mesh.piece.vertex(v));
    vertices.back().owner = owners[v];
  }
  for (Index c : m_mesh.own_cells())
    cells.push_back(m_mesh.piece.sent(c));
  internal::Placement<d> placement;
  placement.add(vertices, cells);
  place(placement);
}

template <class Complex> double Distributed_complex<Complex>::imbalance() const {
  std::int64_t own = 0;
  for (Index v : m_mesh.own_vertices())
    own += m_mesh.weight(v);
  const std::int64_t sum = communicator().reduced(Communicator::Operation::sum, own),
                     most = communicator().reduced(Communicator::Operation::maximum, own);
  return sum > 0 ? double(most) * double(communicator().size()) / double(sum) : 1;
}

template <class Complex>
auto Distributed_complex<Complex>::graph() const -> Distributed_graph<Complex::dimension> {
  Distributed_graph<d> result;
  result.first.push_back(0);
  for (size_type number :
       internal::gather_items<size_type>(communicator(), {number_of_own_vertices()}))
    result.first.push_back(result.first.back() + std::int64_t(number));
  const auto box = m_mesh.extent();
  std::vector<std::int64_t> numbers(m_mesh.piece.vertex_bound(), 0);
  std::int64_t next = result.first[m_mesh.rank()];
  for (Index v : m_mesh.own_vertices())
    numbers[v] = next++;
  m_mesh.ghosts.update(numbers);
  std::vector<std::int64_t> neighbors;
  for (Index v : m_mesh.own_vertices()) {
    neighbors.clear();
    m_mesh.for_each_neighbor(v, [&](Index w) { neighbors.push_back(numbers[w]); });
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    result.begin.push_back(std::int64_t(result.neighbors.size()));
    result.neighbors.insert(result.neighbors.end(), neighbors.begin(), neighbors.end());
    result.weights.push_back(m_mesh.weight(v));
    result.positions.push_back(box.in_unit_cube(m_mesh.piece.vertex(v).point));
  }
  result.begin.push_back(std::int64_t(result.neighbors.size()));
  return result;
}

template <class Complex> Complex Distributed_complex<Complex>::gather() const {
  std::vector<Vertex> vertices;
  std::vector<Cell> cells;
  for (Index v : m_mesh.own_vertices())
    vertices.push_back(m_mesh.piece.vertex(v));
  for (Index c : m_mesh.own_cells())
    cells.push_back(m_mesh.piece.sent(c));
  internal::Message_writer writer;
  writer.write(vertices);
  writer.write(cells);
  std::vector<Communicator::Message> messages;
  messages.push_back({0, writer.take()});
  Complex result;
  const auto arrived = communicator().exchange(std::move(messages));
  communicator().call_together([&] {
    if (m_mesh.rank() != 0)
      return;
    vertices.clear();
    cells.clear();
    for (const auto& message : arrived) {
      internal::Message_reader reader(message.bytes);
      const auto some_vertices = reader.template read_list<Vertex>();
      const auto some_cells = reader.template read_list<Cell>();
      vertices.insert(vertices.end(), some_vertices.begin(), some_vertices.end());
      cells.insert(cells.end(), some_cells.begin(), some_cells.end());
    }
    std::sort(vertices.begin(), vertices.end(),
              [](const Vertex& a, const Vertex& b) { return a.id < b.id; });
    std::sort(cells.begin(), cells.end(), internal::less_vertices<d>);
    std::vector<typename Complex::Point> points;
    std::unordered_map<internal::Global_id, std::size_t> numbers;
    for (const Vertex& v : vertices) {
      numbers.emplace(v.id, points.size());
      points.push_back(point_at<Complex>(v.point));
    }
    std::vector<std::array<std::size_t, std::size_t(d) + 1>> indices;
    std::vector<Label> labels;
    for (const Cell& c : cells) {
      indices.emplace_back();
      for (int i = 0; i <= d; ++i)
        indices.back()[i] = numbers.at(c.vertices[i]);
      labels.push_back(c.data.label);
    }
    if (!indices.empty())
      result.assign(points, indices, labels);
    result.set_normalization(m_mesh.normalization);
  });
  return result;
}

template <class Complex> std::uint64_t Distributed_complex<Complex>::checksum() const {
  std::uint64_t sum = 0; // of the ranks, modulo 2^64
  const auto bits = [](double x) {
    std::uint64_t result;
    std::memcpy(&result, &x, sizeof(result));
    return result;
  };
  for (Index v : m_mesh.own_vertices()) {
    const Vertex& vertex = m_mesh.piece.vertex(v);
    std::uint64_t hash = internal::mixed(vertex.id);
    for (double x : vertex.point)
      hash = internal::mixed(hash ^ bits(x));
    hash = internal::mixed(hash ^ bits(vertex.spacing));
    sum += internal::mixed(hash ^ vertex.boundary_class);
  }
  for (Index c : m_mesh.own_cells()) {
    const auto& data = m_mesh.piece.cell(c).data;
    std::uint64_t hash = internal::hash_of(m_mesh.piece.ids(c));
    hash = internal::mixed(hash ^ std::uint32_t(data.label));
    hash = internal::mixed(hash ^ bits(data.noted_quality));
    sum += internal::mixed(hash ^ data.failures);
  }
  // Halves of 32 bits, whose sums cannot overflow.
  std::vector<std::int64_t> halves = {std::int64_t(sum >> 32), std::int64_t(sum & 0xffffffff)};
  communicator().reduce(Communicator::Operation::sum, halves);
  return (std::uint64_t(halves[0]) << 32) + std::uint64_t(halves[1]);
}

template <class Complex> auto Distributed_complex<Complex>::interface_here() const -> Interface {
  Interface result;
  const std::vector<std::uint8_t> flags = m_mesh.interface_flags();
  const auto& piece = m_mesh.piece;
  for (Index v : piece.vertices())
    if (flags[v])
      result.indices.push_back(v);
  std::sort(result.indices.begin(), result.indices.end(),
            [&](Index v, Index w) { return piece.vertex(v).id < piece.vertex(w).id; });
  std::vector<std::size_t> number(piece.vertex_bound(), 0);
  for (std::size_t i = 0; i < result.indices.size(); ++i) {
    number[result.indices[i]] = i;
    result.positions.push_back(m_mesh.position(result.indices[i]));
  }
  result.snapshot.vertices.resize(result.indices.size());
  // Each facet of the interface around the vertices, from the cell with the larger label.
  struct Side
  {
    std::array<std::size_t, std::size_t(d)> sorted; // numbers of the vertices
    Index cell;
    int opposite;
  };
  std::vector<Side> sides;
  for (Index c : piece.cells()) {
    const auto& vertices = piece.cell(c).vertices;
    for (int i = 0; i <= d; ++i) {
      Side side = {{}, c, i};
      bool is_on_interface = true;
      for (int k = 1; k <= d; ++k) {
        const Index v = vertices[(i + k) % (d + 1)];
        is_on_interface = is_on_interface && flags[v];
        side.sorted[k - 1] = number[v];
      }
      if (!is_on_interface)
        continue;
      std::sort(side.sorted.begin(), side.sorted.end());
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted
                                : piece.cell(a.cell).data.label > piece.cell(b.cell).data.label;
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    const Label behind = piece.cell(a.cell).data.label, in_front = piece.cell(b.cell).data.label;
    if (a.sorted != b.sorted || behind == in_front)
      continue;
    typename Interface_snapshot<Complex>::Facet facet;
    for (int k = 0; k < d; ++k)
      facet.vertices[k] =
          number[piece.cell(a.cell).vertices[Complex::Space::facet_vertices[a.opposite][k]]];
    facet.behind = behind;
    facet.in_front = in_front;
    result.snapshot.facets().push_back(facet);
  }
  return result;
}

template <class Complex>
auto Distributed_complex<Complex>::label_measures() const -> std::vector<Label_measures> {
  // Exponents of the units of measures, relative to the box; sums do not overflow.
  static constexpr int bits = 56, interface_bits = 36;
  using Space = typename Complex::Space;
  std::vector<Label_measures> result;
  for (const auto& [number, component] : m_mesh.components)
    result.push_back({component.label, 0, 0, 0, 1, 0});
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.label < b.label; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (kept > 0 && result[kept - 1].label == result[i].label)
      ++result[kept - 1].components;
    else
      result[kept++] = result[i];
  result.resize(kept);
  const auto place = [&](Label label) {
    return std::size_t(
        std::lower_bound(result.begin(), result.end(), label,
                         [](const Label_measures& m, Label l) { return m.label < l; }) -
        result.begin());
  };
  // Cells, measures, measures of the interface and characteristics of all labels, as integers.
  std::vector<std::int64_t> numbers(4 * kept, 0);
  const double volume_unit = std::ldexp(m_mesh.domain_measure, -bits);
  const double side = std::pow(m_mesh.domain_measure, 1. / d);
  const double interface_unit = std::ldexp(m_mesh.domain_measure / side, -interface_bits);
  for (Index c : m_mesh.own_cells()) {
    const std::size_t i = 4 * place(m_mesh.piece.cell(c).data.label);
    ++numbers[i];
    numbers[i + 1] += std::llrint(m_mesh.measure(c) / volume_unit);
  }
  const Interface interface_ = interface_here();
  using Edge = std::array<std::size_t, 3>; // label, ends; a vertex has equal ends
  std::vector<Edge> edges;
  for (const auto& facet : interface_.snapshot.facets())
    for (Label label : {facet.behind, facet.in_front}) {
      const std::size_t i = place(label);
      if (owns(interface_, facet)) {
        std::array<Point, std::size_t(d)> corners;
        for (int k = 0; k < d; ++k)
          corners[k] = interface_.positions[facet.vertices[k]];
        numbers[4 * i + 2] += std::llrint(Space::facet_measure(corners) / interface_unit);
        numbers[4 * i + 3] += d == 3;
      }
      for (int k = 0; k < d; ++k)
        for (int l = 0; l <= k; ++l) {
          const auto ends = std::minmax(facet.vertices[k], facet.vertices[l]);
          if (m_mesh.is_own(interface_.indices[ends.first]))
            edges.push_back({i, ends.first, ends.second});
        }
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const Edge& edge : edges)
    numbers[4 * edge[0] + 3] += edge[1] == edge[2] ? 1 : -1;
  communicator().reduce(Communicator::Operation::sum, numbers);
  for (std::size_t i = 0; i < kept; ++i) {
    result[i].cells = size_type(numbers[4 * i]);
    result[i].measure = double(numbers[4 * i + 1]) * volume_unit;
    result[i].interface_measure = double(numbers[4 * i + 2]) * interface_unit;
    result[i].euler_characteristic = numbers[4 * i + 3];
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_COMPLEX_H

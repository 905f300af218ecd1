// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELED_COMPLEX_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELED_COMPLEX_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Item_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>
#include <CGAL/Deformable_simplicial_complexes/internal/components/Component_tracker.h>
#include <CGAL/Deformable_simplicial_complexes/internal/components/kept_components.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {
template <class Complex> class Complex_builder;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A domain divided into simplices, called cells; each cell carries a label. The *interface* is the set
of facets between cells of different labels. It may be non-manifold, and any number of labels may
meet. This class contains everything that complexes of all dimensions have in common. The cells are
triangles in 2D and tetrahedra in 3D.

Invariant: every finite cell is positively oriented, decided by exact predicates. If a member
function fails, the complex is unchanged.

All coordinates in a complex are doubles, so that copies and files are exact, and sides of a box
stay flat. Predicates on them are exact; measures are rounded.

No order depends on addresses. Lists of simplices are ordered by time stamps, which increase with
creation. A handle stays valid until its simplex is removed.

While no thread changes a complex, any number of threads may call its const member functions and
propose changes. Queries that visit vertices and cells mark them in tables of the calling thread, of
4 to 8 bytes for each vertex and cell. A thread allocates the tables at its first query of a complex
of that size and keeps them until it ends. The first query of a new thread is thus linear in the
number of cells, even if it visits a single star.

\tparam Derived the complex of a given dimension that derives from this class
\tparam Space_ simplices, predicates and measures of that dimension
\tparam QualityMeasure_ quality of a cell as a function of its corners; cached in cells
\tparam Domain_ model of `SimplicialDomain`; operations that depend on the shape of space as a whole
*/
template <class Derived, class Space_, class QualityMeasure_, class Domain_> class Labeled_complex
{
public:
  /// Simplices, predicates and measures.
  using Space = Space_;
  /// Model of `SimplicialDomain`.
  using Domain = Domain_;
  /// Dimension of space.
  static constexpr int dimension = Space::dimension;
  /// Number of vertices of a cell.
  static constexpr int corners = dimension + 1;

  /// The geometric traits class.
  using Geom_traits = typename Space::Geom_traits;
  /// Quality cached in cells.
  using Quality_measure = QualityMeasure_;
  /// Container of the simplices.
  using Triangulation_data_structure = typename Space::Triangulation_data_structure;
  /// Triangulation that stores the complex.
  using Triangulation = typename Space::Triangulation;
  /// Position of a vertex.
  using Point = typename Space::Point;
  /// Difference of two positions.
  using Vector = typename Space::Vector;
  /// Handle of a vertex; handles compare by time stamp.
  using Vertex_handle = typename Space::Vertex_handle;
  /// Handle of a cell; handles compare by time stamp.
  using Cell_handle = typename Space::Cell_handle;
  /// Cell and the index of the vertex opposite to the facet.
  using Facet = std::pair<Cell_handle, int>;
  /// Vertices of a facet.
  using Facet_vertices = std::array<Vertex_handle, dimension>;
  /// Proposal that `replace()` commits.
  using Cavity = Deformable_simplicial_complexes::Cavity<Derived>;
  /// Result of `state()` and argument of `restore()`.
  using State = Deformable_simplicial_complexes::State<dimension>;
  /// Name of a phase: any integer; 0 for the outside if there is one.
  using Label = int;
  /// Type of numbers of simplices, indices and time stamps.
  using size_type = std::size_t;

  /// Map between coordinates: user coordinates = translation + scale * coordinates of the complex.
  struct Normalization
  {
    Vector translation = CGAL::NULL_VECTOR; ///< user coordinates of the origin of the complex
    double scale = 1;                       ///< length of a unit of the complex in user coordinates

    /// Returns a point of the complex in user coordinates.
    Point in_user_coordinates(const Point& p) const {
      return CGAL::ORIGIN + (translation + scale * (p - CGAL::ORIGIN));
    }
  };

  /// \name Creation
  /// @{

  /// Exchanges the contents of two complexes. Handles stay valid. Proposals to both complexes
  /// become stale. Constant time.
  void swap(Labeled_complex& other) noexcept;
  /// Empties the complex, and keeps its traits, quality measure and domain. Handles are
  /// invalidated.
  void clear() { Labeled_complex(geom_traits(), m_quality_measure, m_domain).swap(*this); }

  /*!
  Replaces the complex by labeled cells. Vertices and cells are stored along a Hilbert curve. Takes
  time n log n in the number of cells.

  \param points vertices, each used by a cell; their coordinates are rounded to doubles
  \param cells indices of the corners of each cell, positively oriented with the rounded points
  \param labels one label for each cell
  \return the vertices in the order of `points`
  \throws Invalid_cells_error if sizes or indices do not fit, coordinates are not finite, the extent
          of the domain is not in [1e-30, 1e30], a vertex is unused, a cell is not positively
          oriented, or the cells do not form the domain; the complex is then unchanged
  \pre the boundary of the domain does not intersect itself

  */
  std::vector<Vertex_handle> assign(const std::vector<Point>& points,
                                    const std::vector<std::array<size_type, corners>>& cells,
                                    const std::vector<Label>& labels);

  /*!
  Replaces the complex by the cells of a triangulation, which is moved. Labels are the subdomain
  indices of the cells. Handles stay valid. Takes time n log n in the number of cells.

  \param triangulation such as one of `release()` that CGAL's algorithms have changed
  \throws Invalid_cells_error as the other overload does; the indices are those of finite vertices
          and of all cells by increasing time stamp. The complex is then unchanged, and so is the
          triangulation, except that surface patches have the numbers that `release()` gives them
  \pre `triangulation.is_valid()`
  */
  template <class D = Domain> void assign(Triangulation&& triangulation);

  /*!
  Empties the complex, and returns its triangulation, for `Mesh_complex_3_in_triangulation_3`,
  `tetrahedral_isotropic_remeshing()` and other functions of CGAL. Handles stay valid.

  In space, facets between different subdomains get the numbers of surface patches, from 1 on, by
  increasing pairs of labels; the outside of the domain has the label 0. The dimension of a vertex
  is 3 inside a subdomain, 2 on a patch, and 1 where several patches meet. Its index is the label
  or the number of the patch, and 0 on several patches. n log n in the number of cells.
  */
  Triangulation release();

  /// Stores vertices and cells along a Hilbert curve again, as `assign()` did. Handles are
  /// invalidated. Component events not taken yet are lost.
  void sort_storage();

  /// Returns everything needed to continue a computation with bitwise equal results, except
  /// component events not taken yet. Numbers the components as `update_components()` does. n log n
  /// in the number of cells.
  State state() const;

  /// Replaces the complex by the complex that `state()` described. A state contains no data of the
  /// user, so the new simplices have none.
  /// \throws Invalid_cells_error if the state does not describe a valid complex; this complex is
  ///         then unchanged
  void restore(const State& state);

  /// @}
  /// \name Access
  /// @{

  /// Returns the triangulation that stores the complex.
  const Triangulation& triangulation() const { return m_triangulation; }
  /// Returns the geometric traits object.
  const Geom_traits& geom_traits() const { return m_triangulation.geom_traits(); }
  /// Returns the domain, which answers questions on the shape of space as a whole.
  const Domain& domain() const { return m_domain; }
  /// Returns the quality measure.
  const Quality_measure& quality_measure() const { return m_quality_measure; }
  /// Returns the number of finite vertices. Constant time.
  size_type number_of_vertices() const {
    return m_triangulation.tds().vertices().empty() ? 0 : m_triangulation.number_of_vertices();
  }
  /// Returns the number of finite cells. Constant time.
  size_type number_of_cells() const;
  /// Returns an upper bound of the ids of vertices, including the infinite vertex. If there are
  /// cells, all ids are less than the bound, which is the size of an array indexed by ids.
  size_type vertex_id_bound() const { return m_numbers.vertex_id_bound(); }
  /// Returns an upper bound of the ids of cells, including infinite cells; all ids are less.
  size_type cell_id_bound() const { return m_numbers.cell_id_bound(); }
  std::vector<Vertex_handle> vertices() const; ///< finite vertices by increasing time stamp
  std::vector<Cell_handle> cells() const;      ///< finite cells by increasing time stamp

  /// Returns whether the vertex that v pointed to when it had this time stamp still exists.
  bool is_alive(Vertex_handle v, size_type time_stamp) const {
    return m_triangulation.tds().vertices().is_used(v) && v->time_stamp() == time_stamp;
  }
  /// Returns whether the cell that c pointed to when it had this time stamp still exists.
  bool is_alive(Cell_handle c, size_type time_stamp) const {
    return Space::cell_container(m_triangulation.tds()).is_used(c) && c->time_stamp() == time_stamp;
  }

  /// Returns whether v is the infinite vertex, which lies outside the domain.
  bool is_infinite(Vertex_handle v) const { return m_domain.is_outside(*this, v); }
  /// Returns whether the infinite vertex is one of the vertices of c.
  bool is_infinite(Cell_handle c) const { return m_domain.is_outside(*this, c); }
  /// Returns whether a corner of a cell is constrained by the domain, so that the cell keeps its
  /// label.
  static bool is_constrained(Cell_handle c) {
    for (int i = 0; i < corners; ++i)
      if (Domain::is_constrained(*c->vertex(i)))
        return true;
    return false;
  }
  /// Returns whether an end of the edge between two corners of a cell is constrained by the domain,
  /// so that the edge stays.
  static bool has_constrained_end(Cell_handle c, int i, int j) {
    return Domain::is_constrained(*c->vertex(i)) || Domain::is_constrained(*c->vertex(j));
  }
  /// Returns the range of all finite vertices, in the order of storage. Its elements convert to
  /// handles.
  auto finite_vertices() const { return m_triangulation.finite_vertex_handles(); }
  /// Returns the range of all finite cells, in the order of storage.
  auto finite_cells() const { return Space::finite_cells(m_triangulation); }
  /// Returns the finite cells for which a condition holds, each once, in an unspecified order that
  /// does not depend on the number of threads.
  /// \param condition function object; `condition(c)` can be called by several threads
  /// \param for_each_index loop over indices, on any threads
  template <class Condition>
  std::vector<Cell_handle> finite_cells_if(const Condition& condition,
                                           const For_each_index& for_each_index) const;

  /// Returns the point that is stored for p: p itself; on a torus, the image of p in the box.
  Point canonical(const Point& p) const { return m_domain.canonical(p); }
  /// Returns the position of v, in the coordinates of the complex. \pre v is finite
  const Point& position(Vertex_handle v) const { return v->point(); }
  /// Returns the position of v as seen from p; on a torus, the image nearest to p. \pre v is finite
  Point position_near(const Point& p, Vertex_handle v) const {
    return m_domain.nearest_image(p, position(v));
  }
  /// Returns the position of the vertex `i` of a cell, as seen from its vertex 0. \pre c is finite
  Point corner(Cell_handle c, int i) const {
    return position_near(position(c->vertex(0)), c->vertex(i));
  }
  /// Returns the shortest vector from v to w. \pre both are finite
  Vector displacement(Vertex_handle v, Vertex_handle w) const {
    const Point p = position(v);
    return position_near(p, w) - p;
  }
  /// Returns the shortest vector from v to p. \pre v is finite
  Vector displacement(Vertex_handle v, const Point& p) const {
    const Point from = position(v);
    return m_domain.nearest_image(from, p) - from;
  }
  /// Stores the cells around v, including infinite ones, in `star`, which is cleared first. The
  /// first cell is `v->cell()`.
  void star(Vertex_handle v, std::vector<Cell_handle>& star) const;

  /// Returns the map to user coordinates, see `Normalization`. All other lengths, including volumes
  /// and areas, are in the coordinates of the complex.
  const Normalization& normalization() const { return m_normalization; }
  /// Sets `normalization()`. Nothing moves.
  void set_normalization(const Normalization& n) { m_normalization = n; }
  /// Returns the position of v in user coordinates. \pre v is finite
  Point user_position(Vertex_handle v) const { return in_user_coordinates(position(v)); }
  /// Returns a point of the complex in user coordinates.
  Point in_user_coordinates(const Point& p) const { return m_normalization.in_user_coordinates(p); }

  /// @}
  /// \name Labels, interface and boundary
  /// @{

  /// Returns the phase that fills c. It is 0 for infinite cells, where it has no meaning.
  Label label(Cell_handle c) const { return c->subdomain_index(); }
  /// Returns the cached quality of c, at most 1 up to rounding; 1 for infinite cells.
  double quality(Cell_handle c) const { return c->quality(); }
  std::vector<Label> labels() const; ///< labels of cells, increasing

  /// Returns whether the facet is between two finite cells of different labels.
  bool is_interface(const Facet& f) const {
    const Cell_handle a = f.first, b = a->neighbor(f.second);
    return a->subdomain_index() != b->subdomain_index() && !is_infinite(a) && !is_infinite(b);
  }
  /// Returns whether a facet of the interface contains v. Constant time.
  bool is_interface(Vertex_handle v) const { return v->is_interface(); }

  /// Returns whether v is on the boundary of the domain.
  bool is_boundary(Vertex_handle v) const { return v->boundary_class() != 0; }

  /// vertices of the interface, by increasing time stamp
  std::vector<Vertex_handle> interface_vertices() const;
  /// Returns the facets of the interface. Each facet is given once, by its cell of the larger
  /// label, ordered by the time stamp of this cell.
  /// \param for_each_index loop over indices, on any threads
  std::vector<Facet>
  interface_facets(const For_each_index& for_each_index = For_each_index()) const;
  /// Returns the facets between the labels a and b, given by their cells of the larger label.
  std::vector<Facet> interface_facets(Label a, Label b) const;
  /// Returns the vertices of a facet, counterclockwise seen from outside the cell `f.first`.
  Facet_vertices facet_vertices(const Facet& f) const {
    Facet_vertices result;
    for (int i = 0; i < dimension; ++i)
      result[i] = f.first->vertex(Space::facet_vertices[f.second][i]);
    return result;
  }

  /// Returns the present mean length of the interface edges at v; 0 if v is not on the interface.
  /// Linear in the star of v.
  double interface_edge_length(Vertex_handle v) const;
  /// Returns the mean length of the interface edges when the complex was built; 0 without an
  /// interface. It is the unit of target edge lengths if there is no sizing field.
  double mean_interface_edge() const { return m_mean_interface_edge; }
  /// Returns the smallest length of an interface edge when the complex was built; 0 without an
  /// interface.
  double minimum_interface_edge() const { return m_minimum_interface_edge; }
  /// Sets `mean_interface_edge()`, `minimum_interface_edge()` and the `Vertex_data::spacing()` of
  /// all vertices by the present interface. Use this function if labels were set after the complex
  /// was built. Linear.
  void measure_interface_edges();

  /// @}
  /// \name Measures
  /// @{

  /// Returns the total measure of the cells of a label: the volume in 3D, the area in 2D. Constant
  /// time.
  double measure(Label label) const { return m_totals.volume(label); }
  size_type number_of_cells(Label label) const { return m_totals.cells(label); } ///< constant time
  /// Returns the measure of a cell, up to rounding: the volume in 3D, the area in 2D. \pre c is
  /// finite
  double measure(Cell_handle c) const;
  /// Returns the measure of a facet: the area in 3D, the length in 2D. \pre f is finite
  double measure(const Facet& f) const;
  /// Returns the quality that a finite cell would have with each vertex v at `position_of(v)`.
  template <class PositionOf> double quality(Cell_handle c, const PositionOf& position_of) const {
    return m_domain.template apply<Labeled_complex>(
        m_quality_measure, [&](int i) { return position_of(c->vertex(i)); });
  }
  /// Returns whether a finite cell would be positively oriented with each vertex v at
  /// `point_of(v)`, exactly.
  template <class PointOf> bool is_positive(Cell_handle c, const PointOf& point_of) const {
    return m_domain.orientation(
               *this, [&](int i) -> decltype(auto) { return point_of(c->vertex(i)); }) == POSITIVE;
  }
  /// Returns the exact predicate for the orientation of a cell, a function of its corners.
  auto orientation() const { return Space::orientation(geom_traits()); }

  /// Returns the number of connected components of a label, connected through facets. Linear if the
  /// topology may have changed since the last call, otherwise constant.
  size_type number_of_components(Label label) const {
    return m_components.number_of_components(*this, label);
  }
  /// Renumbers the connected components if they may have changed. Stores the changes for
  /// `take_component_events()`. Linear if the topology may have changed.
  void update_components() { m_components.update(*this, m_totals); }
  /// Returns the number of the connected component that a cell belongs to, as used in events.
  /// \pre the components have not changed since `update_components()`
  std::uint32_t component(Cell_handle c) const { return c->component(); }

  /// Returns the changes of components since the last call. `deform_interface()` also takes the
  /// events: when it begins, when it ends, and after passes in which the topology changed. Linear
  /// if the topology may have changed.
  std::vector<Component_event> take_component_events() {
    update_components();
    return m_components.take_events();
  }

  /// Returns the relation between the components at the last call and the present ones, as pairs of
  /// a former and a present number, sorted. A pair tells that the present component contains cells
  /// of the former one, or cells that replaced them. Components are renumbered when some of them
  /// change. A present component in no pair is new; a former component in no pair has vanished.
  /// Linear if the topology may have changed.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> take_component_lineage() {
    update_components();
    return m_components.take_lineage();
  }

  /// @}
  /// \name Motion
  /// @{

  /// Lower bound of the quality of cells. Deformations and proposals create no cell below the
  /// bound, unless it replaces a cell that was below the bound.
  static constexpr double quality_floor = 1e-3;

  /// Returns whether the quality of a cell may change from `before` to `after`, with a lower bound
  /// on the quality.
  static bool keeps_quality(double before, double after, double floor = quality_floor) {
    return floor == 0 || after >= floor || before < floor;
  }

  /// Returns the finite cells of a quality below `quality_floor`, by increasing time stamp.
  /// Constant time if there is none, else linear.
  std::vector<Cell_handle> flat_cells() const;

  /// Returns the point nearest to q, rounded, on the sides of the domain that v lies on.
  Point admissible_destination(Vertex_handle v, const Point& q) const {
    return m_domain.admissible(*this, v, canonical(q));
  }

  /// Returns whether all cells of the star of v would be positively oriented with v at q, rounded.
  /// The test is exact.
  bool is_positive_star(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const Point& q) const;

  /// Returns whether, in addition, each finite cell of the star would keep its quality, see
  /// `keeps_quality()`.
  bool is_admissible_star(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& q,
                          double floor = quality_floor) const;

  /*!
  Moves v towards q along a straight line (Algorithm 2 of the paper). If every incident cell is
  positively oriented with v at q, v moves to q. Otherwise, v stops shortly before the first point
  where an incident cell would be flat. Volumes are linear in the position of one vertex. A cell
  that is positive at both ends of a segment is thus positive on the whole segment. Linear in the
  star of v.

  \param v, q a finite vertex, and a point with finite coordinates; a vertex on a side of the domain
         moves to `admissible_destination()` instead
  \param margin distance that v keeps from the flat position, as a fraction of the displacement to
         that position, in (0, 1)
  \param floor lower bound of the quality, in [0, 1): no cell falls below the bound that was not
         below it before. If necessary, v keeps a larger distance from flat positions.
  \return the fraction of the displacement to its admissible destination that v moved, in [0, 1].
          For 1, v is exactly at the destination. For 0, its coordinates are bitwise unchanged.
  */
  double move_vertex(Vertex_handle v, const Point& q, double margin = 1. / 1024, double floor = 0);

  /// Moves v to p, rounded.
  /// \pre `star` is the star of v and `is_positive_star(v, star, p)`
  void set_point(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& p);

  /// Moves vertices to points, rounded, all at once.
  /// \param vertices vertices to move
  /// \param points new positions, in the order of `vertices`
  /// \param cells all cells of the stars of the vertices, each once
  /// \param measures measures of each finite cell before and after the move, in the order of
  ///        `cells`; see `measure()`
  /// \param qualities qualities of the finite cells after the move, in the order of `cells`; see
  ///        `quality()`
  /// \param for_each_index loop over indices, on any threads, called as
  ///        `for_each_index(n, f, worthwhile)`; see `For_each_index`
  /// \pre the finite cells are positively oriented after the move
  template <class ForEachIndex>
  void set_points(const std::vector<Vertex_handle>& vertices, const std::vector<Point>& points,
                  const std::vector<Cell_handle>& cells,
                  const std::vector<std::array<double, 2>>& measures,
                  const std::vector<double>& qualities, const ForEachIndex& for_each_index);

  /// @}
  /// \name Change of the mesh
  /// @{

  /// Returns a number that increases with each change of cells, labels or positions. Results of
  /// queries hold as long as it stays the same.
  std::uint64_t version() const { return m_version; }

  /*!
  Commits a proposal: removes the cells of the cavity, creates the planned cells, and fills
  `cavity.created()` and the handles of new vertices. A vertex whose cells are all removed vanishes
  if no planned cell contains it; otherwise, it moves to its position in the cavity. n log n in the
  size of the cavity. After relabelings that may have split a component, at most linear in the size
  of the complex.

  \pre `cavity.is_positive()`, and the planned cells have the same boundary as the removed cells
  \throws Stale_proposal_error if the complex has changed since the cavity was begun. The complex is
          unchanged if this or any other exception, such as one for a lack of memory, is thrown.
  */
  void replace(Cavity& cavity);

  /// Gives a finite cell another label. If memory is exhausted, the complex is unchanged. Linear in
  /// the number of cells around the cell, and in the number of components if one of them may have
  /// been split.
  void relabel(Cell_handle c, Label label);

  /// @}

  /*!
  Checks the data structure, all orientations (exactly), the boundary classes and all cached values.

  \param verbose whether to report errors on `std::cerr`, as CGAL's triangulations do
  \throws Interrupted_error if the callback of a `Progress_scope` returns `false`
  */
  bool is_valid(bool verbose = false) const;

protected:
  /// Constructs an empty complex.
  Labeled_complex(const Geom_traits& traits, const Quality_measure& quality, const Domain& domain)
      : m_triangulation(traits), m_quality_measure(quality), m_domain(domain) {}
  /// Copies a complex, with its time stamps, components and pending component events, and all data
  /// that users have added to the bases of vertices and cells. n log n in the number of cells.
  Labeled_complex(const Labeled_complex& other);
  /// Moves a complex, and leaves `other` empty. Handles stay valid.
  Labeled_complex(Labeled_complex&& other) noexcept;
  /// Replaces the complex by a copy. If an exception is thrown, the complex is unchanged.
  Labeled_complex& operator=(const Labeled_complex& other) {
    Labeled_complex(other).swap(*this);
    return *this;
  }
  /// Replaces the complex by another one, which is moved. Handles of `other` stay valid.
  Labeled_complex& operator=(Labeled_complex&& other) noexcept {
    Labeled_complex(std::move(other)).swap(*this);
    return *this;
  }
  /// Destroys the complex. Only objects of the derived class can be destroyed.
  ~Labeled_complex() = default;

private:
  friend class internal::Complex_builder<Derived>;
  using Item_numbers = internal::Item_numbers<Vertex_handle, Cell_handle>;

  using Cell_vertices = std::array<size_type, corners>; // indices of the vertices of a cell
  class Created_items;

  // Returns the barycenters of new cells. Throws `Invalid_cells_error` unless each cell is
  // positively oriented and each position belongs to a cell.
  std::vector<Point>
  checked_barycenters(const std::vector<Point>& positions,
                      const std::vector<std::array<size_type, corners>>& cells) const;
  double cell_quality(Cell_handle c) const;
  // Caches the quality of a cell, and updates the number of cells below the floor. All changes of
  // cached qualities must use this function.
  void set_quality(Cell_handle c, double quality) {
    m_number_of_flat_cells += quality < quality_floor;
    m_number_of_flat_cells -= c->quality() < quality_floor;
    internal::Simplex_access::set_quality(c, quality);
  }
  bool is_positive(Cell_handle c) const;
  void place(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& p);
  void note_motion(Cell_handle c);
  void forget_failures(Cell_handle c);
  // Adds a number to the interface degree of each vertex of a facet.
  void count_interface_facet(const Facet& f, int number) {
    for (Vertex_handle v : facet_vertices(f))
      internal::Simplex_access::set_interface_degree(v,
                                                     v->interface_degree() + std::uint32_t(number));
  }
  // Changes the volumes of the label and of the component of a cell by some units of the totals.
  void add_volume(Cell_handle c, std::int64_t units) {
    m_totals.add_volume(c->subdomain_index(), units);
    m_components.add_volume(c->component(), units);
  }
  bool has_several_labels(const std::vector<Cell_handle>& cells) const;
  bool are_kept(const internal::Connections<Labeled_complex>& connections,
                const std::vector<Cell_handle>& created) const noexcept;
  void count_removed_interface(const Cavity& cavity, const internal::Marks& removed);
  void collect_surroundings(const Cavity& cavity, const internal::Marks& removed);
  void sew(bool counts_interface);
  void initialize_caches();
  std::vector<Cell_handle> all_cells() const;
  void copy_values(const Labeled_complex& other);
  void copy_simplices(const Labeled_complex& other, const std::vector<Vertex_handle>& vertices,
                      const std::vector<Cell_handle>& cells, bool keeps_time_stamps);
  void join_simplices();
  void leave_simplices();
  static void check_number_of_cells(size_type number);
  static void check_extent(const internal::Extent<dimension>& extent);
  void rebuild(const State& state);
  static std::vector<Cell_vertices> indices_of(const State& state);
  std::vector<Vertex_handle> create_vertices(const State& state);
  void create_items(const State& state);
  void check_stars(const std::vector<Vertex_handle>& vertices) const;
  void check_boundary() const;
  bool is_sewn(bool verbose) const;
  bool report(bool ok, const char* what, bool verbose) const;

  // Facet of a cell to be sewn. Its vertices are indices within the cavity.
  struct Half_facet
  {
    std::array<std::uint32_t, dimension> vertices; // sorted
    Cell_handle cell;
    int index;
  };

  Triangulation m_triangulation;
  Item_numbers m_numbers;
  Quality_measure m_quality_measure;
  Domain m_domain;
  internal::Label_totals m_totals;
  Normalization m_normalization;
  double m_mean_interface_edge = 0, m_minimum_interface_edge = 0;
  size_type m_number_of_flat_cells = 0;
  std::uint64_t m_version = 0;
  mutable internal::Component_tracker<Cell_handle> m_components;

  // Buffers, kept to reuse their memory.
  std::vector<Cell_handle> m_star;
  std::vector<Half_facet> m_half_facets;
};

} // namespace CGAL::Deformable_simplicial_complexes

#include <CGAL/Deformable_simplicial_complexes/internal/complex/changes_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/queries_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/storage_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/triangulation_impl.h>

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELED_COMPLEX_H

// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_COMPLEX_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_COMPLEX_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Component_event.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Component_tracker.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/kept_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Item_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Less_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A domain divided into simplices, each of which, called a cell, carries a label. The *interface* is
the set of facets between cells of different labels; it may be non-manifold, and any number of
labels may meet. This is what complexes of all dimensions have in common; what a cell is, a
tetrahedron or a triangle, follows from the space.

Invariant: every finite cell is positively oriented, decided by exact predicates. Each member
function either keeps that and does what it says, or leaves the complex as it was.

Every position in a complex has coordinates that are doubles, whatever the number type of the
kernel: what comes in is rounded first, see `rounded()`. Measures, copies and files thus lose
nothing, and sides of a box stay flat.

Orders never depend on addresses: lists of simplices are ordered by time stamps, that is by
creation. Handles stay valid until their simplex is removed.

Any number of threads may call const member functions of a complex at once, and propose changes to
it, while none changes it. What a walk notes about vertices and cells is in tables of its thread, of
4 to 8 bytes for each, which the thread makes when it first looks at a complex of that size and
keeps until it ends: a thread for a single query of a star costs as much as a look at all cells.

\tparam Derived the complex of some dimension that this is a part of
\tparam Space_ simplices, predicates and measures of that dimension
\tparam QualityMeasure_ the quality that cells cache: of the corners of a cell
\tparam Domain_ model of `SimplicialDomain`: what depends on the shape of space as a whole
*/
template <class Derived, class Space_, class QualityMeasure_, class Domain_> class Labelled_complex
{
public:
  /// Simplices, predicates and measures.
  using Space = Space_;
  /// model of `SimplicialDomain`
  using Domain = Domain_;
  /// Of space.
  static constexpr int dimension = Space::dimension;
  /// Number of vertices of a cell.
  static constexpr int corners = dimension + 1;

  /// The geometric traits class.
  using Geom_traits = typename Space::Geom_traits;
  /// The quality that cells cache.
  using Quality_measure = QualityMeasure_;
  /// Stores the simplices.
  using Triangulation_data_structure = typename Space::Triangulation_data_structure;
  /// The triangulation that stores the complex.
  using Triangulation = typename Space::Triangulation;
  /// A position as it is stored and as predicates see it.
  using Point = typename Space::Point;
  /// A position with coordinates of type `double`, to measure with.
  using Approximate_point = typename Space::Approximate_point;
  /// The difference of two such positions.
  using Approximate_vector = typename Space::Approximate_vector;
  /// Refers to a vertex; handles compare by time stamp.
  using Vertex_handle = typename Space::Vertex_handle;
  /// Refers to a cell; handles compare by time stamp.
  using Cell_handle = typename Space::Cell_handle;
  /// A cell and the index of the vertex opposite to the facet.
  using Facet = std::pair<Cell_handle, int>;
  /// The vertices of a facet.
  using Facet_vertices = std::array<Vertex_handle, dimension>;
  /// What `replace()` commits.
  using Cavity = Deformable_simplicial_complexes::Cavity<Derived>;
  /// What `state()` returns and `restore()` takes.
  using State = Deformable_simplicial_complexes::State<dimension>;
  /// The name of a phase: any integer, and 0 for the outside where there is one.
  using Label = int;
  /// Numbers of simplices, indices and time stamps.
  using size_type = std::size_t;

  /// user coordinates = translation + scale * coordinates of the complex
  struct Normalization
  {
    Approximate_vector translation =
        Approximate_vector(CGAL::NULL_VECTOR); ///< where the origin of the complex is
    double scale = 1; ///< length for the user of a unit of length of the complex
  };

  /// \name Creation
  /// @{

  /// Exchanges the content of two complexes. Handles stay valid. Constant time.
  void swap(Labelled_complex& other) noexcept;
  /// Empties the complex, which keeps its traits and its quality measure. Handles are invalidated.
  void clear() { Labelled_complex(geom_traits(), m_quality_measure, m_domain).swap(*this); }

  /*!
  Replaces the complex by labelled cells. Vertices and cells are stored along a Hilbert curve.

  \param points vertices; each must be used. Their coordinates are rounded to doubles.
  \param cells indices of the corners of each cell, positively oriented with the rounded points.
  \param labels one label for each cell.
  \return the vertices in the order of `points`
  \throws Invalid_cells_error if sizes or indices do not fit, coordinates are not finite, the
         extent of the domain is not in [1e-30, 1e30], a vertex is unused, a cell is not positive,
         or the cells do not form the domain. The complex is then unchanged.
  \pre the boundary of the domain does not intersect itself

  n log n in the number of cells.
  */
  std::vector<Vertex_handle> assign(const std::vector<Point>& points,
                                    const std::vector<std::array<size_type, corners>>& cells,
                                    const std::vector<Label>& labels);

  /// Stores vertices and cells along a Hilbert curve again, as `assign()` did. Handles are
  /// invalidated; destinations, and changes of components not taken yet, are forgotten.
  void sort_storage();

  /// Everything needed to continue a computation to the same bits, but for changes of components
  /// not taken yet. Numbers components as `update_components()` does. n log n in the number of
  /// cells.
  State state() const;

  /// The complex that `state()` described. \throws Invalid_cells_error if the state is none of
  /// a valid complex; this one is then unchanged.
  void restore(const State& state);

  /// @}
  /// \name Access
  /// @{

  /// The triangulation that stores the complex, to look at.
  const Triangulation& triangulation() const { return m_triangulation; }
  /// The geometric traits object.
  const Geom_traits& geom_traits() const { return m_triangulation.geom_traits(); }
  /// What depends on the shape of space as a whole.
  const Domain& domain() const { return m_domain; }
  /// The quality measure.
  const Quality_measure& quality_measure() const { return m_quality_measure; }
  /// Number of finite vertices. Constant time.
  size_type number_of_vertices() const {
    return m_triangulation.tds().vertices().empty() ? 0 : m_triangulation.number_of_vertices();
  }
  /// Number of finite cells. Constant time in the number of cells.
  size_type number_of_cells() const;
  /// Where there are cells, ids of vertices, of the infinite one too, are below: the size of an
  /// array that is indexed by them.
  size_type vertex_id_bound() const { return m_numbers.vertex_id_bound(); }
  /// Ids of cells, of infinite ones too, are below.
  size_type cell_id_bound() const { return m_numbers.cell_id_bound(); }
  std::vector<Vertex_handle> vertices() const; ///< finite vertices by increasing time stamp
  std::vector<Cell_handle> cells() const;      ///< finite cells by increasing time stamp

  /// Whether the vertex that v pointed to when it had this time stamp still exists.
  bool is_alive(Vertex_handle v, size_type time_stamp) const {
    return m_triangulation.tds().vertices().is_used(v) && v->time_stamp() == time_stamp;
  }
  /// Whether the cell that c pointed to when it had this time stamp still exists.
  bool is_alive(Cell_handle c, size_type time_stamp) const {
    return Space::cell_container(m_triangulation.tds()).is_used(c) && c->time_stamp() == time_stamp;
  }

  /// Whether v is the infinite vertex, which lies outside the domain.
  bool is_infinite(Vertex_handle v) const { return m_domain.is_outside(*this, v); }
  /// Whether the infinite vertex is one of the vertices of c.
  bool is_infinite(Cell_handle c) const { return m_domain.is_outside(*this, c); }
  /// All finite vertices, as they are stored. Handles are converted from what it iterates over.
  auto finite_vertices() const { return m_triangulation.finite_vertex_handles(); }
  /// All finite cells, as they are stored.
  auto finite_cells() const { return Space::finite_cells(m_triangulation); }

  /// The point with coordinates of type `double` nearest to a point as it is stored.
  Approximate_point approximate(const Point& p) const {
    return Space::approximate(geom_traits())(p);
  }
  /// The point to be stored for one with coordinates of type `double`.
  Point exact(const Approximate_point& p) const { return Space::exact(geom_traits())(p); }
  /// The point that is stored for p: each coordinate is a double, that of p if it is one.
  /// On a torus, it is the image in the box.
  Point rounded(const Point& p) const { return exact(m_domain.canonical(approximate(p))); }
  /// Where v is, in the coordinates of the complex. \pre v is finite
  Approximate_point position(Vertex_handle v) const { return approximate(v->point()); }
  /// Where v is as seen from p: on a torus, the image that is nearest. \pre v is finite
  Approximate_point position_near(const Approximate_point& p, Vertex_handle v) const {
    return m_domain.near(p, position(v));
  }
  /// Where a cell has its vertex `i`, as seen from its vertex 0. \pre c is finite
  Approximate_point corner(Cell_handle c, int i) const {
    return position_near(position(c->vertex(0)), c->vertex(i));
  }
  /// From v to w the shortest way. \pre both are finite
  Approximate_vector displacement(Vertex_handle v, Vertex_handle w) const {
    const Approximate_point p = position(v);
    return position_near(p, w) - p;
  }
  /// From v to p the shortest way. \pre v is finite
  Approximate_vector displacement(Vertex_handle v, const Approximate_point& p) const {
    const Approximate_point from = position(v);
    return m_domain.near(from, p) - from;
  }
  /// The cells around v, infinite ones included, in `star` (cleared first), v->cell() first.
  void star(Vertex_handle v, std::vector<Cell_handle>& star) const;

  /// The coordinates that the user sees in files, see `Normalization`. Everything else, volumes and
  /// areas included, is in the coordinates of the complex.
  const Normalization& normalization() const { return m_normalization; }
  /// Sets `normalization()`. Nothing moves.
  void set_normalization(const Normalization& n) { m_normalization = n; }
  /// Where v is, in the coordinates of the user. \pre v is finite
  Approximate_point user_position(Vertex_handle v) const {
    return CGAL::ORIGIN +
           (m_normalization.translation + m_normalization.scale * (position(v) - CGAL::ORIGIN));
  }

  /// @}
  /// \name Labels, interface and boundary
  /// @{

  /// The phase that fills c; 0 for infinite cells, where it means nothing.
  Label label(Cell_handle c) const { return c->label(); }
  /// The cached quality of c, 1 at best up to rounding; 1 for infinite cells.
  double quality(Cell_handle c) const { return c->quality(); }
  std::vector<Label> labels() const; ///< the labels of cells, increasing

  /// Whether two finite cells of different labels share the facet.
  bool is_interface(const Facet& f) const {
    const Cell_handle a = f.first, b = a->neighbor(f.second);
    return a->label() != b->label() && !is_infinite(a) && !is_infinite(b);
  }
  /// Whether a facet of the interface contains v. Constant time.
  bool is_interface(Vertex_handle v) const { return v->is_interface(); }

  /// Whether a facet of the boundary of the domain is incident.
  bool is_boundary(Vertex_handle v) const { return v->boundary_class() != 0; }

  std::vector<Vertex_handle> interface_vertices() const; ///< by increasing time stamp
  /// The interface, each facet once, from the cell of the larger label; by the time stamp of that
  /// cell.
  std::vector<Facet> interface_facets() const;
  /// The facets between labels a and b, from the cell of the larger one.
  std::vector<Facet> interface_facets(Label a, Label b) const;
  /// The vertices of a facet, counterclockwise seen from outside the cell `f.first`.
  Facet_vertices facet_vertices(const Facet& f) const {
    Facet_vertices result;
    for (int i = 0; i < dimension; ++i)
      result[i] = f.first->vertex(Space::facet_vertices[f.second][i]);
    return result;
  }

  /// The mean length of the edges of the interface at v now; 0 if it is not on it. Linear in its
  /// star.
  double interface_edge_length(Vertex_handle v) const;
  /// Mean length of the edges of the interface when the complex was built, the unit of wanted
  /// lengths where none are given; 0 without an interface.
  double mean_interface_edge() const { return m_mean_interface_edge; }
  /// The smallest length of such an edge; 0 without an interface.
  double minimum_interface_edge() const { return m_minimum_interface_edge; }
  /// Makes the edges of the present interface the unit of lengths, instead of those when the
  /// complex was built: where labels came later. So does each vertex with those at it, see
  /// `Vertex_data::spacing()`. Linear.
  void measure_interface_edges();

  /// @}
  /// \name Measures
  /// @{

  /// What the cells of a label measure together: their volume, in the plane their area. Constant
  /// time.
  double measure(Label label) const { return m_totals.volume(label); }
  size_type number_of_cells(Label label) const { return m_totals.cells(label); } ///< constant time
  /// What a cell measures, up to rounding. \pre c is finite
  double measure(Cell_handle c) const;
  /// What a facet measures: its area, in the plane its length. \pre f is finite
  double measure(const Facet& f) const;
  /// The quality that a finite cell would have with each vertex v at `position_of(v)`.
  template <class PositionOf> double quality(Cell_handle c, const PositionOf& position_of) const {
    return m_domain.template apply<Labelled_complex>(
        m_quality_measure, [&](int i) { return position_of(c->vertex(i)); });
  }
  /// Whether a finite cell would be positively oriented with each vertex v at `point_of(v)`,
  /// exactly.
  template <class PointOf> bool is_positive(Cell_handle c, const PointOf& point_of) const {
    return m_domain.orientation(
               *this, [&](int i) -> decltype(auto) { return point_of(c->vertex(i)); }) == POSITIVE;
  }
  /// The exact predicate that tells the orientation of a cell from its corners.
  auto orientation() const { return Space::orientation(geom_traits()); }

  /// Number of connected components of a label through facets. Linear if the topology may have
  /// changed since the last call, else constant.
  size_type number_of_components(Label label) const {
    return m_components.number_of_components(*this, label);
  }
  /// Numbers the connected components anew if they may have changed. What happened to them is kept
  /// for `take_component_events()`. Linear if the topology may have changed.
  void update_components() { m_components.update(*this, m_totals); }
  /// The connected component of its label that a cell belongs to, by the number that events name.
  /// \pre the components did not change since `update_components()`
  std::uint32_t component(Cell_handle c) const { return c->component(); }

  /// What happened to components since the last call. `deform_interface()` takes the events too,
  /// when it begins, when it ends and after passes in which the topology changed.
  /// Linear if the topology may have changed.
  std::vector<Component_event> take_component_events() {
    update_components();
    return m_components.take_events();
  }

  /// Which components of now have cells of which components of the last call, or cells that
  /// replaced these: pairs of their numbers, then and now, sorted. Components are numbered anew
  /// when some of them change; those without a pair come from none, or are gone. Linear if the
  /// topology may have changed.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> take_component_lineage() {
    update_components();
    return m_components.take_lineage();
  }

  /// @}
  /// \name Motion
  /// @{

  /// Lower bound of the quality of cells: deformations and proposals give none a lower quality,
  /// unless the cell, or one that it replaces, was below the bound before.
  static constexpr double quality_floor = 1e-3;

  /// Returns whether a cell of a quality may come to have another one, by a lower bound.
  static bool keeps_quality(double before, double after, double floor = quality_floor) {
    return floor == 0 || after >= floor || before < floor;
  }

  /// Returns the finite cells of a quality below `quality_floor`, by increasing time stamp.
  /// Constant time if there is none, else linear.
  std::vector<Cell_handle> flat_cells() const;

  /// The point nearest to q that v may go to within the sides of the domain it lies on, rounded.
  Point admissible_destination(Vertex_handle v, const Point& q) const {
    return m_domain.admissible(*this, v, rounded(q));
  }

  /// Whether all cells of a star, the star of v, would be positively oriented with v at q,
  /// rounded; exact.
  bool is_positive_star(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const Point& q) const;

  /// Returns whether, besides, each finite cell of the star would keep its quality: see
  /// `keeps_quality()`.
  bool is_admissible_star(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& q,
                          double floor = quality_floor) const;

  /*!
  Moves v towards q in a straight line: to q if every incident cell is positively oriented there,
  else almost to the first point where one would be flat (Algorithm 2 of the paper). Positive at
  both ends of a segment means positive between, as volumes are linear in one vertex.

  \param q finite coordinates; a vertex on a side of the domain goes to `admissible_destination()`.
  \param margin the part of the displacement to the flat position that v keeps clear of it, in
         (0, 1).
  \param floor no cell comes to have a lower quality that did not have one before, in [0, 1); v
         keeps clear of flat positions by more where that is necessary.
  \return the part of the way to its admissible destination that v went, in [0, 1]; 1 means it is
          there, exactly. At 0 its coordinates are what they were, bit for bit.

  Linear in the star of v.
  */
  double move_vertex(Vertex_handle v, const Point& q, double margin = 1. / 1024, double floor = 0);

  /// Puts v at p, rounded. \pre `star` is the star of v and `is_positive_star(v, star, p)`
  void set_point(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& p);

  /// Puts vertices at points, rounded, all at once. \pre `cells` are all cells of the vertices'
  /// stars, each once, and the finite ones are positively oriented afterwards.
  /// \param measures what finite cells measure before, in the order of `cells`; see `measure()`.
  /// \param qualities the qualities of finite cells afterwards, in the same order; see `quality()`.
  /// \param for_each_index `for_each_index(n, f)` calls `f(i)` for all i below n, in any order and on
  ///        any threads.
  template <class ForEachIndex>
  void set_points(const std::vector<Vertex_handle>& vertices, const std::vector<Point>& points,
                  const std::vector<Cell_handle>& cells, const std::vector<double>& measures,
                  const std::vector<double>& qualities, const ForEachIndex& for_each_index);

  /// @}
  /// \name Change of the mesh
  /// @{

  /// A number that each change of cells, labels or positions raises: what was found out about the
  /// complex holds as long as it stays.
  std::uint64_t version() const { return m_version; }

  /*!
  Commits a cavity: removes its cells, creates the planned ones and fills in `cavity.created()` and
  the handles of new vertices, which have no destination. Vertices of removed cells alone vanish if
  no cell is planned for them, and move to where the cavity has them.
  \pre `cavity.is_positive()`, and the planned cells have the boundary of the removed ones.
  \throws Stale_proposal_error if the complex has changed since the cavity was begun. Neither this
         nor a lack of memory changes the complex.

  n log n in the size of the cavity. Linear in the complex, at the most, after relabelings that may
  have parted a component.
  */
  void replace(Cavity& cavity);

  /// Gives a finite cell another label. Linear in the cells around it, and in the number of
  /// components where one may have been parted. A lack of memory leaves the complex as it was.
  void relabel(Cell_handle c, Label label);

  /// @}

  /*!
  Checks the data structure, every orientation exactly, boundary classes and all that is cached.
  \param verbose tells on `std::cerr` what is wrong, as CGAL's triangulations do
  \throws Interrupted_error if the callback of a `Progress_scope` returns `false`
  */
  bool is_valid(bool verbose = false) const;

protected:
  Labelled_complex(const Geom_traits& traits, const Quality_measure& quality, const Domain& domain)
      : m_triangulation(traits), m_quality_measure(quality), m_domain(domain) {}
  Labelled_complex(const Labelled_complex& other);
  Labelled_complex(Labelled_complex&& other) noexcept;
  Labelled_complex& operator=(const Labelled_complex& other) {
    Labelled_complex(other).swap(*this);
    return *this;
  }
  Labelled_complex& operator=(Labelled_complex&& other) noexcept {
    Labelled_complex(std::move(other)).swap(*this);
    return *this;
  }
  ~Labelled_complex() = default;

private:
  using Cell_vertices = std::array<size_type, corners>; // indices
  class Created_items;

  double cell_quality(Cell_handle c) const;
  // Each quality is cached by this function, which counts those below the floor.
  void set_quality(Cell_handle c, double quality) {
    m_number_of_flat_cells += quality < quality_floor;
    m_number_of_flat_cells -= c->quality() < quality_floor;
    c->set_quality(quality);
  }
  bool is_positive(Cell_handle c) const;
  void place(Vertex_handle v, const std::vector<Cell_handle>& star, const Point& p);
  void note_motion(Cell_handle c);
  void forget_failures(Cell_handle c);
  // Adds to the number of facets of the interface that each vertex of a facet has.
  void count_interface_facet(const Facet& f, int number) {
    for (Vertex_handle v : facet_vertices(f))
      v->set_interface_degree(v->interface_degree() + std::uint32_t(number));
  }
  // What a cell measures has changed by so many units of the totals.
  void add_volume(Cell_handle c, std::int64_t units) {
    m_totals.add_volume(c->label(), units);
    m_components.add_volume(c->component(), units);
  }
  bool has_several_labels(const std::vector<Cell_handle>& cells) const;
  bool are_kept(const internal::Connections<Labelled_complex>& connections,
                const std::vector<Cell_handle>& created) const noexcept;
  void count_removed_interface(const Cavity& cavity, const internal::Marks& removed);
  void collect_surroundings(const Cavity& cavity, const internal::Marks& removed);
  void sew(bool counts_interface);
  void initialize_caches();
  std::vector<Cell_handle> all_cells() const;
  void rebuild(const State& state);
  void create_items(const State& state);
  void check_stars(const std::vector<Vertex_handle>& vertices) const;
  void check_boundary() const;
  bool is_sewn(bool verbose) const;
  bool report(bool ok, const char* what, bool verbose) const;

  // A facet of a cell to be sewn; its vertices are indices within the cavity.
  struct Half_facet
  {
    std::array<std::uint32_t, dimension> vertices; // sorted
    Cell_handle cell;
    int index;
  };

  Triangulation m_triangulation;
  internal::Item_numbers m_numbers;
  Quality_measure m_quality_measure;
  Domain m_domain;
  internal::Label_totals m_totals;
  Normalization m_normalization;
  double m_mean_interface_edge = 0, m_minimum_interface_edge = 0;
  size_type m_number_of_flat_cells = 0;
  std::uint64_t m_version = 0;
  mutable internal::Component_tracker<Cell_handle> m_components;

  // Buffers whose memory is reused.
  std::vector<Cell_handle> m_star;
  std::vector<Half_facet> m_half_facets;
  std::vector<std::int64_t> m_volume_changes;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#include <CGAL/Deformable_simplicial_complexes/internal/complex/changes_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/queries_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/storage_impl.h>

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_COMPLEX_H

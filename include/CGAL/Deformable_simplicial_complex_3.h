// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

#include <CGAL/Deformable_simplicial_complex_3/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Component_event.h>
#include <CGAL/Deformable_simplicial_complex_3/State_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/Component_tracker.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/Label_totals.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/assemble_triangulation.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/check_tetrahedra_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/has_finite_coordinates.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/hilbert_order.h>
#include <CGAL/Deformable_simplicial_complex_3/quality_measures_3.h>
#include <CGAL/Deformable_simplicial_complex_cell_base_3.h>
#include <CGAL/Deformable_simplicial_complex_traits_3.h>
#include <CGAL/Deformable_simplicial_complex_vertex_base_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Default.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/Triangulation_data_structure_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

A tetrahedralized domain each cell of which carries a label. The *interface* is the set of facets
between cells of different labels; it may be non-manifold, and any number of labels may meet. The
domain is a ball, in most cases a box whose sides are known to the complex.

Invariant: every finite cell is positively oriented, decided by exact predicates. Each member
function either keeps that and does what it says, or leaves the complex as it was.

Orders never depend on addresses: lists of simplices are ordered by time stamps, that is by
creation. Handles stay valid until their simplex is removed. Queries about stars, facets of the
interface and components write marks into the cells: one thread at a time may use a complex.

\tparam Traits_ model of `DeformableSimplicialComplexTraits_3`
\tparam Tds_ a `Triangulation_data_structure_3` whose items are models of
        `DeformableSimplicialComplexVertexBase_3` and `DeformableSimplicialComplexCellBase_3`
\tparam QualityMeasure_ model of `TetrahedronQualityMeasure_3`: the quality that cells cache
*/
template <class Traits_ = Deformable_simplicial_complex_traits_3<>, class Tds_ = Default,
          class QualityMeasure_ = Volume_length_ratio_3>
class Deformable_simplicial_complex_3
{
public:
  /// model of `DeformableSimplicialComplexTraits_3`
  using Geom_traits = Traits_;
  /// model of `TetrahedronQualityMeasure_3`
  using Quality_measure = QualityMeasure_;
  /// `Tds_`, or for `Default` one of the vertices and cells of this package
  using Triangulation_data_structure = typename Default::Get<
      Tds_,
      Triangulation_data_structure_3<Deformable_simplicial_complex_vertex_base_3<Traits_>,
                                     Deformable_simplicial_complex_cell_base_3<Traits_>>>::type;
  /// The triangulation that stores the complex.
  using Triangulation = Triangulation_3<Geom_traits, Triangulation_data_structure>;
  /// A position as it is stored and as predicates see it.
  using Point_3 = typename Geom_traits::Point_3;
  /// A position with coordinates of type `double`, to measure with.
  using Approximate_point_3 = typename Geom_traits::Approximate_point_3;
  /// The difference of two such positions.
  using Approximate_vector_3 = typename Geom_traits::Approximate_vector_3;
  /// Refers to a model of `DeformableSimplicialComplexVertexBase_3`; handles compare by time stamp.
  using Vertex_handle = typename Triangulation::Vertex_handle;
  /// Refers to a model of `DeformableSimplicialComplexCellBase_3`; handles compare by time stamp.
  using Cell_handle = typename Triangulation::Cell_handle;
  /// A cell and the index of the vertex opposite to the facet.
  using Facet = typename Triangulation::Facet;
  /// A cell and the indices of the ends of the edge.
  using Edge = typename Triangulation::Edge;
  /// What `replace()` commits.
  using Cavity = Cavity_3<Deformable_simplicial_complex_3>;
  /// What `state()` returns and `restore()` takes.
  using State = Deformable_simplicial_complex_state_3;
  /// The name of a phase: any integer, and 0 for the outside where there is one.
  using Label = int;
  /// Numbers of simplices, indices and time stamps.
  using size_type = std::size_t;

  /// user coordinates = translation + scale * coordinates of the complex
  struct Normalization
  {
    Approximate_vector_3 translation =
        Approximate_vector_3(0, 0, 0); ///< where the origin of the complex is
    double scale = 1;                  ///< length for the user of a unit of length of the complex
  };

  /// \name Creation
  /// @{

  /// An empty complex.
  explicit Deformable_simplicial_complex_3(const Geom_traits& traits = Geom_traits(),
                                           const Quality_measure& quality = Quality_measure());
  /// A copy with the same time stamps, so that it behaves like the original.
  Deformable_simplicial_complex_3(const Deformable_simplicial_complex_3&) = default;
  /// Takes over the content of `other`, which becomes empty. Handles stay valid. Constant time.
  Deformable_simplicial_complex_3(Deformable_simplicial_complex_3&& other)
      : Deformable_simplicial_complex_3() {
    swap(other);
  }
  /// Copies or moves, as the constructors do.
  Deformable_simplicial_complex_3& operator=(Deformable_simplicial_complex_3 other) {
    swap(other);
    return *this;
  }

  /// Exchanges the content of two complexes. Handles stay valid. Constant time.
  void swap(Deformable_simplicial_complex_3& other);
  /// Empties the complex, which keeps its traits and its quality measure. Handles are invalidated.
  void clear() { *this = Deformable_simplicial_complex_3(geom_traits(), m_quality_measure); }

  /*!
  Replaces the complex by labelled tetrahedra. Vertices and cells are stored along a Hilbert curve.

  \param points vertices; each must be used.
  \param tetrahedra index quadruples, positively oriented.
  \param labels one label for each tetrahedron.
  \return the vertices in the order of `points`
  \throws Invalid_tetrahedra_error if sizes or indices do not fit, coordinates are not finite, the
         extent of the domain is not in [1e-30, 1e30], a vertex is unused, a tetrahedron is not
         positive, or the tetrahedra do not form a ball. The complex is then unchanged.
  \pre the boundary of the domain does not intersect itself

  n log n in the number of tetrahedra.
  */
  std::vector<Vertex_handle> assign(const std::vector<Point_3>& points,
                                    const std::vector<std::array<size_type, 4>>& tetrahedra,
                                    const std::vector<Label>& labels);

  /// Stores vertices and cells along a Hilbert curve again, as `assign()` did. Handles are
  /// invalidated; destinations, and changes of components not taken yet, are forgotten.
  void sort_storage();

  /// Everything needed to continue a computation to the same bits.
  State state() const;

  /// The complex that `state()` described. \throws Invalid_tetrahedra_error if the state is none of
  /// a valid complex; this one is then unchanged.
  void restore(const State& state);

  /// @}
  /// \name Access
  /// @{

  /// The triangulation that stores the complex, to look at.
  const Triangulation& triangulation() const { return m_triangulation; }
  /// The geometric traits object.
  const Geom_traits& geom_traits() const { return m_triangulation.geom_traits(); }
  /// The quality measure.
  const Quality_measure& quality_measure() const { return m_quality_measure; }
  /// Number of finite vertices. Constant time.
  size_type number_of_vertices() const { return m_triangulation.number_of_vertices(); }
  /// Number of finite cells. Constant time in the number of cells.
  size_type number_of_cells() const;
  std::vector<Vertex_handle> vertices() const; ///< finite vertices by increasing time stamp
  std::vector<Cell_handle> cells() const;      ///< finite cells by increasing time stamp

  /// Whether the vertex that v pointed to when it had this time stamp still exists.
  bool is_alive(Vertex_handle v, size_type time_stamp) const {
    return m_triangulation.tds().vertices().is_used(v) && v->time_stamp() == time_stamp;
  }
  /// Whether the cell that c pointed to when it had this time stamp still exists.
  bool is_alive(Cell_handle c, size_type time_stamp) const {
    return m_triangulation.tds().cells().is_used(c) && c->time_stamp() == time_stamp;
  }

  /// Whether v is the infinite vertex, which lies outside the domain.
  bool is_infinite(Vertex_handle v) const { return v == m_triangulation.infinite_vertex(); }
  /// Whether the infinite vertex is one of the vertices of c.
  bool is_infinite(Cell_handle c) const { return m_triangulation.is_infinite(c); }
  /// Where v is, in the coordinates of the complex. \pre v is finite
  Approximate_point_3 position(Vertex_handle v) const {
    return geom_traits().construct_approximate_point_3_object()(v->point());
  }
  /// The cells around v, infinite ones included, in `star` (cleared first), v->cell() first.
  void star(Vertex_handle v, std::vector<Cell_handle>& star) const;

  /// The coordinates that the user sees in files, see `Normalization`. Everything else, volumes and
  /// areas included, is in the coordinates of the complex.
  const Normalization& normalization() const { return m_normalization; }
  /// Sets `normalization()`. Nothing moves.
  void set_normalization(const Normalization& n) { m_normalization = n; }
  /// Where v is, in the coordinates of the user. \pre v is finite
  Approximate_point_3 user_position(Vertex_handle v) const {
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
  /// Whether a facet of the interface contains the edge. Linear in the number of cells around it.
  bool is_interface(const Edge& e) const;
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
  std::array<Vertex_handle, 3> facet_vertices(const Facet& f) const {
    static constexpr int opposite[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const int* i = opposite[f.second];
    return {f.first->vertex(i[0]), f.first->vertex(i[1]), f.first->vertex(i[2])};
  }

  /// Mean length of the edges of the interface when the complex was built, the unit of lengths
  /// everywhere; 0 without an interface.
  double mean_interface_edge() const { return m_mean_interface_edge; }
  /// The smallest length of such an edge; 0 without an interface.
  double minimum_interface_edge() const { return m_minimum_interface_edge; }
  /// Makes the edges of the present interface the unit of lengths, instead of those when the
  /// complex was built: where labels came later. Linear.
  void measure_interface_edges();

  /// @}
  /// \name Measures
  /// @{

  double volume(Label label) const { return m_totals.volume(label); }            ///< constant time
  size_type number_of_cells(Label label) const { return m_totals.cells(label); } ///< constant time
  double area(const Facet& f) const; ///< \pre f is finite
  double area(Label label) const; ///< of the label's interface, without the boundary of the domain
  double area(Label a, Label b) const; ///< of the interface between two labels
  /// V - E + F of the label's interface: 2 for a ball.
  int euler_characteristic(Label label) const;
  /// Connected components through facets. Linear if the topology may have changed, else in the
  /// number of components.
  size_type number_of_components(Label label) const {
    update_components();
    return m_components.number_of_components(label);
  }

  /// What happened to components since the last call. `deform_interface()` takes the events too,
  /// when it begins, when it ends and after passes in which the topology changed.
  /// Linear if the topology may have changed.
  std::vector<Component_event> take_component_events() {
    update_components();
    return m_components.take_events();
  }

  /// @}
  /// \name Motion
  /// @{

  /// The point nearest to q that v may go to within the sides of the domain it lies on.
  Point_3 admissible_destination(Vertex_handle v, const Point_3& q) const;

  /// Whether all cells of a star, the star of v, would be positively oriented with v at q; exact.
  bool is_positive_star(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const Point_3& q) const;

  /*!
  Moves v towards q in a straight line: to q if every incident cell is positively oriented there,
  else almost to the first point where one would be flat (Algorithm 2 of the paper). Positive at
  both ends of a segment means positive between, as volumes are linear in one vertex.

  \param q finite coordinates; a vertex on a side of the domain goes to `admissible_destination()`.
  \param margin the part of the way to the flat position that v keeps clear of it, in (0, 1).
  \return the part of the way to its admissible destination that v went, in [0, 1]; 1 means it is
          there, exactly. At 0 its coordinates are what they were, bit for bit.

  Linear in the star of v.
  */
  double move_vertex(Vertex_handle v, const Point_3& q, double margin = 1. / 1024);

  /// Puts v at p. \pre `star` is the star of v and `is_positive_star(v, star, p)`
  void set_point(Vertex_handle v, const std::vector<Cell_handle>& star, const Point_3& p);

  /// Puts vertices at points, all at once. \pre `cells` are all cells of the vertices' stars, each
  /// once, and the finite ones are positively oriented afterwards.
  /// \param for_each_index `for_each_index(n, f)` calls `f(i)` for all i below n, in any order and on
  ///        any threads.
  template <class ForEachIndex>
  void set_points(const std::vector<Vertex_handle>& vertices, const std::vector<Point_3>& points,
                  const std::vector<Cell_handle>& cells, const ForEachIndex& for_each_index);

  /// @}
  /// \name Change of the mesh
  /// @{

  /*!
  Commits a cavity: removes its cells, creates its tetrahedra and fills in `cavity.created()` and
  the handles of new vertices, which have no destination. Vertices of removed cells alone vanish if
  no tetrahedron is planned for them, and move to where the cavity has them.
  \pre the cavity was filled since the last change of the complex, `cavity.is_positive()`, and its
       tetrahedra have the boundary of its removed cells.

  n log n in the size of the cavity, plus the stars of its vertices if several labels take part.
  */
  void replace(Cavity& cavity);

  /// Gives a finite cell another label. Linear in the stars of its vertices.
  void relabel(Cell_handle c, Label label);

  /// Remembers that improving c was tried in vain.
  void set_exhausted(Cell_handle c) { c->set_exhausted_quality(float(c->quality())); }

  /// Forgets that, as what is around c has changed.
  void clear_exhausted(Cell_handle c) { c->set_exhausted_quality(2); }

  /// Sets where an interface vertex is to go, in the coordinates of the complex.
  void set_destination(Vertex_handle v, const Point_3& q) { v->set_destination(q); }
  /// Forgets where v is to go.
  void clear_destination(Vertex_handle v) { v->clear_destination(); }
  /// Where v is to be in the end: its destination, or where it is if it has none.
  Approximate_point_3 final_position(Vertex_handle v) const {
    return v->has_destination()
               ? geom_traits().construct_approximate_point_3_object()(v->destination())
               : position(v);
  }

  /// @}

  /*!
  Checks the data structure, every orientation exactly, boundary classes and all that is cached.
  \param verbose tells on `std::cerr` what is wrong, as CGAL's triangulations do
  */
  bool is_valid(bool verbose = false) const;

private:
  using Vertex_indices = Deformable_simplicial_complexes::internal::Cell_vertices;

  double cell_volume(Cell_handle c) const;
  double cell_quality(Cell_handle c) const;
  bool is_positive(Cell_handle c) const;
  bool has_interface_facet(Vertex_handle v) const;
  void sew(Cavity& cavity);
  void initialize_caches();
  void initialize_boundary_classes();
  bool is_on_side(const Facet& f) const;
  void rebuild(const State& state, const std::vector<Point_3>& points);
  void create_items(const State& state, const std::vector<Point_3>& points);
  void check_stars(const std::vector<Vertex_handle>& vertices) const;
  bool report(bool ok, const char* what, bool verbose) const;

  struct Cell_volumes
  {
    const Deformable_simplicial_complex_3& complex;
    std::int64_t units(Cell_handle c) const {
      return complex.m_totals.units(complex.cell_volume(c));
    }
    double to_double(std::int64_t units) const { return complex.m_totals.volume_of(units); }
  };
  void update_components() const { m_components.update(m_triangulation, Cell_volumes{*this}); }

  struct Half_facet
  {
    std::array<std::uint32_t, 3> vertices;
    Cell_handle cell;
    int index;
  };

  Triangulation m_triangulation;
  Quality_measure m_quality_measure;
  Deformable_simplicial_complexes::internal::Label_totals m_totals;
  Normalization m_normalization;
  double m_mean_interface_edge = 0, m_minimum_interface_edge = 0;

  mutable Deformable_simplicial_complexes::internal::Component_tracker m_components;

  // Buffers whose memory is reused.
  mutable std::vector<Cell_handle> m_star;
  std::vector<Half_facet> m_half_facets;
  std::vector<std::int64_t> m_volume_changes;
};

} // namespace CGAL

#include <CGAL/Deformable_simplicial_complex_3/internal/complex_impl.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/complex_motion_impl.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/complex_storage_impl.h>

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

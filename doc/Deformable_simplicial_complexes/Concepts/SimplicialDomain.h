/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The global shape of the space that a complex fills. A domain defines the outside, the positions of
the vertices of a cell as seen from the cell, and the motion along the boundary. All functions that
move or measure use the domain and do not compare raw coordinates. So they also work if space is
periodic. The concept is the same in the plane and in space.

All functions are `const` and are called often. `Complex` is an instance of
`CGAL::Deformable_simplicial_complexes::Labeled_complex`.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Ball_domain}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Solid_domain}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Torus_domain}
\if DSC_PROJECT
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Part_domain}
\endif
\cgalHasModelsEnd
*/
class SimplicialDomain
{
public:
  /// Whether there are an infinite vertex and a boundary. If `false`, the domain must provide
  /// `measure()`; otherwise, it must provide `classify_boundary()` and `keeps_side()`.
  static constexpr bool has_outside;

  /// Whether there is a boundary, and it is a sphere.
  static constexpr bool is_ball;

  /// Returns whether the edges at a vertex stay, and its cells keep their labels. Other cells may
  /// change freely.
  template <class Vertex> static constexpr bool is_constrained(const Vertex& v);

  /// Returns whether a vertex lies outside the domain. Such a vertex has no position, and its cells
  /// are infinite.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Vertex_handle v) const;

  /// Returns whether a cell has a vertex outside the domain.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Cell_handle c) const;

  /// Returns the stored image of a point with coordinates of type `double`.
  template <class Point> Point canonical(const Point& p) const;

  /// Returns the image of `q` that is nearest to `p`.
  template <class Point> Point nearest_image(const Point& p, const Point& q) const;

  /// Returns `f(corner(0), ..., corner(n - 1))`, where the corners of a cell are replaced by images
  /// that form a simplex. Corners are points with coordinates of type `double`.
  template <class Complex, class Function, class Corner>
  auto apply(const Function& f, const Corner& corner) const;

  /// Returns the exact orientation of a cell with these corners of type `Complex::Point`. Returns
  /// `ZERO` if the domain does not permit the cell.
  template <class Complex, class Corner>
  Orientation orientation(const Complex& complex, const Corner& corner) const;

  /// Returns the point nearest to `q` to which `v` can move.
  template <class Complex>
  typename Complex::Point admissible(const Complex& complex, typename Complex::Vertex_handle v,
                                     const typename Complex::Point& q) const;

  /// Returns the periods along each axis; 0 for an axis that is not periodic.
  template <int d> std::array<double, d> periods() const;

  /// Returns the domain of a complex with the given state.
  /// \throws CGAL::Deformable_simplicial_complexes::Invalid_cells_error if the state has a domain of another kind
  template <int d> static SimplicialDomain of(const State<d>& state);

  /// Returns the total volume of all cells.
  double measure() const;

  /// Sets the boundary classes of the vertices on the boundary.
  template <class Complex> void classify_boundary(const Complex& complex) const;

  /// Returns whether a facet of the boundary stays in its side under all permitted motions of its
  /// vertices.
  template <class Complex>
  bool keeps_side(const Complex& complex, const typename Complex::Facet& f) const;
};

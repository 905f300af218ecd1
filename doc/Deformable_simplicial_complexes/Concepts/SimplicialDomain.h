/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The shape of space as a whole, of which a simplicial complex fills a part or all: what lies outside,
how a cell sees its vertices, and what the boundary permits. Whatever moves or measures asks the
domain instead of comparing raw coordinates, so that it also holds where space is periodic.

The functions are called often and are const; `Complex` is an instance of
`CGAL::Deformable_simplicial_complexes::Labelled_complex`.

\cgalRefines `DefaultConstructible`, `CopyConstructible`, `Assignable`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Ball_domain}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Torus_domain}
\cgalHasModelsEnd
*/
class SimplicialDomain
{
public:
  /// whether there is an infinite vertex, which lies outside, and a boundary. If not, `measure()`
  /// is asked for, otherwise `classify_boundary()` and `keeps_side()`.
  static constexpr bool has_outside;

  /// whether a vertex lies outside the domain: it has no position, and no cell with it is filled.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Vertex_handle v) const;

  /// whether a cell has a vertex outside.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Cell_handle c) const;

  /// the image of a point, with coordinates of type `double`, that is stored.
  template <class Point> Point canonical(const Point& p) const;

  /// the image of `q` that is seen from `p`.
  template <class Point> Point near(const Point& p, const Point& q) const;

  /// `f(corner(0), ..., corner(n - 1))` with images of the corners of a cell in which it is a
  /// simplex; the corners are points with coordinates of type `double`.
  template <class Complex, class Function, class Corner>
  auto apply(const Function& f, const Corner& corner) const;

  /// the orientation of a cell with these corners, of type `Complex::Point`, without rounding;
  /// `ZERO` if the domain does not permit it.
  template <class Complex, class Corner>
  Orientation orientation(const Complex& complex, const Corner& corner) const;

  /// the point nearest to `q` that `v` may go to.
  template <class Complex>
  typename Complex::Point admissible(const Complex& complex, typename Complex::Vertex_handle v,
                                     const typename Complex::Point& q) const;

  /// the periods of space along each axis, 0 where it does not repeat itself.
  template <int d> std::array<double, d> periods() const;

  /// the domain of a complex in some state.
  /// \throws Invalid_cells_error if it was one of another kind
  template <int d> static SimplicialDomain of(const State<d>& state);

  /// what all cells measure together.
  double measure() const;

  /// sets the boundary classes of the vertices of the boundary.
  template <class Complex> void classify_boundary(const Complex& complex) const;

  /// whether a facet of the boundary stays within it whatever its vertices may do.
  template <class Complex>
  bool keeps_side(const Complex& complex, const typename Complex::Facet& f) const;
};

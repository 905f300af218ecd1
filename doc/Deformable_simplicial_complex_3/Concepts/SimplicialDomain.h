/*!
\ingroup PkgDeformableSimplicialComplex3Concepts
\cgalConcept

The shape of space as a whole, of which a simplicial complex fills a part or all: what lies outside,
how a cell sees its vertices, and what the boundary permits. Whatever moves or measures asks the
domain instead of comparing raw coordinates, so that it also holds where space is periodic.

The functions are called often and are const; `Complex` is an instance of
`CGAL::Deformable_simplicial_complexes::Labelled_complex`.

\cgalRefines `DefaultConstructible`, `CopyConstructible`, `Assignable`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Ball_domain}
\cgalHasModelsEnd
*/
class SimplicialDomain
{
public:
  /// whether a vertex lies outside the domain: it has no position, and no cell with it is filled.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Vertex_handle v) const;

  /// whether a cell has a vertex outside.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Cell_handle c) const;

  /// where the cell `c`, not outside, sees its vertex `i` if that is at `p`. All corners of a cell are
  /// seen in one chart, in which it is a simplex.
  template <class Complex>
  typename Complex::Approximate_point seen(const Complex& complex, typename Complex::Cell_handle c,
                                           int i,
                                           const typename Complex::Approximate_point& p) const;

  /// where the vertex `j` of `c` is as seen from its vertex `i`, if it is at `p`.
  template <class Complex>
  typename Complex::Approximate_point
  seen_from(const Complex& complex, typename Complex::Cell_handle c, int i, int j,
            const typename Complex::Approximate_point& p) const;

  /// the same as `seen()` for the points that the orientation predicate takes, without rounding.
  template <class Complex>
  typename Complex::Point seen_exactly(const Complex& complex, typename Complex::Cell_handle c,
                                       int i, const typename Complex::Point& p) const;

  /// the point nearest to `q` that `v` may go to.
  template <class Complex>
  typename Complex::Point admissible(const Complex& complex, typename Complex::Vertex_handle v,
                                     const typename Complex::Point& q) const;

  /// sets the boundary classes of the vertices of the boundary, if there is one.
  template <class Complex> void classify_boundary(const Complex& complex) const;

  /// whether a facet of the boundary stays within it whatever its vertices may do.
  template <class Complex>
  bool keeps_side(const Complex& complex, const typename Complex::Facet& f) const;
};

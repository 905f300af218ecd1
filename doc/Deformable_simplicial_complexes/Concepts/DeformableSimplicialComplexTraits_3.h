/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The geometry that `CGAL::Deformable_simplicial_complex_3`, the mesh operations, and the functions
that move interfaces need. What decides is exact: orientations, and with them which facet of its
star a vertex meets. What measures is not: volumes and qualities are computed on points with
coordinates of type `double`. The coordinates of `Point_3` itself are never asked for, except where
points come from or go to somewhere else: building from surfaces, and files.

\cgalRefines `DefaultConstructible`, `CopyConstructible`, `Assignable`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complex_traits_3<Kernel>, for any kernel with exact predicates}
\cgalHasModelsEnd
*/
class DeformableSimplicialComplexTraits_3
{
public:
  /// \name Types
  /// @{

  /// A point in space, a model of `DefaultConstructible`, `CopyConstructible`, `Assignable` and
  /// `EqualityComparable`; two points are equal if and only if their coordinates are.
  typedef unspecified_type Point_3;

  /// `CGAL::Simple_cartesian<double>::%Point_3`
  typedef unspecified_type Approximate_point_3;

  /// `CGAL::Simple_cartesian<double>::%Vector_3`
  typedef unspecified_type Approximate_vector_3;

  /// @}
  /// \name Types Named by CGAL::Triangulation_3
  /// The triangulation in which a complex is stored names these types, but nothing that is done
  /// with a complex uses them: incomplete types will do.
  /// @{

  /// any type
  typedef unspecified_type Segment_3;

  /// any type
  typedef unspecified_type Triangle_3;

  /// any type
  typedef unspecified_type Tetrahedron_3;

  /// any type
  typedef unspecified_type Construct_point_3;

  /// @}

  /// \name Predicates
  /// @{

  /// A function object with
  /// `CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const
  /// Point_3& s) const`, the sign of the volume of a tetrahedron, exactly. It is invariant under
  /// even permutations of the points.
  typedef unspecified_type Orientation_3;

  /*!
  A function object that tells where a ray leaves the star of its source, with

  `CGAL::Star_exit_3 operator()(const Point_3& p, const Point_3& q, const
  std::vector<std::array<Point_3, 3>>& facets) const`

  where `p` is the source of the ray, `q != p` a point on it, and `facets` is the link of `p`:
  triples of points `a`, `b`, `c` with `(p, a, b, c)` positively oriented. The star fills all
  directions around `p`, each but once; if `p` lies on the boundary of the domain, some directions
  are missing.

  The result consists of
  - `facet`, the index of the first facet that the ray meets, decided exactly, or the number of
  facets if it meets none;
  - `dimension`, that of the simplex in the inside of which it does: 2, 1 or 0 for a facet, an edge
  or a vertex, decided exactly;
  - `parameter`, the number `t` for which `p + t (q - p)` lies in the plane of that facet, up to
    rounding; 0 if there is no such facet.
  */
  typedef unspecified_type Link_intersection_3;

  /// @}
  /// \name Constructions
  /// @{

  /// A function object with `Approximate_point_3 operator()(const Point_3& p) const`: the point
  /// with coordinates of type `double` that is nearest to `p`, up to rounding. It is `q` again if
  /// `p` was made from `q` by `Construct_exact_point_3`.
  typedef unspecified_type Construct_approximate_point_3;

  /// A function object with `Point_3 operator()(const Approximate_point_3& p) const`: the point
  /// with exactly these coordinates.
  typedef unspecified_type Construct_exact_point_3;

  /// A function object with
  /// `double operator()(const Approximate_point_3& p, const Approximate_point_3& q, const
  /// Approximate_point_3& r, const Approximate_point_3& s) const`, the volume of a tetrahedron up
  /// to rounding, positive for a positively oriented one.
  typedef unspecified_type Compute_approximate_volume_3;

  /// @}
  /// \name Access to Function Objects
  /// @{

  /// returns a function object.
  Orientation_3 orientation_3_object() const;

  /// returns a function object.
  Link_intersection_3 link_intersection_3_object() const;

  /// returns a function object.
  Construct_approximate_point_3 construct_approximate_point_3_object() const;

  /// returns a function object.
  Construct_exact_point_3 construct_exact_point_3_object() const;

  /// returns a function object.
  Compute_approximate_volume_3 compute_approximate_volume_3_object() const;

  /// @}
};

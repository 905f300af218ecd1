/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The geometric traits of `CGAL::Deformable_simplicial_complex_3`. Predicates are exact: the
orientation, and the facet of its star that a moving vertex meets first. Measures are approximate:
volumes and qualities are computed from points with coordinates of type `double`. Only construction
from surfaces and file input and output access the coordinates of `Point_3`.

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
  /// `EqualityComparable`. Two points are equal if and only if their coordinates are equal.
  typedef unspecified_type Point_3;

  /// `CGAL::Epick::%Point_3`
  typedef unspecified_type Point_3;

  /// `CGAL::Epick::%Vector_3`
  typedef unspecified_type Vector_3;

  /// @}
  /// \name Types Named by CGAL::Triangulation_3
  /// The triangulation of a complex names these types. A complex does not use them, so incomplete
  /// types are sufficient.
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
  /// Point_3& s) const`, which returns the exact sign of the volume of a tetrahedron. The result is
  /// invariant under even permutations of the points.
  typedef unspecified_type Orientation_3;

  /// @}
  /// \name Constructions
  /// @{

  /// A function object with `Point_3 operator()(const Point_3& p) const`. It returns the point with
  /// coordinates of type `double` that is nearest to `p`, up to rounding. For a point that
  /// `Construct_exact_point_3` made from `q`, it returns `q`.
  typedef unspecified_type Construct_approximate_point_3;

  /// A function object with `Point_3 operator()(const Point_3& p) const`. It returns the point with
  /// exactly the same coordinates.
  typedef unspecified_type Construct_exact_point_3;

  /// A function object with
  /// `double operator()(const Point_3& p, const Point_3& q, const
  /// Point_3& r, const Point_3& s) const`. It returns the volume of a tetrahedron up
  /// to rounding. The volume is positive for a positively oriented tetrahedron.
  typedef unspecified_type Compute_approximate_volume_3;

  /// @}
  /// \name Access to Function Objects
  /// @{

  /// Returns a function object.
  Orientation_3 orientation_3_object() const;

  /// Returns a function object.
  Construct_approximate_point_3 construct_approximate_point_3_object() const;

  /// Returns a function object.
  Construct_exact_point_3 construct_exact_point_3_object() const;

  /// Returns a function object.
  Compute_approximate_volume_3 compute_approximate_volume_3_object() const;

  /// @}
};

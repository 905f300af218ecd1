/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The geometric traits of `CGAL::Deformable_simplicial_complex_2`. The counterpart in space is
`DeformableSimplicialComplexTraits_3`. The predicate is exact: the orientation of a triangle.
Measures are approximate: areas and qualities are computed from points with coordinates of type
`double`. Construction from curves and file input and output can also need the coordinates of
`Point_2`.

\cgalRefines `DefaultConstructible`, `CopyConstructible`, `Assignable`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complex_traits_2<Kernel>, for any kernel with exact predicates}
\cgalHasModelsEnd
*/
class DeformableSimplicialComplexTraits_2
{
public:
  /// \name Types
  /// @{

  /// A point in the plane, a model of `DefaultConstructible`, `CopyConstructible`, `Assignable` and
  /// `EqualityComparable`. Two points are equal if and only if their coordinates are equal.
  typedef unspecified_type Point_2;

  /// `CGAL::Epick::%Point_2`
  typedef unspecified_type Point_2;

  /// `CGAL::Epick::%Vector_2`
  typedef unspecified_type Vector_2;

  /// @}
  /// \name Types Named by CGAL::Triangulation_2
  /// The triangulation of a complex names these types. A complex does not use them, so incomplete
  /// types are sufficient, except for `Construct_point_2`.
  /// @{

  /// any type
  typedef unspecified_type Segment_2;

  /// any type
  typedef unspecified_type Triangle_2;

  /// any type
  typedef unspecified_type Compare_x_2;

  /// any type
  typedef unspecified_type Compare_y_2;

  /// A function object with `Point_2 operator()(const Point_2& p) const`. A complex does not call
  /// it, so the operator need not be defined.
  typedef unspecified_type Construct_point_2;

  /// @}

  /// \name Predicates
  /// @{

  /// A function object with
  /// `CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const`,
  /// which returns the exact sign of the area of a triangle. The result is invariant under even
  /// permutations of the points.
  typedef unspecified_type Orientation_2;

  /// @}
  /// \name Constructions
  /// @{

  /// A function object with `Point_2 operator()(const Point_2& p) const`. It returns the point with
  /// coordinates of type `double` that is nearest to `p`, up to rounding. For a point that
  /// `Construct_exact_point_2` made from `q`, it returns `q`.
  typedef unspecified_type Construct_approximate_point_2;

  /// A function object with `Point_2 operator()(const Point_2& p) const`. It returns the point with
  /// exactly the same coordinates.
  typedef unspecified_type Construct_exact_point_2;

  /// A function object with
  /// `double operator()(const Point_2& p, const Point_2& q, const
  /// Point_2& r) const`. It returns the area of a triangle up to rounding. The area is positive if
  /// the vertices are in counterclockwise order.
  typedef unspecified_type Compute_approximate_area_2;

  /// @}
  /// \name Access to Function Objects
  /// @{

  /// Returns a function object.
  Orientation_2 orientation_2_object() const;

  /// Returns a function object.
  Construct_approximate_point_2 construct_approximate_point_2_object() const;

  /// Returns a function object.
  Construct_exact_point_2 construct_exact_point_2_object() const;

  /// Returns a function object.
  Compute_approximate_area_2 compute_approximate_area_2_object() const;

  /// @}
};

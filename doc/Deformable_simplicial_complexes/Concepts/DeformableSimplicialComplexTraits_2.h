/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The geometric traits of `CGAL::Deformable_simplicial_complex_2`: points of the plane whose coordinates have the type `double`, and the
exact orientation of a triangle. Every \cgal kernel with exact predicates whose `FT` is `double` is a model; a kernel of \cgal
whose predicates round does not compile. All measures, such as
areas and qualities, are computed with `double` arithmetic.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Exact_predicates_inexact_constructions_kernel}
\cgalHasModels{CGAL::Filtered_kernel<CGAL::Simple_cartesian<double> >}
\cgalHasModelsEnd

\sa `DeformableSimplicialComplexTraits_3`
*/
class DeformableSimplicialComplexTraits_2
{
public:
  /// \name Types
  /// @{

  /// `double`
  typedef unspecified_type FT;

  /// A point of a \cgal kernel with this `FT`.
  typedef unspecified_type Point_2;

  /// A vector of the same kernel.
  typedef unspecified_type Vector_2;

  /// A function object with `CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const`, which returns the exact sign of the area of a triangle.
  /// The result is invariant under even permutations of the points.
  typedef unspecified_type Orientation_2;

  /// @}
  /// \name Types Named by CGAL::Triangulation_2
  /// The triangulation of a complex names these types. A complex does not use them, so incomplete types are sufficient,
  /// except for `Construct_point_2`.
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

  /// \name Operations
  /// @{

  /// Returns a function object.
  Orientation_2 orientation_2_object() const;

  /// @}
};

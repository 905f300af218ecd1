/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The geometric traits of `CGAL::Deformable_simplicial_complex_3`: points of space whose coordinates have the type `double`, and the
exact orientation of a tetrahedron. Every \cgal kernel with exact predicates whose `FT` is `double` is a model; a kernel of \cgal
whose predicates round does not compile. All measures, such as
volumes and qualities, are computed with `double` arithmetic.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Exact_predicates_inexact_constructions_kernel}
\cgalHasModels{CGAL::Filtered_kernel<CGAL::Simple_cartesian<double> >}
\cgalHasModelsEnd

\sa `DeformableSimplicialComplexTraits_2`
*/
class DeformableSimplicialComplexTraits_3
{
public:
  /// \name Types
  /// @{

  /// `double`
  typedef unspecified_type FT;

  /// A point of a \cgal kernel with this `FT`.
  typedef unspecified_type Point_3;

  /// A vector of the same kernel.
  typedef unspecified_type Vector_3;

  /// A function object with `CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const`, which returns the exact sign of the volume of a tetrahedron.
  /// The result is invariant under even permutations of the points.
  typedef unspecified_type Orientation_3;

  /// @}
  /// \name Types Named by CGAL::Triangulation_3
  /// The triangulation of a complex names these types. A complex does not use them, so incomplete types are sufficient.
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

  /// \name Operations
  /// @{

  /// Returns a function object.
  Orientation_3 orientation_3_object() const;

  /// @}
};

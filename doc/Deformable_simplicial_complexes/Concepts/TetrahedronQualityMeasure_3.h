/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

A function object that tells how good a tetrahedron is. The mesh is improved so that its worst
tetrahedra by this measure get better. It is called often: its time decides that of improvement.

A model may have a member `gradient(p, q, r, s)` with the same arguments, which returns the
derivative of the quality by the position of p, an `Approximate_vector_3`. Where there is none,
optimisation takes differences.

\cgalRefines `DefaultConstructible`, `CopyConstructible`, `Assignable`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_length_ratio_3}
\cgalHasModels{CGAL::Minimum_sine_3}
\cgalHasModels{CGAL::Biased_minimum_sine_3}
\cgalHasModels{CGAL::Radius_ratio_3}
\cgalHasModelsEnd
*/
class TetrahedronQualityMeasure_3
{
public:
  /*!
  returns the quality of a tetrahedron: 1 if it is regular and less if it is not, 0 if it is flat,
  below 0 if it is negatively oriented, all up to rounding. It is continuous where the volume is not
  zero, and invariant under similarities and under even permutations of the vertices, up to
  rounding. It depends on the arguments only: the same call returns the same bits.
  */
  double operator()(const DeformableSimplicialComplexTraits_3::Approximate_point_3& p,
                    const DeformableSimplicialComplexTraits_3::Approximate_point_3& q,
                    const DeformableSimplicialComplexTraits_3::Approximate_point_3& r,
                    const DeformableSimplicialComplexTraits_3::Approximate_point_3& s) const;
};

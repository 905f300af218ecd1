/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

A function object that returns the quality of a tetrahedron. Mesh optimization raises the quality of
the worst tetrahedra. The function is called often, so its cost dominates mesh optimization. Functions that make a complex
default-construct the measure; to give it a state, construct an empty complex with it, and use
`CGAL::Deformable_simplicial_complexes::Labeled_complex::assign()`.

A model can have a member `gradient(p, q, r, s)` with the same arguments. It returns the derivative
of the quality with respect to the position of p, a `Vector_3`. Without this member, the
optimization uses finite differences.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Volume_length_ratio_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Minimum_sine_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Biased_minimum_sine_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Radius_ratio_3}
\cgalHasModelsEnd
*/
class TetrahedronQualityMeasure_3
{
public:
  /*!
  Returns the quality of a tetrahedron, up to rounding. The quality is 1 for a regular tetrahedron,
  between 0 and 1 for a positively oriented one, 0 for a flat one, and negative for a negatively
  oriented one. The quality is continuous where the volume is not zero. It is invariant under
  similarities and under even permutations of the vertices, up to rounding. It is a deterministic
  function of the arguments.
  */
  double operator()(const DeformableSimplicialComplexTraits_3::Point_3& p,
                    const DeformableSimplicialComplexTraits_3::Point_3& q,
                    const DeformableSimplicialComplexTraits_3::Point_3& r,
                    const DeformableSimplicialComplexTraits_3::Point_3& s) const;
};

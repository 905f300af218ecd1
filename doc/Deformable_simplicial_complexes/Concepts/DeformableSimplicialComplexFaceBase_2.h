/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The triangle of a `CGAL::Deformable_simplicial_complex_2`, with a label and cached values. The triangles are the cells of
the complex. A model has all members of `DeformableSimplicialComplexCellBase_3`, and no others are required.

\cgalRefines{TriangulationDSFaceBase_2}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complex_face_base_2<Traits\, Fb>}
\cgalHasModelsEnd
*/
class DeformableSimplicialComplexFaceBase_2
{};

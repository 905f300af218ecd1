/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The vertex of a `CGAL::Deformable_simplicial_complex_2`, with a point and cached values. A model has all members of
`DeformableSimplicialComplexVertexBase_3`, with `DeformableSimplicialComplexTraits_2::Point_2` as the type of the point. It
also has other names of two functions of `TriangulationDSVertexBase_2`, so that code for both dimensions can call them.

\cgalRefines{TriangulationDSVertexBase_2}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complex_vertex_base_2<Traits\, Vb>}
\cgalHasModelsEnd
*/
class DeformableSimplicialComplexVertexBase_2
{
public:
  /// `DeformableSimplicialComplexTraits_2::Point_2`
  typedef unspecified_type Point;

  /// \name Incident Triangle
  /// @{

  /// Returns `face()`, one of the incident triangles.
  Face_handle cell() const;

  /// Calls `set_face()`.
  void set_cell(Face_handle c);

  /// @}
};

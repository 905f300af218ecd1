/*!
\ingroup PkgComplexConstructionConcepts
\cgalConcept

A function object that fills the space inside a closed surface with tetrahedra. The given triangles
are facets of these tetrahedra, or unions of facets.
`CGAL::Deformable_simplicial_complexes::make_deformable_simplicial_complex_3()` passes the surfaces
of the interface and a box around them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Conforming_tetrahedralizer_3}
\cgalHasModels{CGAL::Tetgen_tetrahedralizer_3}
\cgalHasModelsEnd
*/
class ConstrainedTetrahedralizer_3
{
public:
  /*!
  Tetrahedralizes the space inside the outermost triangles. A model may add points inside this
  space. A model may also add points on triangles, up to rounding, and then returns the facets into
  which triangles are divided.

  \param points finite and distinct points. Each point is a corner of a triangle.
  \param triangles indices into `points`, with any orientation. The triangles form closed surfaces that do not
         intersect. One surface encloses the others.

  \return a `CGAL::Deformable_simplicial_complexes::Tetrahedralization_3`, or an object that is
  converted to it:
  - `points` begins with the input points in their order and with identical coordinates. Each point
  is a corner of a tetrahedron.
  - `tetrahedra` are positively oriented, decided by exact arithmetic.
  - `facets` and `triangles_of_facets` are empty if each input triangle is a facet of the
  tetrahedra. Otherwise, each input triangle is the union of the facets with its index, up to
  rounding of the added points. Facets have the orientation of their triangle.

  The outermost triangles are the boundary of the union.

  \throws CGAL::Deformable_simplicial_complexes::Tetrahedralization_error if this is not possible
  */
  CGAL::Deformable_simplicial_complexes::Tetrahedralization_3
  operator()(const std::vector<std::array<double, 3>>& points,
             const std::vector<std::array<std::size_t, 3>>& triangles) const;
};

/*!
\ingroup PkgComplexConstructionConcepts
\cgalConcept

A function object that fills the space inside a closed surface with tetrahedra. The given triangles
are facets of these tetrahedra.
`CGAL::Deformable_simplicial_complexes::make_deformable_simplicial_complex_3()` passes the surfaces
of the interface and a box around them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Tetgen_tetrahedralizer_3}
\cgalHasModelsEnd
*/
class ConstrainedTetrahedralizer_3
{
public:
  /*!
  Tetrahedralizes the space inside the outermost triangles. A model may add points inside this
  space, but not on triangles.

  \param points finite and distinct points. Each point is a corner of a triangle.
  \param triangles indices into `points`, with any orientation. The triangles form closed surfaces that do not
         intersect. One surface encloses the others.

  \return an object of any type with the members of
  `CGAL::Deformable_simplicial_complexes::Tetrahedralization_3`:
  - `points`, a random access range of `std::array<double, 3>`. It begins with the input points in
  their order and with identical coordinates. Each point is a corner of a tetrahedron.
  - `tetrahedra`, a `std::vector<std::array<std::size_t, 4>>` of indices into `points`. All
  tetrahedra are positively oriented, decided by exact arithmetic.

  Each input triangle is a facet of the tetrahedra. The outermost triangles are the boundary of the
  union.

  \throws CGAL::Deformable_simplicial_complexes::Tetrahedralization_error if this is not possible
  */
  unspecified_type operator()(const std::vector<std::array<double, 3>>& points,
                              const std::vector<std::array<std::size_t, 3>>& triangles) const;
};

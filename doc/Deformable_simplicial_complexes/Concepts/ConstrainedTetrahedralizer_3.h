/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

A function object that fills the space inside a closed surface with tetrahedra, in such a way that
given triangles are facets of them. `CGAL::make_deformable_simplicial_complex_3()` passes to it the
surfaces that become the interface, and a box around them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Tetgen_tetrahedralizer_3}
\cgalHasModelsEnd
*/
class ConstrainedTetrahedralizer_3
{
public:
  /*!
  Tetrahedralizes the space inside the triangles that can be seen from outside. Points may be added
  in that space, but not on triangles.

  \param points finite, no two equal, each one a corner of a triangle
  \param triangles indices into `points`, in any orientation. They form closed surfaces that do not
         meet, one of which encloses the others.

  \return an object of any type with the members of `CGAL::Tetrahedralization_3`:
  - `points`, a random access range of `std::array<double, 3>`, begins with the input points in
    their order, the coordinates being the same bit for bit; each point is a corner of a
  tetrahedron;
  - `tetrahedra`, a `std::vector<std::array<std::size_t, 4>>` of indices into these points, contains
    only positively oriented tetrahedra, decided by exact arithmetic;
  - each triangle is a facet of them, and those that can be seen from outside are their boundary.

  \throws CGAL::Deformable_simplicial_complexes::Tetrahedralization_error if this is not possible
  */
  unspecified_type operator()(const std::vector<std::array<double, 3>>& points,
                              const std::vector<std::array<std::size_t, 3>>& triangles) const;
};

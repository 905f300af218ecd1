/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A velocity that depends on the whole interface, for example a motion along normals or a motion by
curvature. `CGAL::Deformable_simplicial_complexes::advect_interface()` calls it for all vertices at
once. The integration scheme determines the number of calls in a time step.

`CGAL::Deformable_simplicial_complexes::advect_adaptively()` uses two optional members. The member
`static constexpr bool contracts_interface` is `true` if the velocity decreases the area of the
interface; then the interface is adapted in each step. The function `bool preserves_volumes() const`
returns `true` if volumes are to be restored after an adaptation.

`Complex` is the type of the complex. A velocity need not define it, and its function can be a
template.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Normal_offset}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Mean_curvature_velocity}
\cgalHasModelsEnd
*/
class InterfaceVelocity
{
public:
  /*!
  Computes the velocities of the vertices of an interface.

  \param snapshot the vertices and facets of the interface
  \param positions the assumed positions of the vertices, in the order of `snapshot.vertices` and in the coordinates of
         the complex. Within a time step, they differ from the positions in the complex.
  \param t the time
  \param velocities the result. It is empty at the beginning and gets the size of `positions`: lengths per unit of
         time, in the coordinates of the complex. If a value is not finite,
         `CGAL::Deformable_simplicial_complexes::advect_interface()` throws.
  */
  void
  operator()(const CGAL::Deformable_simplicial_complexes::Interface_snapshot<Complex>& snapshot,
             const std::vector<Complex::Point>& positions, double t,
             std::vector<Complex::Vector>& velocities) const;
};

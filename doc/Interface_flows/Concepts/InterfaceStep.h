/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A flow that computes the destinations of the whole interface for a time step. It suits flows that
are not integrated from velocities, for example flows whose destinations solve a system of
equations.

`CGAL::Deformable_simplicial_complexes::advect_adaptively()` uses two optional members. The member
`static constexpr bool contracts_interface` is `true` if the flow decreases the area of the
interface; then the interface is adapted in each step. The function `bool preserves_volumes() const`
returns `true` if volumes are to be restored after an adaptation.

The function call may return a `double` instead of nothing: the estimated error of the destinations
due to the length of the step. `Deformation_report::estimated_error` contains it.

`Complex` is the type of the complex. A step need not define it, and its function can be a template.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Face_offset_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Advective_face_offset_3<Field>}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Mean_curvature_flow}
\cgalHasModelsEnd
*/
class InterfaceStep
{
public:
  /*!
  Computes the destinations of the vertices of an interface.

  \param snapshot the vertices and facets of the interface
  \param positions the positions of the vertices at the time `t`, in the order of `snapshot.vertices` and in the
         coordinates of the complex
  \param t the time
  \param dt the length of the step
  \param destinations the result. It is empty at the beginning and gets the size of `positions`: the positions of the
         vertices at the time `t + dt`. If a coordinate is not finite,
         `CGAL::Deformable_simplicial_complexes::advect_interface()` throws.
  */
  void
  operator()(const CGAL::Deformable_simplicial_complexes::Interface_snapshot<Complex>& snapshot,
             const std::vector<Complex::Point>& positions, double t, double dt,
             std::vector<Complex::Point>& destinations) const;
};

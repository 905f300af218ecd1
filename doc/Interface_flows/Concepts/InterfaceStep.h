/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A motion of the whole interface that knows where a step of time leads, for flows that are not
integrated from velocities: where destinations solve a system of equations, or where the step is
part of the construction. `Complex` stands for the type of the complex; a step need not define it,
and its function may be a template.

`CGAL::advect_adaptively()` looks for two optional members. A `static constexpr bool
contracts_interface` that is `true` declares that the step decreases the measure of the interface, so
that the interface is adapted each time. A function `bool preserves_volumes() const` that returns
`true` asks for the restoration of volumes after an adaptation.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Face_offset_3}
\cgalHasModels{CGAL::Advective_face_offset_3<Field>}
\cgalHasModels{CGAL::Mean_curvature_flow_3}
\cgalHasModelsEnd
*/
class InterfaceStep
{
public:
  /*!
  computes where the vertices of an interface go.

  \param snapshot the vertices and triangles of the interface
  \param positions where the vertices are at the time `t`, in the order of `snapshot.vertices`, in
         the coordinates of the complex
  \param t the time
  \param dt the length of the step
  \param destinations is empty and is to become as long as `positions`: where the vertices are at
         the time `t + dt`. Coordinates that are not finite make `CGAL::advect_interface()` throw.
  */
  void operator()(const CGAL::Interface_snapshot_3<Complex>& snapshot,
                  const std::vector<Complex::Approximate_point_3>& positions, double t, double dt,
                  std::vector<Complex::Approximate_point_3>& destinations) const;
};

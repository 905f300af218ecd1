/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A velocity that depends on the whole interface, such as motion along its normals or by its
curvature. `CGAL::advect_interface()` asks for the velocities of all vertices at once, one or more
times for each step of time, as its integration scheme demands. `Complex` stands for the type of the
complex; a velocity need not define it, and its function may be a template.

`CGAL::advect_adaptively()` looks for two optional members. A `static constexpr bool
contracts_interface` that is `true` declares that the velocity decreases the measure of the interface, so
that the interface is adapted each time. A function `bool preserves_volumes() const` that returns
`true` asks for the restoration of volumes after an adaptation.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Normal_offset_3}
\cgalHasModels{CGAL::Mean_curvature_velocity_3}
\cgalHasModelsEnd
*/
class InterfaceVelocity
{
public:
  /*!
  computes the velocities of the vertices of an interface.

  \param snapshot the vertices and triangles of the interface
  \param positions where to take the vertices to be, in the order of `snapshot.vertices`, in the
         coordinates of the complex. They differ from where the vertices are in the middle of a
  step.
  \param t the time
  \param velocities is empty and is to become as long as `positions`: length per unit of time, in
         the coordinates of the complex. Values that are not finite make `CGAL::advect_interface()`
         throw.
  */
  void operator()(const CGAL::Interface_snapshot_3<Complex>& snapshot,
                  const std::vector<Complex::Approximate_point_3>& positions, double t,
                  std::vector<Complex::Approximate_vector_3>& velocities) const;
};

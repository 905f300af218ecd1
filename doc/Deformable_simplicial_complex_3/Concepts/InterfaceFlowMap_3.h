/*!
\ingroup PkgDeformableSimplicialComplex3Concepts
\cgalConcept

A motion of space that is known in closed form, so that `CGAL::advect_interface()` need not
integrate it: whatever the integration scheme, vertices are sent to where the map says. It is asked
for vertices around the interface, too, which follow the interface where it is not finite. `Complex`
stands for the type of the complex; a map need not define it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Rigid_rotation_3}
\cgalHasModelsEnd
*/
class InterfaceFlowMap_3
{
public:
  /// returns where that is at the time `t + dt` which is at `p` at the time `t`, in the coordinates
  /// of the complex. `dt` may be negative.
  Complex::Approximate_point_3 operator()(const Complex::Approximate_point_3& p, double t,
                                          double dt) const;
};

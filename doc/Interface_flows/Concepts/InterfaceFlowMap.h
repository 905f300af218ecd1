/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A motion that is known in closed form, so that `CGAL::advect_interface()` need not integrate it:
whatever the integration scheme, vertices are sent to where the map says. `Complex` stands for the
type of the complex; a map need not define it.

A map that neither folds nor collapses space may define a type `Is_invertible` as `CGAL::Tag_true`.
Vertices around the interface then go with it, too, but where it is not finite.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Rigid_rotation_3}
\cgalHasModelsEnd
*/
class InterfaceFlowMap
{
public:
  /// returns where that is at the time `t + dt` which is at `p` at the time `t`, in the coordinates
  /// of the complex. `dt` may be negative.
  Complex::Approximate_point_3 operator()(const Complex::Approximate_point_3& p, double t,
                                          double dt) const;
};

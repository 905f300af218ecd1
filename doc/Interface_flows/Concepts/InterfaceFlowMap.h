/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A motion in closed form. `CGAL::Deformable_simplicial_complexes::advect_interface()` does not
integrate it: for any integration scheme, the map gives the destinations of the vertices.

A map that neither folds nor collapses space can define a type `Is_invertible` as `CGAL::Tag_true`.
Then vertices near the interface also move with the map where its value is finite.

`Complex` is the type of the complex. A map need not define it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Rigid_rotation_2}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Rigid_rotation_3}
\cgalHasModelsEnd
*/
class InterfaceFlowMap
{
public:
  /// Returns the position at the time `t + dt` of the point that is at `p` at the time `t`, in the
  /// coordinates of the complex. `dt` can be negative.
  Complex::Point operator()(const Complex::Point& p, double t, double dt) const;
};

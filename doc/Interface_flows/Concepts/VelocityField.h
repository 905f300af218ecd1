/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A velocity that depends on position and time only. Any function object of this form is a model, for
example a lambda.

`CGAL::Deformable_simplicial_complexes::advect_interface()` calls the field for each vertex of the
interface, and for free vertices near the interface. Where the velocity of a free vertex is not
finite, the vertex follows the interface. A velocity that depends on the interface, or that is
evaluated for many vertices at once, is an `InterfaceVelocity`.

`Complex` is the type of the complex. A field need not define it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Single_vortex_velocity_2}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Single_vortex_velocity_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Enright_velocity_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Curl_noise_velocity_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Velocity_in_user_coordinates_3<Complex\,Field>}
\cgalHasModelsEnd
*/
class VelocityField
{
public:
  /// Returns the velocity at `p` at the time `t`, in the coordinates of the complex.
  Complex::Vector operator()(const Complex::Point& p, double t) const;
};

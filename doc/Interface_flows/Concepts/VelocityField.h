/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A velocity that depends on place and time only. Any function object of this form will do, such as a
lambda. `CGAL::advect_interface()` calls it for one vertex of the interface after the other, and for
others around, which follow the interface where it is not finite there; what is to be evaluated for many vertices at once, or depends on the interface, is an
`InterfaceVelocity`. `Complex` stands for the type of the complex; a field need not define it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Enright_velocity_3}
\cgalHasModels{CGAL::Single_vortex_velocity_3}
\cgalHasModels{CGAL::Curl_noise_velocity_3}
\cgalHasModels{CGAL::Velocity_in_user_coordinates_3<Complex\,Field>}
\cgalHasModelsEnd
*/
class VelocityField
{
public:
  /// returns the velocity at `p` at the time `t`, in the coordinates of the complex.
  Complex::Approximate_vector_3 operator()(const Complex::Approximate_point_3& p, double t) const;
};

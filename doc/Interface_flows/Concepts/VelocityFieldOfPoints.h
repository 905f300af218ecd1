/*!
\ingroup PkgInterfaceFlowsConcepts
\cgalConcept

A velocity that depends on position and time only, and that is evaluated at many points at once, for
example by a library for arrays. Any function object of this form is a model, for example a lambda.

`CGAL::Deformable_simplicial_complexes::advect_interface()` calls the field for all vertices of the
interface, and for free vertices near the interface. Where the velocity of a free vertex is not
finite, the vertex follows the interface.

`Complex` is the type of the complex. A field need not define it.

\sa `VelocityField`
*/
class VelocityFieldOfPoints
{
public:
  /// Replaces `velocities` by the velocities at `points` at the time `t`, in the coordinates of the
  /// complex.
  void operator()(const std::vector<Complex::Point>& points, double t,
                  std::vector<Complex::Vector>& velocities) const;
};

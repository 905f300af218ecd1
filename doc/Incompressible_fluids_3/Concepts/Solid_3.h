/*!
\ingroup PkgIncompressibleFluids3Concepts
\cgalConcept

A solid, at rest or moving, that liquids do not enter. The inside of a solid has the label of the
void or of a gas. `CGAL::Incompressible_fluid_3` queries the walls of a solid at the vertices
between liquid and void. It queries them at the present position and at the expected destination of
a vertex, which can be inside the solid.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Plane_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Tank_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Box_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Ball_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Cylinder_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Mesh_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Moving_solid_3<Solid>}
\cgalHasModelsEnd
*/
class Solid_3
{
public:
  using Point = CGAL::Epick::Point_3; ///< A point in space.

  /*!
  Appends the walls that a liquid at a point can touch. Each smooth part of the surface is a wall. A
  wall consists of the signed distance, which is negative inside the solid, its gradient, and the
  velocity of the wall there. At a corner, several walls have a distance of about 0.

  A wall is identified by its index in the list. So a solid appends the same walls in the same order
  for all points and times. Walls that are far away can be omitted at the end of the list. A mesh
  appends one wall, at its nearest point. A solid with convex edges can report the plane of a wall
  from behind for a point that is not in front of this wall, see `Wall_3::is_end`. Distances must be
  accurate near the wall only. A vertex inside the solid is moved out by the distance along the
  normal.

  \param p any point, in the coordinates of the complex
  \param t the time
  \param result the list of walls. It can contain walls of other solids.
  */
  void walls(const Point& p, double t,
             std::vector<CGAL::Deformable_simplicial_complexes::Wall_3>& result) const;
};

/*!
\ingroup PkgIncompressibleFluids3Concepts
\cgalConcept

A solid that liquids do not enter, at rest or moving. `CGAL::Incompressible_fluid_3` asks for its walls
at vertices between liquid and void, where they are and where they are expected to arrive, which may be
inside the solid. What is inside is labelled as void.

\cgalRefines `CopyConstructible`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Plane_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Tank_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Ball_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Cylinder_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Mesh_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Moving_solid_3<Solid>}
\cgalHasModelsEnd
*/
class Solid_3
{
public:
  using Point = CGAL::Simple_cartesian<double>::Point_3; ///< of space

  /*!
  appends the walls that a liquid at a point may meet: for each smooth part of the surface the distance,
  negative inside the solid, its gradient, and the velocity there. A corner is where several walls have
  a distance of about 0.

  A wall is known by its place in the list. So a solid has the same walls, in the same order, at all
  points and times; those that are far away may be left out only after all others. A mesh has one, where
  it is nearest. Distances need to be good near the wall only: a vertex inside is put out by the distance
  along the normal.

  \param p any point, in the coordinates of the complex
  \param t the time
  \param result may hold walls of others already
  */
  void walls(const Point& p, double t,
             std::vector<CGAL::Deformable_simplicial_complexes::Wall_3>& result) const;
};

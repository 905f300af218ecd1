/*!
\ingroup PkgDeformableSimplicialComplex3Concepts
\cgalConcept

A solid that the liquids of `CGAL::Deformable_simplicial_complexes::Incompressible_fluid` do not enter:
its surface, as seen from any point. It must be copyable.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Plane_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Tank_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Ball_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Cylinder_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Mesh_solid_3}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Moving_solid_3}
\cgalHasModelsEnd
*/
class Solid_3
{
public:
  /// appends the smooth parts of the surface that a point may touch, at the time t: each with its
  /// signed distance from p, its normal and its velocity. The same parts come in the same order
  /// wherever p is near to all of them.
  void walls(const CGAL::Simple_cartesian<double>::Point_3& p, double t,
             std::vector<CGAL::Deformable_simplicial_complexes::Wall_3>& result) const;
};

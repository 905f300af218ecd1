/*!
\ingroup PkgSolidReconstruction3Concepts
\cgalConcept

A function object that watches `CGAL::reconstruct_point_set_3()`, writes its steps, shows how far it
is, or ends it. If it throws, the exception reaches the caller.

`Complex` stands for the type of the complex; the operator may be a template.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Reconstruction_observer_3}
\cgalHasModelsEnd
*/
class ReconstructionObserver_3
{
public:
  /// is told of the complex before the first step, `step` being 0, and after each one. If it returns
  /// false, the reconstruction ends with what there is.
  bool operator()(const Complex& complex, std::size_t step);
};

/*!
\ingroup PkgSolidReconstruction3Concepts
\cgalConcept

A function object that observes `CGAL::Deformable_simplicial_complexes::reconstruct_point_set_3()`. It can write the
steps, show the progress, or end the reconstruction. If it throws, the exception reaches the caller.

`Complex` is the type of the complex. The operator can be a template.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Reconstruction_observer_3}
\cgalHasModelsEnd
*/
class ReconstructionObserver_3
{
public:
  /// Called with the complex before the first step, where `step` is 0, and after each step. If the function returns
  /// `false`, the reconstruction ends with the present result.
  bool operator()(const Complex& complex, std::size_t step);
};

/*!
\ingroup PkgCutLoci2Concepts
\cgalConcept

The metric of a Riemannian 2-manifold in a chart. The metric determines the geodesics.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Embedded_surface_2}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Metric_tensor_2}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Sphere_like_surface_2}
\cgalHasModelsEnd
*/
class RiemannianMetric_2
{
public:
  /// Returns the first fundamental form and its derivatives at a point of the chart. The result is periodic where the
  /// chart is periodic.
  CGAL::Deformable_simplicial_complexes::Metric_jet_2 operator()(double u, double v) const;
};

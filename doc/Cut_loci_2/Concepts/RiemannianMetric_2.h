/*!
\ingroup PkgCutLoci2Concepts
\cgalConcept

The metric of a Riemannian 2-manifold in a chart: what geodesics follow from.

\cgalRefines `CopyConstructible`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Embedded_surface_2}
\cgalHasModels{CGAL::Metric_tensor_2}
\cgalHasModels{CGAL::Sphere_like_surface_2}
\cgalHasModelsEnd
*/
class RiemannianMetric_2
{
public:
  /// the first fundamental form and its derivatives at a point of the chart, which repeat
  /// themselves with it.
  CGAL::Metric_jet_2 operator()(double u, double v) const;
};

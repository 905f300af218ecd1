/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

A function object that decides whether `CGAL::deform_interface()` and `CGAL::advect_interface()` may
change the topology of the interface. It is asked before each such change, and only then; see
`CGAL::relabeling_keeps_topology()`. If it throws, the exception reaches the caller, and the complex
is valid.

`Complex` stands for the type of the complex; the operator may be a template.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Allow_topology_changes}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Forbid_topology_changes}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Allow_topology_changes_between}
\cgalHasModelsEnd
*/
class TopologyControl
{
public:
  /// whether `cell`, which is nearly flat and lies between two parts of the interface, may take
  /// another label although the topology of its label, of the new one and of the interface changes.
  /// With a manifold interface, other cells of its label may go with it, see
  /// `CGAL::propose_manifold_relabeling()`; where a component vanishes, it stands for all its
  /// cells.
  bool operator()(const Complex& complex, Complex::Cell_handle cell, int label);
};

/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

A function object that permits or rejects changes of the topology of the interface.
`CGAL::Deformable_simplicial_complexes::deform_interface()` and
`CGAL::Deformable_simplicial_complexes::advect_interface()` call it before each change of topology, and only then; see
`CGAL::Deformable_simplicial_complexes::relabeling_keeps_topology()`. If it throws, the exception reaches the caller, and
the complex is valid.

The concept is the same in the plane and in space. `Complex` is the type of the complex. The operator can be a template, and
can be `const`.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Allow_topology_changes}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Forbid_topology_changes}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Allow_topology_changes_between}
\cgalHasModelsEnd
*/
class TopologyControl
{
public:
  /// Returns whether the thin cell `cell` may get another label, although this changes the topology of its label, of
  /// the new label, and of the interface. With a manifold interface, other cells of its label can change together with
  /// it, see `CGAL::Deformable_simplicial_complexes::propose_manifold_relabeling()`. If a component vanishes,
  /// `cell` represents all cells of the component.
  bool operator()(const Complex& complex, Complex::Cell_handle cell, int label);
};

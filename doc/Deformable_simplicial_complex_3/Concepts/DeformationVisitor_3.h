/*!
\ingroup PkgDeformableSimplicialComplex3Concepts
\cgalConcept

An object that is told of each change that `CGAL::deform_interface()`, `CGAL::advect_interface()`,
`CGAL::restore_volumes()`, `CGAL::improve_mesh()`, `CGAL::improve_interface()`,
`CGAL::control_detail()` and `CGAL::remove_degeneracies()` make to the simplices of a complex, so that
data attached to them can follow, and that may end a deformation. Motion is not told of. Only the
first three relabel cells, change the topology or have passes.

The functions are called in an order that does not depend on the number of threads, by one thread at
a time. None of them may change the complex. If one throws, the exception reaches the caller, and
the complex is valid.

`Complex` stands for the type of the complex; a visitor need not define it, and its functions may be
templates. A visitor need not be copied if it is passed by `std::ref()`. Deriving from
`CGAL::Deformation_visitor_3` saves writing the functions of no interest.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformation_visitor_3}
\cgalHasModelsEnd
*/
class DeformationVisitor_3
{
public:
  /// `v` was created on the edge between `a` and `b`, which it replaced by two.
  void after_split(Complex::Vertex_handle v, Complex::Vertex_handle a, Complex::Vertex_handle b);

  /// `v` was created; its star has replaced other cells. In `improve_mesh()` with `aggressive`,
  /// vertices around it may be new too; these calls follow each other.
  void after_insertion(Complex::Vertex_handle v);

  /// `removed` is about to disappear into `kept`, which stays where it is. Both are still there. In
  /// `improve_mesh()` with `aggressive`, they need not share an edge: `kept` is the nearest vertex
  /// around that stays.
  void before_collapse(Complex::Vertex_handle removed, Complex::Vertex_handle kept);

  /// `cells` have replaced other cells: an edge, facets, or an edge of the interface was removed; or,
  /// in `improve_mesh()` with `aggressive`, all between vertices of which some may have collapsed,
  /// moved or been created.
  void after_flip(const std::vector<Complex::Cell_handle>& cells);

  /// `cell` had the label `before` and has another one now.
  void after_relabel(Complex::Cell_handle cell, int before);

  /// Components of a label merged, split, vanished or appeared. Called at the end of the pass, and
  /// after the removal of small angles, once for each event.
  void after_topology_event(const CGAL::Topology_event<Complex>& event);

  /// is asked before each pass of a deformation, the first one being 1; `false` ends the
  /// deformation at once, which is then reported as incomplete.
  bool go_further(unsigned int pass);
};

/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

An object that is told of each change that `CGAL::deform_interface()`, `CGAL::advect_interface()`,
`CGAL::restore_volumes()`, `CGAL::improve_mesh()`, `CGAL::improve_interface()`,
`CGAL::control_detail()` and `CGAL::remove_degeneracies()` make to the simplices of a complex, so that
data attached to them can follow, and that may end a deformation. The motion of a deformation is not
told of: there, vertices and cells carry their data along. Only the first three relabel cells, change
the topology or have passes.

Each change of the mesh is a replacement of cells or the smoothing of a vertex. The functions for these
are told of geometry, where cells were and where they are; the others tell what the change was for.

The functions are called in an order that does not depend on the number of threads, by one thread at
a time. None of them may change the complex. If one throws, the exception reaches the caller, and
the complex is valid; if it is one that is told before a change, that change does not happen. Another
visitor may thus see a `before` without what was to come after it.

`Complex` stands for the type of the complex; a visitor need not define it, and its functions may be
templates. A visitor need not be copied if it is passed by `std::ref()`. Deriving from
`CGAL::Deformation_visitor_3` saves writing the functions of no interest.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformation_visitor_3}
\cgalHasModels{CGAL::Deformation_visitor_pair_3<First\, Second>}
\cgalHasModels{CGAL::Carried_vertex_values_3<Complex\, VertexValueMap>}
\cgalHasModels{CGAL::Carried_cell_averages_3<Complex\, CellValueMap>}
\cgalHasModelsEnd
*/
class DeformationVisitor
{
public:
  /// The tetrahedra planned in `cavity` are about to replace its cells. `cavity.removed()` are still
  /// there, and new vertices have null handles. Called for splits, collapses, insertions and flips
  /// alike, after `before_collapse()`. If another visitor refuses by an exception, nothing is replaced,
  /// and `after_replacement()` is not called.
  void before_replacement(const Complex::Cavity& cavity);

  /// The replacement has happened, and `cavity.created()` are there, as are the handles of new vertices.
  /// Removed cells, parents among them, and vertices that vanished must not be looked at any more.
  /// Called before `after_split()`, `after_insertion()` and `after_flip()`.
  void after_replacement(const Complex::Cavity& cavity);

  /// `v` is about to move to `target` for the sake of the quality of `star`, all cells around it, infinite
  /// ones included. Not called when `v` moves with a deformation.
  void before_smoothing(Complex::Vertex_handle v, const std::vector<Complex::Cell_handle>& star,
                        const Complex::Point_3& target);

  /// `v` is there.
  void after_smoothing(Complex::Vertex_handle v, const std::vector<Complex::Cell_handle>& star);

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

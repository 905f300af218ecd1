/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

An object whose functions are called when the simplices of a complex change. User data that is attached to simplices can
follow these changes. A visitor can also end a deformation.

The following functions call visitors: `CGAL::Deformable_simplicial_complexes::deform_interface()`,
`CGAL::Deformable_simplicial_complexes::advect_interface()`,
`CGAL::Deformable_simplicial_complexes::restore_volumes()`,
`CGAL::Deformable_simplicial_complexes::improve_mesh()`,
`CGAL::Deformable_simplicial_complexes::improve_interface()`,
`CGAL::Deformable_simplicial_complexes::control_detail()` and
`CGAL::Deformable_simplicial_complexes::remove_degeneracies()`. Only the first three functions relabel cells, change the
topology, or work in passes. The motion of a deformation calls no function, since vertices and cells carry their data
along.

Each change of the mesh is a replacement of cells or the smoothing of a vertex. The functions for these two changes
receive the geometry before and after the change. The other functions receive the purpose of the change.

One thread at a time calls the functions. The order of the calls does not depend on the number of threads. No
function may change the complex. If a function throws, the exception reaches the caller, and the complex is valid. If a
function throws before a change, the change does not happen. With several visitors, another visitor can then receive
a call before the change without the call after the change.

The concept is the same in the plane and in space. `Complex` is the type of the complex. A visitor need not define it, and its functions can be templates. A visitor
that is passed by `std::ref()` need not be copyable. A visitor can derive from
`CGAL::Deformable_simplicial_complexes::Deformation_visitor`, whose functions do nothing.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Deformation_visitor}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Deformation_visitor_pair<First\, Second>}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Carried_vertex_values<Complex\, VertexValueMap>}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Carried_cell_averages<Complex\, CellValueMap>}
\cgalHasModelsEnd
*/
class DeformationVisitor
{
public:
  /// Called before the planned cells of `cavity` replace its removed cells. The cells `cavity.removed()` still exist,
  /// and new vertices have null handles. This function is called for splits, collapses, insertions and flips, after
  /// `before_collapse()`. If another visitor throws, nothing is replaced, and `after_replacement()` is not
  /// called.
  void before_replacement(const Complex::Cavity& cavity);

  /// Called after the replacement. The cells `cavity.created()` and the handles of new vertices exist. The removed
  /// cells, their parents, and the removed vertices must not be accessed. This function is called before
  /// `after_split()`, `after_insertion()` and `after_flip()`.
  void after_replacement(const Complex::Cavity& cavity);

  /// Called before smoothing moves `v` to `target`. The vector `star` contains all cells around `v`, including infinite
  /// cells. This function is not called when `v` moves with a deformation.
  void before_smoothing(Complex::Vertex_handle v, const std::vector<Complex::Cell_handle>& star,
                        const Complex::Point& target);

  /// Called after smoothing has moved `v`.
  void after_smoothing(Complex::Vertex_handle v, const std::vector<Complex::Cell_handle>& star);

  /// Called after the edge between `a` and `b` was split at the new vertex `v`.
  void after_split(Complex::Vertex_handle v, Complex::Vertex_handle a, Complex::Vertex_handle b);

  /// Called after the star of the new vertex `v` has replaced other cells. In aggressive mesh optimization,
  /// vertices around `v` can also be new. The calls for these vertices follow each other.
  void after_insertion(Complex::Vertex_handle v);

  /// Called before `removed` is collapsed into `kept`, which keeps its position. Both vertices still exist. In
  /// aggressive mesh optimization, the vertices need not share an edge. Then `kept` is the nearest vertex that
  /// remains.
  void before_collapse(Complex::Vertex_handle removed, Complex::Vertex_handle kept);

  /// Called after `cells` have replaced other cells by the removal of an edge, of facets, or of an edge of the
  /// interface. In aggressive mesh optimization, `cells` fill a neighborhood in which vertices can have been collapsed,
  /// moved or created.
  void after_flip(const std::vector<Complex::Cell_handle>& cells);

  /// Called after the label of `cell` has changed. The old label is `before`.
  void after_relabel(Complex::Cell_handle cell, int before);

  /// Called once for each event in which components of a label merged, split, vanished or appeared. The calls occur at
  /// the end of the pass and after the removal of small angles.
  void after_topology_event(const CGAL::Deformable_simplicial_complexes::Topology_event<Complex>& event);

  /// Called before each pass of a deformation. The first pass has the number 1. If the function returns `false`,
  /// the deformation ends at once, and the report says that it was stopped.
  bool go_further(unsigned int pass);
};

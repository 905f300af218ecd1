/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The vertex of a `CGAL::Deformable_simplicial_complex_3`: besides a point it keeps what the complex
wants to know about the vertex without looking at the cells around it. Each value is what the last
call of its setter made it; setters are called by the complex only. Copies have equal values, time
stamps included.

\cgalRefines `TriangulationDSVertexBase_3`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complex_vertex_base_3<Traits\, Vb>}
\cgalHasModelsEnd
*/
class DeformableSimplicialComplexVertexBase_3
{
public:
  /// `DeformableSimplicialComplexTraits_3::Point_3`
  typedef unspecified_type Point;

  /// `CGAL::Tag_true`: the container of the vertices numbers them in the order of their creation.
  typedef CGAL::Tag_true Has_timestamp;

  /// \name Point
  /// @{

  /// the position of the vertex; it means nothing for the infinite one.
  const Point& point() const;

  /// sets `point()`.
  void set_point(const Point& p);

  /// @}

  /// \name Order of Creation
  /// @{

  /// the number in the order of creation; `std::size_t(-1)` for a simplex outside a container.
  std::size_t time_stamp() const;

  /// sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp);

  /// @}

  /// \name Place in the Complex
  /// @{

  /// whether `interface_degree()` is not zero.
  bool is_interface() const;

  /// the number of facets between two labels that are incident; 0 for a new vertex.
  std::uint32_t interface_degree() const;

  /// sets `interface_degree()`.
  void set_interface_degree(std::uint32_t degree);

  /// the sides of the domain on which the vertex lies, see `CGAL::Boundary_class`; 0 for a new
  /// vertex.
  std::uint8_t boundary_class() const;

  /// sets `boundary_class()`.
  void set_boundary_class(std::uint8_t boundary_class);

  /// how long edges of the interface at the vertex were when it was built or last made finer or
  /// coarser there; 0 for a new vertex.
  float spacing() const;

  /// sets `spacing()`.
  void set_spacing(float spacing);

  /// @}
  /// \name Numbering
  /// @{

  /// an index into arrays beside the complex; 0 for a new vertex.
  std::uint32_t id() const;

  /// sets `id()`.
  void set_id(std::uint32_t id);

  /// @}
};

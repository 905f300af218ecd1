/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The vertex of a `CGAL::Deformable_simplicial_complex_3`, with a point and cached values. Each getter returns the value of
the last call of its setter. Only the complex calls setters. Copies have equal values, including time stamps.

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

  /// Returns the position. It has no meaning for the infinite vertex.
  const Point& point() const;

  /// Sets `point()`.
  void set_point(const Point& p);

  /// @}

  /// \name Order of Creation
  /// @{

  /// Returns the number in the order of creation, or `std::size_t(-1)` for a vertex outside a container.
  std::size_t time_stamp() const;

  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp);

  /// @}

  /// \name Place in the Complex
  /// @{

  /// Returns whether `interface_degree()` is not zero.
  bool is_interface() const;

  /// Returns the number of incident facets of the interface; 0 for a new vertex.
  std::uint32_t interface_degree() const;

  /// Sets `interface_degree()`.
  void set_interface_degree(std::uint32_t degree);

  /// Returns the sides of the domain on which the vertex lies, see
  /// `CGAL::Deformable_simplicial_complexes::Boundary_class`; 0 for a new vertex.
  std::uint8_t boundary_class() const;

  /// Sets `boundary_class()`.
  void set_boundary_class(std::uint8_t boundary_class);

  /// Returns the length of interface edges at the vertex, measured when the interface was built or last
  /// refined or coarsened there; 0 for a new vertex.
  float spacing() const;

  /// Sets `spacing()`.
  void set_spacing(float spacing);

  /// @}
  /// \name Numbering
  /// @{

  /// Returns an index into external arrays; 0 for a new vertex.
  std::uint32_t id() const;

  /// Sets `id()`.
  void set_id(std::uint32_t id);

  /// @}
};

/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The cell of a `CGAL::Deformable_simplicial_complex_3`, with a label and cached values. Each getter returns the value of
the last call of its setter. Only the complex calls setters. Copies have equal values, including time stamps.

\cgalRefines `TriangulationDSCellBase_3`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complex_cell_base_3<Traits\, Cb>}
\cgalHasModelsEnd
*/
class DeformableSimplicialComplexCellBase_3
{
public:
  /// `CGAL::Tag_true`: the container of the cells numbers them in the order of their creation.
  typedef CGAL::Tag_true Has_timestamp;

  /// \name Order of Creation
  /// @{

  /// Returns the number in the order of creation, or `std::size_t(-1)` for a cell outside a container.
  std::size_t time_stamp() const;

  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp);

  /// @}
  /// \name Numbering
  /// @{

  /// Returns an index into external arrays; 0 for a new cell.
  std::uint32_t id() const;

  /// Sets `id()`.
  void set_id(std::uint32_t id);

  /// @}

  /// \name Label
  /// @{

  /// Returns the label; 0 for a new cell and for an infinite cell.
  int label() const;

  /// Sets `label()`.
  void set_label(int label);

  /// Returns the number of the connected component of the label; 0 for a new cell.
  std::uint32_t component() const;

  /// Sets `component()`.
  void set_component(std::uint32_t component);

  /// @}
  /// \name Quality
  /// @{

  /// Returns the quality since the last change of the cell; 1 for a new cell and for an infinite cell.
  double quality() const;

  /// Sets `quality()`.
  void set_quality(double quality);

  /// Returns the quality at the last significant change of shape; 1 for a new cell.
  float noted_quality() const;

  /// Sets `noted_quality()`.
  void set_noted_quality(float quality);

  /// Returns the operations that have failed since this change, as bits; 0 for a new cell.
  std::uint8_t failures() const;

  /// Sets `failures()`.
  void set_failures(std::uint8_t bits);

  /// @}
};

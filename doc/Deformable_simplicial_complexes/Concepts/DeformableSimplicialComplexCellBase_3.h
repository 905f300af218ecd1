/*!
\ingroup PkgDeformableSimplicialComplexesConcepts
\cgalConcept

The cell of a `CGAL::Deformable_simplicial_complex_3`, with a label and what the complex caches.
Each value is what the last call of its setter made it; setters are called by the complex only.
Copies have equal values, time stamps included.

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

  /// the number in the order of creation; `std::size_t(-1)` for a simplex outside a container.
  std::size_t time_stamp() const;

  /// sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp);

  /// @}
  /// \name Numbering
  /// @{

  /// an index into arrays beside the complex; 0 for a new cell.
  std::uint32_t id() const;

  /// sets `id()`.
  void set_id(std::uint32_t id);

  /// @}

  /// \name Label
  /// @{

  /// the phase that fills the cell; 0 for a new cell and for infinite ones.
  int label() const;

  /// sets `label()`.
  void set_label(int label);

  /// a number shared by the cells of a connected part of a label; 0 for a new cell.
  std::uint32_t component() const;

  /// sets `component()`.
  void set_component(std::uint32_t component);

  /// @}
  /// \name Quality
  /// @{

  /// the quality as of the last change of the cell; 1 for a new cell and for infinite ones.
  double quality() const;

  /// sets `quality()`.
  void set_quality(double quality);

  /// the quality when the shape of the cell last changed essentially; 1 for a new cell.
  float noted_quality() const;

  /// sets `noted_quality()`.
  void set_noted_quality(float quality);

  /// what was tried in vain since then, as bits; 0 for a new cell.
  std::uint8_t failures() const;

  /// sets `failures()`.
  void set_failures(std::uint8_t bits);

  /// @}
};

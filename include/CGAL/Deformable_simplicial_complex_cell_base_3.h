// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>

#include <CGAL/Triangulation_cell_base_3.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Cell of a deformable simplicial complex in space. Labels are subdomain indices, and facets of the
interface are facets on surface patches.

In a complex, the patches follow from the labels and cannot be set. `Labeled_complex::release()`
numbers the patches; from then on, they can be set.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Cb a cell base class of 3D triangulations. Data that it adds are copied with a complex, and
        a cell keeps them while it exists; `Deformation_visitor` tells when cells are replaced.

\cgalModels{SimplicialMeshCellBase_3}
*/
template <class Traits, class Cb = Triangulation_cell_base_3<Traits>>
class Deformable_simplicial_complex_cell_base_3
    : public Cb,
      public Deformable_simplicial_complexes::Cell_failures,
      public Deformable_simplicial_complexes::Cell_data
{
public:
  /// Rebinds the cell to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Cb2 = typename Cb::template Rebind_TDS<Tds2>::Other;            ///< `Cb` for `Tds2`
    using Other = Deformable_simplicial_complex_cell_base_3<Traits, Cb2>; ///< this class for `Tds2`
  };

  using Surface_patch_index = int; ///< number of a surface patch; 0 for none

  using Cb::Cb;

  /// Returns the patch that contains the facet `i`. In a complex, it is 1 for each facet between
  /// cells of different labels.
  Surface_patch_index surface_patch_index(int i) const {
    return !this->m_is_in_complex ? this->m_patches[i]
                                  : this->subdomain_index() != this->neighbor(i)->subdomain_index();
  }
  /// Returns whether a patch contains the facet `i`.
  bool is_facet_on_surface(int i) const { return surface_patch_index(i) != 0; }
  /// Sets `surface_patch_index()`. \pre the cell belongs to no complex
  void set_surface_patch_index(int i, Surface_patch_index index) {
    CGAL_precondition(!this->m_is_in_complex);
    this->m_patches[i] = index;
  }

  /// \name Cache of Remeshing
  /// `tetrahedral_isotropic_remeshing()` can store an angle in a cell. This cell stores none.
  /// @{
  bool is_cache_valid() const { return false; }       ///< false
  double sliver_value() const { return 0; }           ///< never called
  void set_sliver_value(double /*squared_cosine*/) {} ///< nothing
  void reset_cache_validity() const {}                ///< nothing
  /// @}
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H

// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_NUMBER_ROWS_H
#define CGAL_INTERFACE_REMESHING_NUMBER_ROWS_H

#include <CGAL/property_map.h>

#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Several numbers, such as the values of all quantities at a vertex. Rows of the same length form a
vector space, as `Carried_vertex_values` and `Carried_cell_averages` require.
*/
struct Number_row
{
  std::vector<double> numbers; ///< the numbers

  /// Returns the sum of two rows. \pre both have the same length
  friend Number_row operator+(Number_row a, const Number_row& b) {
    for (std::size_t i = 0; i < a.numbers.size(); ++i)
      a.numbers[i] += b.numbers[i];
    return a;
  }
  /// Returns a multiple of a row.
  friend Number_row operator*(double factor, Number_row a) {
    for (double& x : a.numbers)
      x *= factor;
    return a;
  }
};

/*!
\ingroup PkgInterfaceRemeshingRef

A map from vertices or cells to rows, which are stored in a vector in the order of `id()`. Copies
refer to the same vector, which must outlive them.

\tparam Handle the type of vertices or cells of a complex
\cgalModels{ReadWritePropertyMap}
*/
template <class Handle> struct Number_row_map
{
  using key_type = Handle;                             ///< vertex or cell
  using value_type = Number_row;                       ///< row
  using reference = Number_row;                        ///< row
  using category = boost::read_write_property_map_tag; ///< category of the map

  /// Returns the row of a vertex or cell.
  friend Number_row get(const Number_row_map& map, Handle h) { return (*map.rows)[h->id()]; }
  /// Stores the row of a vertex or cell, which may be new.
  friend void put(const Number_row_map& map, Handle h, const Number_row& row) {
    if (map.rows->size() <= h->id())
      map.rows->resize(h->id() + 1);
    (*map.rows)[h->id()] = row;
  }

  std::vector<Number_row>* rows; ///< the rows
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_NUMBER_ROWS_H

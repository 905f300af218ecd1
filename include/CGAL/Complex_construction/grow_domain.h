// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_GROW_DOMAIN_H
#define CGAL_COMPLEX_CONSTRUCTION_GROW_DOMAIN_H

#include <CGAL/license/Complex_construction.h>

#include <CGAL/Complex_construction/internal/conversion/Box_layer.h>
#include <CGAL/Complex_construction/internal/thin_parts/improve_new_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/balance/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Domain_box.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

Returns whether the interface keeps a distance from the boundary of the domain, a box. Linear in the
size of the interface and of the boundary.

\param dsc the complex
\param fraction distance from each side, as a fraction of the length of the box perpendicular to the
       side
\return whether all vertices of the interface are farther from all sides; `true` if the domain is
        not a box
*/
template <class Complex>
bool has_room_around_interface(const Complex& dsc, double fraction = .125) {
  const internal::Domain_box<Complex> box(dsc);
  if (!box.is_box())
    return true;
  for (auto v : dsc.interface_vertices())
    for (int axis = 0; axis < Complex::dimension; ++axis) {
      const double x = dsc.position(v)[axis], low = box.extent().lower(axis),
                   high = box.extent().upper(axis), room = fraction * (high - low);
      if (!(x - low > room && high - x > room))
        return false;
    }
  return true;
}

/*!
\ingroup PkgComplexConstructionRef

Returns whether a motion of the interface would leave the domain, a box. Linear in the size of the
interface and of the boundary.

\param dsc the complex
\param interface_ its interface
\param destinations of the vertices of the interface
\return whether a destination is outside the box, and no vertex of the interface is on its sides,
        which are walls otherwise
\throws Invalid_destination_error if a destination is not finite
*/
template <class Complex>
bool leaves_domain(const Complex& dsc, const Interface_vertices<Complex>& interface_,
                   const std::vector<typename Complex::Approximate_point>& destinations) {
  require_finite(destinations, "a destination"); // or the domain would grow up to the largest one
  return !internal::Domain_box<Complex>(dsc).leaving(interface_.vertices, destinations).empty();
}

/*!
\ingroup PkgComplexConstructionRef

Enlarges the domain, a box, about its center, so that an interface near its boundary can move on.
The space between the old and the new box is filled with cells of label 0. The old cells stay, and
are improved together with the new ones. The vertices of the interface, the normalization,
`dsc.mean_interface_edge()` and `dsc.minimum_interface_edge()` are bitwise unchanged. The volumes of
all labels except 0 are unchanged up to rounding. n log n in the number of cells.

\param dsc the complex. Handles are invalidated; component events not taken yet are lost.
\param factor factor by which the sides of the box are multiplied, larger than 1
\throws Error if the factor is not finite or not larger than 1, the domain is not a box, or the new
        box is too large for a complex; the complex is then unchanged
*/
template <class Complex> void grow_domain(Complex& dsc, double factor = 1.5) {
  if (!(factor > 1) || !std::isfinite(factor))
    throw Error("the growth factor of the domain is out of range: use more than 1");
  const internal::Domain_box<Complex> box(dsc);
  if (!box.is_box())
    throw Error("the domain is not a box and cannot grow: build the complex in a box");
  const auto before = dsc.state();
  const internal::Box_layer<Complex> layer(dsc, before, box.extent(), factor);
  Complex grown(dsc);
  const auto vertices = grown.assign(layer.points(), layer.cells(), layer.labels());
  for (std::size_t i = 0; i < before.spacings.size(); ++i)
    if (before.spacings[i] > 0)
      vertices[i]->set_spacing(before.spacings[i]);
  auto after = grown.state();
  after.mean_interface_edge = before.mean_interface_edge;
  after.minimum_interface_edge = before.minimum_interface_edge;
  grown.restore(after);
  Construction_options<Complex::dimension> options;
  options.thin_parts.edge_per_thickness = 0; // the interface stays
  internal::improve_new_mesh(grown, options);
  dsc = std::move(grown);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_GROW_DOMAIN_H

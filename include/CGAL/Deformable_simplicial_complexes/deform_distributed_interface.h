// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_DISTRIBUTED_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_DISTRIBUTED_INTERFACE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Distributed_complex.h>
#include <CGAL/Deformable_simplicial_complexes/Distributed_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/patches/Distributed_deformer.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of the motions of a distributed complex: those of `deform_interface()`. A patch of the
complex is improved as a complex of the type `Part`, which `topology_control` sees. The flow of
space is not taken from the options.

\tparam Complex a distributed complex
*/
template <class Complex> using Distributed_options = Deformation_options<typename Complex::Part>;

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the vertices of the interface to destinations, as `deform_interface()` does on one rank.

A pass moves all vertices simultaneously, as far as no cell inverts. Cells of low quality and
vertices that did not arrive are then improved in patches, see `Part_domain`: each patch is gathered
on one rank and treated as `deform_interface()` treats a complex. Patches that overlap follow each
other in rounds. The result does not depend on the number of ranks or on the partition.

\param dsc the complex
\param interface_ the interface that this rank holds
\param destinations one for each vertex of the interface here; those of vertices of other ranks have
       no effect
\param options the options. `number_of_threads` is used within a patch.
\param flow flow of space, see the parameter `flow` of `deform_interface()`; it returns the
       destinations of points, and may be empty
\return the report, equal on all ranks
\throws Invalid_destination_error on all ranks if a destination of a rank is not finite; the complex
        is then unchanged
\throws Error on all ranks if an option is out of its range, or a function of the user throws on a
        rank; the complex is valid then
\pre the complex has not changed since the interface was taken
*/
template <class Complex>
Distributed_report<Complex>
deform_interface_to(Distributed_complex<Complex>& dsc,
                    const typename Distributed_complex<Complex>::Interface& interface_,
                    const std::vector<typename Complex::Approximate_point>& destinations,
                    const Distributed_options<Distributed_complex<Complex>>& options =
                        Distributed_options<Distributed_complex<Complex>>(),
                    const std::function<std::vector<typename Complex::Approximate_point>(
                        const std::vector<typename Complex::Approximate_point>&)>& flow = {}) {
  internal::Distributed_deformer<Complex> deformer(dsc.mesh(), options);
  deformer.set_destinations(interface_.indices, destinations);
  return deformer.run(flow);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_DISTRIBUTED_INTERFACE_H

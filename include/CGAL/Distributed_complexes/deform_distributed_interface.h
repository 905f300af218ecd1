// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_DEFORM_DISTRIBUTED_INTERFACE_H
#define CGAL_DISTRIBUTED_COMPLEXES_DEFORM_DISTRIBUTED_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/Distributed_report.h>
#include <CGAL/Distributed_complexes/internal/motion/Distributed_deformer.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Options of the motions of a distributed complex, with the names of the options of
`deform_interface()`. `flow` and `flow_moves_all` have no effect. `topology_control` and `visitor`
see a patch, which is a complex of the type `Part`, on the rank that improves the patch. Their
results must not depend on the rest of the complex.

\tparam Complex a distributed complex
*/
template <class Complex> using Distributed_options = Deformation_options<typename Complex::Part>;

/*!
\ingroup PkgDistributedComplexesRef

Moves the vertices of the interface to destinations, as `deform_interface()` does on one rank.

A pass moves all vertices simultaneously, without inverting a cell. Cells of low quality and
vertices that did not arrive are then improved in patches, see `Part_domain`: each patch is gathered
on one rank and treated as `deform_interface()` treats a complex. Overlapping patches are improved
in different rounds. The result does not depend on the number of ranks or on the partition.

\param dsc the complex
\param interface_ the interface that this rank holds
\param destinations one destination for each vertex of `interface_`; destinations of vertices of other
       ranks have no effect
\param options the options. `number_of_threads` is used within a patch.
\param flow destinations of points of space, see the parameter `flow` of `deform_interface()`; it returns the
       destinations of points, and may be empty
\return the report, equal on all ranks
\throws Error on all ranks if an option is out of its range, a destination of a vertex that its rank
        owns is not finite, the number of destinations differs from the number of vertices, or
`flow` throws or returns a wrong number of points on a rank; the complex is then unchanged, or a
        part of its vertices has moved
\throws Error on all ranks if `topology_control` or another function of the options throws on a rank
\throws Interrupted_error on all ranks if a rank is interrupted

After an exception, the complex is valid. `Distributed_complex::restore()` returns to an earlier
state. Collective.

\pre the complex has not changed since the interface was taken
*/
template <class Complex>
Distributed_report<Complex>
deform_interface_to(Distributed_complex<Complex>& dsc,
                    const typename Distributed_complex<Complex>::Interface& interface_,
                    const std::vector<typename Complex::Point>& destinations,
                    const Distributed_options<Distributed_complex<Complex>>& options =
                        Distributed_options<Distributed_complex<Complex>>(),
                    const std::function<std::vector<typename Complex::Point>(
                        const std::vector<typename Complex::Point>&)>& flow = {}) {
  internal::Distributed_deformer<Complex> deformer(dsc.mesh(), options);
  deformer.set_destinations(interface_.indices, destinations);
  return deformer.run(flow);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_DEFORM_DISTRIBUTED_INTERFACE_H

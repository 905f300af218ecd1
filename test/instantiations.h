#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_INSTANTIATIONS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_INSTANTIATIONS_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/IO/labelled_surface_3.h>
#include <CGAL/deform_interface_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>

// The templates that most tests use with the same arguments: compiled once, in instantiations.cpp,
// which defines the macro as nothing.

#ifndef DSC_TEST_EXTERN
#define DSC_TEST_EXTERN extern
#endif

namespace CGAL {

DSC_TEST_EXTERN template class Deformable_simplicial_complex_3<>;

namespace Deformable_simplicial_complexes {
namespace internal {

DSC_TEST_EXTERN template class Mesh_improver_3<Deformable_simplicial_complex_3<>,
                                               Deformation_visitor_3>;
DSC_TEST_EXTERN template class Small_angle_remover_3<Deformable_simplicial_complex_3<>,
                                                     Deformation_visitor_3>;
DSC_TEST_EXTERN template class Trapped_cells_3<Deformable_simplicial_complex_3<>,
                                               Deformation_visitor_3, Allow_topology_changes>;
DSC_TEST_EXTERN template class Interface_deformer_3<Deformable_simplicial_complex_3<>,
                                                    Deformation_visitor_3, Allow_topology_changes>;

} // namespace internal
} // namespace Deformable_simplicial_complexes

namespace IO {

DSC_TEST_EXTERN template Labelled_surface_3<Epick::Point_3>
read_labelled_surface(const std::string&, int);

} // namespace IO
} // namespace CGAL

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_INSTANTIATIONS_H

#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_INSTANTIATIONS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_INSTANTIATIONS_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_collapse_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_split_3.h>
#include <CGAL/Deformable_simplicial_complexes/manifold_interface.h>
#include <CGAL/Deformable_simplicial_complex_3/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/multi_face_retriangulation_3.h>
#include <CGAL/Deformable_simplicial_complex_3/vertex_insertion_3.h>
#include <CGAL/Deformable_simplicial_complex_3/vertex_optimization_3.h>
#include <CGAL/Deformable_simplicial_complexes/vertex_smoothing.h>
#include <CGAL/IO/labelled_surface_3.h>
#include <CGAL/control_detail_2.h>
#include <CGAL/control_detail_3.h>
#include <CGAL/deform_interface_2.h>
#include <CGAL/deform_interface_3.h>
#include <CGAL/improve_interface_2.h>
#include <CGAL/improve_interface_3.h>
#include <CGAL/improve_mesh_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>
#include <vector>

// The templates that most programs here use with the same arguments: compiled once, in
// instantiations.cpp, which defines the macro as nothing.
#ifndef DSC_EXTERN
#define DSC_EXTERN extern
#endif

namespace instantiations {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Cell = Complex::Cell_handle;
using Cells = std::vector<Cell>;
using Vertex = Complex::Vertex_handle;
using Cavity = CGAL::Cavity_3<Complex>;
using Planar_complex = CGAL::Deformable_simplicial_complex_2<>;

} // namespace instantiations

DSC_EXTERN template class CGAL::Deformable_simplicial_complex_3<>;

DSC_EXTERN template bool CGAL::propose_edge_collapse(const instantiations::Complex&,
                                                     instantiations::Cell, int, int, double,
                                                     instantiations::Cavity&);
DSC_EXTERN template bool CGAL::propose_edge_removal(const instantiations::Complex&,
                                                    instantiations::Cell, int, int,
                                                    instantiations::Cavity&);
DSC_EXTERN template bool CGAL::propose_interface_edge_flip(const instantiations::Complex&,
                                                           instantiations::Cell, int, int,
                                                           instantiations::Cavity&, double);
DSC_EXTERN template bool CGAL::propose_edge_split(const instantiations::Complex&,
                                                  instantiations::Cell, int, int, double,
                                                  instantiations::Cavity&);
DSC_EXTERN template bool CGAL::propose_multi_face_removal(const instantiations::Complex&,
                                                          instantiations::Cell, int,
                                                          instantiations::Cavity&);
DSC_EXTERN template bool CGAL::propose_multi_face_retriangulation(const instantiations::Complex&,
                                                                  instantiations::Cell, int,
                                                                  instantiations::Cavity&);
DSC_EXTERN template bool CGAL::propose_vertex_insertion(const instantiations::Complex&,
                                                        instantiations::Cell,
                                                        instantiations::Cavity&);
DSC_EXTERN template bool CGAL::propose_optimal_position(const instantiations::Complex&,
                                                        instantiations::Vertex,
                                                        const instantiations::Cells&,
                                                        instantiations::Complex::Point_3&);
DSC_EXTERN template bool CGAL::propose_smart_laplacian(const instantiations::Complex&,
                                                       instantiations::Vertex,
                                                       const instantiations::Cells&,
                                                       instantiations::Complex::Point_3&);
DSC_EXTERN template bool CGAL::propose_manifold_relabeling(const instantiations::Complex&,
                                                           instantiations::Cell, int,
                                                           instantiations::Cells&);

DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Star_optimizer<
    instantiations::Complex, instantiations::Complex::Quality_measure>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Mesh_improver<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Mesh_improver_3<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Small_angle_remover_3<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Topology_log<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Trapped_cells<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Interface_deformer<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Detail_controller<
    instantiations::Complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Interface_improver<
    instantiations::Complex>;

DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Patch_improver<
    instantiations::Complex>;

DSC_EXTERN template class CGAL::Deformable_simplicial_complex_2<>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Mesh_improver<
    instantiations::Planar_complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Topology_log<
    instantiations::Planar_complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Trapped_cells<
    instantiations::Planar_complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Interface_deformer<
    instantiations::Planar_complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Detail_controller<
    instantiations::Planar_complex>;
DSC_EXTERN template class CGAL::Deformable_simplicial_complexes::internal::Interface_improver<
    instantiations::Planar_complex>;

DSC_EXTERN template CGAL::Labelled_surface_3<CGAL::Epick::Point_3>
CGAL::IO::read_labelled_surface(const std::string&, int);

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_INSTANTIATIONS_H

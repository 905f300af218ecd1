#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_RECONSTRUCTION_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_RECONSTRUCTION_H

#if __has_include(<CGAL/Solid_reconstruction_3/compiled_3.h>) // if the component Compiled is used
#include <CGAL/Solid_reconstruction_3/compiled_3.h>
#endif
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>

// Types of reconstructions.
namespace reconstruction {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Report = CGAL::Deformable_simplicial_complexes::Reconstruction_report_3<Complex>;

} // namespace reconstruction

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_RECONSTRUCTION_H

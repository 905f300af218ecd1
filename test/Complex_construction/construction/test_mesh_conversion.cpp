#include "small_meshes.h"
#include "test.h"

#include <CGAL/Complex_construction/convert_mesh_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>

// Conversions without `make_mesh_3()`, which takes long to compile: see test_mesh_generation.cpp.
namespace test_mesh_conversion {

using small_meshes::Complex;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Mesh = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Mesh_triangulation_3<Domain>::type>;

const CGAL::Tetgen_tetrahedralizer_3 tetgen;

TEST(Mesh_conversion, there_and_back_keeps_cells_labels_and_the_interface) {
  const Complex dsc = small_meshes::make_complex(small_meshes::grid(4, small_meshes::two_boxes));
  const Mesh mesh = DSC::extract_mesh_complex_3<Mesh>(dsc);
  EXPECT_TRUE(mesh.triangulation().tds().is_valid());
  EXPECT_EQ(mesh.number_of_cells_in_complex(), dsc.number_of_cells(1) + dsc.number_of_cells(2));
  EXPECT_EQ(mesh.number_of_facets_in_complex(), dsc.interface_facets().size());
  const auto again = DSC::make_complex_from_mesh_complex_3<Complex>(
      mesh, tetgen, CGAL::parameters::improve(false));
  EXPECT_TRUE(again.is_valid());
  EXPECT_EQ(again.interface_facets().size(), dsc.interface_facets().size());
  for (int label : {1, 2}) {
    EXPECT_EQ(again.number_of_cells(label), dsc.number_of_cells(label));
    EXPECT_NEAR(again.volume(label), dsc.volume(label), 1e-12);
  }
}

TEST(Mesh_conversion, of_nothing_is_refused) {
  EXPECT_THROW(DSC::make_complex_from_mesh_complex_3<Complex>(Mesh(), tetgen),
               DSC::Invalid_cells_error);
}

} // namespace test_mesh_conversion

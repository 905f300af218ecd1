#include "test.h"

#include <CGAL/Complex_construction/convert_mesh_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

namespace test_mesh_generation {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Mesh = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Mesh_triangulation_3<Domain>::type>;

const CGAL::Tetgen_tetrahedralizer_3 tetgen;

// A ball of radius 1 whose upper half has another label.
Mesh two_halves() {
  const std::function<int(const Kernel::Point_3&)> label = [](const Kernel::Point_3& p) {
    return p.x() * p.x() + p.y() * p.y() + p.z() * p.z() > 1 ? 0 : p.z() > 0 ? 2 : 1;
  };
  const Domain domain(label, CGAL::Bbox_3(-1.5, -1.5, -1.5, 1.5, 1.5, 1.5));
  using Criteria = CGAL::Mesh_criteria_3<CGAL::Mesh_triangulation_3<Domain>::type>;
  const Criteria criteria(CGAL::parameters::facet_size = .5, CGAL::parameters::cell_size = .5);
  return CGAL::make_mesh_3<Mesh>(domain, criteria, CGAL::parameters::no_perturb(),
                                 CGAL::parameters::no_exude());
}

std::map<int, double> volumes(const Mesh& mesh) {
  std::map<int, double> result;
  for (auto c = mesh.cells_in_complex_begin(); c != mesh.cells_in_complex_end(); ++c)
    result[mesh.subdomain_index(c)] += mesh.triangulation().tetrahedron(c).volume();
  return result;
}

TEST(Mesh_conversion, to_a_complex_keeps_cells_labels_and_the_interface) {
  const Mesh mesh = two_halves();
  const auto dsc =
      DSC::make_complex_from_mesh_complex_3<Complex>(mesh, tetgen, parameters::improve(false));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(dsc.number_of_cells(1) + dsc.number_of_cells(2), mesh.number_of_cells_in_complex());
  for (const auto& [label, volume] : volumes(mesh))
    EXPECT_NEAR(dsc.volume(label), volume, 1e-12);
  EXPECT_EQ(dsc.interface_facets().size(), mesh.number_of_facets_in_complex());
}

TEST(Mesh_conversion, of_a_complex_and_back_is_the_same) {
  const auto dsc = DSC::make_complex_from_mesh_complex_3<Complex>(
      two_halves(), tetgen, parameters::normalize(true).improve(false));
  const Mesh mesh = DSC::extract_mesh_complex_3<Mesh>(dsc);
  EXPECT_TRUE(mesh.triangulation().tds().is_valid());
  EXPECT_EQ(mesh.number_of_cells_in_complex(), dsc.number_of_cells(1) + dsc.number_of_cells(2));
  EXPECT_EQ(mesh.number_of_facets_in_complex(), dsc.interface_facets().size());
  const double unit =
      dsc.normalization().scale * dsc.normalization().scale * dsc.normalization().scale;
  for (const auto& [label, volume] : volumes(mesh))
    EXPECT_NEAR(dsc.volume(label) * unit, volume, 1e-12);

  std::set<std::pair<int, int>> patches;
  for (auto f = mesh.facets_in_complex_begin(); f != mesh.facets_in_complex_end(); ++f)
    patches.insert(mesh.surface_patch_index(*f));
  EXPECT_EQ(patches, (std::set<std::pair<int, int>>{{0, 1}, {0, 2}, {1, 2}}));
  std::size_t on_surfaces = 0;
  for (const auto v : mesh.triangulation().finite_vertex_handles())
    on_surfaces += mesh.in_dimension(v) == 2;
  EXPECT_EQ(on_surfaces, dsc.interface_vertices().size());

  const auto again =
      DSC::make_complex_from_mesh_complex_3<Complex>(mesh, tetgen, parameters::improve(false));
  EXPECT_EQ(again.number_of_cells(1), dsc.number_of_cells(1));
  EXPECT_EQ(again.interface_facets().size(), dsc.interface_facets().size());
}

} // namespace test_mesh_generation

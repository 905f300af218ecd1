// Interfaces at the domain boundary, and growing domains, in space.
#include "mesh_helpers.h"

#include <CGAL/Deformable_simplicial_complexes/grow_domain.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <set>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace test_domain_boundary {

using small_meshes::Complex;

Complex ball() {
  const auto mesh = small_meshes::grid(8, small_meshes::ball);
  Complex dsc;
  dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  return dsc;
}

TEST(Domain_boundary_3, stops_an_offset_without_loss_of_volume) {
  Complex dsc = ball();
  double volume = dsc.volume(1);
  std::size_t stopped = 0;
  for (int step = 0; step < 12; ++step) {
    const auto report = DSC::advect_interface(dsc, DSC::Normal_offset{.08}, step, 1);
    ASSERT_TRUE(dsc.is_valid());
    EXPECT_GE(dsc.volume(1), volume * (1 - 1e-12)) << step;
    volume = dsc.volume(1);
    stopped += report.stopped_at_boundary;
  }
  EXPECT_GT(stopped, 0u);
  EXPECT_NEAR(dsc.volume(0) + volume, 8, 1e-10);
}

TEST(Grow_domain_3, keeps_the_interface_bit_for_bit) {
  Complex dsc = ball();
  const auto positions = [&] {
    std::set<std::array<double, 3>> result;
    for (auto v : dsc.interface_vertices())
      result.insert({dsc.position(v).x(), dsc.position(v).y(), dsc.position(v).z()});
    return result;
  };
  const auto before = positions();
  const double volume = dsc.volume(1), edge = dsc.mean_interface_edge();
  DSC::grow_domain(dsc);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(positions(), before);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-12);
  EXPECT_NEAR(dsc.volume(0) + dsc.volume(1), 27, 1e-10);
  EXPECT_EQ(dsc.mean_interface_edge(), edge);
}

} // namespace test_domain_boundary

// Interfaces at the domain boundary, and growing domains, in space.
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Complex_construction/grow_domain.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>

namespace test_domain_boundary {

using CGAL::Deformable_simplicial_complexes::Domain_rule;
using CGAL::Deformable_simplicial_complexes::Invalid_destination_error;
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
    const auto report = DSC::advect_interface(dsc, DSC::Normal_offset{.08}, step, 1,
                                              parameters::domain_rule(Domain_rule::stop));
    ASSERT_TRUE(dsc.is_valid());
    EXPECT_GE(dsc.volume(1), volume * (1 - 1e-12)) << step;
    volume = dsc.volume(1);
    stopped += report.stopped_at_boundary;
  }
  EXPECT_GT(stopped, 0u);
  EXPECT_NEAR(dsc.volume(0) + volume, 8, 1e-10);
}

TEST(Domain_boundary_3, is_an_error_for_an_interface_that_would_leave) {
  Complex dsc = ball();
  const auto before = dsc.state();
  EXPECT_THROW(DSC::advect_interface(dsc, DSC::Normal_offset{.5}, 0, 1,
                                     parameters::largest_displacement(0.)),
               Invalid_destination_error);
  EXPECT_TRUE(dsc.state() == before);
  const auto error = thrown_by<Invalid_destination_error>([&] {
    DSC::deform_interface(
        dsc,
        [&](Complex::Vertex_handle v) { return dsc.position(v) + Complex::Vector_3(.6, 0, 0); },
        parameters::domain_rule(Domain_rule::refuse));
  });
  EXPECT_FALSE(error.vertices().empty());
  EXPECT_TRUE(dsc.state() == before);
}

TEST(Domain_boundary_3, moves_away_from_the_interface_if_asked) {
  Complex dsc = ball();
  const double volume = dsc.volume(1);
  const auto grow = parameters::domain_rule(Domain_rule::grow);
  const auto report = DSC::advect_interface(
      dsc, [](const auto&, double) { return Complex::Vector_3(.7, 0, -.2); }, 0, 1, grow);
  EXPECT_EQ(report.stopped_at_boundary, 0u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(1), volume, .01 * volume); // the new cells are coarse
  EXPECT_GT(dsc.volume(0) + dsc.volume(1), 8.1);
  EXPECT_EQ(DSC::advect_interface(dsc, DSC::Normal_offset{.5}, 0, 1, grow).stopped_at_boundary, 0u);
  EXPECT_GT(dsc.volume(1), 4);
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

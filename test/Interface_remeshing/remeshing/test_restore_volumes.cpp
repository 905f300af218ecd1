#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_restore_volumes {

using namespace small_meshes;

void expect_restored(Complex dsc, const std::map<int, double>& factors) {
  std::map<int, double> volumes;
  for (const auto& [label, factor] : factors)
    volumes[label] = factor * dsc.volume(label);
  EXPECT_TRUE(DSC::restore_volumes(dsc, volumes).complete);
  EXPECT_TRUE(dsc.is_valid());
  for (const auto& [label, volume] : volumes)
    EXPECT_NEAR(dsc.volume(label), volume, 1e-10 * volume);
}

TEST(Restore_volumes, of_one_label) {
  expect_restored(mesh_helpers::sphere(8, .6), {{1, 1.05}});
  expect_restored(mesh_helpers::sphere(8, .6), {{1, .95}});
  expect_restored(mesh_helpers::sphere(8, .6), {{0, 1.01}});
}

TEST(Restore_volumes, of_labels_that_touch) {
  expect_restored(make_complex(grid(8, small_meshes::two_boxes)), {{1, 1.05}, {2, .9}});
  expect_restored(make_complex(grid(8, small_meshes::two_boxes)), {{0, 1.}, {1, 1.05}, {2, .95}});
}

// The interface ends on the sides of the domain at any angle and slides along them.
TEST(Restore_volumes, of_labels_on_the_boundary) {
  const auto slope = [](const small_meshes::Point& p) { return p.x() > p.y() ? 1 : 0; };
  expect_restored(make_complex(grid(4, slope)), {{1, 1.01}});
  expect_restored(make_complex(grid(4, small_meshes::four_phases)), {{0, 1.02}, {1, .97}, {2, 1.}});
}

TEST(Restore_volumes, does_nothing_where_nothing_is_wrong) {
  Complex dsc = mesh_helpers::sphere(4, .6);
  const auto before = dsc.state();
  EXPECT_TRUE(DSC::restore_volumes(dsc, {{1, dsc.volume(1)}}).complete);
  EXPECT_TRUE(DSC::restore_volumes(dsc, {}).deformations.empty());
  EXPECT_TRUE(dsc.state() == before);
}

TEST(Restore_volumes, tells_what_cannot_be_reached) {
  Complex dsc = mesh_helpers::sphere(4, .6);
  const double half = .5 * dsc.volume(1), nearly_all = .99 * (dsc.volume(0) + dsc.volume(1));
  EXPECT_FALSE(
      DSC::restore_volumes(dsc, {{1, half}}, parameters::number_of_iterations(0u)).complete);
  const auto report =
      DSC::restore_volumes(dsc, {{1, nearly_all}}, parameters::number_of_iterations(1u));
  EXPECT_FALSE(report.complete);
  ASSERT_EQ(report.deformations.size(), 1u);
  EXPECT_EQ(report.deformations[0].labels[1].volume_after, dsc.volume(1));
  EXPECT_TRUE(dsc.is_valid());
}

// A visitor can stop the restoration after it has allowed one pass of a deformation.
TEST(Restore_volumes, a_visitor_can_end_it) {
  struct Visitor : public DSC::Deformation_visitor<Complex>
  {
    bool go_further(unsigned pass) override { return pass < 2; }
  };
  Complex dsc = make_complex(grid(8, small_meshes::two_boxes));
  const auto report =
      DSC::restore_volumes(dsc, {{1, 1e-3 * dsc.volume(1)}}, parameters::visitor(Visitor()));
  EXPECT_FALSE(report.complete);
  ASSERT_EQ(report.deformations.size(), 1u);
  EXPECT_TRUE(report.deformations[0].stopped);
}

TEST(Restore_volumes, refuses_nonsense) {
  Complex dsc = mesh_helpers::sphere(4, .6);
  const auto before = dsc.state();
  using CGAL::Deformable_simplicial_complexes::Error;
  EXPECT_THROW(DSC::restore_volumes(dsc, {{7, 1.}}), Error);
  EXPECT_THROW(DSC::restore_volumes(dsc, {{0, dsc.volume(0)}, {1, .9 * dsc.volume(1)}}), Error);
  const double all = dsc.volume(0) + dsc.volume(1);
  for (double bad : {0., -1., std::nan(""), HUGE_VAL, all})
    EXPECT_THROW(DSC::restore_volumes(dsc, {{1, bad}}), Error);
  for (double bad : {0., -1., std::nan("")})
    EXPECT_THROW(DSC::restore_volumes(dsc, {{1, 1.}}, parameters::volume_tolerance(bad)), Error);
  EXPECT_THROW(DSC::restore_volumes(dsc, {{1, 1.}}, parameters::number_of_iterations(-1)), Error);
  EXPECT_TRUE(dsc.state() == before);
}

} // namespace test_restore_volumes

#include "mesh_helpers.h"
#include "test.h"

// Detection of cells below the quality floor; deformations leave no such cells.

namespace {

using small_meshes::Complex;
using small_meshes::Point;
using Cell_handle = Complex::Cell_handle;

std::vector<Cell_handle> cells_below_floor(const Complex& dsc) {
  auto cells = dsc.cells();
  cells.erase(
      std::remove_if(cells.begin(), cells.end(),
                     [&](Cell_handle c) { return !(dsc.quality(c) < Complex::quality_floor); }),
      cells.end());
  return cells;
}

// The center of a grid of two cubes per side, moved almost onto a facet of its star.
Complex with_flat_cell() {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(2, small_meshes::four_phases));
  for (auto v : dsc.vertices())
    if (dsc.position(v) == CGAL::ORIGIN)
      dsc.move_vertex(v, Point(1e-5 - 1, .3, .6), 1e-5);
  return dsc;
}

TEST(Quality_floor, cells_below_it_are_known_whatever_changes_the_complex) {
  Complex dsc = with_flat_cell();
  ASSERT_FALSE(cells_below_floor(dsc).empty());
  EXPECT_EQ(dsc.flat_cells(), cells_below_floor(dsc));
  EXPECT_TRUE(dsc.is_valid());

  const Complex copy = dsc;
  EXPECT_EQ(copy.flat_cells(), cells_below_floor(copy));
  Complex restored;
  restored.restore(dsc.state());
  EXPECT_EQ(restored.flat_cells(), cells_below_floor(restored));
  EXPECT_EQ(restored.flat_cells().size(), dsc.flat_cells().size());
  const Complex moved = std::move(restored);
  EXPECT_EQ(moved.flat_cells(), cells_below_floor(moved));

  const auto before = dsc.flat_cells();
  const auto stay = [](auto v) { return v->point(); };
  const auto report = DSC::deform_interface(dsc, stay);
  ASSERT_EQ(report.flat.size(), dsc.flat_cells().size());
  for (std::size_t i = 0; i < report.flat.size(); ++i) {
    EXPECT_EQ(report.flat[i].cell, dsc.flat_cells()[i]);
    EXPECT_EQ(report.flat[i].quality, dsc.quality(report.flat[i].cell));
  }
  for (auto v : dsc.vertices())
    if (!dsc.is_boundary(v))
      dsc.move_vertex(v, Point(0, 0, 0));
  EXPECT_LT(dsc.flat_cells().size(), before.size());
  EXPECT_EQ(dsc.flat_cells(), cells_below_floor(dsc));
}

// The removal of small angles uses sines, which are large for needles, too.
TEST(Quality_floor, rough_motions_leave_no_cell_below_it) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(6, small_meshes::four_phases));
  mesh_helpers::Random random(1);
  for (int step = 0; step < 8; ++step) {
    const double length = 1.5 * dsc.mean_interface_edge();
    const auto anywhere = [&](auto v) { return dsc.position(v) + random.vector<Complex>(length); };
    EXPECT_TRUE(DSC::deform_interface(dsc, anywhere).flat.empty()) << step;
    EXPECT_TRUE(cells_below_floor(dsc).empty()) << step;
  }
}

} // namespace

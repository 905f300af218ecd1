#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

namespace test_patches {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Patch = DSC::Labeled_patch_3<Point>;
using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;

const CGAL::Tetgen_tetrahedralizer_3 tetgen;

void append_rectangle(Patch& patch, const Point& a, const Point& b, const Point& c,
                      const Point& d) {
  const std::size_t n = patch.points.size();
  patch.points.insert(patch.points.end(), {a, b, c, d});
  patch.triangles.push_back({n, n + 1, n + 2});
  patch.triangles.push_back({n, n + 2, n + 3});
}

// Appends the sides of [x, x + 1] x [0, 1]^2 that are parallel to the x axis, with outward
// orientation.
void append_tube(Patch& patch, double x) {
  const auto p = [x](int i, int j, int k) { return Point(x + i, j, k); };
  append_rectangle(patch, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
  append_rectangle(patch, p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
  append_rectangle(patch, p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0));
  append_rectangle(patch, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
}

// Orientation towards increasing x.
void append_wall(Patch& patch, double x) {
  append_rectangle(patch, Point(x, 0, 0), Point(x, 1, 0), Point(x, 1, 1), Point(x, 0, 1));
}

// Two cubes of labels 1 and 2 with a common wall.
std::vector<Patch> two_cubes() {
  Patch left, right, wall, left_end, right_end;
  append_tube(left, 0);
  append_tube(right, 1);
  append_wall(wall, 1);
  append_wall(left_end, 0);
  append_wall(right_end, 2);
  left.label_behind = 1;
  right.label_behind = 2;
  wall.label_behind = 1;
  wall.label_in_front = 2;
  left_end.label_behind = 0;
  left_end.label_in_front = 1;
  right_end.label_behind = 2;
  return {left, right, wall, left_end, right_end};
}

TEST(Patches, that_share_borders_separate_materials) {
  const auto dsc = DSC::make_deformable_simplicial_complex_3<Complex>(two_cubes(), tetgen);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
  EXPECT_NEAR(dsc.volume(2), 1, 1e-12);
  EXPECT_EQ(dsc.interface_facets().size(), 22u);
  // The boundary of the square where three labels meet: four edges of one triple line.
  std::size_t triple_edges = 0;
  for (const auto& e : dsc.triangulation().finite_edges()) {
    std::set<int> labels;
    auto c = dsc.triangulation().incident_cells(e), first = c;
    do {
      if (!dsc.triangulation().is_infinite(c))
        labels.insert(c->subdomain_index());
    } while (++c != first);
    triple_edges += labels.size() == 3;
  }
  EXPECT_EQ(triple_edges, 4u);
}

TEST(Patches, may_enclose_other_patches_and_be_open_within_a_label) {
  auto patches = two_cubes();
  Patch fin; // inside the left cube, not a part of the interface
  fin.points = {Point(.25, .25, .25), Point(.75, .25, .5), Point(.5, .75, .5)};
  fin.triangles = {{0, 1, 2}};
  fin.label_behind = fin.label_in_front = 1;
  patches.push_back(fin);
  const auto dsc = DSC::make_deformable_simplicial_complex_3<Complex>(patches, tetgen);
  EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
  EXPECT_EQ(dsc.interface_facets().size(), 22u);
}

TEST(Patches, that_leave_a_gap_are_refused) {
  auto patches = two_cubes();
  patches[4].triangles.pop_back();
  const auto error = thrown_by<Invalid_surface_error>(
      [&] { DSC::make_deformable_simplicial_complex_3<Complex>(patches, tetgen); });
  EXPECT_EQ(error.reason(), Reason::contradicting_sides);
  EXPECT_EQ(error.facets().size(), 2u);
  EXPECT_TRUE(error.surface() == 1 || error.surface() == 4 || error.other_surface() == 1 ||
              error.other_surface() == 4);
}

TEST(Patches, with_a_turned_triangle_are_refused) {
  auto patches = two_cubes();
  std::swap(patches[2].triangles[1][0], patches[2].triangles[1][1]);
  const auto error = thrown_by<Invalid_surface_error>(
      [&] { DSC::make_deformable_simplicial_complex_3<Complex>(patches, tetgen); });
  EXPECT_EQ(error.reason(), Reason::contradicting_sides);
  EXPECT_EQ(error.facets().size(), 2u);
}

TEST(Patches, that_cross_are_refused) {
  auto patches = two_cubes();
  append_wall(patches[2], .5);
  for (auto& p : patches[2].points)
    p = Point(p.x() + (p.x() < 1 ? .1 * p.y() : 0), p.y() * 1.5, p.z());
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_3<Complex>(patches, tetgen),
               Invalid_surface_error);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_3<Complex>(std::vector<Patch>(), tetgen),
               Invalid_surface_error);
}

// Six tetrahedra around the diagonal of a unit cube at (x, y, z).
void append_cube(std::vector<Point>& points, std::vector<std::array<std::size_t, 4>>& tetrahedra,
                 double x, double y, double z) {
  const std::size_t n = points.size();
  for (int i = 0; i < 8; ++i)
    points.emplace_back(x + i % 2, y + i / 2 % 2, z + i / 4);
  std::array<std::size_t, 3> axes = {1, 2, 4};
  do
    tetrahedra.push_back({n, n + axes[0], n + axes[0] + axes[1], n + 7});
  while (std::next_permutation(axes.begin(), axes.end()));
}

struct Tetrahedra
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;

  void append(double x, double y, double z, int label) {
    append_cube(points, tetrahedra, x, y, z);
    labels.resize(tetrahedra.size(), label);
  }
  Complex complex() const {
    return DSC::make_deformable_simplicial_complex_3<Complex>(points, tetrahedra, labels, tetgen,
                                                              parameters::improve(false));
  }
};

TEST(Tetrahedra_in_a_box, of_several_parts_and_labels_stay_what_they_are) {
  Tetrahedra mesh;
  mesh.append(0, 0, 0, 1);
  mesh.append(1, 0, 0, 2); // the corners of the common side are duplicated
  mesh.append(0, 1, 1, 3); // shares an edge with the first cube
  mesh.append(5, 0, 0, 1);
  const Complex dsc = mesh.complex();
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_NEAR(dsc.volume(1), 2, 1e-12);
  EXPECT_NEAR(dsc.volume(2), 1, 1e-12);
  EXPECT_NEAR(dsc.volume(3), 1, 1e-12);
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  EXPECT_EQ(dsc.number_of_cells(2), 6u);
}

TEST(Tetrahedra_in_a_box, may_have_voids) {
  Tetrahedra mesh;
  for (int i = 0; i < 27; ++i)
    if (i != 13)
      mesh.append(i % 3, i / 3 % 3, i / 9, 4);
  const Complex dsc = mesh.complex();
  EXPECT_NEAR(dsc.volume(4), 26, 1e-12);
  EXPECT_EQ(dsc.number_of_components(0), 2u);
}

TEST(Tetrahedra_in_a_box, that_overlap_are_refused) {
  Tetrahedra crossing;
  crossing.append(0, 0, 0, 1);
  crossing.append(.5, .5, .5, 2);
  const auto error = thrown_by<Invalid_cells_error>([&] { crossing.complex(); });
  EXPECT_FALSE(error.tetrahedra().empty());
  EXPECT_LT(error.tetrahedra().back(), 12u);
  Tetrahedra twice;
  twice.append(0, 0, 0, 1);
  twice.append(0, 0, 0, 2);
  EXPECT_THROW(twice.complex(), Invalid_cells_error);
  Tetrahedra nested;
  nested.append(0, 0, 0, 1);
  nested.append(.25, .25, .25, 2);
  for (std::size_t i = 8; i < 16; ++i)
    nested.points[i] = CGAL::midpoint(nested.points[i], Point(.5, .5, .5));
  EXPECT_THROW(nested.complex(), Invalid_cells_error);
}

TEST(Tetrahedra_in_a_box, that_are_no_mesh_are_refused) {
  EXPECT_THROW(Tetrahedra().complex(), Invalid_cells_error);
  Tetrahedra mesh;
  mesh.append(0, 0, 0, 1);
  Tetrahedra unlabeled = mesh;
  unlabeled.labels.pop_back();
  EXPECT_THROW(unlabeled.complex(), Invalid_cells_error);
  Tetrahedra infinite = mesh;
  infinite.points[0] = Point(std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_THROW(infinite.complex(), Invalid_cells_error);
  Tetrahedra flat = mesh;
  flat.tetrahedra[0][3] = flat.tetrahedra[0][2];
  EXPECT_THROW(flat.complex(), Invalid_cells_error);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_3<Complex>(
                   mesh.points, mesh.tetrahedra, mesh.labels, tetgen,
                   parameters::enclosing_box(CGAL::Bbox_3(0, 0, 0, 1, 1, 1))),
               Invalid_surface_error);
}

} // namespace test_patches
